// Makes the text of a route card: directions between places of a world. The result depends only on the arguments. One
// thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "settings/settings.h"
#include "worlds/base/result.h"
#include "worlds/exports/route_card.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/plan/storey.h"

namespace handrail::program {

struct CardOptions {
    // Names of a room, an object or a start. Without `from`, routes begin at the base. Without `to`, they lead to every
    // room.
    std::optional<std::string> from, to;
    settings::Settings settings;
};

struct CardRoutes {
    std::vector<exports::CardRoute> ways;
    std::vector<std::string> unreached;  // names of the rooms on the storey to which no route leads
};

// Returns directions from one place to another, or to every room of the storey in the order of the rooms' names. Each
// leg is a sentence, the same that a session with these settings announces to a person at that place. Fails with one
// sentence if a name is unknown, which suggests the nearest name. Also fails if there is no base or no route at all.
Result<CardRoutes> card_routes(const std::shared_ptr<const Scene>& scene, const navigation::RoomGraph& graph,
                               navigation::Navigation& navigation, const plan::Storey& storey,
                               const CardOptions& options);

}  // namespace handrail::program
