// Examines the ground under and in front of the walker. This class announces stairs, ramps, drops and doors ahead. It
// stops the walker at an edge until the person presses the key again. Use it on the app thread only. Lengths are in
// world metres.
#pragma once

#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/walking/paces.h"
#include "app/core/world/hazards.h"
#include "app/core/world/walker.h"

namespace handrail::core {

class Footing : SessionPart {
public:
    // Moves the walker in `body` back at edges.
    Footing(const SessionContext& context, WalkerState& avatar) : SessionPart(context), avatar_(avatar) {}

    void enter_world();
    // Call it after the walker was moved elsewhere in the same world. Announcements from the last half minute are not
    // repeated.
    void set_down();
    // Call it with every command before the command acts. If the person presses a walking key at an edge, the walker
    // may cross it.
    void notice(Command command, double now_s);
    // If the walker is over a drop that the person has not confirmed, moves it back to `before` and returns true. The
    // announcement includes the steps to the edge.
    bool held_at_edge(const WalkerMotion& before, Paces& paces, double now_s);
    // Announces changes of the ground. Call it each tick while the walker stands on the ground. `before_m` is the
    // walker's position in the last tick.
    void tick(const Vec3& before_m, const WalkResult& walked, double now_s);
    // Returns a factor on the pitch of footsteps, which is higher uphill.
    double step_pitch() const { return underfoot_.step_pitch; }

private:
    bool announce_place_once(const Vec3& place_m, bool drop, double now_s);
    void announce_underfoot(const Vec3& moved_m, const WalkResult& walked, double now_s);
    void announce_ahead(double now_s);
    void beat_ahead(double now_s);

    // The ground ahead, as last examined after the walker had moved or turned.
    struct Looked {
        GroundAhead ahead;
        Vec3 from_m{0.0};
        double heading_rad = 0.0, at_s = -1e9;
        double moved_s = -1e9;  // time when the walker last walked or turned
        double beat_s = -1e9, door_s = -1e9;
    };
    struct Edge {
        bool held = false;       // true: the walker was stopped at an edge; announced once for each press of a key
        double at_s = -1e9;      // time when the walker was stopped
        bool confirmed = false;  // true: the person has confirmed, so the walker may cross the next edge
    };
    struct Underfoot {
        int risers = 0;  // number of risers since the stairs began, positive upwards
        double since_riser_m = 0.0;
        double ramp_m = 0.0;     // distance walked on the ramp; level ground reduces it
        int announced_ramp = 0;  // announced ramp: 1 up, -1 down, 0 none
        double step_pitch = 1.0;
    };
    struct Announced {
        Vec3 place_m{0.0};
        double time_s = 0.0;
        bool drop = false;
    };

    WalkerState& avatar_;
    Looked looked_;
    Edge edge_;
    Underfoot underfoot_;
    std::vector<Announced> announced_;  // stairs and edges announced in the last half minute
};

}  // namespace handrail::core
