// Finds the material of the library for a material name of a mesh; shared by the readers of meshes. Pure; any thread.
#pragma once

#include <optional>
#include <string>

#include "worlds/scene/material.h"

namespace handrail::readers {

// Finds it by the exact name or, if `guess` is true, by words within the name. Empty if neither fits.
std::optional<Material> mesh_material(const std::string& name, bool guess);

}  // namespace handrail::readers
