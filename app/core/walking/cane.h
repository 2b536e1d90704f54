// Probes the ground ahead with a virtual white cane. While the cane is out, it sweeps in step with the walker. The
// person can also sweep it with keys, with the hand or with the stick of a pad. The tip sounds like what it meets, and
// drops, steps and obstacles are announced when the tip finds them. Drops and stairs are then not announced from afar
// (Footing), so the person hears only what a cane would find. While the cane is put away, a tick costs one comparison.
// Use it on the app thread only.
#pragma once

#include <optional>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/dialogue/held_keys.h"
#include "app/core/walking/steering.h"
#include "app/core/world/cane_tip.h"

namespace handrail::core {

class Cane : SessionPart {
public:
    // Sets in `avatar` whether the cane is out.
    Cane(const SessionContext& context, WalkerState& avatar, const HeldKeys& keys)
        : SessionPart(context), avatar_(avatar), keys_(keys) {}

    // Forgets what the tip met, and keeps the cane out or put away.
    void enter_world();
    // Carries out the commands of the cane. Returns false if the command belongs to another feature.
    bool act(Command command, double now_s);
    // While the cane is out, the stick that otherwise turns the walker points the cane, and a pad in the hand swings
    // it. Returns what remains for walking.
    Steering take(const Steering& steering);
    // Sweeps the cane. Call it once a tick, after the walker has walked.
    void tick(double now_s, double dt_s);
    // Returns true if no sweep that the person has requested is under way.
    bool idle() const { return !goal_rad_; }

    // At both ends of the arc, the tip passes the body at this distance.
    static constexpr double kPastBody_m = 0.15;

private:
    double arc_rad() const;
    bool sweep_by_person(double now_s, double dt_s);
    void sweep_in_step(double walked_m, double now_s);
    void put(bool touches, double now_s);
    void announce(const CaneTip& tip, double now_s);
    void turn_at_shore(bool met_shore, double now_s);
    bool announce_once(const Vec3& place_m, double now_s);

    WalkerState& avatar_;
    const HeldKeys& keys_;
    double bearing_rad_ = 0.0;        // direction of the cane relative to the heading, to the right
    double side_ = 1.0;               // end of the arc to which the cane sweeps in step: 1 right, -1 left
    std::optional<double> goal_rad_;  // direction that the person has requested by a key
    // What the person moves the cane with.
    struct Held {
        double stick = 0.0;              // deflection of the stick, -1 to 1
        double swing_rad_per_s = 0.0;    // turn of a pad in the hand, to the right
        std::optional<double> hand_rad;  // direction of the hand relative to the heading in the last tick
        double until_s = -1e9;           // until then, the cane follows the person and does not sweep in step
    };
    Held held_;
    struct Met {
        CaneTip tip;
        bool known = false;
        Vec3 scraped_m{1e9};  // where the tip sounded last
    };
    Met met_;
    // The wall or edge that the technique Shoreline follows: the side of it, and whether the last sweep met it.
    struct Shore {
        double side = 0.0;  // 0: not chosen yet
        bool met = false;
    };
    Shore shore_;
    struct Announced {
        Vec3 place_m{0.0};
        double time_s = 0.0;
    };
    std::vector<Announced> announced_;
    // The walker's place in the last tick, and the distance since it last climbed or went down a step.
    Vec3 feet_m_{0.0};
    double since_step_m_ = 1e9;
};

}  // namespace handrail::core
