#include "app/core/session/session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/context/device_settings.h"
#include "app/core/dialogue/brief_words.h"
#include "app/core/world/world_now.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/scene/lint.h"
#include "worlds/scene/models.h"
#include "worlds/scene/surfaces.h"

namespace handrail {
namespace {}  // namespace

Session::Session(const Settings& settings, const HandFacts& hand) : person_(settings) {
    hands_.right = hand;
    wire();
    lay_device_overrides(person_.settings, hands_.right);
    desk_visit_.furnish();
    for (const std::string& problem : person_.keys.problems()) say(problem, SpeechClass::Answer, 0.0);
}

void Session::enter_world(EnteringWorld world, double now_s) {
    settled_.give_up();
    body_.walker.reset();
    // The world one leaves is let go of beside everything else.
    auto left = std::make_shared<std::pair<std::shared_ptr<const Scene>, std::shared_ptr<const BodyWorld>>>(
        std::move(world_.scene), std::move(world_.solids));
    if (touch_view_.beside())
        settled_.begin([left = std::move(left)](const std::stop_token&) { return std::shared_ptr<const Scene>(); });
    world_.scene = std::move(world.scene);
    world_.thing_of_mover = std::move(world.thing_of_mover);
    rooms_.enter_world(std::move(world.file));
    take_additions();  // before the hand's scene is made: what bears a mark is not simplified
    touch_view_.enter_world(std::move(world.sharp), now_s);
    world_.movers.enter(world_.scene->movers);
    world_.solids = std::move(world.body);
    body_.walker =
        std::make_unique<Walker>(*world_.solids, body_size(*world_.scene, person_.settings.walk.body_radius_m));
    body_.walker->place(world.feet_m);
    world_.home_feet_m = body_.walker->state().feet_m;
    world_.home_heading_rad = body_.heading_rad = body_.heading_goal_rad = wrap_angle(world.heading_rad);
    soundscape_.enter(*world_.scene);
    learning_.enter_world(now_s);
    hunt_.enter_world();
    lists_.dialogue.close_all();  // what it was about may be gone
    triggers_.enter_world();
    walking_.enter_world();
    context_.tick_s = now_s;
    ++world_.entered;

    publish_pose(now_s, PoseChange::Placed);
    if (!greeting_waits()) say(entering_text(), SpeechClass::Answer, now_s);
    if (person_.settings.speech.crowding_hint)
        if (std::string crowded = crowded_view(*world_.scene); !crowded.empty())
            say(std::move(crowded), SpeechClass::Answer, now_s);
    tell_additions(now_s);
    if (std::string news = greeting_waits() ? std::string() : touch_view_.news(); !news.empty())
        say(std::move(news), SpeechClass::Ambient, now_s);
    hunt_.begin_awaited(now_s);
}

void Session::set_hand(const HandFacts& hand, const Settings& settings, double now_s) {
    forces_.take(hand);
    guide_.let_go();
    workspace_.take_hand();
    desk_visit_.lay_out();
    change_settings(settings, now_s);
}

// What it is, how large, where one is and which way one faces, what to try: at most kMostOnEntering words.
std::string Session::entering_text() const {
    constexpr std::size_t kMostOnEntering = 35;
    const Vec3 size = world_.scene->bounds_m.empty() ? Vec3(0.0) : world_.scene->bounds_m.size_m();
    const std::string world = sentence_case(spoken_name(*world_.scene));
    const bool named_large = size.x >= 0.5 && size.y >= 0.5;
    std::string first = named_large
                            ? phrase("session.world_of_size", {{"world", world}, {"wide", size.x}, {"deep", size.y}})
                            : world + ".";
    std::string hints = phrase(hands_.right.present && !hands_.right.simulated ? "session.begin_with_hand"
                                                                               : "session.begin_with_keys") +
                        " " + phrase("session.where_help_is");
    const std::size_t rest = kMostOnEntering - std::min(kMostOnEntering, count_words(first) + count_words(hints));
    return first + " " + asking_.where_am_i(std::min(rest, Asking::kMostWords)) + " " + hints;
}

void Session::press(Command command, double now_s, int times) {
    if (keys_held_.held(command)) return;
    // Any key interrupts what is being said; Repeat wants it again, and Stop says so itself.
    if (command != Command::Repeat && command != Command::HistoryBack && command != Command::HistoryForward &&
        command != Command::StopSpeech && command != Command::StopEverything)
        quiet(now_s);
    if (lesson_session_.takes(command, now_s)) return;
    lesson_session_.note(command);
    if (info(command).hold) keys_held_.press(command);
    act(command, now_s, times);
}

void Session::release(Command command) { keys_held_.release(command); }

void Session::set_focus(bool focused) {
    if (!focused) walking_.steer({});
    hands_.tuning.focused = focused;
    if (!focused) {
        keys_held_.release_all();
        workspace_.let_go();
    }
}

void Session::know_stops(std::uint32_t stops, double now_s) {
    if (forces_.know_stops(stops)) act(Command::StopEverything, now_s);
}

bool Session::idle() const {
    if (!lesson_session_.idle() || calibration_asked_) return false;
    return walking_.idle() && workspace_.idle() && !keys_held_.any();
}

void Session::act(Command command, double now_s, int times) {
    if (!world_.scene) return;
    if (desk_visit_.refuses(command, now_s)) return;
    if (walking_.act(command, now_s, times) || workspace_.act(command, now_s) || forces_.act(command, now_s) ||
        learning_.act(command, now_s) || hunt_.act(command, now_s))
        return;
    switch (command) {
        case Command::WhereAmI:
        case Command::Heading:
        case Command::AroundMe:
        case Command::AheadOfMe:
        case Command::LookNext:
        case Command::LookBefore:
        case Command::ScaleBar:
        case Command::Coordinates:
        case Command::WhatIsThis:
            asking_.act(command, now_s);
            break;
        case Command::Simplified:
            simplified_list_.open(touch_view_.plan(), touch_view_.portals(), now_s);
            break;
        case Command::Repeat:
        case Command::HistoryBack:
        case Command::HistoryForward:
        case Command::StopSpeech: {
            CueRequest request;
            request.kind = command == Command::Repeat           ? CueRequestKind::Repeat
                           : command == Command::HistoryBack    ? CueRequestKind::HistoryBack
                           : command == Command::HistoryForward ? CueRequestKind::HistoryForward
                                                                : CueRequestKind::StopSpeech;
            request.time_s = now_s;
            cue(std::move(request));
            break;
        }
        case Command::StopEverything:
            if (forces_.stop(now_s)) walking_.fall_silent();
            break;
        case Command::BringOut:
            bring_out(now_s);
            break;
        case Command::LastPlace:
            ask_for_last_place(now_s);
            break;
        case Command::Use:
            doors_.act(command, now_s);
            break;
        case Command::DropMark:
        case Command::DeleteMark:
        case Command::Marks:
            mark_list_.act(command, now_s);
            break;
        case Command::Exits:
        case Command::UnvisitedExits:
        case Command::NameRoom:
            rooms_.act(command, now_s);
            break;
        case Command::SetBeacon:
        case Command::MuteBeacon:
        case Command::TakeMe:
        case Command::Find:
        case Command::CrossLines:
        case Command::Routes:
            guide_.act(command, now_s);
            break;
        case Command::Ways:
        case Command::KeepWay:
            kept_ways_.act(command, now_s);
            break;
        case Command::PlanView:
            plan_view_ = !plan_view_;
            rooms_.show_plan(plan_view_);
            answer(phrase(plan_view_ ? "session.plan" : "session.first_person"), now_s);
            break;
        case Command::Menu:
        case Command::Help:
        case Command::InputHelp:
        case Command::Language:
            menu_.act(command, now_s);
            break;
        case Command::Lessons:
        case Command::FirstMinutes:
            lesson_session_.act(command, now_s);
            break;
        case Command::NextSound:
            cue(dictionary_.step(1, listener(), now_s));
            break;
        case Command::LastSound:
            cue(dictionary_.step(-1, listener(), now_s));
            break;
        case Command::Callouts:
            person_.settings.walk.callouts = !person_.settings.walk.callouts;
            person_.changes.emplace_back("walk.callouts", person_.settings.walk.callouts ? "true" : "false");
            answer(phrase(person_.settings.walk.callouts ? "walking.callouts_on" : "walking.callouts_off"), now_s);
            break;
        case Command::VerbosityCycle:
            person_.settings.speech.verbosity = (person_.settings.speech.verbosity + 1) % 5;
            person_.changes.emplace_back("speech.verbosity", fmt::format("{}", person_.settings.speech.verbosity));
            answer(phrase("session.verbosity", {{"level", person_.settings.speech.verbosity}}), now_s);
            break;
        case Command::Calibrate:
            calibration_asked_ = true;
            break;
        case Command::Desk:
            desk_visit_.open_list(now_s);
            break;
        case Command::Leave:
            if (at_desk()) {
                publish_pose(now_s, PoseChange::Moved);  // a jump of the workspace ends the visit
            } else if (asked_to_leave_.lately(now_s)) {
                wants_to_leave_ = true;
                answer(phrase("session.goodbye"), now_s);
            } else {
                asked_to_leave_.at_s = now_s;
                answer(phrase("session.leave_again"), now_s);
            }
            break;
        default:  // done above
            break;
    }
}

void Session::place(const Vec3& feet_m, double heading_rad, double now_s) {
    contract_pre(world_.scene != nullptr);
    contract_pre(is_finite(feet_m) && std::isfinite(heading_rad));
    walking_.set_down(feet_m, heading_rad);
    publish_pose(now_s, PoseChange::Placed);
    events_.tell(Teleported{feet_m, body_.heading_rad}, now_s);
}

// The body out of what it stands in, and the hand.
void Session::bring_out(double now_s) {
    const Vec3 workspace_was_m = workspace_.middle_m();
    std::string said = walking_.bring_out(now_s);
    const std::string of_hand = workspace_.bring_out(workspace_was_m, !said.empty(), now_s);
    if (!said.empty() && !of_hand.empty()) said += ' ';
    said += of_hand;
    answer(said.empty() ? phrase("session.inside_nothing") : said, now_s);
}

// The same world with something added or removed: everything else goes on.
void Session::change_world(Scene scene, double now_s) {
    settled_.give_up();
    world_.scene = std::make_shared<const Scene>(std::move(scene));
    touch_view_.change_world(now_s);
}

// Everything has come to rest: where it is now is where it is found, drawn and led to. The walls that a body meets are
// there already.
void Session::settle(double) {
    if (touch_view_.beside()) {
        settled_.begin(
            [scene = world_.scene, now = things_now(world_)](const std::stop_token&) -> std::shared_ptr<const Scene> {
                return std::make_shared<const Scene>(with_things(*scene, now));
            });
        return;
    }
    world_.scene = std::make_shared<const Scene>(world_now(world_));
    world_.movers.follow(world_.scene->movers);
}

void Session::take_settled() {
    auto settled = settled_.take();
    if (!settled || !*settled || world_.things.moving() || world_.movers.any_moving())
        return;  // what moves again settles again
    auto left = std::exchange(world_.scene, std::move(*settled));
    world_.movers.follow(world_.scene->movers);
    rebuild_solids(world_, body_);
    settled_.begin([left = std::move(left)](const std::stop_token&) { return std::shared_ptr<const Scene>(); });
}

Result<void> Session::add_thing(const std::string& name, std::shared_ptr<const Scene> model, const Placement& at,
                                const std::string& material, double now_s) {
    if (!world_.scene) return fail(phrase("session.no_world"));
    if (world_.scene->placed.size() >= HapticScene::kMostBodies)
        return fail(phrase("session.too_many_things", {{"count", world_.scene->placed.size()}}));
    auto changed = with_placed(world_now(world_), name, std::move(model), at, material);
    if (!changed) return tl::unexpected(changed.error());
    change_world(std::move(*changed), now_s);
    return {};
}

Result<void> Session::remove_thing(const std::string& name, double now_s) {
    if (!world_.scene) return fail(phrase("session.no_world"));
    auto changed = without_placed(world_now(world_), name);
    if (!changed) return tl::unexpected(changed.error());
    change_world(std::move(*changed), now_s);
    return {};
}

Result<void> Session::send_thing(const std::string& name, const Placement& to, double speed_m_per_s) {
    const int thing = world_.scene ? find_placed(*world_.scene, name) : -1;
    if (thing < 0) return fail(phrase("session.none_to_move", {{"name", name}}));
    if (!is_finite(to.position_m) || !std::isfinite(to.scale) || !(to.scale > 0.0) || !(speed_m_per_s > 0.0) ||
        !std::isfinite(speed_m_per_s))
        return fail(phrase("session.way_needs", {{"name", name}}));
    Placement there = to;
    there.rotation = normalized(to.rotation);
    world_.things.send(static_cast<std::size_t>(thing), there, speed_m_per_s);
    return {};
}

std::optional<Placement> Session::thing_at(const std::string& name) const {
    const int thing = world_.scene ? find_placed(*world_.scene, name) : -1;
    if (thing < 0) return std::nullopt;
    return world_.things.at(static_cast<std::size_t>(thing));
}

void Session::tick(double now_s, const ToolState& tool, const ToolState& left_tool) {
    contract_pre(std::isfinite(now_s));
    hands_.tool = tool;
    hands_.left_tool = left_tool;
    if (!world_.scene) return;
    const double dt_s = std::clamp(now_s - context_.tick_s, 0.0, 0.1);
    context_.tick_s = now_s;
    desk_visit_.tick(now_s);
    if (at_desk()) {
        // The world waits: nothing moves, walks or turns.
        workspace_.move_hand_by_keys(dt_s);
        forces_.tick(now_s);
        publish_pose(now_s, PoseChange::Walked);
        return;
    }
    doors_.tick(now_s, dt_s);
    const bool mover_arrived = doors_.take_arrived();
    if (world_.things.tick(now_s, dt_s) || mover_arrived) {
        // From now on it is seen where it is, as soon as everything stands still again.
        if (!world_.things.moving() && !world_.movers.any_moving()) settle(now_s);
        rebuild_solids(world_, body_);
    } else if (world_.things.moving() || world_.movers.any_moving() || world_.movers.any_endless()) {
        rebuild_solids(world_, body_);
    }
    if (dt_s > 0.0) {
        workspace_.move_hand_by_keys(dt_s);
        walking_.tick(now_s, dt_s);
    }
    forces_.tick(now_s);
    lesson_session_.tick(now_s);
    if (workspace_.pushed(now_s)) guide_.person_moved(now_s);
    workspace_.push(guide_.carry(), now_s);
    workspace_.tell_motion(now_s);
    touch_events_.tick(now_s);
    triggers_.tick(now_s);
    rooms_.tick(now_s);
    workspace_.take_touch(rooms_.looked_for(), greeting_waits(), now_s);
    take_settled();
    guide_.follow(now_s);
    walking_.tell_walls(now_s);
    soundscape_.tick(*world_.solids, listener().ears_m, now_s, cues_.waiting);
    mark_list_.tick_button(now_s);
    guide_.lead(now_s);
    mark_list_.tick(now_s);
    guide_.call(now_s);
    publish_pose(now_s, PoseChange::Walked);
    forces_.tell_break(now_s);
}

void Session::set_left_hand(const HandFacts& hand, double now_s) {
    hands_.left = hand;
    hands_.left_tool = {};
    if (world_.scene) publish_pose(now_s, PoseChange::Moved);
}

Listener Session::listener() const { return {body_.ears_m(), body_.heading_rad, soundscape_.reverberation_s()}; }

ViewState Session::view(const ToolState& tool, const std::string& last_spoken) const {
    ViewState view;
    view.scene = world_.scene;
    view.feet_m = feet_m();
    view.eyes_m = view.feet_m + Vec3(0.0, 0.0, body_.walker->size().eye_height_m);
    view.heading_rad = body_.heading_rad;
    view.tilt_rad = walking_.tilt_rad();
    view.show_hand = hands_.right.present;
    view.proxy_m = tool.proxy_m;
    view.ball_radius_m = tool.ball_radius_m;
    view.touching = tool.touches();
    view.plan_view = plan_view_;
    view.forces_on = hands_.tuning.forces_on && hands_.tuning.focused && !hands_.tuning.panic;
    view.north_up = person_.settings.workspace.frame == FrameChoice::Map;
    view.last_spoken = last_spoken;
    view.path_m = walking_.path_m();
    if (plan_view_) view.rooms = rooms_.drawing(), view.room = rooms_.here();
    view.dialogue = lists_.dialogue.view();
    return view;
}

}  // namespace handrail
