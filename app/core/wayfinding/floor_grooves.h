// Grooves on the floor along the last planned route and through nearby doorways, for the hand to feel if the person
// wants them and nothing else guides the hand. This class decides which path the servo gets. Hand and world metres. App
// thread only.
#pragma once

#include <optional>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/wayfinding/grooves.h"
#include "app/core/wayfinding/route_plans.h"

namespace handrail::core {

class FloorGrooves : SessionPart {
public:
    FloorGrooves(const SessionContext& context, Rooms& rooms, const RoutePlans& plans);

    void enter_world();
    // True if the person wants them, and a hand in the world can feel them.
    bool wished() const;
    // Call it while nothing else acts and force is permitted. path: the servo's present path. Returns the new grooves,
    // still without a number; no value: no change. New grooves are made for another route, another scale, or a hand
    // that has moved far.
    std::optional<servo::GuidancePath> lay(const servo::GuidancePath& path, double now_s);

private:
    Rooms& rooms_;
    const RoutePlans& plans_;
    struct Laid {
        std::vector<GrooveLeg> doorways;  // of this world
        bool doorways_known = false;
        bool ended = false;  // by the servo, since they were made
        unsigned way = 0;    // RoutePlans::changes() at that time
        Vec3 near_m{0.0};    // place of the hand
        double good_within_m = 0.0;
        double scale = 0.0;
        double ended_s = -1e9;
    } laid_;
};

}  // namespace handrail::core
