// A labyrinth as seen from above, for the ears: the straight strips of floor that the ball can roll along, and how they
// join. Pure functions; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail {

// Cells x from and to, y from and to, both ends belong to it.
struct CellStrip {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    int wide() const { return x1 - x0 + 1; }
    int deep() const { return y1 - y0 + 1; }
    bool operator==(const CellStrip&) const = default;
};

// Takes the largest rectangle of free cells, then the largest of those left, and so on until none is left; of equal
// ones the southern, then the western one first. free: width times depth, rows from the south, each from the west.
std::vector<CellStrip> largest_strips(std::vector<bool> free, int width, int depth);

enum class CorridorSide : std::uint8_t { East, North, West, South };

struct Corridor {
    struct Branch {
        std::size_t to = 0;    // place in the list
        double at_m = 0.0;     // along this one from its beginning, where the strips meet
        CorridorSide towards;  // it lies there
    };
    bool east = true;       // it runs from west to east, else from south to north
    Aabb box_m;             // where the ball's middle can be; level
    double length_m = 0.0;  // that it can roll
    double across_m = 0.0;  // likewise
    std::vector<Branch> branches;

    // Along it from its beginning; below 0 or above the length: before or behind it.
    double along_m(const Vec3& place_m) const { return east ? place_m.x - box_m.min_m.x : place_m.y - box_m.min_m.y; }
};

// Those that the ball can come to from where it lies, holes passed over, things that are free to move left out; the one
// it lies in first, then the nearest by corridors passed. Strips shorter than half a roll of the ball (its diameter)
// are left out. Of two floors above each other the one that is reached first. Fails where nothing can be rolled on.
Result<std::vector<Corridor>> corridors_of(const Scene& scene, const Vec3& ball_m, double radius_m);

}  // namespace handrail
