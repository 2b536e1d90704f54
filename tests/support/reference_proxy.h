// Computes where a proxy ends that is pulled to the hand continuously: the reference for the renderer's proxy. Uses
// projected gradient flow of |proxy - goal| in steps of at most 20 micrometres and in long double. Everything is judged
// by brute force at every step, without hierarchy, cache, warm start or look-ahead. Slow on purpose: about 10
// microseconds for each step and triangle. Sources: the flow is the ideal of the god-object (Zilles & Salisbury 1995)
// with a radius (Ruspini et al. 1997).
#pragma once

#include <vector>

#include "tests/support/brute_force.h"
#include "tests/support/names.h"

namespace handrail::test {

class ReferenceProxy {
public:
    // The judge outlives the proxy. The proxy starts free, no nearer to anything than its radius.
    ReferenceProxy(const BruteForce& judge, const Vec3& start_m, double radius_m)
        : judge_(judge), ball_(start_m), radius_(radius_m) {}

    // Moves the proxy until it rests for this goal, and returns its position.
    Vec3 follow(const Vec3& goal_m);
    // Moves the proxy elsewhere, for a comparison of one tick.
    void place(const Vec3& ball_m) { ball_ = LVec(ball_m); }
    long steps() const { return steps_; }
    double work() const {
        return work_;
    }  // The approximate number of comparisons in all steps; solids are judged by trying every three of their planes.

private:
    void look_around();

    const BruteForce& judge_;
    LVec ball_;
    long double radius_;
    long steps_ = 0;
    double work_ = 0.0;
    std::vector<const BruteForce::Thing*>
        near_;  // Everything that the proxy can meet before it is farther than kLook_m from looked_from_.
    LVec looked_from_{0.0L};
    bool looked_ = false;
};

// The approximate number of comparisons for judging one thing.
double judging_work(const BruteForce::Thing& thing);

}  // namespace handrail::test
