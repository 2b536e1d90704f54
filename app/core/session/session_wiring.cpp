// Connects the features with each other and with the session: it sets what features may request of the session, and
// which other features get their events. Use it on the app thread only.
#include <cmath>

#include "app/core/menu/setting_lists.h"
#include "app/core/session/session.h"
#include "app/core/whereabouts/room_things.h"
#include "app/core/world/questions.h"
#include "worlds/base/language.h"

namespace handrail::core {

void Session::wire() {
    state_.context.session_requests.save_additions = [this](double now_s) { return save_additions(now_s); };
    state_.context.session_requests.place = [this](const Vec3& feet_m, double heading_rad, double now_s) {
        place(feet_m, heading_rad, now_s);
    };
    state_.context.session_requests.move_base = [this](const Vec3& feet_m, double heading_rad) {
        state_.world.home_feet_m = feet_m;
        state_.world.home_heading_rad = heading_rad;
    };
    state_.context.session_requests.perform = [this](Command command, double now_s) {
        press(command, now_s);
        release(command);
    };
    state_.context.session_requests.set = [this](std::string_view key, const std::string& value, double now_s) {
        return set(key, value, now_s);
    };
    where_.rooms.on_known = [this](double now_s) {
        places_.ways.announce_unfit(now_s);
        if (!learn_.teaching.blocked.empty()) lay_blocked();
    };
    where_.rooms.on_renamed = [this](const std::string& before, const std::string& name) {
        places_.ways.follow_room_name(before, name);
    };
    places_.ways.on_go = [this](const std::vector<Stop>& stops, bool by_hand, double now_s) {
        guide_.go_along(stops, by_hand, now_s);
    };
    places_.lesson.routes = [this] {
        std::vector<PrepareLesson::Offer> routes;
        for (KeptRoutes::Offer& offer : places_.ways.offers())
            routes.push_back({std::move(offer.name), std::move(offer.stops)});
        return routes;
    };
    learn_.teaching.exercise.on_prepare = [this](double now_s) { places_.lesson.open(now_s); };
    places_.groups.on_felt = [this](double now_s) { hand_.touch_view.change_world(now_s); };
    places_.labels.on_material = [this](double now_s) { hand_.touch_view.change_world(now_s); };
    places_.faults.on_landmark = [this](FeatureId thing, double now_s) { places_.labels.make_landmark(thing, now_s); };
    places_.faults.on_find = [this](const Goal& place, double now_s) { guide_.open_tools(place, now_s); };
    places_.marks.on_find = [this](const Goal& mark, double now_s) { guide_.open_tools(mark, now_s); };
    // The rows above the marks are the beacon and the amount of guidance.
    places_.marks.rows_above = [this] {
        const auto help = [this] { return phrase("guide.percent", {{"percent", std::lround(100.0 * guide_.help())}}); };
        const std::string beacon = guide_.beacon().on() ? guide_.beacon().name() : phrase("setting_value.off");
        const auto change_help = [this, help](int by) {
            guide_.change_help(by);
            return help();
        };
        return std::vector<MarkList::Row>{
            {{phrase("guide.beacon"), beacon}, [this](double now_s) { guide_.act(Command::MuteBeacon, now_s); }},
            {{phrase("guide.help"), help(), true},
             [this](double now_s) { (void)guide_.act(Command::TakeMe, now_s); },
             change_help}};
    };
    movers_.triggers.on_leads_elsewhere = [this](const Vec3& feet_m, double heading_rad, double now_s) {
        place(feet_m, heading_rad, now_s);
        play(cues::SoundKind::FrameSwitch, now_s);
        answer(phrase("movers.elsewhere") + " " + where_am_i(), now_s);
    };
    learn_.place.on_go_to_room = [this](std::uint32_t room, double now_s) { guide_.go_to_room(room, now_s); };
    state_.events.on_reported = [this](const SessionEvent& event) { learn_.ways.see(event); };
    questions_.answers.learns = [this] { return learn_.place.guides(); };
    guide_.on_face = [this](double heading_rad, double now_s) { walk_.walking.face(heading_rad, now_s); };
    guide_.on_leap = [this] { walk_.by_ear.keep_place(); };
    where_.climbs.on_way = [this] { return guide_.climb_here(); };
    guide_.on_no_route = [this](std::uint32_t room, double) { places_.why_no_route.look(room); };
    walk_.walking.line_up_m = [this](const Vec3& feet_m, double heading_rad) {
        return guide_.line_up_m(feet_m, heading_rad);
    };
    walk_.by_ear.where_am_i = [this] { return where_am_i(); };
    walk_.by_ear.doors_of_room = [this] {
        std::vector<LeapDoor> doors;
        for (const RoomDoor& door : doors_of_room(state_.context, where_.rooms))
            doors.push_back({door.feature, door.place_m, door.feet_m});
        return doors;
    };
    walk_.walking.push_ahead = [this](Vec3& intended_m_per_s, double now_s) {
        return bodies_.push_ahead(intended_m_per_s, now_s);
    };
    walk_.walking.on_walked = [this](const WalkResult& walked, double now_s) {
        if (walked.held_at_edge) guide_.note_stop(kNoFeature);
        learn_.place.note(walked.bump ? std::optional(walked.bump->normal) : std::nullopt, walk_.by_ear.wall_at_side(),
                          now_s);
        learn_.hunt.tick(now_s);
        learn_.place.tick(now_s);
        learn_.ways.tick(now_s);
    };
    walk_.walking.on_bumped = [this](FeatureId feature, double now_s) {
        lesson_session_.note_bump(feature);
        guide_.note_stop(feature);
        // In games, a walker who walks against a button presses the button.
        if (const int met = mover_of(state_.world, feature);
            met >= 0 && state_.world.scene->features[feature.value].kind == FeatureKind::Button)
            movers_.doors.press(static_cast<std::uint32_t>(met), false, now_s);
        if (!lock_words(state_.context, feature).empty()) movers_.doors.announce_shut(feature, now_s);
    };
    hand_.touch_view.openings = [this] {
        if (where_.rooms.awaited()) return KnownOpenings{{}, true};
        // Use found() instead of known(), which needs the movers of the world and the positions of its door leaves.
        // These are not available yet when a world has just been entered.
        return KnownOpenings{where_.rooms.found() ? open_portals(where_.rooms.graph()) : OpenPortals{}, false};
    };
    hand_.workspace.in_room_of_walker = [this](const Vec3& place_m) {
        if (!where_.rooms.found()) return false;
        const auto above_m = above_floor_m(*state_.world.solids, place_m);
        if (!above_m) return false;
        const auto room = [this](const Vec3& soles_m) {
            return navigation::room_at(where_.rooms.graph(), where_.rooms.space(), soles_m);
        };
        const std::uint32_t hand = room(place_m - Vec3(0.0, 0.0, *above_m));
        return hand != navigation::kNothing && hand == room(feet_m());
    };
    hand_.workspace.rests_silently = [this] { return guide_.take_carried(); };
    state_.lists.before_open = [this] {
        walk_.keys_held.release_all();
        walk_.walking.halt();
    };
    desk_visit_.where_am_i = [this] { return where_am_i(); };
    desk_visit_.progress = [this](double now_s) { return learn_.place.progress_words(now_s); };
    desk_visit_.beacon = [this] { return guide_.beacon().on() ? std::optional(guide_.beacon().name()) : std::nullopt; };
    desk_visit_.on_beacon = [this](const Mark* mark) {
        if (!mark) return void(guide_.end(Guidance::Beacon));
        guide_.call_from({mark->name, point_box(mark->place_m), kNoFeature});
    };
    desk_visit_.on_come = [this] {
        walk_.keys_held.release_all();
        walk_.walking.halt();
        state_.avatar.heading_goal_rad = state_.avatar.heading_rad;
    };
    desk_visit_.on_back = [this](const std::optional<std::string>& scale, double now_s) {
        settings::Settings changed = state_.person.settings;
        if (scale && settings::change_setting(changed, "workspace.scale", *scale))
            follow("workspace.scale", changed, now_s);
        if (hand_.touch_view.stale()) follow("haptic.simplify", state_.person.settings, now_s);
    };
    lesson_session_.beacon_calls = [this] { return guide_.beacon().on(); };
    lesson_session_.at_beacon = [this] {
        const Vec3 way = nearest_place(guide_.beacon().thing_m(), feet_m()) - feet_m();
        return std::hypot(way.x, way.y) <= Beacon::kArrived_m;
    };
    lesson_session_.world_greeting = [this] { return entering_text(); };
    lesson_session_.on_begin_here = [this](double now_s) { publish_pose(now_s, PoseChange::Placed); };
    // The hunt takes place in the bundled house. If there is no such house, it takes place in the present world.
    lesson_session_.on_hunt = [this](double now_s) {
        const auto house = menu_.worlds().bundled("house");
        if (!house) {
            learn_.hunt.act(Command::Hunt, now_s);
            return;
        }
        learn_.hunt.await_world();
        menu_.worlds().go_to(*house);
    };
    lesson_session_.on_worlds = [this](double now_s) { menu_.worlds().open(now_s); };
    lesson_session_.on_settings = [this](double now_s) { open_setting_topics(state_.context, now_s); };
    simplified_list_.on_choose = [this](const Goal& goal, double now_s) { guide_.open_tools(goal, now_s); };
}

}  // namespace handrail::core
