// Decides which grooves on the floor the servo gets. The hand can feel them along the last planned route and through
// nearby doorways. The person must want them, and no other guidance of the hand may be active. Lengths are in hand and
// world metres. Use this class on the app thread only.
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
    // Returns true if the person wants grooves and a hand in the world can feel them.
    bool wanted() const;
    // Returns new grooves, which have no number yet, or no value if the present ones stay. New grooves are made for
    // another route, another scale, or a hand that has moved far. `path` is the present path of the servo. Call this
    // function while no other guidance acts and force is permitted.
    std::optional<servo::GuidancePath> lay(const servo::GuidancePath& path, double now_s);

private:
    Rooms& rooms_;
    const RoutePlans& plans_;
    struct Laid {
        std::vector<GrooveLeg> doorways;  // grooves through the doorways of this world
        bool doorways_known = false;
        bool ended = false;  // true: the servo has ended the grooves since they were made
        unsigned way = 0;    // RoutePlans::changes() when the grooves were made
        Vec3 near_m{0.0};    // position of the hand when the grooves were made
        double good_within_m = 0.0;
        double scale = 0.0;
        double ended_s = -1e9;
    } laid_;
};

}  // namespace handrail::core
