#include "worlds/navigation/reach.h"

#include <algorithm>
#include <limits>

#include "worlds/base/language.h"

namespace handrail::navigation {
namespace {

constexpr double kLeastReported_m2 = 1.0;
constexpr std::size_t kMostNamed = 4;

std::vector<bool> reached_from(const RoomGraph& graph, std::uint32_t first) {
    std::vector<std::vector<std::uint32_t>> leads_to(graph.rooms.size());
    for (const Portal& portal : graph.portals) {
        leads_to[portal.rooms[0]].push_back(portal.rooms[1]);
        if (!portal.one_way) leads_to[portal.rooms[1]].push_back(portal.rooms[0]);
    }
    std::vector<bool> reached(graph.rooms.size(), false);
    std::vector<std::uint32_t> open{first};
    reached[first] = true;
    while (!open.empty()) {
        const std::uint32_t here = open.back();
        open.pop_back();
        for (const std::uint32_t next : leads_to[here]) {
            if (reached[next]) continue;
            reached[next] = true;
            open.push_back(next);
        }
    }
    return reached;
}

}  // namespace

const Start* base_of(const Scene& scene) {
    const auto base =
        std::find_if(scene.starts.begin(), scene.starts.end(), [](const Start& start) { return start.base; });
    return base == scene.starts.end() ? nullptr : &*base;
}

std::vector<std::vector<std::uint32_t>> spans_led_to(const WalkSpace& space) {
    std::vector<std::vector<std::uint32_t>> leads_to(space.spans.size());
    for (const WalkLink& link : space.links) {
        leads_to[link.from].push_back(link.to);
        if (link.both_ways) leads_to[link.to].push_back(link.from);
    }
    return leads_to;
}

std::vector<bool> spans_reached(const WalkSpace& space, std::uint32_t first) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> links;
    for (const WalkLink& link : space.links) {
        links.emplace_back(link.from, link.to);
        if (link.both_ways) links.emplace_back(link.to, link.from);
    }
    std::sort(links.begin(), links.end());
    std::vector<bool> seen(space.spans.size(), false);
    std::vector<std::uint32_t> open{first};
    seen[first] = true;
    const auto go = [&](std::uint32_t next) {
        if (next == kNothing || seen[next]) return;
        seen[next] = true;
        open.push_back(next);
    };
    while (!open.empty()) {
        const std::uint32_t here = open.back();
        open.pop_back();
        for (const std::uint32_t next : space.spans[here].next) go(next);
        for (auto link = std::lower_bound(links.begin(), links.end(), std::pair(here, 0U));
             link != links.end() && link->first == here; ++link)
            go(link->second);
    }
    return seen;
}

Vec3 goal_in_room(const Navigation& navigation, const RoomGraph& graph, std::uint32_t room, const Vec3& from_m) {
    const Vec3 middle_m = graph.rooms[room].middle_m;
    if (navigation.reachable(from_m, middle_m)) return middle_m;
    const WalkSpace& space = navigation.space();
    Vec3 goal_m = middle_m;
    double least_m = std::numeric_limits<double>::infinity();
    for (std::uint32_t s = 0; s < space.spans.size(); ++s) {
        if (graph.room_of_span[s] != room) continue;
        const Vec3 place_m = space.place_m(s);
        const double off_m = glm::length(place_m - middle_m);
        if (off_m >= least_m || !navigation.reachable(from_m, place_m)) continue;
        least_m = off_m;
        goal_m = place_m;
    }
    return goal_m;
}

std::vector<RoomOutOfReach> rooms_out_of_reach(const Scene& scene, const WalkSpace& space, const RoomGraph& graph) {
    const Start* const base = base_of(scene);
    if (!base) return {};
    const std::uint32_t first = room_at(graph, space, base->feet_m);
    if (first == kNothing) return {};
    const std::vector<bool> reached = reached_from(graph, first);
    std::vector<RoomOutOfReach> rooms;
    for (std::uint32_t i = 0; i < graph.rooms.size(); ++i) {
        const Room& room = graph.rooms[i];
        // Pools are left out, because nobody walks into a basin with a rim.
        if (room.kind == RoomKind::Liquid) continue;
        const bool named = room.given || !room.map_name.empty();
        if (!reached[i] && (named || (room.kind != RoomKind::Niche && room.area_m2 >= kLeastReported_m2)))
            rooms.push_back({capitalised(room.name), i, room.middle_m});
    }
    for (const RoomName& name : scene.room_names) {
        const bool has_room = std::any_of(graph.rooms.begin(), graph.rooms.end(),
                                          [&](const Room& room) { return room.map_name == name.name; });
        if (!has_room && space.nearest(name.at_m, 1.0, 0.6, 3.0) == kNothing)
            rooms.push_back({capitalised(in_spoken_language(name.name, name.name_in)), kNothing, name.at_m});
    }
    return rooms;
}

std::vector<std::string> unreachable_rooms(const Scene& scene, const WalkSpace& space, const RoomGraph& graph) {
    std::vector<std::string> names;
    for (RoomOutOfReach& room : rooms_out_of_reach(scene, space, graph))
        if (std::find(names.begin(), names.end(), room.name) == names.end()) names.push_back(std::move(room.name));
    return names;
}

std::string unreachable_words(const std::vector<std::string>& names) {
    if (names.empty()) return {};
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i) list += (i ? ", " : "") + names[i];
    if (names.size() > kMostNamed)
        return phrase("rooms.unreachable_more", {{"names", list}, {"more", names.size() - kMostNamed}});
    return phrase("rooms.unreachable", {{"names", list}, {"count", names.size()}});
}

}  // namespace handrail::navigation
