// Ways between two places of a world in words, for a card. Functions of what was read; one thread.
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

namespace handrail {

struct CardWish {
    std::optional<std::string> from, to;  // by name: a room, a thing, a start; from none: the base; to none: every room
    Settings settings;
};

struct CardWays {
    std::vector<CardWay> ways;
    std::vector<std::string> unreached;  // rooms of the storey that no way leads to
};

// The legs are those that a session with these settings tells somebody who stands there, each a sentence of the way.
// From there to there, or to every room of the storey, in the order of their names. Fails with one sentence where there
// is no such name (and tells the nearest), no base, or no way at all.
Result<CardWays> card_ways(const std::shared_ptr<const Scene>& scene, const RoomGraph& graph, Navigation& navigation,
                           const Storey& storey, const CardWish& wish);

}  // namespace handrail
