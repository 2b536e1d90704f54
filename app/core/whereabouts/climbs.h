// Stairs on which nobody walks and that are taken in one go: told of to who comes to one of their ends, and taken by
// the key that uses things. App thread only.
#pragma once

#include <functional>
#include <optional>

#include "app/core/context/session_part.h"
#include "app/core/whereabouts/asking.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail {

class Climbs : SessionPart {
public:
    static constexpr double kAtEnd_m = 1.0;  // so near to an end one stands at them

    Climbs(const SessionContext& context, Rooms& rooms, const Asking& asking)
        : SessionPart(context), rooms_(rooms), asking_(asking) {}

    void enter_world() { told_.reset(); }
    // Use, at an end of such stairs: those that the way one follows leads over, in its direction; else the nearest,
    // where one touches and faces nothing else that is used. False: it is another's.
    bool act(Command command, double now_s);
    // Once a tick, after the rooms.
    void tick(double now_s);

    // Set by the session: the next stairs on the way that is followed, if one stands at them.
    std::function<std::optional<RoutePassage>()> on_way;

private:
    struct End {
        std::uint32_t link = 0;  // of WalkSpace::links
        Vec3 here_m{0.0}, there_m{0.0};
        FeatureId feature = kNoFeature;
    };
    std::optional<End> end_here(double within_m, const RoutePassage* only = nullptr) const;
    bool something_else(bool wanted) const;

    Rooms& rooms_;
    const Asking& asking_;
    std::optional<std::uint32_t> told_;  // the link that one stands at an end of
};

}  // namespace handrail
