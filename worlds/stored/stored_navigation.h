// Packs the walkable space of a world and the rooms found in it into bytes. The cache keeps the bytes, so that the next
// start need not search again. They are valid only for the same scene, walker and build, which the key identifies. Pure
// functions. Call them on any thread except the app thread, because a large building costs noticeable time.
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

// Returns the key: the SHA-256, in hex, of everything that the result depends on (the scene, the requested measures of
// the walker, and kWorldsVersion).
std::string navigation_key(const Scene& scene, const navigation::WalkerMeasures& body);

struct FoundNavigation {
    navigation::WalkSpace space;  // the walkable space without its walls, which are needed only to find rooms
    navigation::RoomGraph graph;  // the rooms, without names that the person gave
};

// Returns the compressed bytes for the cache; equal values give equal bytes. Empty after a stop request, or if the
// space must not be kept because a column has over 255 floors. Costs about a tenth of the time of the search.
std::string stored_navigation(const navigation::WalkSpace& space, const navigation::RoomGraph& graph,
                              const std::stop_token& stop = {});
// Uncompresses the result of stored_navigation, checks it with validate() and packs it again without compression. Empty
// if the bytes are damaged. handrail-reader calls this, so that the program itself never decompresses cached bytes.
std::string unpacked_navigation(std::string_view packed);
// Reads the result of unpacked_navigation for the scene and walker of its key. Empty if it does not match them. Room
// names are in the spoken language.
std::optional<FoundNavigation> navigation_from(std::string_view plain, const navigation::WalkerMeasures& body,
                                               const Scene& scene);

// If there are fewer spans than this, and fewer solids and triangles, the search is faster than the cache.
inline constexpr std::size_t kLeastKeptSpans = 50'000, kLeastKeptShapes = 2'000;
bool worth_keeping(const navigation::WalkSpace& space, const Scene& scene);

}  // namespace handrail::stored
