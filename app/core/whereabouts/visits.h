// Which things a person visits, that is, stands still and touches, asks about or faces. Reported as ThingVisited, once
// for each stay at a thing. Walls, floors and the like do not count. App thread only.
#pragma once

#include "app/core/context/session_part.h"

namespace handrail::core {

class Visits : SessionPart {
public:
    static constexpr double kStood_s = 0.5;  // least time of standing for a visit
    static constexpr double kFaced_s = 1.5;  // least time for a faced thing
    static constexpr double kFaced_m = 1.2;  // from the walker's centre
    static constexpr double kLeft_m = 1.0;   // at this distance a visit is over

    explicit Visits(const SessionContext& context) : SessionPart(context) {}

    void enter_world();
    // Call it once a tick, after the context has the state of the hands. asked_about: since the last tick; kNoFeature:
    // nothing.
    void tick(FeatureId asked_about, double now_s);

private:
    bool is_thing(FeatureId feature) const;
    void visit(FeatureId feature, VisitedBy by, double now_s);
    FeatureId faced() const;

    Vec3 stands_m_{0.0};
    double stands_rad_ = 0.0, since_s_ = 0.0;  // present heading, and since when place and heading are unchanged
    bool looked_ = false;                      // the faced thing has been examined since then
    FeatureId last_ = kNoFeature;
    Vec3 last_m_{0.0};  // from where it was visited
};

}  // namespace handrail::core
