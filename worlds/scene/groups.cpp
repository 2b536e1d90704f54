#include "worlds/scene/groups.h"

#include <algorithm>
#include <memory>
#include <set>

#include "worlds/base/contract.h"
#include "worlds/geometry/box_index.h"
#include "worlds/scene/surface_material.h"

namespace handrail {
namespace {

constexpr double kTouch_m = 1e-3;  // two solids that are no farther apart than this may cover each other's faces

bool any_hidden(const Scene& scene) {
    return std::any_of(scene.groups.begin(), scene.groups.end(), [](const Group& group) { return group.hidden; });
}

// The solids of a placed thing refer to the groups of the scene that contains the thing.
bool is_hidden_in(const std::vector<Group>& groups, std::uint32_t group) {
    for (; group < groups.size(); group = groups[group].inside)
        if (groups[group].hidden) return true;
    return false;
}

Aabb box_of(const Polygon& face) {
    Aabb box;
    for (const Vec3& point : face.points_m) box.include(point);
    return box;
}

}  // namespace

bool is_in_group(const Scene& scene, const Solid& solid, std::uint32_t group) {
    for (std::uint32_t at = solid.group; at < scene.groups.size(); at = scene.groups[at].inside)
        if (at == group) return true;
    return false;
}

bool is_hidden(const Scene& scene, const Solid& solid) { return is_hidden_in(scene.groups, solid.group); }

std::size_t solids_in_group(const Scene& scene, std::uint32_t group) {
    const auto is_in = [&](const Solid& solid) { return is_in_group(scene, solid, group); };
    auto count = std::count_if(scene.solids.begin(), scene.solids.end(), is_in);
    for (const PlacedModel& placed : scene.placed)
        count += std::count_if(placed.model->solids.begin(), placed.model->solids.end(), is_in);
    return static_cast<std::size_t>(count);
}

std::optional<Scene> without_hidden_groups(const Scene& scene) {
    if (!any_hidden(scene)) return std::nullopt;
    std::optional<Scene> felt = scene;
    std::vector<Aabb> boxes;
    for (const Solid& solid : scene.solids) boxes.push_back(solid.shape.bounds_m);
    const BoxIndex index(boxes);
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < scene.solids.size(); ++i) {
        if (!is_hidden(scene, scene.solids[i])) continue;
        felt->solids[i].role = SolidRole::Illusion;
        const Aabb around = grown(boxes[i], kTouch_m);
        index.find(around, near);
        for (const std::uint32_t j : near) {
            Solid& other = felt->solids[j];
            for (std::size_t face = 0; face < other.face_hidden.size(); ++face)
                if (overlap(box_of(other.shape.faces[face]), around)) other.face_hidden[face] = false;
        }
    }
    for (PlacedModel& placed : felt->placed) {
        const auto hidden = [&](const Solid& solid) { return is_hidden_in(scene.groups, solid.group); };
        if (std::none_of(placed.model->solids.begin(), placed.model->solids.end(), hidden)) continue;
        auto model = std::make_shared<Scene>(*placed.model);
        for (Solid& solid : model->solids)
            if (hidden(solid)) solid.role = SolidRole::Illusion;
        placed.model = std::move(model);
    }
    return felt;
}

void give_material_to_group(Scene& scene, std::uint32_t group, const MaterialSpec& spec) {
    contract_pre(group < scene.groups.size());
    std::set<std::uint32_t> things;
    const MaterialId id = library_material(scene, spec);
    for (Solid& solid : scene.solids) {
        if (!is_in_group(scene, solid, group)) continue;
        std::fill(solid.face_materials.begin(), solid.face_materials.end(), id);
        if (solid.feature) things.insert(solid.feature.value);
    }
    for (const PlacedModel& placed : scene.placed)
        for (const Solid& solid : placed.model->solids)
            if (is_in_group(scene, solid, group)) things.insert(placed.feature.value);
    for (const std::uint32_t thing : things) give_material(scene, FeatureId{thing}, spec);
}

}  // namespace handrail
