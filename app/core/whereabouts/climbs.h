// Lets a person climb stairs on which the walker cannot walk, with one command for all of the stairs. This class
// announces such stairs when the person comes to one of their ends, and the Use key climbs them. Use it on the app
// thread only.
#pragma once

#include <functional>
#include <optional>

#include "app/core/context/session_part.h"
#include "app/core/whereabouts/queries.h"
#include "app/core/whereabouts/rooms.h"

namespace handrail::core {

class Climbs : SessionPart {
public:
    static constexpr double kAtEnd_m = 1.0;  // the person can climb stairs from within this distance of an end

    Climbs(const SessionContext& context, Rooms& rooms, const Queries& queries)
        : SessionPart(context), rooms_(rooms), queries_(queries) {}

    void enter_world() { announced_.reset(); }
    // Carries out the command Use at an end of such stairs. Stairs on the followed route have priority, in the
    // direction of the route. Otherwise the command climbs the nearest stairs if the person neither touches nor faces
    // anything else to use. Returns false if the command belongs to another feature.
    bool act(Command command, double now_s);
    // Announces stairs at whose end the person has arrived. Call it once a tick, after Rooms::tick().
    void tick(double now_s);

    // The session sets this function. It returns the next stairs on the followed route if the person stands before
    // them.
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
    const Queries& queries_;
    std::optional<std::uint32_t> announced_;  // index of the announced stairs at whose end the person stands
};

}  // namespace handrail::core
