// Gives a part of a scene another material. Pure functions in world units; any thread may call them.
#pragma once

#include "worlds/scene/scene.h"

namespace handrail {

// Returns the index of this material of the library in the scene. Adds the material if it is new.
MaterialId library_material(Scene& scene, const MaterialSpec& spec);
// Makes everything that belongs to this feature of the material from the library. The values that the file states for
// its surface, such as its friction, no longer apply. The time grows with the numbers of solids and triangles.
void give_material(Scene& scene, FeatureId feature, const MaterialSpec& spec);

}  // namespace handrail
