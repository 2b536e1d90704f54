// Scene -> HapticScene: the only haptic code that knows Scene. App or worker thread.
#pragma once

#include <memory>

#include "haptic/compile/prepare_mesh.h"
#include "haptic/render/haptic_scene.h"
#include "worlds/scene/scene.h"

namespace handrail {

// Which values surfaces get that the file leaves open.
enum class MaterialSource {
    KeysOnly,  // only keys written in the world count (the `touch` contract)
    Library,   // a named or guessed material brings its library values (exploring)
};

// Placed models become bodies, in their order; beyond HapticScene::kMostBodies they are left out. Solids and movers become convex obstacles (boxes recognised
// as boxes), mesh triangles become sheets, liquids become volumes. The generation is a number that differs for every compiled scene of this process. world:
// HapticScene::world of the scene that this one follows with something added or removed; 0: another world. mesh: what is done to mesh triangles of one feature
// and material, of the scene and of each model; what was done is added to the report where one is given.
std::shared_ptr<const HapticScene> compile_haptic(const Scene& scene, MaterialSource materials, std::uint32_t world = 0, const MeshOptions& mesh = kExactMesh,
                                                  MeshReport* report = nullptr);

}  // namespace handrail
