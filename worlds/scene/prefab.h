// Defines ready-made furniture, so that an author need not draw it. The pieces have usual sizes, and each consists of a
// few boxes with materials. We designed them after furniture in European homes and public buildings. Pure data; any
// thread may use it.
#pragma once

#include <span>
#include <string_view>

#include "worlds/geometry/convex.h"

namespace handrail {

struct PrefabPart {
    Aabb box_m;                 // relative to the middle of the piece's underside; the front of the piece faces +y
    std::string_view material;  // a name from the material library (material.h)
};

struct Prefab {
    std::string_view name;  // name in maps and in the key kind.NAME of the language files: "table"
    std::span<const PrefabPart> parts;
};

std::span<const Prefab> prefabs();
// Finds a piece by its name, which must be in lower case. Returns null if there is no piece of that name.
const Prefab* find_prefab(std::string_view name);

}  // namespace handrail
