// Directions between places of a world as text, for a route card. The functions depend only on what was read; one
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

struct CardWish {
    // Names of a room, a thing or a start; no `from`: the base; no `to`: every room.
    std::optional<std::string> from, to;
    settings::Settings settings;
};

struct CardRoutes {
    std::vector<exports::CardRoute> ways;
    std::vector<std::string> unreached;  // rooms of the storey that no route reaches
};

// Directions from one place to the other, or to every room of the storey in the order of their names. Each leg is a
// sentence, the same that a session with these settings announces to a person who stands there. Fails with one sentence
// if the name is unknown (and gives the nearest), or if there is no base or no route at all.
Result<CardRoutes> card_ways(const std::shared_ptr<const Scene>& scene, const navigation::RoomGraph& graph,
                             navigation::Navigation& navigation, const plan::Storey& storey, const CardWish& wish);

}  // namespace handrail::program
