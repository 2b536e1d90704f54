#include "worlds/readers/map_prefab.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "worlds/base/text.h"

namespace handrail::readers {

const Prefab* prefab_of(const MapEntity& entity, Diagnostics& diagnostics) {
    const MapKey* key = entity.find("prefab");
    if (!key) return nullptr;
    const std::string name = lower_ascii(trimmed(key->value).substr(0, 32));
    const Prefab* prefab = find_prefab(name);
    if (!prefab) {
        std::vector<std::string> names;
        for (const Prefab& one : prefabs()) names.emplace_back(one.name);
        diagnostics.warn(key->place, "map.then_left_out", "map.no_prefab",
                         {{"value", excerpt(key->value)}, {"nearest", nearest_name(name, names)}});
    } else if (!entity.brushes.empty() || !entity.patches.empty()) {
        diagnostics.warn(key->place, "map.then_key_left_out", "map.prefab_with_brushes", {{"name", name}});
        return nullptr;
    } else if (!entity.find("origin")) {
        diagnostics.warn(entity.place, "map.then_left_out", "map.prefab_nowhere", {{"name", name}});
        return nullptr;
    }
    return prefab;
}

MapEntity with_prefab(const MapEntity& entity, const Prefab& prefab, const Vec3& origin_units, double heading_rad,
                      double metres_per_unit) {
    MapEntity made = entity;
    const double c = std::cos(heading_rad), s = std::sin(heading_rad);
    for (const PrefabPart& part : prefab.parts) {
        const auto at = [&](int x, int y, int z) {
            const Vec3 p(x ? part.box_m.max_m.x : part.box_m.min_m.x, y ? part.box_m.max_m.y : part.box_m.min_m.y,
                         z ? part.box_m.max_m.z : part.box_m.min_m.z);
            return origin_units + Vec3(p.x * c + p.y * s, p.y * c - p.x * s, p.z) / metres_per_unit;
        };
        MapBrush brush;
        brush.place = entity.place;
        // The faces in the order south, east, north, west, top, bottom. Seen from outside, their points run clockwise.
        for (const std::array<Vec3, 3>& points :
             {std::array{at(1, 0, 0), at(0, 0, 0), at(0, 0, 1)}, std::array{at(1, 1, 0), at(1, 0, 0), at(1, 0, 1)},
              std::array{at(0, 1, 0), at(1, 1, 0), at(1, 1, 1)}, std::array{at(0, 0, 0), at(0, 1, 0), at(0, 1, 1)},
              std::array{at(0, 0, 1), at(0, 1, 1), at(1, 1, 1)}, std::array{at(0, 1, 0), at(0, 0, 0), at(1, 0, 0)}})
            brush.faces.push_back({points, part.material, entity.place});
        made.brushes.push_back(std::move(brush));
    }
    return made;
}

}  // namespace handrail::readers
