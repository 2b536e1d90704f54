// Detects which things a person visits: the person stands still and touches a thing, asks about it or faces it. Each
// stay at a thing is reported once as ThingVisited. Walls, floors and similar parts of the building are not reported.
// Use it on the app thread only.
#pragma once

#include "app/core/context/session_part.h"

namespace handrail::core {

class Visits : SessionPart {
public:
    static constexpr double kStood_s = 0.5;  // least time of standing still for a visit
    static constexpr double kFaced_s = 1.5;  // least time of facing a thing for a visit
    static constexpr double kFaced_m = 1.2;  // largest distance of a faced thing from the walker's centre
    static constexpr double kLeft_m = 1.0;   // a visit ends when the person has moved this far

    explicit Visits(const SessionContext& context) : SessionPart(context) {}

    void enter_world();
    // Reports visits as events. Call it once a tick, after the context has received the state of the hands.
    // `queried_thing` is what the person asked about since the last tick, or kNoFeature.
    void tick(FeatureId queried_thing, double now_s);

private:
    bool is_thing(FeatureId feature) const;
    void visit(FeatureId feature, VisitedBy by, double now_s);
    FeatureId faced() const;

    Vec3 stands_m_{0.0};
    // The present heading, and the time since which place and heading have been unchanged.
    double stands_rad_ = 0.0, since_s_ = 0.0;
    bool looked_ = false;  // true: the faced thing has been examined since `since_s_`
    FeatureId last_ = kNoFeature;
    Vec3 last_m_{0.0};  // place from which the person visited the last thing
};

}  // namespace handrail::core
