// Where a ball ends that is drawn to the hand continuously: the reference that the renderer's proxy is compared with.
// Projected gradient flow of |ball - goal| in steps of at most 20 micrometres, long double, every thing judged by brute
// force at every step, no hierarchy, cache, warm start or look-ahead. Sources: the flow is the ideal of the god-object
// (Zilles & Salisbury 1995) with a radius (Ruspini et al. 1997). Slow on purpose: about 10 microseconds a step and
// triangle.
#pragma once

#include <vector>

#include "tests/support/brute_force.h"

namespace handrail::test {

class ReferenceProxy {
public:
    // The judge outlives the proxy. The ball starts free, not nearer to anything than its radius.
    ReferenceProxy(const BruteForce& judge, const Vec3& start_m, double radius_m)
        : judge_(judge), ball_(start_m), radius_(radius_m) {}

    // Moves the ball to rest for this goal and returns where it is.
    Vec3 follow(const Vec3& goal_m);
    // Puts the ball elsewhere, for a comparison of one tick.
    void place(const Vec3& ball_m) { ball_ = LVec(ball_m); }
    long steps() const { return steps_; }
    double work() const {
        return work_;
    }  // comparisons of all steps, about: solids are judged by trying every three of their planes

private:
    void look_around();

    const BruteForce& judge_;
    LVec ball_;
    long double radius_;
    long steps_ = 0;
    double work_ = 0.0;
    std::vector<const BruteForce::Thing*>
        near_;  // all that can be met before the ball is farther than kLook_m from looked_from_
    LVec looked_from_{0.0L};
    bool looked_ = false;
};

// About how many comparisons it takes to judge one thing.
double judging_work(const BruteForce::Thing& thing);

}  // namespace handrail::test
