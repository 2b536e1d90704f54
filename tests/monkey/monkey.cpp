#include "tests/monkey/monkey.h"

#include <fmt/format.h>

#include <cmath>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/worlds_once.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::test {
namespace {

constexpr std::size_t kStory = 30;
constexpr double kInside_m = 1e-4;  // greater depths in a solid cannot be rounding errors

// Returns the building without moving parts and placed objects, because those may move into a walker.
std::shared_ptr<const Scene> still_part(const Scene& scene) {
    auto still = std::make_shared<Scene>(scene);
    still->placed.clear();
    std::erase_if(still->solids, [&](const Solid& solid) {
        return std::any_of(scene.movers.begin(), scene.movers.end(),
                           [&](const Mover& mover) { return mover.feature == solid.feature; });
    });
    return still;
}

// Returns whether a solid is nearer to the place than `nearer_m`. A negative `nearer_m` means a depth: returns whether
// the place is at least that deep in a solid.
bool solid_within(const HapticScene& scene, const Vec3& world_m, double nearer_m) {
    const Vec3 local_m = world_m - scene.origin_m;
    bool found = false;
    scene.obstacle_bvh.within(local_m, std::abs(nearer_m), [&](std::uint32_t obstacle, double&) {
        found = found || (scene.solid(obstacle) && scene.closest(obstacle, local_m).distance_m < nearer_m);
    });
    return found;
}

}  // namespace

void CountingSpeech::take(const Utterance& utterance) {
    ++lines;
    if (utterance.text.empty()) ++empty;
    if (!is_utf8(utterance.text)) ++damaged;
    last.push_back(utterance.text);
    if (last.size() > kStory) last.pop_front();
}

Monkey::Monkey(std::uint32_t seed, std::vector<std::shared_ptr<const Scene>> worlds)
    : random_(seed), worlds_(std::move(worlds)), settings_(SettingsStore().explain()) {
    begin();
}

// Starts a session as the program does, with a random hand or none and a random world.
void Monkey::begin() {
    note("begin");
    if (!speak_language("en")) fail("English is gone");
    held_.clear();
    walls_of_.reset();
    walls_.reset();
    body_free_m_ = 0.0;
    least_radius_m_ = Settings{}.walk.body_radius_m;
    proxy_free_[0] = proxy_free_[1] = {};
    facts_[0] = facts_[1] = {};
    if (chance(0.8)) {
        facts_[0].present = facts_[0].simulated = true;
        facts_[0].spec = *find_device_spec(chance(0.5) ? "sim-t" : "sim-f");
    }
    session_ = std::make_unique<HeadlessSession>(Settings{}, facts_[0], audio_, speech_, with_known_rooms());
    app().apply(WorldsKnown{{test::project_root() / "worlds/maps", {}}}, 0.0);
    if (chance(0.2)) app().apply(FirstMinutesBegun{"nobody", chance(0.5)}, 0.0);
    app().apply(WorldEntered{make_ready(worlds_[below(static_cast<std::uint32_t>(worlds_.size()))])}, 0.0);
    run(0.2);
}

std::string Monkey::word() {
    static constexpr const char* kWords[] = {"1",
                                             "2",
                                             "17",
                                             "enter",
                                             "escape",
                                             "down",
                                             "up",
                                             "list",
                                             "left",
                                             "right",
                                             "home",
                                             "end",
                                             "backspace",
                                             "door",
                                             "kitchen",
                                             "where",
                                             "-1",
                                             "999999999999",
                                             "",
                                             " ",
                                             "T\xC3\xBCr",
                                             "\xFF\xFE",
                                             "\xF0\x9F\x98\x80",
                                             "nan",
                                             "a\nb",
                                             "\x1B[2J",
                                             "%s%n",
                                             "{0}",
                                             "hall"};
    std::string text = kWords[below(std::size(kWords))];
    if (chance(0.1)) text += kWords[below(std::size(kWords))];
    if (chance(0.03)) text.append(1000, 'x');
    if (chance(0.1)) text += static_cast<char>(below(256));
    return text;
}

void Monkey::press_something() {
    const auto table = command_table();
    const CommandInfo& command = table[below(static_cast<std::uint32_t>(table.size()))];
    note("command", std::string(command.word));
    session_->press(command.command);
    if (command.hold && chance(0.7)) held_.push_back(command.command);
    else app().apply(CommandUp{command.command}, session_->now_s());
    if (!held_.empty() && chance(0.5)) {
        app().apply(CommandUp{held_.front()}, session_->now_s());
        held_.erase(held_.begin());
    }
}

void Monkey::key() {
    static constexpr const char* kKeys[] = {
        "Enter",     "Escape", "Up",      "Down",  "Left",       "Right",      "Home",   "End", "PageUp", "PageDown",
        "Backspace", "Delete", "Tab",     "Space", "Shift+Left", "Ctrl+Right", "Alt+F4", "F1",  "F2",     "F5",
        "F12",       "A",      "Shift+4", "7",     "Nothing",    "",           "+",      "\xFF"};
    std::string name = kKeys[below(std::size(kKeys))];
    // In a list, keys that move through the list reach more of the program.
    if (app().dialogue().is_open() && chance(0.5)) name = chance(0.5) ? "Down" : chance(0.6) ? "Enter" : "Right";
    note("key", name);
    session_->tap_key(name);
}

void Monkey::text() {
    const std::string typed = word();
    note("text", typed);
    app().apply(TextTyped{typed}, session_->now_s());
}

void Monkey::line() {
    const std::string typed = word();
    note("line", typed);
    app().apply(LineTyped{typed}, session_->now_s());
    if (!chance(0.3)) return;
    ItemAct act;
    const DialogueView view = app().dialogue().view();
    act.kind = static_cast<ItemAct::Kind>(below(5));
    act.item = below(static_cast<std::uint32_t>(view.items.size()) + 2);
    act.name = act.item < view.items.size() && chance(0.9) ? view.items[act.item].name : word();
    act.number = chance(0.1) ? std::nan("") : between(-10.0, 1000.0);
    note("act", act.name);
    app().apply(ItemActed{act}, session_->now_s());
}

void Monkey::hand() {
    const std::size_t which = below(2);
    HandCommand command;
    command.mode = static_cast<HandMode>(below(4));
    const double reach_m = chance(0.1) ? 0.3 : 0.09;
    command.target_m = {between(-reach_m, reach_m), between(-reach_m, reach_m), between(-reach_m, reach_m)};
    command.speed_m_per_s = chance(0.05) ? 0.0 : between(0.02, chance(0.1) ? 20.0 : 1.0);
    command.push_n = {between(-5.0, 5.0), between(-5.0, 5.0), between(-5.0, 5.0)};
    command.buttons = chance(0.3) ? below(16) : 0;
    note("hand", fmt::format("{} mode {} to {:.3f} {:.3f} {:.3f}", which, static_cast<int>(command.mode),
                             command.target_m.x, command.target_m.y, command.target_m.z));
    session_->hand(which).command.publish(command);
    if (chance(0.2))
        app().apply(HandMoved{{between(-0.1, 0.1), between(-0.1, 0.1), between(-0.1, 0.1)}}, session_->now_s());
}

void Monkey::trouble() {
    DeviceTrouble trouble;
    const std::uint32_t kind = below(8);
    note("trouble", std::to_string(kind));
    switch (kind) {
        case 0:
            trouble.not_a_number_samples = 1 + static_cast<int>(below(6));
            break;
        case 1:
            trouble.jump_samples = chance(0.5) ? -1 : 3;
            trouble.jump_m = {between(-0.1, 0.1), between(-0.1, 0.1), between(-0.1, 0.1)};
            break;
        case 2:
            trouble.silent_samples = chance(0.3) ? -1 : static_cast<int>(below(200));
            break;
        case 3:
            trouble.unplugged = true;
            break;
        case 4:
            trouble.hot = true;
            break;
        case 5:
            trouble.failed = true;
            break;
        default:
            break;  // no trouble: the device works again
    }
    session_->hand(below(2)).trouble.publish(trouble);
    session_->slow_servo(chance(0.1) ? 1 + static_cast<int>(below(30)) : 1);
    session_->set_focus(!chance(0.1));
}

void Monkey::device() {
    HandFacts facts;
    const bool left = chance(0.3);
    if (chance(0.75)) {
        const auto specs = device_specs();
        facts.present = facts.simulated = true;
        facts.spec = chance(0.8) ? *find_device_spec(chance(0.5) ? "sim-t" : "sim-f")
                                 : specs[below(static_cast<std::uint32_t>(specs.size()))];
        if (!facts.spec.kinesthetic || !std::isfinite(facts.spec.peak_force_n)) facts.spec = *find_device_spec("sim-f");
    }
    note("device", fmt::format("{} {}", left ? "left" : "right", facts.present ? facts.spec.name : "none"));
    if (left) session_->give_left_hand(facts);
    else session_->change_hand(facts);
    facts_[left ? 1 : 0] = facts;
    if (chance(0.2)) app().apply(HandOffered{"simulated Touch"}, session_->now_s());
}

// Sets a random setting to a valid or an invalid value.
void Monkey::setting() {
    const SettingRow& row = settings_[below(static_cast<std::uint32_t>(settings_.size()))];
    if (row.key == "speech.language" && chance(0.8)) return;  // loading a language is slow and rarely finds a fault
    std::string value = row.value == "true" ? "false" : "true";
    const std::size_t to = row.range.find(" to ");
    double least = 0.0, most = 0.0;
    if (row.value != "true" && row.value != "false") {
        if (to != std::string::npos && parse_finite(row.range.substr(0, to), least) &&
            parse_finite(row.range.substr(to + 4), most))
            value = row.value.find('.') == std::string::npos
                        ? std::to_string(static_cast<long>(between(least, most + 0.99)))
                        : fmt::format("{:.3f}", between(least, most));
        else value = word();
    }
    if (chance(0.1)) value = word();
    note("setting", row.key + "=" + value);
    (void)app().apply(SettingSet{std::string(row.key), value}, session_->now_s());
}

void Monkey::world() {
    const std::shared_ptr<const Scene> scene = worlds_[below(static_cast<std::uint32_t>(worlds_.size()))];
    switch (below(4)) {
        case 0:
            note("world");
            app().apply(WorldEntered{make_ready(scene)}, session_->now_s());
            break;
        case 1: {
            note("place");
            const Aabb bounds = app().scene()->bounds_m;
            app().apply(
                Placed{{between(bounds.min_m.x - 2.0, bounds.max_m.x + 2.0),
                        between(bounds.min_m.y - 2.0, bounds.max_m.y + 2.0), between(bounds.min_m.z, bounds.max_m.z)},
                       between(-10.0, 10.0)},
                session_->now_s());
            break;
        }
        case 2:
            note("steer");
            app().apply(
                Steered{{between(-1.5, 1.5), between(-1.5, 1.5), chance(0.1) ? std::nan("") : between(-1.0, 1.0)}},
                session_->now_s());
            break;
        default:
            note("rest");
            app().apply(Steered{{}}, session_->now_s());
            break;
    }
    body_free_m_ = 0.0;
}

void Monkey::owner() {
    if (const auto wanted = app().requests().take_world()) {
        note("chosen", wanted->file.filename().string());
        app().apply(WorldEntered{make_ready(worlds_[below(static_cast<std::uint32_t>(worlds_.size()))])},
                    session_->now_s());
    }
    if (app().requests().take_first_set_up()) app().apply(SetUpOver{}, session_->now_s());
    (void)app().requests().take_set_up();
    if (app().requests().take_offered_hand() && !facts_[0].present) {
        facts_[0].present = facts_[0].simulated = true;
        facts_[0].spec = *find_device_spec("sim-t");
        session_->change_hand(facts_[0]);
    }
    if (app().requests().leave) begin();
}

void Monkey::one_act() {
    const double dice = between(0.0, 1.0);
    if (dice < 0.52) press_something();
    else if (dice < 0.70) key();
    else if (dice < 0.74) text();
    else if (dice < 0.80) line();
    else if (dice < 0.92) hand();
    else if (dice < 0.95) trouble();
    else if (dice < 0.96) device();
    else if (dice < 0.98) setting();
    else world();
}

bool Monkey::act() {
    one_act();
    owner();
    const double rest = between(0.0, 1.0);
    run(rest < 0.6 ? 0.005 : rest < 0.95 ? 0.06 : 0.5);
    check_places();
    if (chance(0.02)) expect_an_answer();
    if (speech_.empty > 0) fail("nothing is said, as a sentence");
    if (speech_.damaged > 0) fail("what is said is no UTF-8");
    return fault_.empty();
}

void Monkey::run(double seconds) {
    for (const double until = session_->now_s() + seconds; session_->now_s() < until - 1e-9 && fault_.empty();) {
        seconds_ += 1e-3;
        const double ceiling_n[] = {app().hand().tuning.force_ceiling_n, app().hand(1).tuning.force_ceiling_n};
        session_->advance();
        for (std::size_t which = 0; which < 2; ++which) {
            if (!facts_[which].present) continue;
            const ToolState& tool = session_->tool(which);
            // If the hand felt no force, or the force started to fade in again on this tick, the proxy may have
            // restarted at the hand, even inside a wall. Then the last check says nothing about it.
            Free& free = proxy_free_[which];
            if (tool.force_gain == 0.0 || free.gain == 0.0 || tool.force_gain < free.gain) free.known = false;
            free.gain = tool.force_gain;
            const double force_n = glm::length(tool.force_n),
                         most_n = std::min(ceiling_n[which], facts_[which].spec.peak_force_n);
            if (!(force_n <= most_n * (1.0 + 1e-12) + 1e-12))
                fail(fmt::format("a force of {} N on hand {}, where {} N is the ceiling", force_n, which, most_n));
            if (!is_finite(tool.proxy_m) || !is_finite(tool.hip_m))
                fail(fmt::format("the place of ball {} is not finite", which));
        }
        if (!is_finite(app().feet_m()) || !std::isfinite(app().heading_rad()))
            fail("the place of the body is not finite");
    }
}

// Checks that the proxies and the walker are still outside all solids. Skips proxies and walkers that were inside a
// solid before, or that something placed elsewhere.
void Monkey::check_places() {
    const std::shared_ptr<const HapticScene> touch = app().haptic_scene();
    for (std::size_t which = 0; which < 2; ++which) {
        const ToolState& tool = session_->tool(which);
        Free& free = proxy_free_[which];
        if (!touch || !facts_[which].present || tool.ticks == 0 || tool.scene_generation != touch->generation ||
            tool.desk.open) {
            free.known = false;
            continue;
        }
        const bool inside = solid_within(*touch, tool.proxy_m, -kInside_m);
        const bool must_be_free =
            free.known && free.generation == touch->generation && free.jump == tool.workspace_jump;
        if (must_be_free) ++done_["ball in its place"];
        if (inside && must_be_free)
            fail(fmt::format("ball {} came into a solid at {} {} {}", which, tool.proxy_m.x, tool.proxy_m.y,
                             tool.proxy_m.z));
        // A proxy that was just placed inside a solid does not feel that solid until the whole proxy has left it.
        const bool out =
            (must_be_free && !inside) || !solid_within(*touch, tool.proxy_m, app().hand(which).tuning.touch.radius_m);
        free = {out, touch->generation, tool.workspace_jump, tool.force_gain};
    }
    if (walls_of_ != app().scene()) {
        walls_of_ = app().scene();
        walls_ = walls_of_ ? std::make_unique<WalkerWorld>(still_part(*walls_of_)) : nullptr;
        body_free_m_ = 0.0;
    }
    if (!walls_) return;
    least_radius_m_ = std::min(least_radius_m_, app().settings().walk.body_radius_m);
    const WalkerSize size = walker_size(*walls_of_, least_radius_m_);
    const Vec3 feet = app().feet_m();
    const bool blocked = walls_->blocked(feet, {size.radius_m, size.height_m});
    if (blocked && body_free_m_ == size.radius_m)
        fail(fmt::format("the body came into a solid at {} {} {}", feet.x, feet.y, feet.z));
    body_free_m_ = blocked ? 0.0 : size.radius_m;
}

// Leaves every list, gives the window the keyboard focus, and checks that the program answers a query.
void Monkey::expect_an_answer() {
    session_->set_focus(true);
    // At most 120 times, because lists can open further lists.
    for (int i = 0; i < 120 && app().dialogue().is_open(); ++i) {
        // While input help is on, Escape only announces what Escape does. The test does not know whether input help is
        // on, so it tries Escape in both states.
        if (i % 45 == 15) session_->press(Command::InputHelp);
        session_->tap_key("Escape");
        run(0.02);
    }
    owner();
    if (app().dialogue().is_open())
        return fail(fmt::format("Escape does not leave what is open: {}", app().dialogue().view().title));
    static constexpr Command kQuestions[] = {
        Command::WhereAmI,    Command::Heading,    Command::AroundMe, Command::AheadOfMe, Command::ScaleBar,
        Command::Coordinates, Command::WhatIsThis, Command::Help,     Command::Exits,     Command::ProgressReport};
    const Command question = kQuestions[below(std::size(kQuestions))];
    note("question", std::string(info(question).word));
    const long before = speech_.lines;
    session_->press(question);
    app().apply(CommandUp{question}, session_->now_s());
    run(0.3);
    if (speech_.lines == before) fail(fmt::format("{} is not answered", info(question).word));
}

void Monkey::note(std::string kind, const std::string& what) {
    ++done_[kind];
    acts_.push_back(fmt::format("{:8.3f} s {} {}", session_ ? session_->now_s() : 0.0, kind, one_line(what)));
    if (acts_.size() > kStory) acts_.pop_front();
}

void Monkey::fail(std::string what) {
    if (fault_.empty()) fault_ = std::move(what);
}

std::string Monkey::story() const {
    std::string text = fault_ + "\nThe last acts:\n";
    for (const std::string& act : acts_) text += "  " + act + "\n";
    text += "What was said last:\n";
    for (const std::string& line : speech_.last) text += "  " + one_line(line) + "\n";
    return text;
}

}  // namespace handrail::test
