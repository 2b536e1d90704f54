// Operates doors, lifts, buttons and trains. This class moves them together with a walker who stands on them, and
// announces them. It also announces shut doors on the route. WorldState owns their positions. Use this class on the app
// thread only.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/world/mover_meeting.h"

namespace handrail::core {

class Doors : SessionPart {
public:
    // Moves the things of `world`. Moves the walker in `body` if the walker stands on one of them.
    Doors(const SessionContext& context, WorldState& world, WalkerState& avatar);

    // Carries out the command Use. Returns false for other commands.
    bool act(Command command, double now_s);
    void tick(double now_s, double dt_s);
    // Returns true if anything that moves automatically has arrived since the last call.
    bool take_arrived() { return std::exchange(arrived_, false); }
    // Operates a mover that was pressed by the hand or by a walker who walked against it. If `back_again` is true and
    // the mover is an open door, this function closes it.
    void press(std::uint32_t mover, bool back_again, double now_s);

    // Sends the lift on which the walker stands to this floor height, and announces it as `storey`. Returns false if
    // the walker is not on a lift, or if the lift is already there or does not stop there.
    bool ride_to(double floor_m, const std::string& storey, double now_s);

    // Keeps a door shut against everything that would open it. If `blocked` is false, no longer does so. Returns false
    // if the feature is not a mover.
    bool block(FeatureId feature, bool blocked);
    bool blocked(std::uint32_t mover) const { return world_.movers.held_shut(mover); }

    // Announces once that a door on the route is shut, and what opens it. If the door has been open in between,
    // announces it again. A door that the person has just shut is not announced.
    void announce_shut(FeatureId feature, double now_s);
    // Announces shut doors that the hand touches.
    void announce_touched(double now_s);
    // Announces shut doors on the straight line from the walker to `ahead_m`, at floor level.
    void announce_ahead(const Vec3& ahead_m, double now_s);
    // Forgets which shut doors were announced, so that they are announced again. Call it when there is another route.
    void forget_announced() {
        announced_.clear();
        shut_by_person_ = kNoFeature;
    }

    // Returns the door that the announced directions tell the person to open or to shut, or kNoFeature. May be empty.
    std::function<FeatureId()> of_leg;

private:
    int lift_under_walker() const;
    int door_of_leg() const;
    int leaf_at_walker() const;
    void use(double now_s);
    std::string shut_words(std::uint32_t mover) const;
    Meeting meet(std::uint32_t mover, const Placement& from, const Placement& to);
    void announce(std::span<const MoverEvent> events, double now_s);
    void announce_endless(const MoverEvent& event, const Aabb& box_m, double now_s);

    WorldState& world_;
    WalkerState& avatar_;
    std::vector<FeatureId> announced_;       // shut doors on the route that have been announced
    FeatureId shut_by_person_ = kNoFeature;  // the door that the person shut last, until it is opened
    bool arrived_ = false;
};

}  // namespace handrail::core
