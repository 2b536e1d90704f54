// Makes the walker follow routes. It walks along the last planned route, point after point, and opens the doors before
// which it stands.
#pragma once

#include <cmath>
#include <functional>

#include "tests/support/names.h"
#include "tests/unit/core/app_session.h"

namespace handrail::test {

// Walks along the route until `there` returns true, but at most for `seconds`. Returns true if the walker got there.
inline bool walk_along(AppSession& person, const std::function<bool()>& there, double seconds) {
    // The walker turns up to a hand's breadth before each point, so it cuts a corner by no more than that.
    constexpr double kAtPoint_m = 0.05, kStuck_s = 0.5, kDoorOpens_s = 2.5;
    Session& app = person.app;
    std::vector<Vec3> way;
    std::size_t at = 0;
    Vec3 was = app.feet_m();
    double moved_s = person.now;
    for (const double until = person.now + seconds; person.now < until && !there();) {
        if (way != app.guide().way_m()) {
            way = app.guide().way_m();
            at = 0;
        }
        const auto level = [&](const Vec3& to) { return Vec3(to.x - app.feet_m().x, to.y - app.feet_m().y, 0.0); };
        while (at < way.size() && glm::length(level(way[at])) < kAtPoint_m) ++at;
        if (at >= way.size()) {
            app.apply(Steered{{}}, person.now);
            person.run(0.1);
            continue;
        }
        const Vec3 to = level(way[at]);
        const double right_rad = wrap_angle(std::atan2(to.x, to.y) - app.heading_rad());
        app.apply(Steered{{std::cos(right_rad), std::sin(right_rad), std::clamp(2.0 * right_rad, -1.0, 1.0)}},
                  person.now);
        person.run(1.0 / 60.0);
        if (glm::length(app.feet_m() - was) > 0.05) {
            was = app.feet_m();
            moved_s = person.now;
        }
        if (person.now - moved_s < kStuck_s) continue;
        app.apply(Steered{{}}, person.now);
        person.request(Command::Use);
        person.run(kDoorOpens_s);
        moved_s = person.now;
    }
    app.apply(Steered{{}}, person.now);
    return there();
}

// Chooses a room in the list of routes and walks there. Returns true if the walker arrives.
inline bool go_to_room(AppSession& person, const std::string& room, double seconds) {
    person.request(Command::Routes);
    person.line(room);
    person.said.clear();
    person.bumped.clear();
    const std::string there = room + ". You are there.";
    return walk_along(
        person, [&] { return person.heard(there); }, seconds);
}

// Walks straight from place to place, without following a planned route. `run(seconds)` lets time pass and returns the
// time afterwards.
template <class Run>
void steer_along(Session& app, const std::vector<Vec3>& places, Run run) {
    double now_s = run(0.0);
    for (const Vec3& place : places)
        for (int frame = 0; frame < 600; ++frame) {
            const Vec3 off = place - app.feet_m();
            const double way_m = std::hypot(off.x, off.y);
            if (way_m < 0.1) break;
            app.apply(Steered{{off.y / way_m, off.x / way_m, 0.0}}, now_s);
            now_s = run(1.0 / 60.0);
        }
    app.apply(Steered{{}}, now_s);
    run(0.3);
}

}  // namespace handrail::test
