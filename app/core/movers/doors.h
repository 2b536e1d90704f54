// Doors, lifts, buttons and trains: using them, moving them on with whoever stands on them, telling of them and of the
// shut ones across a way. How they stand belongs to the world. App thread only.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/world/mover_meeting.h"

namespace handrail {

class Doors : SessionPart {
public:
    // It moves the things of `world`, and of `body` what stands on one.
    Doors(const SessionContext& context, WorldState& world, BodyState& body);

    // Use. False: it is another's.
    bool act(Command command, double now_s);
    void tick(double now_s, double dt_s);
    // Something that moves by itself has come to its end since this was asked last.
    bool take_arrived() { return std::exchange(arrived_, false); }
    // By hand or by walking against it. back_again: one that is open goes back.
    void press(std::uint32_t mover, bool back_again, double now_s);

    // Whoever stands on a lift rides to where its floor is at that height, told as `storey`. False: on no lift, or on
    // one that stands there or does not stop there.
    bool ride_to(double floor_m, const std::string& storey, double now_s);

    // Shut, and not to be opened, whatever else would open it; or as before. False: that feature is none.
    bool block(FeatureId feature, bool blocked);
    bool blocked(std::uint32_t mover) const { return world_.movers.held_shut(mover); }

    // A shut door across the way is told once, with what opens it; again once it has been open.
    void tell_shut(FeatureId feature, double now_s);
    // Those that the hand touches.
    void tell_touched(double now_s);
    // Those that a body meets on a straight way there, soles.
    void tell_ahead(const Vec3& ahead_m, double now_s);
    // On another way they are told again.
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
    BodyState& body_;
    std::vector<FeatureId> told_;  // shut ones across the way
    bool arrived_ = false;
};

}  // namespace handrail
