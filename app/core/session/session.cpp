#include "app/core/session/session.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "app/core/context/device_settings.h"
#include "app/core/context/spotlight.h"
#include "app/core/dialogue/brief_words.h"
#include "app/core/world/world_now.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/scene/building_bounds.h"
#include "worlds/scene/honest_report.h"
#include "worlds/scene/lint.h"
#include "worlds/scene/models.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {
namespace {

// If an answer must wait for the rooms, typed lines wait this long for the answer.
constexpr double kAnswerFollows_s = 60.0;

}  // namespace

Session::Session(const settings::Settings& settings, const HandFacts& hand, const SessionOptions& options)
    : state_(settings, hand, options.executor, options.arrivals, options.rooms_kept) {
    wire();
    bodies_.make_engines(options.bodies);
    if (!options.records_in.empty()) {
        learn_.hunt.keep_records_in(options.records_in);
        labyrinth_.keep_records_in(options.records_in);
    }
    learn_.place.set_day(options.day);
    if (!options.languages_in.empty()) menu_.languages().find_in(options.languages_in);
    lay_device_overrides(state_.person.settings, state_.hands.right);
    desk_visit_.furnish();
    for (const std::string& problem : state_.person.keys.problems()) say(problem, cues::SpeechClass::Answer, 0.0);
}

void Session::enter_world(EnteringWorld world, const std::optional<Placed>& begins_at, double now_s) {
    settled_.give_up();
    keep_learnt(now_s);
    state_.avatar.walker.reset();
    shown_.hand_path.clear();
    // A background task destroys the data of the previous world, because that is slow.
    std::shared_ptr<RoomsOfWorld> rooms_left = where_.rooms.enter_world(std::move(world.file), std::move(world.ways));
    auto left = std::make_shared<
        std::tuple<std::shared_ptr<RoomsOfWorld>, std::shared_ptr<const Scene>, std::shared_ptr<const WalkerWorld>>>(
        std::move(rooms_left), std::move(state_.world.scene), std::move(state_.world.solids));
    settled_.begin([left = std::move(left)](const std::stop_token&) { return std::shared_ptr<const Scene>(); });
    state_.world.scene = std::move(world.scene);
    state_.world.building_m = building_bounds_m(*state_.world.scene);
    state_.world.thing_of_mover = std::move(world.thing_of_mover);
    where_.far.enter_world();
    where_.climbs.enter_world();
    where_.visits.enter_world();
    questions_.too_early.reset();
    // The additions come before the scene for the hand is made, because things with a mark are not simplified.
    take_additions();
    hand_.touch_view.enter_world(std::move(world.sharp), now_s);
    state_.world.movers.enter(state_.world.scene->movers);
    state_.world.solids = std::move(world.body);
    state_.avatar.walker = std::make_unique<Walker>(
        *state_.world.solids, walker_size(*state_.world.scene, state_.person.settings.walk.body_radius_m));
    state_.avatar.walker->place(world.feet_m);
    state_.world.home_feet_m = state_.avatar.walker->state().feet_m;
    state_.world.home_heading_rad = state_.avatar.heading_rad = state_.avatar.heading_goal_rad =
        wrap_angle(world.heading_rad);
    state_.world.begun_at = begins_at ? begins_at->name : std::string();
    if (begins_at) {
        state_.avatar.walker->place(begins_at->feet_m);
        state_.avatar.heading_rad = state_.avatar.heading_goal_rad = wrap_angle(begins_at->heading_rad);
    }
    state_.world.begun_feet_m = state_.avatar.walker->state().feet_m;
    bodies_.enter_world(std::move(world.moves_freely), now_s);
    soundscape_.enter(*state_.world.scene);
    learn_.place.enter_world(now_s);
    learn_.ways.enter_world();
    learn_.hunt.enter_world();
    learn_.teaching.exercise.enter_world();
    places_.lesson.enter_world();
    places_.why_no_route.enter_world();
    learn_.teaching.blocked.clear();
    labyrinth_.enter_world(now_s);
    // A labyrinth is seen from above.
    if (const bool game = labyrinth_.camera_m().has_value(); game != std::exchange(shown_.game, game))
        shown_.pictures = game ? Pictures::Plan : Pictures::Both;
    state_.lists.dialogue.close_all();  // The lists are closed, because they may refer to the old world.
    movers_.triggers.enter_world();
    walk_.walking.enter_world();
    walk_.cane.enter_world();
    state_.context.tick_s = now_s;
    ++state_.world.entered;

    publish_pose(now_s, PoseChange::Placed);
    if (!greeting_waits()) state_.context.announce(cues::SpeechTopic::Place, entering_text(), now_s, {.answers = true});
    if (const Scene& entered = *state_.world.scene;
        !greeting_waits() && entered.stated && !entered.stated->rooms.empty())
        say(honest_sentence(entered, honest_report(entered)), cues::SpeechClass::Answer, now_s);
    if (state_.person.settings.speech.crowding_hint)
        if (std::string crowded = crowded_view(*state_.world.scene); !crowded.empty())
            say(std::move(crowded), cues::SpeechClass::Answer, now_s);
    announce_additions(now_s);
    if (std::string game = labyrinth_.opening_words(); !game.empty())
        say(std::move(game), cues::SpeechClass::Answer, now_s);
    learn_.hunt.begin_awaited(now_s);
}

void Session::keep_learnt(double now_s) {
    if (state_.world.scene) learn_.place.keep(now_s);
    if (state_.additions_due_s) save_additions(now_s);
}

void Session::set_hand(const HandFacts& hand, const settings::Settings& settings, double now_s) {
    hand_.forces.take(hand);
    guide_.let_go();
    hand_.workspace.take_hand();
    desk_visit_.lay_out();
    change_settings(settings, now_s);
}

// Returns the name and size of the world, the person's place and direction, and hints, in at most kMostOnEntering
// words.
std::string Session::entering_text() const {
    constexpr std::size_t kMostOnEntering = 35;
    const Vec3 size = state_.world.building_m.empty() ? Vec3(0.0) : state_.world.building_m.size_m();
    const std::string world = sentence_case(spoken_name(*state_.world.scene));
    const bool named_large = size.x >= 0.5 && size.y >= 0.5;
    std::string first = named_large
                            ? phrase("session.world_of_size", {{"world", world}, {"wide", size.x}, {"deep", size.y}})
                            : world + ".";
    const bool hand = state_.hands.right.present && !state_.hands.right.simulated;
    std::string hints = phrase("session.where_help_is");
    // In a labyrinth, the arrow keys do not walk; the game says what they do.
    if (!shown_.game) hints = phrase(hand ? "session.begin_with_hand" : "session.begin_with_keys") + " " + hints;
    const std::size_t rest = kMostOnEntering - std::min(kMostOnEntering, count_words(first) + count_words(hints));
    return first + " " + where_.queries.where_am_i(std::min(rest, Queries::kMostWords)) + " " + hints;
}

void Session::press(Command command, double now_s, int times) {
    if (walk_.keys_held.held(command)) return;
    // Any key interrupts the present announcement, except keys that repeat the announcement and keys that stop speech
    // themselves.
    if (command != Command::Repeat && command != Command::HistoryBack && command != Command::HistoryForward &&
        command != Command::StopSpeech && command != Command::StopEverything)
        quiet(now_s);
    if (command != Command::Repeat && command != Command::StopSpeech) questions_.too_early.reset();
    hand_.workspace.note_command();
    if (lesson_session_.takes(command, now_s)) return;
    lesson_session_.note(command);
    if (info(command).hold && !bodies_.keeps(command) && !labyrinth_.keeps(command)) walk_.keys_held.press(command);
    act(command, now_s, times);
}

// Says again the announcements that were cut off, with their present content. What is no longer true is not said.
void Session::say_anew(cues::SpeechTopics topics, double now_s) {
    for (const cues::SpeechTopic topic : {cues::SpeechTopic::Praise, cues::SpeechTopic::Lesson})
        if (topics.has(topic)) lesson_session_.announce_anew(topic, now_s);
    if (!state_.world.scene) return;
    if (topics.has(cues::SpeechTopic::Place) && !guide_.tell_arrival_anew(cues::SpeechTopic::Place, now_s) &&
        !where_.rooms.announce_here_anew(now_s))
        state_.context.announce(cues::SpeechTopic::Place, where_am_i(), now_s, {.anew = true, .answers = true});
    if (topics.has(cues::SpeechTopic::Arrival)) guide_.tell_arrival_anew(cues::SpeechTopic::Arrival, now_s);
    for (const cues::SpeechTopic topic : {cues::SpeechTopic::Summary, cues::SpeechTopic::Leg})
        if (topics.has(topic)) guide_.announce_anew(topic, now_s);
}

void Session::release(Command command) {
    walk_.keys_held.release(command);
    bodies_.release(command);
}

void Session::set_focus(bool focused) {
    if (!focused) steer({});
    state_.hands.tuning.focused = focused;
    if (!focused) {
        walk_.keys_held.release_all();
        hand_.workspace.let_go();
    }
}

void Session::know_stops(std::uint32_t stops, double now_s) {
    if (hand_.forces.know_stops(stops)) act(Command::StopEverything, now_s);
}

bool Session::idle() const {
    if (!lesson_session_.idle() || state_.requests.set_up) return false;
    if (!menu_.reports().idle(state_.context.tick_s) || !places_.faults.idle()) return false;
    if (questions_.too_early && state_.context.tick_s - questions_.too_early->requested_s < kAnswerFollows_s)
        return false;
    return walk_.walking.idle() && walk_.cane.idle() && bodies_.idle() && hand_.workspace.idle() &&
           !walk_.keys_held.any();
}

void Session::act(Command command, double now_s, int times) {
    if (!state_.world.scene) return;
    if (desk_visit_.refuses(command, now_s)) return;
    where_.rooms.take_refused();  // Forgets refusals to other callers since the last command.
    carry_out(command, now_s, times);
    where_.far.note(command);
    if (where_.rooms.take_refused()) questions_.too_early = Questions::TooEarly{command, {}, now_s};
}

// Answers the question that was asked before the rooms were known.
void Session::answer_what_was_too_early(double now_s) {
    if (!questions_.too_early || where_.rooms.awaited()) return;
    const Questions::TooEarly requested = *std::exchange(questions_.too_early, std::nullopt);
    if (state_.lists.dialogue.is_open()) return;
    if (requested.command) act(*requested.command, now_s);
    else if (const auto wish = wish_in(requested.line)) grant(*wish, requested.line, now_s);
}

void Session::place(const Vec3& feet_m, double heading_rad, double now_s) {
    contract_pre(state_.world.scene != nullptr);
    contract_pre(is_finite(feet_m) && std::isfinite(heading_rad));
    walk_.walking.set_down(feet_m, heading_rad);
    publish_pose(now_s, PoseChange::Placed);
    ++state_.avatar.times_put;
    state_.events.report(Teleported{feet_m, state_.avatar.heading_rad}, now_s);
}

// Moves the walker and the hand out of a solid that contains them.
void Session::bring_out(double now_s) {
    const Vec3 workspace_was_m = hand_.workspace.middle_m();
    std::string said = walk_.walking.bring_out(now_s);
    const std::string of_hand = hand_.workspace.bring_out(workspace_was_m, !said.empty(), now_s);
    if (!said.empty() && !of_hand.empty()) said += ' ';
    said += of_hand;
    answer(said.empty() ? phrase("session.inside_nothing") : said, now_s);
}

// Replaces the scene of the same world after a thing was added or removed. Everything else continues.
void Session::change_world(Scene scene, double now_s) {
    settled_.give_up();
    state_.world.scene = std::make_shared<const Scene>(std::move(scene));
    hand_.touch_view.change_world(now_s);
}

// Call it when all things have come to rest. A background task makes a scene with their present positions, for finding,
// drawing and guiding. The solids for walking are already up to date.
void Session::settle() {
    settled_.begin([scene = state_.world.scene,
                    now = things_now(state_.world)](const std::stop_token&) -> std::shared_ptr<const Scene> {
        return std::make_shared<const Scene>(with_things(*scene, now));
    });
}

bool Session::anything_moves() const {
    return state_.world.things.moving() || state_.world.movers.any_moving() || bodies_.any_moving();
}

void Session::take_settled() {
    auto settled = settled_.take();
    if (!settled || !*settled) return;
    // If things move again, another scene will be made once they rest, so this scene would be useless.
    const bool in_vain = anything_moves();
    auto left = in_vain ? std::move(*settled) : std::exchange(state_.world.scene, std::move(*settled));
    if (!in_vain) {
        state_.world.movers.follow(state_.world.scene->movers);
        rebuild_solids(state_.world, state_.avatar);
    }
    // Destroying a whole world takes tens of milliseconds, so a background task does it.
    settled_.begin([left = std::move(left)](const std::stop_token&) { return std::shared_ptr<const Scene>(); });
}

Result<void> Session::add_thing(const std::string& name, std::shared_ptr<const Scene> model, const Placement& at,
                                const std::string& material, double now_s) {
    if (!state_.world.scene) return fail(phrase("session.no_world"));
    if (state_.world.scene->placed.size() >= render::HapticScene::kMostBodies)
        return fail(phrase("session.too_many_things", {{"count", state_.world.scene->placed.size()}}));
    auto changed = with_placed(world_now(state_.world), name, std::move(model), at, material);
    if (!changed) return tl::unexpected(changed.error());
    change_world(std::move(*changed), now_s);
    return {};
}

Result<void> Session::remove_thing(const std::string& name, double now_s) {
    if (!state_.world.scene) return fail(phrase("session.no_world"));
    auto changed = without_placed(world_now(state_.world), name);
    if (!changed) return tl::unexpected(changed.error());
    change_world(std::move(*changed), now_s);
    return {};
}

Result<void> Session::send_thing(const std::string& name, const Placement& to, double speed_m_per_s) {
    const int thing = state_.world.scene ? find_placed(*state_.world.scene, name) : -1;
    if (thing < 0) return fail(phrase("session.none_to_move", {{"name", name}}));
    if (!is_finite(to.position_m) || !std::isfinite(to.scale) || !(to.scale > 0.0) || !(speed_m_per_s > 0.0) ||
        !std::isfinite(speed_m_per_s))
        return fail(phrase("session.way_needs", {{"name", name}}));
    Placement there = to;
    there.rotation = normalized(to.rotation);
    state_.world.things.send(static_cast<std::size_t>(thing), there, speed_m_per_s);
    return {};
}

std::optional<Placement> Session::thing_at(const std::string& name) const {
    const int thing = state_.world.scene ? find_placed(*state_.world.scene, name) : -1;
    if (thing < 0) return std::nullopt;
    return state_.world.things.at(static_cast<std::size_t>(thing));
}

void Session::tick(double now_s, const servo::ToolState& tool, const servo::ToolState& left_tool) {
    contract_pre(std::isfinite(now_s));
    const Arrivals::Turn turn(state_.context.arrivals);
    state_.hands.tool = tool;
    state_.hands.left_tool = left_tool;
    if (!state_.world.scene) return;
    const double dt_s = std::clamp(now_s - state_.context.tick_s, 0.0, 0.1);
    state_.context.tick_s = now_s;
    report_changes(now_s);
    desk_visit_.tick(now_s);
    if (at_desk()) {
        // The world is paused: no thing moves, and the walker neither walks nor turns.
        hand_.workspace.move_hand_by_keys(dt_s);
        hand_.forces.tick(now_s);
        publish_pose(now_s, PoseChange::Walked);
        return;
    }
    movers_.doors.tick(now_s, dt_s);
    bodies_.tick(now_s);
    labyrinth_.tick(now_s);
    const bool mover_arrived = movers_.doors.take_arrived(), bodies_rest = bodies_.take_rested();
    if (state_.world.things.tick(now_s, dt_s) || mover_arrived || bodies_rest) {
        // Once all moving things are at rest, the scene gets their new positions.
        if (!anything_moves()) settle();
        rebuild_solids(state_.world, state_.avatar);
    } else if (anything_moves() || state_.world.movers.any_endless()) {
        rebuild_solids(state_.world, state_.avatar);
    }
    if (dt_s > 0.0) {
        hand_.workspace.move_hand_by_keys(dt_s);
        walk_.walking.tick(now_s, dt_s);
        walk_.cane.tick(now_s, dt_s);
    }
    hand_.forces.tick(now_s);
    lesson_session_.tick(now_s);
    learn_.teaching.exercise.tick();
    if (hand_.workspace.pushed(now_s)) guide_.person_moved(now_s);
    hand_.workspace.push(guide_.carry(), now_s);
    if (!guide_.leads_hand()) hand_.workspace.stay_with_walker(now_s);
    hand_.workspace.announce_motion(now_s);
    touch_events_.tick(now_s);
    movers_.triggers.tick(now_s);
    where_.rooms.tick(now_s);
    where_.far.tick();
    where_.climbs.tick(now_s);
    where_.visits.tick(where_.queries.take_queried_thing(), now_s);
    answer_what_was_too_early(now_s);
    hand_.workspace.take_touch(where_.rooms.looked_for(), greeting_waits(), now_s);
    take_settled();
    guide_.follow(now_s);
    walk_.walking.announce_walls(now_s);
    soundscape_.tick(*state_.world.solids, listener().ears_m, now_s, state_.cues.waiting,
                     {spotlight(state_.context), static_cast<std::size_t>(state_.person.settings.sound.most_at_once)});
    places_.marks.tick_button(now_s);
    guide_.lead(now_s);
    places_.marks.tick(now_s);
    places_.faults.tick(now_s);
    places_.why_no_route.tick(now_s);
    tick_additions(now_s);
    guide_.call(now_s);
    publish_pose(now_s, PoseChange::Walked);
    hand_.forces.announce_break(now_s);
}

void Session::report_changes(double now_s) {
    const auto report = [&](bool& reported, bool now, const auto& what) {
        if (std::exchange(reported, now) != now) state_.events.report(what, now_s);
    };
    const bool leads = guide_.leads(), open = state_.lists.dialogue.is_open();
    report(watched_.leads, leads, Leading{leads});
    report(watched_.list_open, open, ListShown{open});
}

void Session::set_left_hand(const HandFacts& hand, double now_s) {
    state_.hands.left = hand;
    state_.hands.left_tool = {};
    if (state_.world.scene) publish_pose(now_s, PoseChange::Moved);
}

HandOutput Session::hand(std::size_t which) const {
    const Workspace& workspace = hand_.workspace;
    const std::shared_ptr<servo::HandBodyServo>& engine = bodies_.hand_engine(which);
    if (which == 1) return {workspace.left_pose(), hand_.touch_view.left_tuning(), nullptr, Vec3(0.0), engine};
    return {workspace.pose(), state_.hands.tuning, &guide_.path(), workspace.hand_target_m(), engine};
}

cues::Listener Session::listener() const {
    return {state_.avatar.ears_m(), state_.avatar.heading_rad, soundscape_.reverberation_s()};
}

}  // namespace handrail::core
