// The part of Session for an instructor's lessons: it carries out what a teacher requests, and returns what a teacher
// sees. Use it on the app thread only.
#include <algorithm>

#include "app/core/session/session.h"
#include "app/core/world/wall_at_side.h"
#include "worlds/base/language.h"

namespace handrail::core {

void Session::teach(const TeacherActed& act, double now_s) {
    if (!state_.world.scene) return;
    using Kind = TeacherActed::Kind;
    switch (act.kind) {
        case Kind::Lead:
            lead_in_lesson(act, now_s);
            break;
        case Kind::Leave:
            guide_.leave_route();
            break;
        case Kind::Block:
        case Kind::Open: {
            const FeatureId door{static_cast<std::uint32_t>(std::clamp(act.number, 0.0, 4e9))};
            if (!state_.world.scene->find(door) || !movers_.doors.block(door, act.kind == Kind::Block)) break;
            std::erase(learn_.teaching.blocked, door);
            if (act.kind == Kind::Block) learn_.teaching.blocked.push_back(door);
            lay_blocked();
            break;
        }
        case Kind::End:
            guide_.limit_help({});
            guide_.leave_route();
            for (const FeatureId door : learn_.teaching.blocked) movers_.doors.block(door, false);
            learn_.teaching.blocked.clear();
            lay_blocked();
            learn_.teaching.exercise.take(act, now_s);
            break;
        default:
            learn_.teaching.exercise.take(act, now_s);
            break;
    }
    report_changes(now_s);
}

// If there is a hand, the lesson guides the hand. If there is none, the amount of guidance decides: from a half on, the
// lesson guides by words, below a half by the sound of the goal alone.
void Session::lead_in_lesson(const TeacherActed& act, double now_s) {
    constexpr double kByWords = 0.5;
    guide_.limit_help(std::clamp(act.number, 0.0, 1.0));
    guide_.leave_route();
    std::vector<Stop> stops;
    for (std::size_t i = 0; i < std::min(act.items.size(), act.places_m.size()); ++i)
        if (is_finite(act.places_m[i])) {
            Stop& stop = stops.emplace_back();
            stop.name = act.items[i];
            stop.place_m = act.places_m[i];
        }
    if (act.number <= 0.0 || stops.empty() || !where_.rooms.have(now_s)) return;
    const bool by_hand = guide_.may_lead_hand();
    if (by_hand || act.number >= kByWords) return guide_.go_along(stops, by_hand, now_s);
    guide_.call_from({stops.back().name, point_box(stops.back().place_m), kNoFeature});
    state_.events.report(Led{stops.back().name, LedBy::Beacon}, now_s);
}

// Makes routes avoid the blocked doors. Does nothing until the rooms are known.
void Session::lay_blocked() {
    if (!where_.rooms.found()) return;
    std::vector<Aabb> boxes;
    for (const FeatureId door : learn_.teaching.blocked)
        for (const Aabb& box : navigation::door_boxes(*where_.rooms.file_scene(), where_.rooms.graph(), door))
            boxes.push_back(box);
    where_.rooms.navigation().block(boxes);
}

LessonView Session::lesson_view() {
    const Arrivals::Turn looks(state_.context.arrivals, true);
    LessonView view;
    if (!state_.world.scene) return view;
    view.feet_m = feet_m();
    view.times_put = state_.avatar.times_put;
    view.heading_rad = state_.avatar.heading_rad;
    view.wall_m = wall_at_side_m(*state_.world.solids, view.feet_m);
    view.trails = walk_.by_ear.wall_at_side().has_value();
    view.rooms_known = where_.rooms.known();
    if (!view.rooms_known || where_.rooms.here() == navigation::kNothing) return view;
    view.room = navigation::own_name(where_.rooms.graph().rooms[where_.rooms.here()]);
    if (const navigation::Room& here = where_.rooms.graph().rooms[where_.rooms.here()]; here.given)
        view.room = here.name;
    const Progress progress = learn_.place.progress_in(where_.rooms.here());
    // Outdoors, the walls are the outer walls of the building, and nobody is expected to walk along all of them.
    if (!navigation::is_outside(where_.rooms.graph().rooms[where_.rooms.here()], where_.rooms.space(),
                                *where_.rooms.file_scene())) {
        view.perimeter_m = progress.perimeter_m;
        view.walls_share = progress.perimeter_share();
        view.walls = static_cast<int>(progress.walls.size());
        view.walls_done = static_cast<int>(std::count_if(progress.walls.begin(), progress.walls.end(),
                                                         [](const WallProgress& w) { return w.done(); }));
    }
    view.exits = progress.exits;
    view.exits_found = progress.exits_found;
    return view;
}

}  // namespace handrail::core
