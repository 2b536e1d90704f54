// Reads the parts of a building from an IFC file and puts their shapes in place. It also cuts openings and tests doors.
// IfcScene turns the resulting IfcBuilding into a Scene. Used on the reading thread only.
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

// Coordinates farther from zero than this are treated as those of a national grid.
inline constexpr double kFarAway_m = 10'000.0;

struct IfcPart {
    PartRole role = PartRole::Other;
    std::uint64_t id = 0;
    int line = 0;
    std::string name, guid;
    Frame frame;        // frame of the placement, relative to the world's origin
    Body body;          // shape in world coordinates
    Aabb box;           // bounds of the shape before openings were cut
    std::string words;  // the file's words for the material
    // Index of the whole to which this part belongs when it is touched, for example the stairs of a flight. If the part
    // belongs to no whole, this is its own index.
    std::size_t whole = 0;
    // Index of an earlier part with the same shape in the same place, which represents both parts. The `body` of this
    // part is then empty. If there is no such earlier part, this is the part's own index.
    std::size_t same_as = 0;
    double width_m = 0.0, height_m = 0.0;  // size of a door or window as the file states it; 0: not stated
    std::string operation;                 // how a door operates, such as "SINGLE_SWING_LEFT"
    // The prefab that replaces a part without a shape. The `body` then contains the boxes of the prefab in order. Null
    // for other parts.
    const Prefab* prefab = nullptr;
};

// The gap of a door or window in its wall, in the axes of its placement: x along the wall, y through it, z up.
struct WallGap {
    Frame axes;
    Vec3 least_m{0.0}, most_m{0.0};
    bool cut = false;  // the file names the wall through which this gap is cut
};

struct IfcBuilding {
    std::string name, schema;
    Vec3 origin_m{0.0};          // origin in the file's coordinates, which was subtracted from all positions
    std::vector<IfcPart> parts;  // in file order, without openings and spaces
    std::vector<StatedStorey> storeys;
    std::vector<StatedRoom> rooms;
    std::unordered_map<std::uint64_t, std::uint32_t> room_of_id;  // index into `rooms` by the id of the space
    std::shared_ptr<const BoxIndex> by_place;                     // index over the boxes of `parts`
    std::map<std::size_t, WallGap> gaps;  // gaps of doors and windows, by their index in `parts`
    // Names of the walls through which a door without an opening was cut, by the door's index in `parts`.
    std::map<std::size_t, std::vector<std::string>> cut_as_leaf;
    int openings = 0, openings_cut = 0;
    std::vector<std::size_t> openings_uncut;  // lines in the file of the openings that could not be cut
    std::map<std::string, int, std::less<>> skipped, not_read;
    std::vector<MissingPart> missing;  // missing parts in file order
    // Names of the rooms that had no floor below them, for which a floor was made.
    std::vector<std::string> floors_made;
    int walls_made = 0;  // number of rooms that got walls because the file contains none
    int approximated = 0, odd_placements = 0, far = 0, repeated = 0;
    bool too_large = false;
};

// Reads the building. `progress` is called with values from 0 to 1. After a stop request the result must not be used.
IfcBuilding read_building(IfcModel& model, const IfcRelations& relations, const std::function<void(double)>& progress,
                          const std::stop_token& stop);

// Sweeps a walker's body through a gap. Cuts a box out of every part that is in the walker's way, except doors. Returns
// the names of the parts that were cut; empty if the walker passed without a cut.
std::vector<std::string> free_the_way(IfcBuilding& building, const WallGap& gap);
// Returns true if a walker 0.5 m wide can pass through the gap.
bool can_pass(const IfcBuilding& building, const WallGap& gap);
// Returns the side of a gap that is under the open sky, along the y axis of the gap: -1 or 1. Returns 0 if neither side
// is, or both are.
double sky_side(const IfcBuilding& building, const WallGap& gap);

}  // namespace handrail::ifc
