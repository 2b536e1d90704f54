// Stairs that cannot be walked and are climbed in one go. They are announced to a person who comes to one of their
// ends, and the Use key climbs them. App thread only.
#pragma once

#include <functional>
#include <optional>

#include "app/core/context/session_part.h"
#include "app/core/whereabouts/asking.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

class Climbs : SessionPart {
public:
    static constexpr double kAtEnd_m = 1.0;  // distance from an end at which the person can climb

    Climbs(const SessionContext& context, Rooms& rooms, const Asking& asking)
        : SessionPart(context), rooms_(rooms), asking_(asking) {}

    void enter_world() { told_.reset(); }
    // Handles Use at an end of such stairs. Stairs on the followed route come first, in its direction. Otherwise the
    // nearest, if the person neither touches nor faces anything else that can be used. Returns false if the command
    // belongs to another feature.
    bool act(Command command, double now_s);
    // Call it once a tick, after the rooms.
    void tick(double now_s);

    // Set by the session: the next stairs on the followed route, if the person stands before them.
    std::function<std::optional<navigation::RoutePassage>()> on_way;

private:
    struct End {
        std::uint32_t link = 0;  // index in WalkSpace::links
        Vec3 here_m{0.0}, there_m{0.0};
        FeatureId feature = kNoFeature;
    };
    std::optional<End> end_here(double within_m, const navigation::RoutePassage* only = nullptr) const;
    bool something_else(bool wanted) const;

    Rooms& rooms_;
    const Asking& asking_;
    std::optional<std::uint32_t> told_;  // the announced link, at whose end the person stands
};

}  // namespace handrail::core
