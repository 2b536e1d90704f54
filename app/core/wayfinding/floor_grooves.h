// Grooves on the floor along the way planned last and through the doorways near by, which lie for the hand while they
// are wished for and nothing else leads it: which path the servo is to have. Hand and world metres. App thread only.
#pragma once

#include <optional>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/wayfinding/grooves.h"
#include "app/core/wayfinding/way_plans.h"

namespace handrail {

class FloorGrooves : SessionPart {
public:
    FloorGrooves(const SessionContext& context, Rooms& rooms, const WayPlans& plans);

    void enter_world();
    // They are wished for, and there is a hand for them in the world.
    bool wished() const;
    // While nothing else acts and force may. path: as the servo has it. What is to lie from now on, its number not
    // given yet; none: all stays as it is. They are laid anew for another way, another scale, and a hand that has gone
    // far.
    std::optional<GuidancePath> lay(const GuidancePath& path, double now_s);

private:
    Rooms& rooms_;
    const WayPlans& plans_;
    struct Laid {
        std::vector<GrooveLeg> doorways;  // of this world
        bool doorways_known = false;
        bool ended = false;  // by the servo, since they were laid
        unsigned way = 0;    // WayPlans::changes() then
        Vec3 near_m{0.0};    // where the hand was
        double good_within_m = 0.0;
        double scale = 0.0;
        double ended_s = -1e9;
    } laid_;
};

}  // namespace handrail
