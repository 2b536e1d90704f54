// Finds the materials of floors and walls, for the text that describes a building.
#include <algorithm>
#include <cmath>
#include <map>

#include "worlds/exports/as_words.h"
#include "worlds/geometry/clip.h"
#include "worlds/geometry/flat_parts.h"

namespace handrail::exports {
namespace {

constexpr double kOnFloor_m = 0.05, kUpwards = 0.9, kUpright = 0.1;

}  // namespace

FloorMaterials::FloorMaterials(const Scene& scene) {
    for (const SurfacePolygon& surface : scene.surfaces) {
        std::string name = words::material_of_word(scene.material(surface.material).name);
        if (surface.normal.z < kUpwards || name.empty()) continue;
        Piece piece;
        piece.rings.emplace_back();
        for (const Vec3& p : surface.polygon.points_m) piece.box_m.include(p), piece.rings[0].emplace_back(p);
        piece.material = std::move(name);
        if (!piece.box_m.empty()) pieces_.push_back(std::move(piece));
    }
    std::stable_sort(pieces_.begin(), pieces_.end(),
                     [](const Piece& a, const Piece& b) { return a.box_m.min_m.z < b.box_m.min_m.z; });
}

std::string FloorMaterials::at(const Vec3& place) const {
    const auto from = std::lower_bound(pieces_.begin(), pieces_.end(), place.z - kOnFloor_m,
                                       [](const Piece& piece, double z) { return piece.box_m.min_m.z < z; });
    const Vec2 here(place);
    for (auto piece = from; piece != pieces_.end() && piece->box_m.min_m.z <= place.z + kOnFloor_m; ++piece)
        if (here.x >= piece->box_m.min_m.x && here.x <= piece->box_m.max_m.x && here.y >= piece->box_m.min_m.y &&
            here.y <= piece->box_m.max_m.y && handrail::inside(piece->rings, here))
            return piece->material;
    return {};
}

std::string wall_material(const Scene& scene) {
    std::map<std::string, double> areas;  // wall area of each material; the empty name is for walls without one
    for (const SurfacePolygon& surface : scene.surfaces) {
        const Feature* feature = scene.find(surface.feature);
        if (!feature || feature->kind != FeatureKind::Wall || std::abs(surface.normal.z) > kUpright) continue;
        areas[words::material_of_word(scene.material(surface.material).name)] += area_m2(surface.polygon);
    }
    const auto most =
        std::max_element(areas.begin(), areas.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == areas.end() ? std::string() : most->first;
}

}  // namespace handrail::exports
