// Where a person who searches for a thing by ear is on the planned route: how far it still is, where the next turning
// is, and when the route must be planned again. Tools that guide by ear thus respect walls, doors and storeys. Plain
// state and pure functions; app thread. One update costs some 20 flops for each leg and a line through the world, under
// half a microsecond in our house. A plan takes up to 5 ms there (seeking_cost). It is made once for each request, then
// only after the person has left the route or the world has changed, and at most once a second.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/navigation/route.h"

namespace handrail::core {

class SoughtRoute {
public:
    static constexpr double kPassed_m = 0.4;  // distance to a turning; nearer, the next one counts
    static constexpr double kLeft_m = 1.2;    // off the route, if it is not in sight: then it is planned again
    static constexpr double kFar_m = 3.0;     // the same, if it is in sight
    static constexpr double kAgain_s = 1.0;   // least time between two plans
    // Share of the movement by which the reported distance approaches that of a new route.
    static constexpr double kEasing = 0.5;
    static constexpr double kValley_m = 0.6, kSlope = 0.7;
    static constexpr double kLeastTurn_rad = 0.35;

    // Another request: nothing is known yet.
    void clear() { *this = {}; }
    // Sets a route from the person's place `at_m`; the reported distance continues smoothly. tail_m: from its end to
    // the thing. `passages`: its doors and stairs, which count as turnings. One point or none: no route.
    void plan(std::vector<Vec3> points_m, const std::vector<navigation::RoutePassage>& passages, double tail_m,
              const Vec3& at_m, double now_s);
    // Planning found no route, or the person is straight before the thing.
    void no_way(double now_s);
    bool known() const { return points_m_.size() >= 2; }
    bool tried() const { return tried_; }
    // True if no route was planned for this request or it was left, and the last attempt is not too recent. `changed`:
    // something has moved.
    bool wants_plan(bool changed, double now_s) const;

    // Updates the place of the person; height_counts and `sees` as in near_on_way. A jump does not count as movement.
    void follow(const Vec3& at_m, double height_counts, const std::function<bool(const Vec3&)>& sees);
    double off_m() const { return off_m_; }
    // Distance to the thing along the route. Close to the route, the distance sideways adds only little. The function
    // has no edge there, so that moving sideways is neither nearer nor farther.
    double left_m() const { return back_m() + length_m_ - along_m_ + tail_m_; }
    // The same, but continuous when the route is planned again.
    double told_m() const { return left_m() + eased_m_; }
    // The next turning, door or flight of stairs; the end of the route if none is left.
    Vec3 next_turning_m() const;
    Vec3 ahead_m(double by_m) const;
    const std::vector<Vec3>& points_m() const { return points_m_; }

private:
    double back_m() const {
        return kSlope * (off_m_ < kValley_m ? off_m_ * off_m_ / (2.0 * kValley_m) : off_m_ - 0.5 * kValley_m);
    }

    std::vector<Vec3> points_m_;
    std::vector<double> turnings_m_;  // along the route, rising; the last is its end
    double length_m_ = 0.0, tail_m_ = 0.0;
    double along_m_ = 0.0, off_m_ = 0.0;
    double eased_m_ = 0.0;  // reported distance minus measured distance
    Vec3 at_m_{0.0};
    double planned_s_ = -1e9;
    bool tried_ = false, seen_ = true;
};

}  // namespace handrail::core
