// Packs the walkable space of a world and the rooms found in it into bytes. The cache keeps them, so that the next
// start need not search again. They are valid only for the same scene, body and build, which their key identifies.
// Pure; any thread except the app's, because a large building takes a while.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "worlds/navigation/rooms.h"
#include "worlds/navigation/walk_space.h"
#include "worlds/stored/stored_scene.h"

namespace handrail::stored {

// SHA-256, in hex, of everything that the result depends on: the scene, the body as requested, and kWorldsVersion.
std::string ways_key(const Scene& scene, const navigation::WalkerMeasures& body);

struct FoundWays {
    navigation::WalkSpace space;  // without its walls, which are needed only to find rooms
    navigation::RoomGraph graph;  // without names that the person gave
};

// Returns the compressed bytes for the cache; equal values give equal bytes. Empty if stopped, or if the space must not
// be kept (over 255 floors in one column). Takes about a tenth of the time of the search.
std::string stored_ways(const navigation::WalkSpace& space, const navigation::RoomGraph& graph,
                        const std::stop_token& stop = {});
// Uncompresses the result of stored_ways, checks it with validate() and writes it again; empty if the bytes are
// damaged. handrail-reader does this, so that the program itself never decompresses cached bytes.
std::string unpacked_ways(std::string_view packed);
// Reads the result of unpacked_ways, for the scene and body of its key; empty if it does not fit them. Names are in the
// spoken language.
std::optional<FoundWays> ways_from(std::string_view plain, const navigation::WalkerMeasures& body, const Scene& scene);

// With fewer spans, and fewer solids and triangles, the search is faster than the cache.
inline constexpr std::size_t kLeastKeptSpans = 50'000, kLeastKeptShapes = 2'000;
bool worth_keeping(const navigation::WalkSpace& space, const Scene& scene);

}  // namespace handrail::stored
