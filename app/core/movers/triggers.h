// Applies the effects of volumes that a walker enters: liquids, and volumes that announce something, start a mover or
// move the walker elsewhere. Use it on the app thread only.
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

    // The session sets this function. It is called when a teleporter moves the walker.
    std::function<void(const Vec3& feet_m, double heading_rad, double now_s)> on_leads_elsewhere;

private:
    void meet_switch(FeatureId volume, double now_s);

    WorldState& world_;
    std::vector<FeatureId> inside_;     // volumes that contain the walker
    std::vector<FeatureId> announced_;  // volumes whose text has been announced; each text is announced only once
    std::vector<FeatureId> used_;       // volumes that act only once and have acted
};

}  // namespace handrail::core
