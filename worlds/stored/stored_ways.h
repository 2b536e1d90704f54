// Where one can stand in a world and the rooms found there, kept in a file, so that the next start does not look for
// them again. It holds for the same scene, body and build alone; whatever is damaged counts as not there. Pure but for
// the file; any thread but the app's, which waits for no disk.
#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "worlds/navigation/rooms.h"
#include "worlds/navigation/walk_space.h"
#include "worlds/stored/stored_scene.h"

namespace handrail {

// Another number whenever a source of the walkable space, of rooms, or of what a Scene is made of has changed.
extern const std::uint64_t kWaysVersion;

// What they were found of.
struct WaysFrom {
    std::uint64_t version = 0;
    SceneSum scene;
    WalkBody body;  // as it was asked for
    bool operator==(const WaysFrom&) const = default;
};

WaysFrom ways_made_of(const Scene& scene, const WalkBody& body);

struct FoundWays {
    WalkSpace space;  // without its walls, which only finding rooms needs
    RoomGraph graph;  // no names of a person
};

// The same values give the same bytes. Empty: stopped, or not to be kept (over 255 floors in one column). Time goes
// with the spans, about a tenth of what finding them takes.
std::string stored_ways(const WaysFrom& from, const WalkSpace& space, const RoomGraph& graph,
                        const std::stop_token& stop = {});
// Nothing of bytes that are damaged or were made of something else; `scene` is what `from` was made of. Names are in
// the language spoken. What comes holds together by validate() of both.
std::optional<FoundWays> ways_from(std::string_view bytes, const WaysFrom& from, const Scene& scene);

// With less floor than that, among fewer solids and triangles, they are found sooner than a file would be worth.
inline constexpr std::size_t kLeastKeptSpans = 50'000, kLeastKeptShapes = 2'000;
// From and into the file; an error of the disk counts as nothing kept.
std::optional<FoundWays> take_ways(const std::filesystem::path& file, const WaysFrom& from, const Scene& scene,
                                   const std::stop_token& stop = {});
void keep_ways_in(const std::filesystem::path& file, const WaysFrom& from, const Scene& scene, const WalkSpace& space,
                  const RoomGraph& graph, const std::stop_token& stop = {});

}  // namespace handrail
