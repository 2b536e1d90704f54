#include "worlds/readers/map_brushes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handrail::readers {

namespace {

// Greatest number of faces of a brush. The time to build a solid grows with the square of the number of planes: 12,000
// planes took 18 s. Real brushes have under 100.
constexpr std::size_t kMostFaces = 1000;

BuiltSolid no_solid() {
    BuiltSolid nothing;
    nothing.fault = SolidFault::Open;
    return nothing;
}

}  // namespace

BuiltSolid MapBrushes::solid_of(const MapBrush& brush, bool report) {
    if (brush.faces.size() > kMostFaces) {
        if (report) diagnostics_.warn(brush.place, "map.then_left_out", "map.many_faces", {{"most", kMostFaces}});
        return no_solid();
    }
    std::vector<Plane>& planes = planes_;
    planes.clear();
    face_of_plane_.clear();
    Vec3 middle{0.0};
    double farthest_m = 0.0;
    int degenerate = 0;
    for (std::uint32_t i = 0; i < brush.faces.size(); ++i) {
        const MapFace& face = brush.faces[i];
        std::array<Vec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = face.points_units[k] * units_;
            farthest_m = std::max({farthest_m, std::abs(p[k].x), std::abs(p[k].y), std::abs(p[k].z)});
        }
        Plane plane;
        if (!plane_from_clockwise(p[0], p[1], p[2], plane)) {
            if (report && degenerate == 0) diagnostics_.warn(face.place, "map.then_without_face", "map.flat_face");
            ++degenerate;
            continue;
        }
        planes.push_back(plane);
        face_of_plane_.push_back(i);
        middle += p[0];
    }
    if (farthest_m > kFarthestM) {
        if (report) diagnostics_.warn(brush.place, "map.then_left_out", "map.far_brush");
        return no_solid();
    }
    if (!planes.empty()) middle /= static_cast<double>(planes.size());
    BuiltSolid built = solid_from_planes(planes, middle, 4.0 * farthest_m + 4096.0, {1e-6 * units_, 1e-4 * units_});
    if (!report) return built;
    if (built.fault == SolidFault::Empty) diagnostics_.warn(brush.place, "map.then_left_out", "map.flat_brush");
    if (built.fault == SolidFault::Open) diagnostics_.warn(brush.place, "map.then_left_out", "map.leaky_brush");
    if (built.was_inside_out) diagnostics_.warn(brush.place, "map.then_turned", "map.inside_out");
    if (built.fault == SolidFault::None) dropped_faces_ += built.planes_without_face;
    return built;
}

BuiltSolid MapBrushes::counted_solid_of(const MapBrush& brush) {
    BuiltSolid built = solid_of(brush, true);
    count(built);
    return built;
}

void MapBrushes::count(const BuiltSolid& built) {
    ++report_.brushes;
    if (built.fault != SolidFault::None) {
        ++left_out_;
        return;
    }
    for (const Polygon& face : built.solid.faces) {
        ++report_.polygons;
        report_.triangles += static_cast<int>(face.points_m.size()) - 2;
    }
}

const TextureFacts& MapBrushes::facts_of(std::string_view texture) {
    const auto [found, is_new] = textures_.try_emplace(texture);
    if (is_new) found->second = facts_of_texture(texture);
    return found->second;
}

TextureSense MapBrushes::sense_of(const MapBrush& brush) {
    for (const MapFace& face : brush.faces)
        if (facts_of(face.texture).sense == TextureSense::Ordinary) return TextureSense::Ordinary;
    return facts_of(brush.faces.front().texture).sense;
}

int MapBrushes::repeats(const BuiltSolid& built, std::uint32_t owner, int line) {
    std::vector<std::string> planes;
    for (const Plane& plane : built.solid.planes) {
        // Adding 0.0 turns minus zero into zero.
        const std::array<double, 4> numbers{plane.normal.x + 0.0, plane.normal.y + 0.0, plane.normal.z + 0.0,
                                            plane.offset_m + 0.0};
        planes.emplace_back(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
    }
    // The planes are sorted, so that the order in which the faces were drawn has no influence.
    std::sort(planes.begin(), planes.end());
    std::string key(reinterpret_cast<const char*>(&owner), sizeof owner);
    for (const std::string& plane : planes) key += plane;
    const auto [found, is_new] = lines_.try_emplace(std::move(key), line);
    return is_new ? 0 : found->second;
}

}  // namespace handrail::readers
