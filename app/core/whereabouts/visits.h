// Which things a person visits: stands still and touches, asks about or faces. Told as ThingVisited, once for each stay
// at a thing. Walls, floors and the like are no such things. App thread only.
#pragma once

#include "app/core/context/session_part.h"

namespace handrail {

class Visits : SessionPart {
public:
    static constexpr double kStood_s = 0.5;  // so long one has stood before it is a visit
    static constexpr double kFaced_s = 1.5;  // and so long before what is faced is meant
    static constexpr double kFaced_m = 1.2;  // from the middle of the body
    static constexpr double kLeft_m = 1.0;   // so far away a visit is over

    explicit Visits(const SessionContext& context) : SessionPart(context) {}

    void enter_world();
    // Once a tick, when the context knows what the hands feel. asked_about: since the tick before; kNoFeature: nothing.
    void tick(FeatureId asked_about, double now_s);

private:
    bool is_thing(FeatureId feature) const;
    void visit(FeatureId feature, VisitedBy by, double now_s);
    FeatureId faced() const;

    Vec3 stands_m_{0.0};
    double stands_rad_ = 0.0, since_s_ = 0.0;  // where and which way, and since when
    bool looked_ = false;                      // at what is faced, since then
    FeatureId last_ = kNoFeature;
    Vec3 last_m_{0.0};  // from where it was visited
};

}  // namespace handrail
