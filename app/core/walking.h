// What AppCore remembers while a body moves by ear: the wall it trails, the way it came, what it was told of the ground. Plain data; app thread.
#pragma once

#include <vector>

#include "app/core/hazards.h"
#include "app/core/trail.h"

namespace handrail {

struct Walking {
    // Trailing.
    Trail trail;
    double trail_left_m = 0.0;    // of taps, still to go
    bool trail_to_event = false;  // until something is met
    // Going back: places a quarter of a metre apart, the newest last, since the body was last set down.
    std::vector<Vec3> crumbs_m;
    double retrace_left_m = 0.0;
    bool retracing = false;
    // Leaps, Home and the like that can be taken back, the newest last.
    struct Place {
        Vec3 feet_m{0.0};
        double heading_rad = 0.0;
    };
    std::vector<Place> undo;
    FeatureId leapt_to = kNoFeature;  // or the number of a mark, counted on from the features
    // The ground ahead, looked at when the body has moved or turned.
    GroundAhead ahead;
    Vec3 looked_from_m{0.0};
    double looked_heading_rad = 0.0, looked_s = -1e9;
    double moved_s = -1e9;  // when the body last walked or turned
    double beat_s = -1e9, door_s = -1e9;
    struct Told {
        Vec3 place_m{0.0};
        double time_s = 0.0;
        bool drop = false;
    };
    std::vector<Told> told;  // stairs and edges of the last minute
    // At an edge.
    bool edge_held = false;       // stopped; told once for a press
    double edge_s = -1e9;         // when
    bool edge_confirmed = false;  // the next edge may be gone over
    // On stairs and ramps.
    int risers = 0;  // since the stairs began, positive up
    double since_riser_m = 0.0;
    double ramp_m = 0.0;     // walked on it so far; level ground counts it down
    int ramp_told = 0;       // 1 up, -1 down
    double step_pitch = 1.0;  // of footsteps

    // The body was set down elsewhere.
    void set_down(const Vec3& feet_m) {
        const std::vector<Place> kept = std::move(undo);
        const FeatureId leapt = leapt_to;
        const std::vector<Told> known = std::move(told);
        *this = {};
        undo = kept;
        leapt_to = leapt;
        told = known;
        crumbs_m.assign(1, feet_m);
    }
};

}  // namespace handrail
