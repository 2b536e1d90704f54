// A plate with raised areas as a closed solid of triangles. Coordinates are whole micrometres, so every decision is
// exact and common corners are equal. Pure functions; any thread.
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

// Seen from above, the rim is counter-clockwise and the holes are clockwise; none touches another.
struct PlateArea {
    PlateRing rim;
    std::vector<PlateRing> holes;
};

struct SolidTriangle {
    std::array<std::array<std::int32_t, 3>, 3> corners_um;  // counter-clockwise seen from outside
};

// Divides an area into counter-clockwise triangles without new corners; nothing if rings touch or cross. Uses ear
// clipping, with bridges that join holes to the rim. Source: Eberly, Triangulation by ear clipping, 2008. Unlike there,
// bridges go to the nearest visible corner: the corner that a ray finds may be a doubled one, seen from its other side.
std::optional<std::vector<std::array<PlatePoint, 3>>> triangulated(const PlateArea& area);

struct RaisedArea {
    PlateArea area;
    std::int32_t height_um = 0;  // above the plate
};

// A rectangular plate from the origin, with raised areas that touch neither each other nor its rim.
std::optional<std::vector<SolidTriangle>> plate_with(std::int32_t wide_um, std::int32_t deep_um, std::int32_t thick_um,
                                                     std::span<const RaisedArea> raised);

struct SolidCheck {
    std::size_t open_edges = 0;     // edges without a triangle in the opposite direction
    std::size_t crowded_edges = 0;  // edges that more than two triangles share
    std::size_t flat = 0;           // triangles without area
    double volume_mm3 = 0.0;

    bool closed() const { return open_edges == 0 && crowded_edges == 0 && flat == 0 && volume_mm3 > 0.0; }
};
SolidCheck check_solid(std::span<const SolidTriangle> triangles);

// Binary STL in millimetres.
std::string stl_of(std::span<const SolidTriangle> triangles);

}  // namespace handrail::exports
