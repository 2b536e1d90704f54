// Doors, lifts, buttons and trains: uses them, moves them together with a walker who stands on them, and announces them
// and shut doors on the route. Their positions belong to the world. App thread only.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/world/mover_meeting.h"

namespace handrail::core {

class Doors : SessionPart {
public:
    // Moves the things of `world`, and in `body` the walker if it stands on one.
    Doors(const SessionContext& context, WorldState& world, WalkerState& body);

    // Handles Use. Returns false for other commands.
    bool act(Command command, double now_s);
    void tick(double now_s, double dt_s);
    // True if anything that moves automatically has arrived since the last call.
    bool take_arrived() { return std::exchange(arrived_, false); }
    // Pressed by hand or by walking against it. back_again: an open door closes again.
    void press(std::uint32_t mover, bool back_again, double now_s);

    // Sends the lift under the walker to this floor height, announced as `storey`. Returns false if the walker is on no
    // lift, or the lift is there already or does not stop there.
    bool ride_to(double floor_m, const std::string& storey, double now_s);

    // Keeps a door shut, whatever would otherwise open it, or ends that. Returns false if the feature cannot move.
    bool block(FeatureId feature, bool blocked);
    bool blocked(std::uint32_t mover) const { return world_.movers.held_shut(mover); }

    // Announces a shut door on the route once, with what opens it; again after it has been open.
    void tell_shut(FeatureId feature, double now_s);
    // Announces the shut doors that the hand touches.
    void tell_touched(double now_s);
    // Announces the shut doors on the straight path of the walker to this place, at floor level.
    void tell_ahead(const Vec3& ahead_m, double now_s);
    // Call it on another route: shut doors are announced again.
    void forget_told() { told_.clear(); }

private:
    int lift_under_body() const;
    int leaf_at_body() const;
    void use(double now_s);
    std::string shut_words(std::uint32_t mover) const;
    Meeting meet(std::uint32_t mover, const Placement& from, const Placement& to);
    void tell(std::span<const MoverEvent> events, double now_s);
    void tell_endless(const MoverEvent& event, const Aabb& box_m, double now_s);

    WorldState& world_;
    WalkerState& body_;
    std::vector<FeatureId> told_;  // announced shut doors on the route
    bool arrived_ = false;
};

}  // namespace handrail::core
