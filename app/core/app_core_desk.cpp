// AppCore's part on the desk: what its controls are bound to, the hand at it, the same by keys, and the world that waits meanwhile. App thread only.
#include <algorithm>
#include <cmath>
#include <ctime>

#include "app/core/app_core.h"
#include "worlds/base/text.h"
#include "worlds/scene/surfaces.h"

namespace handrail {
namespace {

constexpr std::string_view kAtDesk = "You are at your desk, and the world waits. Pull your hand towards you and through, or press Escape, to go back.";

constexpr std::string_view kDeskTitle = "Your desk";

// What needs the world to go on.
bool needs_world(Command command) {
    switch (command) {
        case Command::Forward:
        case Command::Back:
        case Command::TurnLeft:
        case Command::TurnRight:
        case Command::SwitchFrame:
        case Command::ScaleBuilding:
        case Command::ScaleFloor:
        case Command::ScaleRoom:
        case Command::ScaleDetail:
        case Command::WorkspaceForward:
        case Command::WorkspaceBack:
        case Command::WorkspaceLeft:
        case Command::WorkspaceRight:
        case Command::WorkspaceUp:
        case Command::WorkspaceDown:
        case Command::WorkspaceTurnLeft:
        case Command::WorkspaceTurnRight:
        case Command::Grab:
        case Command::Use:
        case Command::BringOut:
        case Command::TrailLeft:
        case Command::TrailRight:
        case Command::TrailOn:
        case Command::TrailBack:
        case Command::SquareUp:
        case Command::LeapNext:
        case Command::LeapLast:
        case Command::Retrace:
        case Command::FreeLeft:
        case Command::FreeRight:
            return true;
        default:
            return false;
    }
}

std::string clock_words() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    return fmt::format("{}:{:02}", local.tm_hour, local.tm_min);
}

}  // namespace

void AppCore::furnish_desk() {
    std::vector<DeskControl> controls;
    const auto of_setting = [&](const DeskSetting& row) {
        controls.push_back(bound(row, [this, &row] { return desk_value(row.key); }, [this, &row](const std::string& value) { change_setting(row.key, value, last_tick_s_); }));
    };
    const auto indicator = [&](std::string name, std::function<std::string()> value) {
        DeskControl one;
        one.name = std::move(name);
        one.value = std::move(value);
        controls.push_back(std::move(one));
    };
    // The knob stands behind the volumes, and what is one cell wide beside the sliders.
    for (const DeskSetting& row : desk_settings()) {
        of_setting(row);
        if (row.key == "sound.earcon_volume") {
            DeskControl knob;
            knob.name = "Volume knob";
            knob.kind = DeskKind::Knob;
            controls.push_back(std::move(knob));
        }
        if (row.key == "speech.verbosity") indicator("Time", clock_words);
    }
    indicator("Heading", [this] {
        return fmt::format("{}, {:.0f} degrees", compass_word(heading_rad_), std::fmod(degrees_from_radians(heading_rad_) + 360.0, 360.0));
    });
    desk_ = Desk(std::move(controls));
}

// As TOML writes it; a scale that waits for the hand to be back counts already.
std::string AppCore::desk_value(std::string_view key) const {
    if (key == "workspace.scale" && scale_waits_) return *scale_waits_;
    if (key == "workspace.scale" && named_scale_ && scene_) return fmt::format("{}", scale());
    return setting_text(settings_, key).value_or("");
}

// A live change, wherever it comes from: at once in force, stored and saved by whoever owns the settings.
Result<void> AppCore::change_setting(std::string_view key, const std::string& value, double now_s) {
    Settings changed = settings_;
    if (auto done = handrail::change_setting(changed, key, value); !done) return done;
    setting_changes_.emplace_back(std::string(key), setting_text(changed, key).value_or(value));
    if (key == "workspace.scale" && at_desk()) {
        scale_waits_ = value;  // the world is larger or smaller when the hand is back in it
        return {};
    }
    if (key != "workspace.scale") {
        settings_ = std::move(changed);
        if (scene_) retune();
        return {};
    }
    rescale(changed, now_s);
    return {};
}

// For another device, or another page.
void AppCore::lay_desk(std::size_t page) {
    panel_ = hand_.present ? lay_out_desk(desk_.controls(), hand_.spec, page) : DeskPanel{};
}

std::optional<Vec3> AppCore::desk_place_m(std::string_view control) const {
    const auto found = desk_.find(control);
    for (const PlacedControl& one : panel_.placed)
        if (found ? one.control == *found : !one.control && lower_ascii(control) == "next page") return one.touch_m();
    return std::nullopt;
}

bool AppCore::refused_at_desk(Command command, double now_s) {
    if (!at_desk() || !needs_world(command)) return false;
    play(SoundKind::Denied, now_s);
    answer(std::string(kAtDesk), now_s);
    return true;
}

void AppCore::leave_desk(double now_s) {
    publish_pose(now_s, PoseChange::Moved);  // a jump of the workspace ends the visit
}

void AppCore::tick_desk(double now_s) {
    if (at_desk() != std::exchange(desk_told_, at_desk())) {
        if (desk_told_) {
            std::fill(held_.begin(), held_.end(), false);
            pending_way_m_ = 0.0;
            heading_goal_rad_ = heading_rad_;
            desk_hand_.begin(tool_.desk);
            answer(panel_.pages > 1 ? fmt::format("Your desk. Page {} of {}.", panel_.page + 1, panel_.pages) : "Your desk.", now_s);
        } else {
            if (const auto waited = std::exchange(scale_waits_, std::nullopt)) {
                Settings changed = settings_;
                if (handrail::change_setting(changed, "workspace.scale", *waited)) rescale(changed, now_s);
            }
            answer("Back in the world. " + where_am_i(), now_s);
        }
    }
    if (!desk_told_) return;
    for (const DeskNews& one : desk_hand_.follow(tool_.desk, panel_, now_s)) hear_of_desk(one, now_s);
}

void AppCore::hear_of_desk(const DeskNews& news, double now_s) {
    if (news.kind != DeskNews::Kind::Met) play(SoundKind::Click, now_s);
    if (!news.on.control) {
        if (news.kind == DeskNews::Kind::Pressed) {
            lay_desk(panel_.page + 1);
            return answer(fmt::format("Page {} of {}", panel_.page + 1, panel_.pages), now_s);
        }
        return answer("Next page", now_s);
    }
    const std::size_t control = *news.on.control;
    switch (news.kind) {
        case DeskNews::Kind::Met:
            return answer(desk_.words(control), now_s);
        case DeskNews::Kind::Pressed:
            return answer(press_control(control), now_s);
        case DeskNews::Kind::Put:
            return answer(put_control(control, news.number), now_s);
        case DeskNews::Kind::Stepped:
            return answer(step_control(control, news.number), now_s);
    }
}

// The same desk by keys.
void AppCore::open_desk_list(double now_s) {
    if (!settings_.desk.use) return answer("Your desk is switched off; the setting desk.use brings it back.", now_s);
    ListSpec list;
    list.title = kDeskTitle;
    list.items = desk_items();
    list.adjusted = [this](std::size_t i, int by) { return step_control(i, by); };
    list.chosen = [this](std::size_t i) { answer(press_control(i), last_tick_s_); };
    list.stays_open = true;
    open_list(std::move(list), now_s);
}

std::vector<ListItem> AppCore::desk_items() const {
    std::vector<ListItem> items;
    for (std::size_t i = 0; i < desk_.controls().size(); ++i) {
        const DeskControl& control = desk_.controls()[i];
        items.push_back({control.name, desk_.value(i), control.positions > 0 || control.kind == DeskKind::Knob});
    }
    return items;
}

// One change may show in several places: on the knob, in the open list.
std::string AppCore::after_desk_change(std::string words) {
    if (const DialogueView view = dialogue_.view(); view.kind == DialogueView::Kind::List && view.title == kDeskTitle) dialogue_.change_items(desk_items());
    return words;
}

}  // namespace handrail
