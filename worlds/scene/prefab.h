// Ready-made furniture, so that an author need not draw it: pieces of usual sizes, each of a few boxes with materials.
// We designed them after what is usual in European homes and public buildings. Pure data; any thread.
#pragma once

#include <span>
#include <string_view>

#include "worlds/geometry/convex.h"

namespace handrail {

struct PrefabPart {
    Aabb box_m;                 // relative to the middle of the piece's floor; the front faces +y
    std::string_view material;  // a name from the material library (material.h)
};

struct Prefab {
    std::string_view name;  // its name in maps and in the key kind.NAME of the languages: "table"
    std::span<const PrefabPart> parts;
};

std::span<const Prefab> prefabs();
// Null if there is no piece of that name. The name must be in lower case.
const Prefab* find_prefab(std::string_view name);

}  // namespace handrail
