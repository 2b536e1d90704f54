#include "worlds/readers/mesh_materials.h"

namespace handrail::readers {

std::optional<Material> mesh_material(const std::string& name, bool guess) {
    Material material;
    const MaterialSpec* spec = find_material(name);
    if (!spec && guess) {
        spec = guess_material(name);
        material.guessed = spec != nullptr;
    }
    if (!spec) return std::nullopt;
    material.name = spec->name;
    material.sound = spec->sound;
    return material;
}

}  // namespace handrail::readers
