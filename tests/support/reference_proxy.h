// Computes where a proxy ends if the hand pulls it continuously. The result is the reference for the renderer's proxy.
// ReferenceProxy uses projected gradient flow of |proxy - goal|, in steps of at most 20 micrometres and in long double.
// Brute force judges all obstacles at every step, without hierarchy, cache, warm start or look-ahead. It is slow on
// purpose: about 10 microseconds for each step and triangle. Sources: the flow is the ideal of the god-object (Zilles &
// Salisbury 1995) with a radius (Ruspini et al. 1997).
#pragma once

#include <vector>

#include "tests/support/brute_force.h"
#include "tests/support/names.h"

namespace handrail::test {

class ReferenceProxy {
public:
    // The judge must outlive the proxy. The proxy starts free, no nearer to any obstacle than its radius.
    ReferenceProxy(const BruteForce& judge, const Vec3& start_m, double radius_m)
        : judge_(judge), proxy_(start_m), radius_(radius_m) {}

    // Moves the proxy until it rests for this goal, and returns its position.
    Vec3 follow(const Vec3& goal_m);
    // Places the proxy elsewhere, in order to compare a single tick.
    void place(const Vec3& proxy_m) { proxy_ = LVec(proxy_m); }
    long steps() const { return steps_; }
    // Returns the approximate number of comparisons in all steps. A solid is judged by trying every three of its
    // planes.
    double work() const { return work_; }

private:
    void look_around();

    const BruteForce& judge_;
    LVec proxy_;
    long double radius_;
    long steps_ = 0;
    double work_ = 0.0;
    std::vector<const BruteForce::Thing*>
        near_;  // All things that the proxy can meet before it is farther than kLook_m from looked_from_.
    LVec looked_from_{0.0L};
    bool looked_ = false;
};

// Returns the approximate number of comparisons for judging one thing.
double judging_work(const BruteForce::Thing& thing);

}  // namespace handrail::test
