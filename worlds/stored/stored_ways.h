// Where a body can stand in a world and the rooms found there, as bytes: the cache keeps them, so that the next start
// does not look for them again. They are valid for the same scene, body and build alone, which their key says. Pure;
// any thread but the app's, because a large building takes a while.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "worlds/navigation/rooms.h"
#include "worlds/navigation/walk_space.h"
#include "worlds/stored/stored_scene.h"

namespace handrail {

// SHA-256, in hex, of what they are found from: the scene, the body as it was requested, and kWorldsVersion.
std::string ways_key(const Scene& scene, const WalkBody& body);

struct FoundWays {
    WalkSpace space;  // without its walls, which only finding rooms needs
    RoomGraph graph;  // no names of a person
};

// Compressed, as the cache keeps them; the same values give the same bytes. Empty: stopped, or not to be kept (over 255
// floors in one column). Takes about a tenth of the time of finding them.
std::string stored_ways(const WalkSpace& space, const RoomGraph& graph, const std::stop_token& stop = {});
// Of stored_ways: uncompressed and written anew from values that hold together by validate(); empty if the bytes are
// damaged. handrail-reader does this, so that the program itself decompresses nothing that was kept.
std::string unpacked_ways(std::string_view packed);
// Of unpacked_ways, for the scene and body of their key; nothing if they do not fit them. Names are in the language
// spoken.
std::optional<FoundWays> ways_from(std::string_view plain, const WalkBody& body, const Scene& scene);

// With less floor than that, among fewer solids and triangles, finding them is faster than keeping them.
inline constexpr std::size_t kLeastKeptSpans = 50'000, kLeastKeptShapes = 2'000;
bool worth_keeping(const WalkSpace& space, const Scene& scene);

}  // namespace handrail
