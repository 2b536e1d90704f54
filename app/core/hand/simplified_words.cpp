#include "app/core/hand/simplified_words.h"

#include <cmath>

#include "app/core/dialogue/words.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {

OpenPortals open_portals(const navigation::RoomGraph& graph) {
    OpenPortals open;
    for (std::uint32_t p = 0; p < graph.portals.size(); ++p)
        if (graph.portals[p].kind == navigation::PassageKind::Opening) {
            open.portals.push_back(p);
            open.places_m.push_back(graph.portals[p].place_m);
        }
    return open;
}

bool needs_openings(double world_m_per_hand_m, double body_radius_m) {
    return compile::kLeastGap_hand_m * world_m_per_hand_m > 2.0 * body_radius_m;
}

std::string simplified_sentence(const compile::Simplification& plan, std::size_t coarser) {
    std::string list;
    const auto add = [&](const char* key, std::size_t count) {
        if (count == 0) return;
        const std::string part = phrase(key, {{"count", count}});
        list = list.empty() ? part : joined(list, part);
    };
    add("simplify.widened", plan.widened());
    add("simplify.narrow", plan.staying_narrow());
    add("simplify.left_out", plan.left_out.size());
    add("simplify.coarser", coarser);
    return list.empty() ? list : phrase("simplify.sentence", {{"what", list}});
}

std::string opening_name(const Scene& scene, const compile::NarrowOpening& opening, const navigation::RoomGraph* graph,
                         const OpenPortals& portals) {
    if (!opening.doors.empty()) return sentence_case(spoken_name(scene.features[opening.doors.front().value]));
    if (!graph) return sentence_case(phrase("rooms.opening"));
    const navigation::Portal& portal = graph->portals[portals.portals[static_cast<std::size_t>(opening.place)]];
    return phrase("simplify.opening_between",
                  {{"one", graph->rooms[portal.rooms[0]].name}, {"other", graph->rooms[portal.rooms[1]].name}});
}

std::string coarser_words(const compile::CoarserMesh& mesh, double world_m_per_hand_m) {
    return phrase("simplify.is_coarser", {{"after", mesh.after},
                                          {"before", mesh.before},
                                          {"off", std::ceil(1e5 * mesh.off_m / world_m_per_hand_m) / 100.0}});
}

std::string opening_words(const compile::NarrowOpening& opening) {
    const auto metres = [](double width_m) {
        return phrase("words.metres", {{"metres", std::round(width_m * 10.0) / 10.0}});
    };
    const std::string truly = metres(opening.width_m());
    if (!opening.widened()) return phrase("simplify.stays_narrow", {{"truly", truly}});
    return phrase("simplify.felt_wider", {{"felt", metres(opening.felt_width_m())},
                                          {"truly", truly},
                                          {"enough", opening.stays_narrow() ? "no" : "yes"}});
}

}  // namespace handrail::core
