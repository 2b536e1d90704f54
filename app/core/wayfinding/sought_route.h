// Follows the planned route of a person who searches for a thing by ear. The class computes how far the thing still is,
// where the next turning is, and when the route must be planned again. So the tools respect walls, doors and storeys.
// Plain state and pure functions for the app thread. One update costs some 20 flops for each leg and one trace through
// the world, under half a microsecond in our house. A plan takes up to 5 ms there (seeking_cost). There is one plan for
// each request. Further plans follow only after the person has left the route or the world has changed, and at most
// once a second.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/navigation/route.h"

namespace handrail::core {

class SoughtRoute {
public:
    static constexpr double kPassed_m = 0.4;  // a turning nearer than this has been reached, and the next one follows
    // If the route is out of sight, it is planned again at this distance from it.
    static constexpr double kLeft_m = 1.2;
    // If the route is in sight, it is planned again at this distance from it.
    static constexpr double kFar_m = 3.0;
    static constexpr double kAgain_s = 1.0;  // least time between two plans
    // While the person moves, the reported distance approaches the distance along a new route by this share of the
    // movement.
    static constexpr double kEasing = 0.5;
    static constexpr double kValley_m = 0.6, kSlope = 0.7;
    static constexpr double kLeastTurn_rad = 0.35;

    // Forgets everything. Call it for another request.
    void clear() { *this = {}; }
    // Sets a route for a person at `at_m`. The reported distance stays continuous. `tail_m` is the distance from the
    // end of the route to the thing. `passages` are the doors and stairs of the route, which are turnings too. If
    // `points_m` has at most one point, there is no route.
    void plan(std::vector<Vec3> points_m, const std::vector<navigation::RoutePassage>& passages, double tail_m,
              const Vec3& at_m, double now_s);
    // Call it if planning found no route, or if the person is straight in front of the thing.
    void no_route(double now_s);
    bool known() const { return points_m_.size() >= 2; }
    bool tried() const { return tried_; }
    // Returns true if no route has been planned for this request or the person has left it, and the last attempt is not
    // too recent. `changed` is true if something in the world has moved.
    bool wants_plan(bool changed, double now_s) const;

    // Updates the position of the person. near_on_path() explains `height_counts` and `sees`. A jump is not treated as
    // a movement.
    void follow(const Vec3& at_m, double height_counts, const std::function<bool(const Vec3&)>& sees);
    double off_m() const { return off_m_; }
    // Returns the distance to the thing along the route. Near the route, the sideways distance adds only little, with a
    // smooth transition. So after a movement sideways, the person is neither nearer nor farther.
    double left_m() const { return back_m() + length_m_ - along_m_ + tail_m_; }
    // Returns the same distance as left_m(), but without a jump when the route is planned again.
    double announced_m() const { return left_m() + eased_m_; }
    // Returns the next turning, door or flight of stairs, or the end of the route if there is none.
    Vec3 next_turning_m() const;
    Vec3 ahead_m(double by_m) const;
    const std::vector<Vec3>& points_m() const { return points_m_; }

private:
    double back_m() const {
        return kSlope * (off_m_ < kValley_m ? off_m_ * off_m_ / (2.0 * kValley_m) : off_m_ - 0.5 * kValley_m);
    }

    std::vector<Vec3> points_m_;
    std::vector<double> turnings_m_;  // distances along the route, rising; the last one is the end of the route
    double length_m_ = 0.0, tail_m_ = 0.0;
    double along_m_ = 0.0, off_m_ = 0.0;
    double eased_m_ = 0.0;  // reported distance minus measured distance
    Vec3 at_m_{0.0};
    double planned_s_ = -1e9;
    bool tried_ = false, seen_ = true;
};

}  // namespace handrail::core
