#include "app/core/desk/desk_visit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "app/core/context/context_words.h"
#include "app/core/context/workspace_commands.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {
namespace {

// Returns true for commands that act only while the world is running.
bool needs_world(Command command) {
    switch (command) {
        case Command::SwitchFrame:
        case Command::Use:
        case Command::PutBack:
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
        case Command::FaceRoute:
            return true;
        case Command::WorkspaceCentre:  // a jump, which would end the visit to the desk
            return false;
        default:
            return steps_or_turns(command) || lays_workspace(command);
    }
}

std::string clock_words() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    return fmt::format("{}:{:02}", local.tm_hour, local.tm_min);
}

}  // namespace

void DeskVisit::furnish() {
    std::vector<DeskControl> controls;
    const auto of_setting = [&](const DeskSetting& row) {
        controls.push_back(bound(
            row, [this, &row] { return value_of(row.key); },
            [this, &row](const std::string& value) {
                // The control announces the resulting value. If the setting refuses a value, that announcement shows
                // it, so the error needs no announcement.
                static_cast<void>(context_.session_requests.set(row.key, value, context_.tick_s));
            }));
    };
    const auto indicator = [&](std::string name, std::function<std::string()> value) {
        DeskControl one;
        one.name = std::move(name);
        one.value = std::move(value);
        controls.push_back(std::move(one));
    };
    // This loop sets the order of the controls: the knob comes after the volumes, and controls one cell wide come next
    // to the sliders.
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
    const auto button = [&](std::string name, std::function<std::string()> value,
                            std::function<std::string()> pressed) {
        DeskControl one;
        one.name = std::move(name);
        one.kind = DeskKind::Button;
        one.value = std::move(value);
        one.pressed = std::move(pressed);
        controls.push_back(std::move(one));
    };
    // Adds a control that selects an entry of a list of varying length. `at` always stays within the list.
    const auto list = [&](std::string name, std::size_t& at, const std::function<std::size_t()>& many,
                          std::function<std::string()> value) {
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
        phrase("desk.world"), world_, [this] { return worlds_.size(); },
        [this] { return world() ? name_of_file(*world()) : phrase("desk.no_world"); });
    button(phrase("desk.go"), {}, [this] { return go_to_world(); });
    list(
        phrase("desk.mark"), mark_, [this] { return context_.world.marks.size(); },
        [this] { return mark() ? mark()->name : phrase("desk.no_mark"); });
    button(
        phrase("desk.beacon"), [this] { return beacon().value_or(phrase("desk.off")); },
        [this] { return switch_beacon(); });
    button(phrase("desk.where"), {},
           [this] { return context_.world.scene ? where_am_i() : phrase("desk.not_in_a_world"); });
    button(
        phrase("desk.units"),
        [this] { return phrase(context_.settings.speech.distances_in_steps ? "desk.steps" : "desk.metres"); },
        [this] { return switch_units(); });
    // Shows only the first sentence of the report. The call is cheap, because progress() examines the floor of a room
    // only once.
    indicator(phrase("desk.explored"), [this] {
        if (!context_.world.scene) return phrase("desk.nothing_explored");
        std::string words = progress(context_.tick_s);
        words.resize(std::min(words.size(), words.find(". ")));
        return words;
    });
    indicator(phrase("desk.heading"), [this] {
        const double heading_rad = context_.avatar.heading_rad;
        return phrase("desk.heading_degrees",
                      {{"direction", compass_word(heading_rad)},
                       {"degrees", std::lround(std::fmod(degrees_from_radians(heading_rad) + 360.0, 360.0))}});
    });
    button(
        phrase("desk.device"), [this] { return hand_words(context_.hands); },
        [this] {
            context_.requests.devices = true;
            return phrase("devices.looking");
        });
    desk_ = Desk(std::move(controls));
    lay(0);
}

void DeskVisit::offer_worlds(const WorldShelf& shelf) {
    worlds_ = shelf.recent;
    for (const ShelvedWorld& world : worlds_in(shelf.bundled))
        if (std::find(worlds_.begin(), worlds_.end(), world.file) == worlds_.end()) worlds_.push_back(world.file);
}

const std::filesystem::path* DeskVisit::world() const {
    return worlds_.empty() ? nullptr : &worlds_[std::min(world_, worlds_.size() - 1)];
}

const Mark* DeskVisit::mark() const {
    const std::vector<Mark>& marks = context_.world.marks;
    return marks.empty() ? nullptr : &marks[std::min(mark_, marks.size() - 1)];
}

std::string DeskVisit::go_to_world() {
    const std::filesystem::path* file = world();
    if (!file) return phrase("desk.no_world_to_go_to");
    context_.requests.world = WorldRequest{*file};
    return phrase("desk.going_to", {{"world", name_of_file(*file)}});
}

// Moves the beacon to the selected mark. If the beacon is already there, this function switches it off.
std::string DeskVisit::switch_beacon() {
    const Mark* chosen = mark();
    const std::optional<std::string> on = beacon();
    if (on && (!chosen || *on == chosen->name)) {
        on_beacon(nullptr);
        return phrase("desk.beacon_off");
    }
    if (!chosen) return phrase("desk.no_marks", {{"key", context_.keys.keys_of(Command::DropMark)}});
    on_beacon(chosen);
    return phrase("desk.beacon_on",
                  {{"mark", chosen->name}, {"where", where_words(context_, Aabb{chosen->place_m, chosen->place_m})}});
}

std::string DeskVisit::switch_units() {
    const bool in_steps = !context_.settings.speech.distances_in_steps;
    context_.set("speech.distances_in_steps", in_steps ? "true" : "false", context_.tick_s);
    return phrase(in_steps ? "desk.in_steps" : "desk.in_metres");
}

// Returns the value in TOML syntax. It returns a scale chosen at the desk at once, even though the scale changes only
// when the hand has left the desk.
std::string DeskVisit::value_of(std::string_view key) const {
    if (key == "workspace.scale" && scale_waits_) return *scale_waits_;
    if (key == "workspace.scale" && context_.hands.named_scale && context_.world.scene)
        return fmt::format("{}", scale(context_));
    return settings::setting_text(context_.settings, key).value_or("");
}

// Lays out the panel for the present device with the given page.
void DeskVisit::lay(std::size_t page) {
    const HandFacts& hand = context_.hands.right;
    panel_ = hand.present ? lay_out_desk(desk_.controls(), hand.spec, page) : DeskPanel{};
}

std::optional<Vec3> DeskVisit::place_m(std::string_view control) const {
    const auto found = desk_.find(control);
    for (const PlacedControl& one : panel_.placed)
        if (found ? one.control == *found
                  : !one.control && lower_ascii(control) == lower_ascii(phrase("desk.next_page")))
            return one.touch_m();
    return std::nullopt;
}

bool DeskVisit::refuses(Command command, double now_s) {
    if (!context_.hands.at_desk() || !needs_world(command)) return false;
    context_.play(cues::SoundKind::Denied, now_s);
    context_.answer(phrase("desk.world_waits"), now_s);
    return true;
}

void DeskVisit::tick(double now_s) {
    const bool here = context_.hands.at_desk();
    if (here != std::exchange(announced_, here)) {
        if (here) come(now_s);
        else go_back(now_s);
    }
    if (!here) return;
    for (const DeskNews& one : hand_.follow(context_.hands.tool.desk, panel_, now_s)) hear(one, now_s);
}

void DeskVisit::come(double now_s) {
    on_come();
    hand_.begin(context_.hands.tool.desk);
    context_.answer(panel_.pages > 1 ? phrase("desk.here_page", {{"page", panel_.page + 1}, {"pages", panel_.pages}})
                                     : phrase("desk.here"),
                    now_s);
}

void DeskVisit::go_back(double now_s) {
    on_back(std::exchange(scale_waits_, std::nullopt), now_s);
    context_.announce(cues::SpeechTopic::Place, phrase("desk.back", {{"where", where_am_i()}}), now_s,
                      {.answers = true});
}

void DeskVisit::hear(const DeskNews& news, double now_s) {
    if (news.kind != DeskNews::Kind::Met) context_.play(cues::SoundKind::Click, now_s);
    if (!news.on.control) {
        if (news.kind == DeskNews::Kind::Pressed) {
            lay(panel_.page + 1);
            return context_.answer(phrase("desk.page", {{"page", panel_.page + 1}, {"pages", panel_.pages}}), now_s);
        }
        return context_.answer(phrase("desk.next_page"), now_s);
    }
    const std::size_t control = *news.on.control;
    switch (news.kind) {
        case DeskNews::Kind::Met:
            return context_.answer(desk_.words(control), now_s);
        case DeskNews::Kind::Pressed:
            return context_.answer(press(control), now_s);
        case DeskNews::Kind::Put:
            return context_.answer(put(control, news.number), now_s);
        case DeskNews::Kind::Stepped:
            return context_.answer(step(control, news.number), now_s);
    }
}

void DeskVisit::open_list(double now_s) {
    if (!context_.settings.desk.use) return context_.answer(phrase("desk.switched_off"), now_s);
    ListSpec list;
    list.title = phrase("desk.title");
    list.items = items();
    list.adjusted = [this](std::size_t i, int by) { return step(i, by); };
    list.put = [this](std::size_t i, double number) { return put_number(i, number); };
    list.chosen = [this](std::size_t i) { context_.answer(press(i), context_.tick_s); };
    list.stays_open = true;
    context_.open_list(std::move(list), now_s);
}

std::vector<ListItem> DeskVisit::items() const {
    std::vector<ListItem> items;
    for (std::size_t i = 0; i < desk_.controls().size(); ++i) {
        const DeskControl& control = desk_.controls()[i];
        items.push_back({control.name, desk_.value(i), control.adjustable(), desk_.number(i)});
    }
    return items;
}

// Updates the open list, because one change may also affect other entries, such as the knob's.
std::string DeskVisit::after_change(std::string words) {
    if (const DialogueView view = context_.lists.dialogue.view();
        view.kind == DialogueView::Kind::List && view.title == phrase("desk.title"))
        context_.lists.dialogue.change_items(items());
    return words;
}

}  // namespace handrail::core
