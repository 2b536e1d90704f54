// Volumes that act on a walker who enters them: liquids, and volumes that announce something, start a mover or move the
// walker elsewhere. App thread only.
#pragma once

#include <functional>
#include <vector>

#include "app/core/context/session_part.h"

namespace handrail::core {

class Triggers : SessionPart {
public:
    // Starts the movers of `world`.
    Triggers(const SessionContext& context, WorldState& world) : SessionPart(context), world_(world) {}

    void enter_world();
    void tick(double now_s);

    // Set by the session. It is called when a teleporter moves the walker.
    std::function<void(const Vec3& feet_m, double heading_rad, double now_s)> on_leads_elsewhere;

private:
    void meet_switch(FeatureId volume, double now_s);

    WorldState& world_;
    std::vector<FeatureId> inside_;  // volumes that contain the walker
    std::vector<FeatureId> told_;    // volumes that have made their announcement; each makes it once
    std::vector<FeatureId> used_;    // volumes that act only once and have acted
};

}  // namespace handrail::core
