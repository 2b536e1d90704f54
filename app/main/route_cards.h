// Ways between two places of a world in words, for a card. Functions of what was read; one thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/core/dialogue/words.h"
#include "worlds/base/result.h"
#include "worlds/exports/route_card.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/plan/storey.h"

namespace handrail {

struct CardWish {
    std::optional<std::string> from, to;  // by name: a room, a thing, a start; from none: the base; to none: every room
    DistanceWords how;
};

struct CardWays {
    std::vector<CardWay> ways;
    std::vector<std::string> unreached;  // rooms of the storey that no way leads to
};

// From there to there, or to every room of the storey, in the order of their names. Fails with one sentence where there
// is no such name (and tells the nearest), no base, or no way at all.
Result<CardWays> card_ways(const Scene& scene, const RoomGraph& graph, Navigation& navigation, const Storey& storey,
                           const CardWish& wish);

}  // namespace handrail
