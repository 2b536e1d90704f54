// Furniture that an author need not draw: pieces of usual sizes, each of a few boxes with their materials. Ours, made
// of what is usual in European homes and public buildings. Pure data; any thread.
#pragma once

#include <span>
#include <string_view>

#include "worlds/geometry/convex.h"

namespace handrail {

struct PrefabPart {
    Aabb box_m;                 // its floor's middle at 0, its front to +y
    std::string_view material;  // a name of the library (material.h)
};

struct Prefab {
    std::string_view name;  // as maps and texts call it, and kind.NAME in the languages: "table"
    std::span<const PrefabPart> parts;
};

std::span<const Prefab> prefabs();
// Null: there is none of that name, lower case.
const Prefab* find_prefab(std::string_view name);

}  // namespace handrail
