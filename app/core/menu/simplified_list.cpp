#include "app/core/menu/simplified_list.h"

#include <string>
#include <utility>
#include <vector>

#include "app/core/context/context_words.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {

void SimplifiedList::open(const compile::Simplification& plan, const OpenPortals& portals,
                          std::span<const compile::CoarserMesh> coarser, double now_s) {
    contract_pre(context_.world.scene != nullptr);
    if (!context_.hands.right.present) return context_.answer(phrase("session.no_hand"), now_s);
    if (!context_.settings.haptic.simplify) return context_.answer(phrase("simplify.off"), now_s);
    const Scene& scene = *context_.world.scene;
    ListSpec list;
    list.title = phrase("simplify.title");
    std::vector<Goal> goals;
    const auto add = [&](std::string name, const Aabb& box, FeatureId feature, const std::string& what) {
        list.items.push_back({name, joined(what, where_words(context_, box))});
        goals.push_back({std::move(name), box, feature});
    };
    const navigation::RoomGraph* rooms = rooms_.known() ? &rooms_.graph() : nullptr;
    for (const compile::NarrowOpening& opening : plan.openings) {
        const FeatureId door = opening.doors.empty() ? kNoFeature : opening.doors.front();
        const Vec3 middle = opening.middle_m();
        add(opening_name(scene, opening, rooms, portals),
            door ? scene.features[door.value].bounds_m : Aabb{middle, middle}, door, opening_words(opening));
    }
    for (const FeatureId id : plan.left_out) {
        const Feature& thing = scene.features[id.value];
        add(sentence_case(spoken_name(thing)), thing.bounds_m, id, phrase("simplify.is_left_out"));
    }
    for (const compile::CoarserMesh& mesh : coarser) {
        const Feature& thing = scene.features[mesh.feature.value];
        add(sentence_case(spoken_name(thing)), thing.bounds_m, mesh.feature, coarser_words(mesh, scale(context_)));
    }
    if (goals.empty()) return context_.answer(phrase("simplify.nothing"), now_s);
    list.chosen = [this, goals](std::size_t i) { on_choose(goals[i], context_.tick_s); };
    context_.open_list(std::move(list), now_s);
}

}  // namespace handrail::core
