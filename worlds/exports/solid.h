// A plate with raised areas as a closed solid of triangles, in whole micrometres, so that every decision is exact and
// corners that belong together are equal. Pure functions; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace handrail {

struct PlatePoint {
    std::int32_t x_um = 0, y_um = 0;
    bool operator==(const PlatePoint&) const = default;
};
using PlateRing = std::vector<PlatePoint>;

// Seen from above the rim goes counter-clockwise and holes clockwise; none touches another.
struct PlateArea {
    PlateRing rim;
    std::vector<PlateRing> holes;
};

struct SolidTriangle {
    std::array<std::array<std::int32_t, 3>, 3> corners_um;  // counter-clockwise seen from outside
};

// Its triangles, counter-clockwise, with no corners but its own; nothing where rings touch or cross. By ear clipping,
// holes joined to the rim by bridges. Source: Eberly, Triangulation by ear clipping, 2008; here the bridges go to the
// nearest corner that is seen, since the one that a ray finds may be a doubled one seen from its other side.
std::optional<std::vector<std::array<PlatePoint, 3>>> triangulated(const PlateArea& area);

struct RaisedArea {
    PlateArea area;
    std::int32_t height_um = 0;  // above the plate
};

// A rectangle from the origin with areas raised on it that do not touch each other or its rim.
std::optional<std::vector<SolidTriangle>> plate_with(std::int32_t wide_um, std::int32_t deep_um, std::int32_t thick_um,
                                                     std::span<const RaisedArea> raised);

struct SolidCheck {
    std::size_t open_edges = 0;     // that no triangle follows in the other direction
    std::size_t crowded_edges = 0;  // that more than two triangles share
    std::size_t flat = 0;           // triangles without area
    double volume_mm3 = 0.0;

    bool closed() const { return open_edges == 0 && crowded_edges == 0 && flat == 0 && volume_mm3 > 0.0; }
};
SolidCheck check_solid(std::span<const SolidTriangle> triangles);

// As binary STL in millimetres.
std::string stl_of(std::span<const SolidTriangle> triangles);

}  // namespace handrail
