// Places that one walks into: liquids, those that say something, and those that set something going or lead elsewhere.
// App thread only.
#pragma once

#include <functional>
#include <vector>

#include "app/core/context/session_part.h"

namespace handrail {

class Triggers : SessionPart {
public:
    // It sets the movers of `world` going.
    Triggers(const SessionContext& context, WorldState& world) : SessionPart(context), world_(world) {}

    void enter_world();
    void tick(double now_s);

    // Set by the session: a teleporter puts the body there.
    std::function<void(const Vec3& feet_m, double heading_rad, double now_s)> on_leads_elsewhere;

private:
    void meet_switch(FeatureId volume, double now_s);

    WorldState& world_;
    std::vector<FeatureId> inside_;  // volumes the body is in
    std::vector<FeatureId> told_;    // each speaks once
    std::vector<FeatureId> used_;    // that act only once
};

}  // namespace handrail
