// AppCore's part on the desk: what its controls are bound to, the hand at it, the same by keys, and the world that waits meanwhile. App thread only.
#include <algorithm>
#include <cmath>
#include <ctime>

#include "app/core/app_core.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/scene/surfaces.h"

namespace handrail {
namespace {

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
        controls.push_back(bound(
            row, [this, &row] { return desk_value(row.key); }, [this, &row](const std::string& value) { change_setting(row.key, value, last_tick_s_); }));
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
            knob.name = phrase("desk.knob");
            knob.kind = DeskKind::Knob;
            controls.push_back(std::move(knob));
        }
        if (row.key == "speech.verbosity") indicator(phrase("desk.time"), clock_words);
    }
    const auto button = [&](std::string name, std::function<std::string()> value, std::function<std::string()> pressed) {
        DeskControl one;
        one.name = std::move(name);
        one.kind = DeskKind::Button;
        one.value = std::move(value);
        one.pressed = std::move(pressed);
        controls.push_back(std::move(one));
    };
    // A place in something whose entries come and go; `at` stays among them.
    const auto list = [&](std::string name, std::size_t& at, std::function<std::size_t()> many, std::function<std::string()> value) {
        DeskControl one;
        one.name = std::move(name);
        one.kind = DeskKind::List;
        one.many = [many] { return static_cast<int>(many()); };
        one.position = [&at, many] { return static_cast<int>(std::min(at, std::max<std::size_t>(many(), 1) - 1)); };
        one.put = [&at](int position) { at = static_cast<std::size_t>(position); };
        one.value = std::move(value);
        controls.push_back(std::move(one));
    };
    list(
        phrase("desk.world"), desk_world_, [this] { return desk_worlds_.size(); },
        [this] { return desk_worlds_.empty() ? phrase("desk.no_world") : name_of_file(desk_worlds_[std::min(desk_world_, desk_worlds_.size() - 1)]); });
    button(phrase("desk.go"), {}, [this] {
        if (desk_worlds_.empty()) return phrase("desk.no_world_to_go_to");
        world_wanted_ = desk_worlds_[std::min(desk_world_, desk_worlds_.size() - 1)];
        return phrase("desk.going_to", {{"world", name_of_file(*world_wanted_)}});
    });
    list(
        phrase("desk.mark"), desk_mark_, [this] { return guiding_.marks.size(); }, [this] { return desk_mark() ? desk_mark()->name : phrase("desk.no_mark"); });
    button(
        phrase("desk.beacon"), [this] { return guiding_.beacon.on() ? guiding_.beacon.name() : phrase("desk.off"); }, [this] { return beacon_of_desk(); });
    button(phrase("desk.where"), {}, [this] { return scene_ ? where_am_i() : phrase("desk.not_in_a_world"); });
    button(
        phrase("desk.units"), [this] { return phrase(settings_.speech.distances_in_steps ? "desk.steps" : "desk.metres"); },
        [this] {
            const bool changed = change_setting("speech.distances_in_steps", settings_.speech.distances_in_steps ? "false" : "true", last_tick_s_).has_value();
            contract_pre(changed);
            return phrase(settings_.speech.distances_in_steps ? "desk.in_steps" : "desk.in_metres");
        });
    // The first sentence of what the report says; the floor of a place is looked over once.
    indicator(phrase("desk.explored"), [this] {
        if (!scene_) return phrase("desk.nothing_explored");
        std::string words = progress_words(last_tick_s_);
        words.resize(std::min(words.size(), words.find(". ")));
        return words;
    });
    indicator(phrase("desk.heading"), [this] {
        return phrase("desk.heading_degrees",
                      {{"direction", compass_word(heading_rad_)}, {"degrees", std::lround(std::fmod(degrees_from_radians(heading_rad_) + 360.0, 360.0))}});
    });
    desk_ = Desk(std::move(controls));
}

void AppCore::set_worlds(WorldShelf shelf) {
    shelf_ = std::move(shelf);
    desk_worlds_ = shelf_.recent;
    for (const ShelvedWorld& world : worlds_in(shelf_.bundled))
        if (std::find(desk_worlds_.begin(), desk_worlds_.end(), world.file) == desk_worlds_.end()) desk_worlds_.push_back(world.file);
}

const Mark* AppCore::desk_mark() const { return guiding_.marks.empty() ? nullptr : &guiding_.marks[std::min(desk_mark_, guiding_.marks.size() - 1)]; }

// On the mark that is chosen, or off where it is on that one already.
std::string AppCore::beacon_of_desk() {
    const Mark* mark = desk_mark();
    if (guiding_.beacon.on() && (!mark || guiding_.beacon.name() == mark->name)) {
        guiding_.beacon.clear();
        return phrase("desk.beacon_off");
    }
    if (!mark) return phrase("desk.no_marks", {{"key", keys_.keys_of(Command::DropMark)}});
    const Aabb place{mark->place_m, mark->place_m};
    guiding_.goal = Goal{mark->name, place, kNoFeature};
    start_beacon({mark->name, place, kNoFeature});
    return phrase("desk.beacon_on", {{"mark", mark->name}, {"where", where_words(place)}});
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
    if (key == "haptic.simplify" && scene_ && !at_desk()) {
        feel_otherwise(changed, now_s);
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
void AppCore::lay_desk(std::size_t page) { panel_ = hand_.present ? lay_out_desk(desk_.controls(), hand_.spec, page) : DeskPanel{}; }

std::optional<Vec3> AppCore::desk_place_m(std::string_view control) const {
    const auto found = desk_.find(control);
    for (const PlacedControl& one : panel_.placed)
        if (found ? one.control == *found : !one.control && lower_ascii(control) == lower_ascii(phrase("desk.next_page"))) return one.touch_m();
    return std::nullopt;
}

bool AppCore::refused_at_desk(Command command, double now_s) {
    if (!at_desk() || !needs_world(command)) return false;
    play(SoundKind::Denied, now_s);
    answer(phrase("desk.world_waits"), now_s);
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
            answer(panel_.pages > 1 ? phrase("desk.here_page", {{"page", panel_.page + 1}, {"pages", panel_.pages}}) : phrase("desk.here"), now_s);
        } else {
            if (const auto waited = std::exchange(scale_waits_, std::nullopt)) {
                Settings changed = settings_;
                if (handrail::change_setting(changed, "workspace.scale", *waited)) rescale(changed, now_s);
            }
            if (!(touch_plan_ == compiled_plan_)) feel_otherwise(Settings(settings_), now_s);
            answer(phrase("desk.back", {{"where", where_am_i()}}), now_s);
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
            return answer(phrase("desk.page", {{"page", panel_.page + 1}, {"pages", panel_.pages}}), now_s);
        }
        return answer(phrase("desk.next_page"), now_s);
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
    if (!settings_.desk.use) return answer(phrase("desk.switched_off"), now_s);
    ListSpec list;
    list.title = phrase("desk.title");
    list.items = desk_items();
    list.adjusted = [this](std::size_t i, int by) { return step_control(i, by); };
    list.put = [this](std::size_t i, double number) { return put_control_number(i, number); };
    list.chosen = [this](std::size_t i) { answer(press_control(i), last_tick_s_); };
    list.stays_open = true;
    open_list(std::move(list), now_s);
}

std::vector<ListItem> AppCore::desk_items() const {
    std::vector<ListItem> items;
    for (std::size_t i = 0; i < desk_.controls().size(); ++i) {
        const DeskControl& control = desk_.controls()[i];
        items.push_back({control.name, desk_.value(i), control.adjustable(), desk_.number(i)});
    }
    return items;
}

// One change may show in several places: on the knob, in the open list.
std::string AppCore::after_desk_change(std::string words) {
    if (const DialogueView view = dialogue_.view(); view.kind == DialogueView::Kind::List && view.title == phrase("desk.title"))
        dialogue_.change_items(desk_items());
    return words;
}

}  // namespace handrail
