// The ground under and before the feet: what is told of stairs, ramps, drops and doors ahead, and the edge at which a
// body stops until it is asked for twice. App thread only; world metres.
#pragma once

#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/walking/paces.h"
#include "app/core/world/hazards.h"
#include "app/core/world/walker.h"

namespace handrail {

class Footing : SessionPart {
public:
    // It holds `body` back at edges.
    Footing(const SessionContext& context, BodyState& body) : SessionPart(context), body_(body) {}

    void enter_world();
    // The body was set down elsewhere in the same world: what was told of it lately stays told.
    void set_down();
    // A key that walks, pressed at an edge, goes over it; told of every command before it is acted on.
    void notice(Command command, double now_s);
    // Takes the body back to `before` when it stands over a drop that was not asked for twice. True: it was.
    // The steps that led there are told with it.
    bool held_at_edge(const WalkerState& before, Paces& paces, double now_s);
    // While the body stands: tells of what the ground does. before_m: where it stood a tick ago.
    void tick(const Vec3& before_m, const WalkResult& walked, double now_s);
    // Of footsteps: higher uphill.
    double step_pitch() const { return underfoot_.step_pitch; }

private:
    bool tell_place_once(const Vec3& place_m, bool drop, double now_s);
    void tell_underfoot(const Vec3& moved_m, const WalkResult& walked, double now_s);
    void tell_ahead(double now_s);
    void beat_ahead(double now_s);

    // The ground ahead, looked at when the body has moved or turned.
    struct Looked {
        GroundAhead ahead;
        Vec3 from_m{0.0};
        double heading_rad = 0.0, at_s = -1e9;
        double moved_s = -1e9;  // when the body last walked or turned
        double beat_s = -1e9, door_s = -1e9;
    };
    struct Edge {
        bool held = false;       // stopped; told once for a press
        double at_s = -1e9;      // when
        bool confirmed = false;  // the next edge may be gone over
    };
    struct Underfoot {
        int risers = 0;  // since the stairs began, positive up
        double since_riser_m = 0.0;
        double ramp_m = 0.0;  // walked on it so far; level ground counts it down
        int ramp_told = 0;    // 1 up, -1 down
        double step_pitch = 1.0;
    };
    struct Told {
        Vec3 place_m{0.0};
        double time_s = 0.0;
        bool drop = false;
    };

    BodyState& body_;
    Looked looked_;
    Edge edge_;
    Underfoot underfoot_;
    std::vector<Told> told_;  // stairs and edges of the last half minute
};

}  // namespace handrail
