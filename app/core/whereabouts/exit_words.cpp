#include "app/core/whereabouts/exit_words.h"

#include <algorithm>
#include <cmath>

#include "app/core/context/telling.h"
#include "app/core/dialogue/brief_words.h"
#include "worlds/base/language.h"

namespace handrail {

std::vector<std::string> exit_sentences(const SessionContext& context, const RoomGraph& graph, std::uint32_t room,
                                        ExitOrder order, const std::function<bool(std::uint32_t)>& told) {
    const Vec3& feet_m = context.body.feet_m();
    const auto way = [&](std::uint32_t portal) { return graph.portals[portal].place_m - feet_m; };
    const auto far_m = [&](std::uint32_t portal) { return std::hypot(way(portal).x, way(portal).y); };
    std::vector<std::uint32_t> exits = exits_of(graph, room, feet_m, context.body.heading_rad);
    if (order == ExitOrder::Nearest)
        std::stable_sort(exits.begin(), exits.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return far_m(a) < far_m(b); });
    std::vector<std::string> sentences;
    for (const std::uint32_t p : exits) {
        const Portal& portal = graph.portals[p];
        const std::uint32_t other = portal.rooms[0] == room ? portal.rooms[1] : portal.rooms[0];
        if (told && !told(other)) continue;
        const std::string what = passage_name(context, portal.kind, portal.feature, 0.0), to = graph.rooms[other].name;
        // A locked one says so first: it belongs to the name.
        const std::string lock = lock_words(context, portal.feature);
        const std::string exit =
            sentence_case(lock.empty() ? what : phrase("rooms.locked_exit", {{"exit", what}, {"lock", lock}}));
        const std::string where =
            brief_place_words(far_m(p), std::atan2(way(p).x, way(p).y), context.body.heading_goal_rad,
                              context.settings.speech.directions, distances(context));
        sentences.push_back(to == what ? phrase("rooms.exit", {{"exit", exit}, {"where", where}})
                                       : phrase("rooms.exit_to", {{"exit", exit}, {"room", to}, {"where", where}}));
    }
    return sentences;
}

}  // namespace handrail
