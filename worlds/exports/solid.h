// Makes a plate with raised areas as a closed solid of triangles. Coordinates are whole micrometres, so every decision
// is exact and common corners are equal. Pure functions; any thread may call them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace handrail::exports {

struct PlatePoint {
    std::int32_t x_um = 0, y_um = 0;
    bool operator==(const PlatePoint&) const = default;
};
using PlateRing = std::vector<PlatePoint>;

// An area with holes. Seen from above, the rim is counter-clockwise and the holes are clockwise. No ring touches
// another.
struct PlateArea {
    PlateRing rim;
    std::vector<PlateRing> holes;
};

struct SolidTriangle {
    // Corners of the triangle, counter-clockwise as seen from outside.
    std::array<std::array<std::int32_t, 3>, 3> corners_um;
};

// Divides an area into counter-clockwise triangles without new corners. Returns nothing if rings touch or cross. Uses
// ear clipping, with bridges that join holes to the rim. Source: Eberly, Triangulation by ear clipping, 2008. Unlike in
// that source, a bridge goes to the nearest visible corner. In the source, a ray finds the corner. Because of an
// earlier bridge, that corner may exist twice, and the ray may find the wrong one of the two.
std::optional<std::vector<std::array<PlatePoint, 3>>> triangulated(const PlateArea& area);

struct RaisedArea {
    PlateArea area;
    std::int32_t height_um = 0;  // height above the plate
};

// Returns a rectangular plate with a corner at the origin and with raised areas. The raised areas touch neither each
// other nor the rim of the plate.
std::optional<std::vector<SolidTriangle>> plate_with(std::int32_t wide_um, std::int32_t deep_um, std::int32_t thick_um,
                                                     std::span<const RaisedArea> raised);

struct SolidCheck {
    std::size_t open_edges = 0;     // number of edges without a triangle in the opposite direction
    std::size_t crowded_edges = 0;  // number of edges that more than two triangles share
    std::size_t flat = 0;           // number of degenerate triangles, which have no area
    double volume_mm3 = 0.0;

    bool closed() const { return open_edges == 0 && crowded_edges == 0 && flat == 0 && volume_mm3 > 0.0; }
};
SolidCheck check_solid(std::span<const SolidTriangle> triangles);

// Returns binary STL in millimetres.
std::string stl_of(std::span<const SolidTriangle> triangles);

}  // namespace handrail::exports
