// The ground under and before the feet. It announces stairs, ramps, drops and doors ahead, and stops the walker at an
// edge until the person asks twice. App thread only; world metres.
#pragma once

#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/walking/paces.h"
#include "app/core/world/hazards.h"
#include "app/core/world/walker.h"

namespace handrail::core {

class Footing : SessionPart {
public:
    // Holds `body` back at edges.
    Footing(const SessionContext& context, WalkerState& body) : SessionPart(context), body_(body) {}

    void enter_world();
    // Call it after the walker was placed elsewhere in the same world. What was announced lately is not repeated.
    void set_down();
    // Call it with every command before it acts. A walking key pressed at an edge permits the walker to cross it.
    void notice(Command command, double now_s);
    // Moves the walker back to `before` if it is over a drop that was not confirmed, and returns true. The steps to the
    // edge are announced with it.
    bool held_at_edge(const WalkerMotion& before, Paces& paces, double now_s);
    // Call it each tick while the walker stands: announces changes of the ground. before_m: its place in the last tick.
    void tick(const Vec3& before_m, const WalkResult& walked, double now_s);
    // Pitch of footsteps: higher uphill.
    double step_pitch() const { return underfoot_.step_pitch; }

private:
    bool tell_place_once(const Vec3& place_m, bool drop, double now_s);
    void tell_underfoot(const Vec3& moved_m, const WalkResult& walked, double now_s);
    void tell_ahead(double now_s);
    void beat_ahead(double now_s);

    // The ground ahead, examined after the walker has moved or turned.
    struct Looked {
        GroundAhead ahead;
        Vec3 from_m{0.0};
        double heading_rad = 0.0, at_s = -1e9;
        double moved_s = -1e9;  // when the walker last walked or turned
        double beat_s = -1e9, door_s = -1e9;
    };
    struct Edge {
        bool held = false;       // stopped; announced once for each press
        double at_s = -1e9;      // time of the stop
        bool confirmed = false;  // the next edge may be crossed
    };
    struct Underfoot {
        int risers = 0;  // since the stairs began, positive upwards
        double since_riser_m = 0.0;
        double ramp_m = 0.0;  // distance walked on the ramp; level ground reduces it
        int ramp_told = 0;    // announced: 1 up, -1 down
        double step_pitch = 1.0;
    };
    struct Told {
        Vec3 place_m{0.0};
        double time_s = 0.0;
        bool drop = false;
    };

    WalkerState& body_;
    Looked looked_;
    Edge edge_;
    Underfoot underfoot_;
    std::vector<Told> told_;  // announced stairs and edges of the last half minute
};

}  // namespace handrail::core
