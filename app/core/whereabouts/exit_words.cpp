#include "app/core/whereabouts/exit_words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/brief_words.h"
#include "worlds/base/language.h"

namespace handrail::core {

namespace {

constexpr std::size_t kMostListed = 8;

Vec3 way_to(const SessionContext& context, const navigation::Portal& portal) {
    return portal.place_m - context.avatar.feet_m();
}

double far_m(const SessionContext& context, const navigation::Portal& portal) {
    return std::hypot(way_to(context, portal).x, way_to(context, portal).y);
}

std::uint32_t beyond(const navigation::Portal& portal, std::uint32_t room) {
    return portal.rooms[0] == room ? portal.rooms[1] : portal.rooms[0];
}

std::vector<std::uint32_t> in_order(const SessionContext& context, const navigation::RoomGraph& graph,
                                    std::uint32_t room, ExitOrder order,
                                    const std::function<bool(std::uint32_t)>& included) {
    std::vector<std::uint32_t> exits =
        navigation::exits_of(graph, room, context.avatar.feet_m(), context.avatar.heading_rad);
    if (included) std::erase_if(exits, [&](std::uint32_t p) { return !included(beyond(graph.portals[p], room)); });
    if (order == ExitOrder::Nearest)
        std::stable_sort(exits.begin(), exits.end(), [&](std::uint32_t a, std::uint32_t b) {
            return far_m(context, graph.portals[a]) < far_m(context, graph.portals[b]);
        });
    return exits;
}

std::string exit_sentence(const SessionContext& context, const navigation::RoomGraph& graph, std::uint32_t room,
                          const navigation::Portal& portal) {
    const std::string what = passage_name(context, portal.kind, portal.feature, 0.0),
                      to = graph.rooms[beyond(portal, room)].name;
    // A lock is mentioned first, as part of the name.
    const std::string lock = lock_words(context, portal.feature);
    const std::string exit =
        sentence_case(lock.empty() ? what : phrase("rooms.locked_exit", {{"exit", what}, {"lock", lock}}));
    const Vec3 way = way_to(context, portal);
    const std::string where =
        brief_place_words(far_m(context, portal), std::atan2(way.x, way.y), context.avatar.heading_goal_rad,
                          context.settings.speech.directions, distances(context));
    return sentence_case(to) == sentence_case(what)
               ? phrase("rooms.exit", {{"exit", exit}, {"where", where}})
               : phrase("rooms.exit_to", {{"exit", exit}, {"room", to}, {"where", where}});
}

// Returns the number of the other exits: "89 more: 60 doors, 29 openings."
std::string more_exits(const navigation::RoomGraph& graph, std::span<const std::uint32_t> exits) {
    constexpr std::array kKinds{"exit_kind.door", "exit_kind.opening",    "exit_kind.stairs", "exit_kind.lift",
                                "exit_kind.drop", "exit_kind.teleporter", "exit_kind.climb"};
    std::array<int, kKinds.size()> counts{};
    for (const std::uint32_t p : exits) ++counts[static_cast<std::size_t>(graph.portals[p].kind)];
    std::string kinds;
    for (std::size_t k = 0; k < kKinds.size(); ++k)
        if (counts[k] > 0) kinds += (kinds.empty() ? "" : ", ") + phrase(kKinds[k], {{"n", counts[k]}});
    return phrase("rooms.more_exits", {{"n", exits.size()}, {"kinds", kinds}});
}

}  // namespace

std::vector<std::string> exit_sentences(const SessionContext& context, const navigation::RoomGraph& graph,
                                        std::uint32_t room, ExitOrder order,
                                        const std::function<bool(std::uint32_t)>& included) {
    std::vector<std::string> sentences;
    for (const std::uint32_t p : in_order(context, graph, room, order, included))
        sentences.push_back(exit_sentence(context, graph, room, graph.portals[p]));
    return sentences;
}

ListedExits listed_exits(const SessionContext& context, const navigation::RoomGraph& graph, std::uint32_t room,
                         const std::function<bool(std::uint32_t)>& included) {
    std::vector<std::uint32_t> exits = in_order(context, graph, room, ExitOrder::Clockwise, included);
    if (exits.size() > kMostListed) exits = in_order(context, graph, room, ExitOrder::Nearest, included);
    ListedExits listed{exits.size(), {}};
    const std::size_t first = std::min(exits.size(), kMostListed);
    for (std::size_t i = 0; i < first; ++i)
        listed.sentences.push_back(exit_sentence(context, graph, room, graph.portals[exits[i]]));
    if (exits.size() > first)
        listed.sentences.push_back(more_exits(graph, std::span<const std::uint32_t>(exits).subspan(first)));
    return listed;
}

}  // namespace handrail::core
