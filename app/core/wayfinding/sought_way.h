// Where on the planned way to a thing somebody is who looks for it by ear: how far it still is, where one turns next,
// and when the way must be planned anew. So the tools that lead by ear know walls, doors and storeys. Plain state and
// pure functions; app thread. One look costs some 20 flops a leg and a line through the world, under half a microsecond
// in our house; a plan takes up to 5 ms there (seeking_cost) and is made once for a wish, then only after one has left
// the way or the world has changed, at most once a second.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/navigation/route.h"

namespace handrail {

class SoughtWay {
public:
    static constexpr double kPassed_m = 0.4;  // of a turning: nearer, the next one counts
    static constexpr double kLeft_m = 1.2;    // off the way, where one does not see it: it is to be planned anew
    static constexpr double kFar_m = 3.0;     // where one does
    static constexpr double kAgain_s = 1.0;   // no sooner after the last plan
    static constexpr double kEasing = 0.5;  // of what one goes, by which the told distance comes nearer to a new way's
    static constexpr double kValley_m = 0.6, kSlope = 0.7;
    static constexpr double kLeastTurn_rad = 0.35;

    // Another wish: nothing is known yet.
    void clear() { *this = {}; }
    // A way from where one is, at `at_m`; the told distance goes on from what it was. tail_m: from its end to the
    // thing. `passages`: doors and stairs on it, where one listens anew as at a turning. One point or none: no way.
    void plan(std::vector<Vec3> points_m, const std::vector<RoutePassage>& passages, double tail_m, const Vec3& at_m,
              double now_s);
    // One tried and there was none, or one is straight before the thing.
    void no_way(double now_s);
    bool known() const { return points_m_.size() >= 2; }
    bool tried() const { return tried_; }
    // Never tried for this wish, or left; and not tried a moment ago. `changed`: something stands elsewhere.
    bool wants_plan(bool changed, double now_s) const;

    // Where one has come to; height_counts and `sees` as near_on_way has them. A jump is no going.
    void follow(const Vec3& at_m, double height_counts, const std::function<bool(const Vec3&)>& sees);
    double off_m() const { return off_m_; }
    // To the thing along the way. Beside it little more as long as one is near it: it is a valley without an edge, in
    // which aside is neither nearer nor farther.
    double left_m() const { return back_m() + length_m_ - along_m_ + tail_m_; }
    // The same, continuous where the way was planned anew.
    double told_m() const { return left_m() + eased_m_; }
    // Where one turns next, or goes through a door or over stairs; the end of the way where nothing comes any more.
    Vec3 next_turning_m() const;
    Vec3 ahead_m(double by_m) const;
    const std::vector<Vec3>& points_m() const { return points_m_; }

private:
    double back_m() const {
        return kSlope * (off_m_ < kValley_m ? off_m_ * off_m_ / (2.0 * kValley_m) : off_m_ - 0.5 * kValley_m);
    }

    std::vector<Vec3> points_m_;
    std::vector<double> turnings_m_;  // along it, rising; the last is its end
    double length_m_ = 0.0, tail_m_ = 0.0;
    double along_m_ = 0.0, off_m_ = 0.0;
    double eased_m_ = 0.0;  // what is told more than is measured
    Vec3 at_m_{0.0};
    double planned_s_ = -1e9;
    bool tried_ = false, seen_ = true;
};

}  // namespace handrail
