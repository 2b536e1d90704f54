// What a mesh calls a material, as a material of the library: what the readers of meshes share. Pure; any thread.
#pragma once

#include <optional>
#include <string>

#include "worlds/scene/material.h"

namespace handrail {

// By its name, or by what stands in the name where that may be guessed; none: neither tells anything.
std::optional<Material> mesh_material(const std::string& name, bool guess);

}  // namespace handrail
