// A labyrinth in words: the straight strips of floor along which the ball can roll, and how they join. Pure functions;
// any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

// A range of cells in x and in y; both ends are included.
struct CellStrip {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    int wide() const { return x1 - x0 + 1; }
    int deep() const { return y1 - y0 + 1; }
    bool operator==(const CellStrip&) const = default;
};

// Takes the largest rectangle of free cells, then the largest of the rest, until none is left. Of equal ones, the
// southernmost comes first, then the westernmost. free: width times depth, rows from the south, each from the west.
std::vector<CellStrip> largest_strips(std::vector<bool> free, int width, int depth);

enum class CorridorSide : std::uint8_t { East, North, West, South };

struct Corridor {
    struct Branch {
        std::size_t to = 0;    // index in the list
        double at_m = 0.0;     // distance from the beginning of this corridor to where the strips meet
        CorridorSide towards;  // direction of the other corridor
    };
    bool east = true;       // true: from west to east; false: from south to north
    Aabb box_m;             // where the ball's centre can be; level
    double length_m = 0.0;  // how far the ball can roll along it
    double across_m = 0.0;  // how far the ball can roll across it
    std::vector<Branch> branches;

    // Distance along the corridor from its beginning; negative or above the length if outside it.
    double along_m(const Vec3& place_m) const { return east ? place_m.x - box_m.min_m.x : place_m.y - box_m.min_m.y; }
};

// The corridors that the ball can reach from its place. Holes count as floor, and movable things are ignored. The
// ball's own corridor comes first, then the others by the number of corridors between. Strips shorter than half a roll
// of the ball (its diameter) are left out. Of two floors above each other, the first one reached counts. Fails if there
// is no floor to roll on.
Result<std::vector<Corridor>> corridors_of(const Scene& scene, const Vec3& ball_m, double radius_m);

}  // namespace handrail::core
