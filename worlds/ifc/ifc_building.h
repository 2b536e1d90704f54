// The parts of a building from an IFC file, with their shapes in place: openings are cut and doors tested. This is the
// stage between the file and the Scene. One reading thread uses it.
#pragma once

#include <functional>
#include <memory>
#include <unordered_map>

#include "worlds/geometry/box_index.h"
#include "worlds/ifc/ifc_relations.h"
#include "worlds/ifc/ifc_shapes.h"
#include "worlds/scene/prefab.h"
#include "worlds/scene/stated_building.h"

namespace handrail::ifc {

// Coordinates farther from zero than this belong to a national grid.
inline constexpr double kFarAway_m = 10'000.0;

struct IfcPart {
    PartRole role = PartRole::Other;
    std::uint64_t id = 0;
    int line = 0;
    std::string name, guid;
    Frame frame;        // of the placement, relative to the world's origin
    Body body;          // in world coordinates
    Aabb box;           // around the shape, before openings were cut
    std::string words;  // the material, in the file's words
    // Index of the whole to which this part belongs under the hand, for example the stairs of a flight; else its own
    // index.
    std::size_t whole = 0;
    // Index of an earlier part with the same shape in the same place, which stands for both; this part's `body` is then
    // empty. Otherwise its own index.
    std::size_t same_as = 0;
    double width_m = 0.0, height_m = 0.0;  // of doors and windows as the file states them; 0: not stated
    std::string operation;                 // of a door, such as "SINGLE_SWING_LEFT"
    // The prefab that replaces a part without a shape, with its boxes in `body` in order; else null.
    const Prefab* prefab = nullptr;
};

// The gap of a door or window in its wall, in the axes of its placement: x along the wall, y through it, z up.
struct WallGap {
    Frame axes;
    Vec3 least_m{0.0}, most_m{0.0};
    bool cut = false;  // the file names the wall that the gap goes through
};

struct IfcBuilding {
    std::string name, schema;
    Vec3 origin_m{0.0};          // in the file's coordinates; subtracted from all positions
    std::vector<IfcPart> parts;  // in file order; without openings and spaces
    std::vector<StatedStorey> storeys;
    std::vector<StatedRoom> rooms;
    std::unordered_map<std::uint64_t, std::uint32_t> room_of_id;  // index in `rooms` of each space
    std::shared_ptr<const BoxIndex> by_place;                     // index of `parts` by their boxes
    std::map<std::size_t, WallGap> gaps;                          // of doors and windows, by their index in `parts`
    // Names of the walls that a door without an opening was cut through, by the door's index in `parts`.
    std::map<std::size_t, std::vector<std::string>> cut_as_leaf;
    int openings = 0, openings_cut = 0;
    std::vector<std::size_t> openings_uncut;  // lines in the file
    std::map<std::string, int, std::less<>> skipped, not_read;
    std::vector<MissingPart> missing;      // in file order
    std::vector<std::string> floors_made;  // names of rooms that had no floor under them
    int walls_made = 0;                    // number of rooms that got walls, in a file without walls
    int approximated = 0, odd_placements = 0, far = 0, repeated = 0;
    bool too_large = false;
};

// `progress` runs from 0 to 1. If the reading was stopped, the result is not usable.
IfcBuilding read_building(IfcModel& model, const IfcRelations& relations, const std::function<void(double)>& progress,
                          const std::stop_token& stop);

// Sweeps a walker's body through a gap against everything but doors, and cuts obstacles free with a box. Returns the
// names of the parts that were cut; empty if the walker passed.
std::vector<std::string> free_the_way(IfcBuilding& building, const WallGap& gap);
// Returns whether a walker 0.5 m wide can pass.
bool can_pass(const IfcBuilding& building, const WallGap& gap);
// The side of a gap that is under open sky, along the y axis of the gap: -1 or 1; 0 if neither or both are.
double sky_side(const IfcBuilding& building, const WallGap& gap);

}  // namespace handrail::ifc
