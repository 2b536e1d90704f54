// Finds the library material for the name of a material in a mesh file. The readers of meshes share it. Pure functions;
// any thread may call them.
#pragma once

#include <optional>
#include <string>

#include "worlds/scene/material.h"

namespace handrail::readers {

// Finds the material by its exact name or, if `guess` is true, by words within the name. Empty if neither matches.
std::optional<Material> mesh_material(const std::string& name, bool guess);

}  // namespace handrail::readers
