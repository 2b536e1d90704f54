// Finds the corridors of a labyrinth, for its description: straight strips of floor along which the ball can roll, and
// the places where they join. Pure functions, which any thread may call.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// A rectangle of cells. Each range includes both of its ends.
struct CellStrip {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    int wide() const { return x1 - x0 + 1; }
    int deep() const { return y1 - y0 + 1; }
    bool operator==(const CellStrip&) const = default;
};

// Divides the free cells into rectangles. It removes the largest rectangle, then the largest of the remaining cells,
// until no cell is left. Among rectangles of equal size, the southernmost comes first, then the westernmost. `free` has
// `width` times `depth` cells, in rows from south to north, each from west to east.
std::vector<CellStrip> largest_strips(std::vector<bool> free, int width, int depth);

enum class CorridorSide : std::uint8_t { East, North, West, South };

struct Corridor {
    struct Branch {
        std::size_t to = 0;    // index of the other corridor in the list
        double at_m = 0.0;     // distance from the beginning of this corridor to the junction
        CorridorSide towards;  // direction from this corridor to the other one
    };
    bool east = true;       // true: the corridor runs from west to east; false: from south to north
    Aabb box_m;             // the positions that the ball's centre can have; horizontal
    double length_m = 0.0;  // how far the ball can roll along it
    double across_m = 0.0;  // how far the ball can roll across it
    std::vector<Branch> branches;

    // Returns the distance of a place from the corridor's beginning, along the corridor. If the place is outside the
    // corridor, the distance is negative or greater than `length_m`.
    double along_m(const Vec3& place_m) const { return east ? place_m.x - box_m.min_m.x : place_m.y - box_m.min_m.y; }
};

// Returns the corridors that the ball can reach from its place. Holes are treated as floor, and movable things are
// ignored. The ball's own corridor comes first, and the others follow by the number of corridors between. Strips that
// are shorter than half a roll, which is the diameter of the ball, are left out. If there are two floors above each
// other, the function uses the floor that it reaches first. It fails if there is no floor to roll on.
Result<std::vector<Corridor>> corridors_of(const Scene& scene, const Vec3& ball_m, double radius_m);

}  // namespace handrail::core
