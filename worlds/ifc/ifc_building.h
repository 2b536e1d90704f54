// The parts of a building from an IFC file, with their bodies where they stand: openings cut, doors proven. Between the
// file and the Scene. One reading thread.
#pragma once

#include <functional>
#include <memory>
#include <unordered_map>

#include "worlds/geometry/box_index.h"
#include "worlds/ifc/ifc_relations.h"
#include "worlds/ifc/ifc_shapes.h"
#include "worlds/scene/prefab.h"
#include "worlds/scene/stated_building.h"

namespace handrail {

// Coordinates farther from zero than this belong to a national grid.
inline constexpr double kFarAway_m = 10'000.0;

struct IfcPart {
    PartRole role = PartRole::Other;
    std::uint64_t id = 0;
    int line = 0;
    std::string name, guid;
    Frame frame;            // of its placement, from the world's origin
    Body body;              // in the world
    Aabb box;               // around it, before openings were cut
    std::string words;      // what it is made of, in the file's words
    std::size_t whole = 0;  // place of the part that it is felt as a piece of: a flight's stairs; else itself
    // Place of an earlier part with the same body in the same place, which is felt for both; else itself. Its own body
    // is empty then.
    std::size_t same_as = 0;
    double width_m = 0.0, height_m = 0.0;  // of doors and windows as stated; 0: not
    std::string operation;                 // of a door: "SINGLE_SWING_LEFT"
    // Of a part without a form of its own: what stands there in its place, its boxes in `body` in order.
    const Prefab* prefab = nullptr;
};

// Where a door or window stands in its wall, in the axes of its placement: x along it, y through the wall, z up.
struct WallGap {
    Frame axes;
    Vec3 least_m{0.0}, most_m{0.0};
    bool cut = false;  // through a wall that the file names
};

struct IfcBuilding {
    std::string name, schema;
    Vec3 origin_m{0.0};          // of the file, taken off everything
    std::vector<IfcPart> parts;  // in file order; openings and spaces are not among them
    std::vector<StatedStorey> storeys;
    std::vector<StatedRoom> rooms;
    std::unordered_map<std::uint64_t, std::uint32_t> room_of_id;  // their places in `rooms`
    std::shared_ptr<const BoxIndex> by_place;                     // of `parts`, by their boxes
    std::map<std::size_t, WallGap> gaps;                          // of doors and windows, by their place in `parts`
    // Names of the walls that a door without an opening was cut through, by its place in `parts`.
    std::map<std::size_t, std::vector<std::string>> cut_as_leaf;
    int openings = 0, openings_cut = 0;
    std::vector<std::size_t> openings_uncut;  // lines
    std::map<std::string, int, std::less<>> skipped, not_read;
    std::vector<MissingPart> missing;      // in file order
    std::vector<std::string> floors_made;  // names of rooms that nothing lay under
    int walls_made = 0;                    // rooms of a file without walls
    int approximated = 0, odd_placements = 0, far = 0, repeated = 0;
    bool too_large = false;
};

// Progress runs from 0 to 1. Stopped, it is of no use.
IfcBuilding read_building(IfcModel& model, const IfcRelations& relations, const std::function<void(double)>& progress,
                          const std::stop_token& stop);

// Sweeps a body through a gap against everything but doors; what stands in its way is cut free by a box. The names of
// those; empty: it passed.
std::vector<std::string> free_the_way(IfcBuilding& building, const WallGap& gap);
// A body of 0.5 m passes through.
bool can_pass(const IfcBuilding& building, const WallGap& gap);
// The side of a gap that lies under open sky: -1 or 1, along the y axis of the gap; 0: neither side, or both.
double sky_side(const IfcBuilding& building, const WallGap& gap);

}  // namespace handrail
