#include "app/core/whereabouts/room_words.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/brief_words.h"
#include "app/core/whereabouts/extents.h"
#include "app/core/whereabouts/room_things.h"
#include "app/core/whereabouts/storeys.h"
#include "app/core/world/questions.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/navigation/stated_rooms.h"
#include "worlds/scene/outer_ground.h"
#include "worlds/scene/stated_building.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {
namespace {

constexpr double kThingAtWall_m = 0.8;
constexpr std::size_t kMostAtWall = 5, kMostNeighbours = 5, kMostHubs = 4, kMostParts = 6;
constexpr std::size_t kMostWordsOfExits = 38;
// If the names of neighbouring rooms are long, fewer rooms are named, so that the sentence has no more words than this.
constexpr std::size_t kMostWordsOfNeighbours = 40;
constexpr std::array kWalls{"kind.north_wall", "kind.east_wall", "kind.south_wall", "kind.west_wall"};
constexpr std::size_t kMiddle = kWalls.size();

// The wall of the room next to which a box is, and the clockwise distance along that wall. If `wall` is kMiddle, the
// box is not at a wall.
struct AtWall {
    std::size_t wall = kMiddle;
    double along_m = 0.0;
};
AtWall at_wall(const Aabb& room, const Aabb& box, double reach_m) {
    const std::array<double, 4> off{room.max_m.y - box.max_m.y, room.max_m.x - box.max_m.x, box.min_m.y - room.min_m.y,
                                    box.min_m.x - room.min_m.x};
    const auto nearest = static_cast<std::size_t>(std::min_element(off.begin(), off.end()) - off.begin());
    const Vec3 middle = box.centre_m();
    const std::array<double, 4> along{middle.x, -middle.y, -middle.x, middle.y};
    if (off[nearest] > reach_m) return {kMiddle, middle.x};
    return {nearest, along[nearest]};
}

bool is_furniture(const Feature& feature) {
    if (is_outer_ground(feature)) return false;
    switch (feature.kind) {
        case FeatureKind::Object:
        case FeatureKind::Button:
        case FeatureKind::Lift:
        case FeatureKind::Mover:
        case FeatureKind::Liquid:
        case FeatureKind::Teleport:
            return !feature.bounds_m.empty();
        default:
            return false;
    }
}

// Returns "shelf; table, 4 times; and 3 more", in the order of the things along the wall.
std::string things_words(std::vector<std::pair<double, std::string>> things) {
    std::stable_sort(things.begin(), things.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::pair<std::string, int>> kinds;
    for (const auto& thing : things) {
        const std::string& name = thing.second;
        const auto known = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == name; });
        if (known == kinds.end()) kinds.emplace_back(name, 1);
        else ++known->second;
    }
    std::vector<std::string> said;
    int more = 0;
    for (const auto& [name, times] : kinds) {
        if (said.size() == kMostAtWall) more += times;
        else said.push_back(times == 1 ? name : phrase("describe.times", {{"name", name}, {"times", times}}));
    }
    const std::string names = fmt::format("{}", fmt::join(said, "; "));
    return more == 0 ? names : phrase("describe.and_more", {{"names", names}, {"more", more}});
}

std::string exits_words(const SessionContext& context, const navigation::RoomGraph& graph, std::uint32_t room) {
    std::vector<std::pair<double, std::string>> exits;
    for (const navigation::Portal& portal : graph.portals) {
        if (portal.rooms[0] != room && portal.rooms[1] != room) continue;
        if (portal.one_way && portal.rooms[1] == room) continue;
        const std::uint32_t other = portal.rooms[0] == room ? portal.rooms[1] : portal.rooms[0];
        const Aabb place{portal.place_m, portal.place_m};
        const AtWall at = at_wall(graph.rooms[room].bounds_m, place, 1e9);
        const std::string what = passage_name(context, portal.kind, portal.feature, 0.0), to = graph.rooms[other].name;
        const std::string exit = sentence_case(to) == sentence_case(what)
                                     ? what
                                     : phrase("describe.exit_to", {{"exit", what}, {"room", to}});
        exits.emplace_back(1e6 * static_cast<double>(at.wall) + at.along_m, joined(exit, phrase(kWalls[at.wall])));
    }
    std::stable_sort(exits.begin(), exits.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    // The length of the sentence is limited, because nobody remembers more words of one sentence.
    std::vector<std::string> said;
    std::size_t words = 0;
    for (auto& [order, exit] : exits) {
        words += count_words(exit);
        if (!said.empty() && words > kMostWordsOfExits) break;
        said.push_back(std::move(exit));
    }
    std::string list = fmt::format("{}", fmt::join(said, "; "));
    if (said.size() < exits.size())
        list = phrase("describe.and_more", {{"names", list}, {"more", exits.size() - said.size()}});
    return exits.empty() ? phrase("describe.no_exits")
                         : phrase("describe.exits", {{"count", exits.size()}, {"exits", list}});
}

// Returns the size of the outline that the file states, if this room is the only one in it. The walkable floor is
// smaller, because it ends before the walls and before things along them. Otherwise returns the size of the floor.
Vec2 room_size_m(const Scene& scene, const navigation::RoomGraph& graph, std::uint32_t room) {
    const Vec2 floor_m(graph.rooms[room].bounds_m.size_m());
    if (!scene.stated) return floor_m;
    for (const StatedRoom& stated : scene.stated->rooms) {
        if (stated.rings.empty() || !holds(stated, graph.rooms[room].middle_m)) continue;
        for (std::uint32_t other = 0; other < graph.rooms.size(); ++other)
            if (other != room && holds(stated, graph.rooms[other].middle_m)) return floor_m;
        return outline_size_m(stated);
    }
    return floor_m;
}

std::string storeys_sentence(const SessionContext& context, const navigation::RoomGraph& graph) {
    const std::vector<StoreyOfRooms> storeys = storeys_of(*context.world.scene, graph);
    const std::string world = sentence_case(spoken_name(*context.world.scene));
    if (storeys.size() < 2)
        return phrase("overview.one_storey",
                      {{"world", world}, {"rooms", storeys.empty() ? 0 : storeys.front().rooms.size()}});
    std::vector<std::string> said;
    for (const StoreyOfRooms& storey : storeys)
        said.push_back(phrase("overview.rooms", {{"rooms", storey.rooms.size()}}));
    return phrase("overview.storeys",
                  {{"world", world}, {"storeys", storeys.size()}, {"rooms", fmt::format("{}", fmt::join(said, ", "))}});
}

// Returns the wings and other parts that the file names, each with its number of rooms; empty if it names fewer than
// two.
std::string parts_sentence(const SessionContext& context, const navigation::RoomGraph& graph) {
    std::map<std::string, std::size_t> rooms_of;
    for (std::uint32_t room = 0; room < graph.rooms.size(); ++room)
        if (const std::string part = part_of_building(*context.world.scene, graph, room); !part.empty())
            ++rooms_of[part];
    if (rooms_of.size() < 2) return {};
    std::vector<std::string> said;
    for (const auto& [part, rooms] : rooms_of) {
        if (said.size() == kMostParts) break;
        said.push_back(phrase("overview.part", {{"part", part}, {"rooms", rooms}}));
    }
    std::string list = fmt::format("{}", fmt::join(said, "; "));
    if (rooms_of.size() > said.size())
        list = phrase("overview.and_more", {{"names", list}, {"more", rooms_of.size() - said.size()}});
    return phrase("overview.parts", {{"parts", list}});
}

std::string shape_sentence(const SessionContext& context, const navigation::RoomGraph& graph) {
    std::vector<Aabb> roofed, all;
    for (const navigation::Room& room : graph.rooms) {
        all.push_back(room.bounds_m);
        if (under_roof(*context.world.solids, room.middle_m)) roofed.push_back(room.bounds_m);
    }
    const std::vector<Aabb>& boxes = roofed.empty() ? all : roofed;
    Aabb whole;
    for (const Aabb& box : boxes) whole.include(box);
    const Vec3 size = whole.size_m();
    const Outline outline = outline_of(boxes);
    constexpr std::array kCorners{"compass.north_east", "compass.south_east", "compass.south_west",
                                  "compass.north_west"};
    std::string shape;
    switch (outline.shape) {
        case OutlineShape::Rectangle:
            shape = phrase("overview.rectangle");
            break;
        case OutlineShape::CornerMissing:
            shape = phrase("overview.corner_missing",
                           {{"corner", phrase(kCorners[static_cast<std::size_t>(outline.corner)])}});
            break;
        case OutlineShape::Court:
            shape = phrase("overview.court");
            break;
        case OutlineShape::Irregular:
            shape = phrase("overview.irregular");
            break;
    }
    return phrase("overview.shape", {{"shape", shape}, {"wide", size.x}, {"deep", size.y}});
}

std::string neighbours_sentence(const navigation::RoomGraph& graph) {
    std::vector<std::set<std::uint32_t>> joins(graph.rooms.size());
    for (const navigation::Portal& portal : graph.portals) {
        if (portal.rooms[0] == portal.rooms[1]) continue;
        joins[portal.rooms[0]].insert(portal.rooms[1]);
        joins[portal.rooms[1]].insert(portal.rooms[0]);
    }
    std::vector<std::string> said;
    std::size_t words = 0;
    bool left_out = false;
    while (said.size() < kMostHubs) {
        const auto hub = std::max_element(joins.begin(), joins.end(),
                                          [](const auto& a, const auto& b) { return a.size() < b.size(); });
        if (hub == joins.end() || hub->empty()) break;
        const auto at = static_cast<std::uint32_t>(hub - joins.begin());
        std::vector<std::string> names;
        std::size_t more = 0;
        for (const std::uint32_t other : *hub) {
            if (names.size() == kMostNeighbours) ++more;
            else names.push_back(graph.rooms[other].name);
            joins[other].erase(at);
        }
        hub->clear();
        std::string list = fmt::format("{}", fmt::join(names, ", "));
        if (more > 0) list = phrase("overview.and_more", {{"names", list}, {"more", more}});
        const std::string name = graph.rooms[at].name;
        const std::string neighbours =
            phrase("overview.joins", {{"room", said.empty() ? sentence_case(name) : name}, {"names", list}});
        words += count_words(neighbours);
        if (!said.empty() && words > kMostWordsOfNeighbours) {
            left_out = true;
            break;
        }
        said.push_back(neighbours);
    }
    if (said.empty()) return phrase("overview.one_room");
    const bool rest =
        left_out || std::any_of(joins.begin(), joins.end(), [](const auto& others) { return !others.empty(); });
    return phrase(rest ? "overview.first_joins" : "overview.all_joins",
                  {{"joins", fmt::format("{}", fmt::join(said, "; "))}});
}

}  // namespace

std::string room_size_words(const SessionContext& context, const Rooms& rooms, std::uint32_t room) {
    const navigation::RoomGraph& graph = rooms.graph();
    contract_pre(room < graph.rooms.size());
    const Vec2 size = room_size_m(*context.world.scene, graph, room);
    return phrase("describe.room", {{"room", sentence_case(graph.rooms[room].name)},
                                    {"size", size_words(size.x, size.y, distances(context))}});
}

std::string part_of_building(const Scene& scene, const navigation::RoomGraph& graph, std::uint32_t room) {
    const StatedRoom* const stated = navigation::stated_room_at(scene, graph.rooms[room].middle_m);
    return stated ? one_line(stated->part) : std::string();
}

std::string room_words(const SessionContext& context, const Rooms& rooms, std::uint32_t room) {
    const navigation::RoomGraph& graph = rooms.graph();
    contract_pre(room < graph.rooms.size());
    const navigation::Room& said = graph.rooms[room];
    const Vec2 size = room_size_m(*context.world.scene, graph, room);
    const std::string name = sentence_case(said.name);
    // If the name of the room already consists of the size, the size is not repeated.
    const bool by_size =
        !said.given && said.map_name.empty() && said.made.thing.empty() && said.kind == navigation::RoomKind::Room;
    std::string text =
        by_size ? name + "."
                : phrase("describe.room", {{"room", name}, {"size", size_words(size.x, size.y, distances(context))}});
    const std::vector<StoreyOfRooms> storeys = storeys_of(*context.world.scene, graph);
    if (const std::size_t on = storey_of_room(storeys, graph, room); storeys.size() > 1 && on < storeys.size())
        text += " " + (storeys[on].file_name.empty()
                           ? phrase("describe.storey", {{"storey", on + 1}})
                           : phrase("describe.storey_named", {{"storey", storey_name(storeys, on)}}));
    if (const std::string part = part_of_building(*context.world.scene, graph, room); !part.empty())
        text += " " + phrase("describe.part", {{"part", part}});
    if (std::string runs = extent_words(context, rooms, room); !runs.empty()) text += " " + runs;
    text += " " + exits_words(context, graph, room);
    std::array<std::vector<std::pair<double, std::string>>, kMiddle + 1> things;
    for (const Feature& feature : context.world.scene->features) {
        if (!is_furniture(feature) || room_of(rooms, feature.bounds_m) != room) continue;
        const AtWall at = at_wall(said.bounds_m, feature.bounds_m, kThingAtWall_m);
        const std::string thing = spoken_name(feature);
        if (!thing.empty()) things[at.wall].emplace_back(at.along_m, thing);
    }
    bool any = false;
    for (std::size_t wall = 0; wall <= kMiddle; ++wall) {
        if (things[wall].empty()) continue;
        any = true;
        const std::string where = wall == kMiddle ? phrase("describe.middle") : sentence_case(phrase(kWalls[wall]));
        text += " " + phrase("describe.wall", {{"wall", where}, {"things", things_words(std::move(things[wall]))}});
    }
    return any ? text : text + " " + phrase("describe.empty");
}

std::string building_words(const SessionContext& context, const Rooms& rooms) {
    const navigation::RoomGraph& graph = rooms.graph();
    if (graph.rooms.empty()) return phrase("rooms.nowhere");
    const std::string parts = parts_sentence(context, graph);
    return storeys_sentence(context, graph) + " " + (parts.empty() ? parts : parts + " ") +
           shape_sentence(context, graph) + " " + neighbours_sentence(graph);
}

Outline outline_of(const std::vector<Aabb>& boxes_m) {
    contract_pre(!boxes_m.empty());
    constexpr int kCells = 24;  // number of cells of the grid in each direction
    // The shape of the outline depends on whether the covered share of a quarter, or of the whole, is above or below
    // these limits.
    constexpr double kWhole = 0.8, kMissing = 0.35, kFull = 0.7;
    Aabb whole;
    for (const Aabb& box : boxes_m) whole.include(box);
    const Vec3 size = whole.size_m();
    const auto covered = [&](int x, int y) {
        const double at_x = whole.min_m.x + (x + 0.5) * size.x / kCells,
                     at_y = whole.min_m.y + (y + 0.5) * size.y / kCells;
        return std::any_of(boxes_m.begin(), boxes_m.end(), [&](const Aabb& box) {
            return at_x >= box.min_m.x && at_x <= box.max_m.x && at_y >= box.min_m.y && at_y <= box.max_m.y;
        });
    };
    std::array<double, 4> quarter{};  // covered share of each quarter, clockwise from the north-east
    double middle = 0.0;
    for (int y = 0; y < kCells; ++y)
        for (int x = 0; x < kCells; ++x) {
            if (!covered(x, y)) continue;
            const bool east = x >= kCells / 2, north = y >= kCells / 2;
            quarter[north ? (east ? 0 : 3) : (east ? 1 : 2)] += 4.0 / (kCells * kCells);
            const auto inside = [](int at) { return at >= kCells / 3 && at < kCells - kCells / 3; };
            if (inside(x) && inside(y)) middle += 9.0 / (kCells * kCells);
        }
    const double all = 0.25 * (quarter[0] + quarter[1] + quarter[2] + quarter[3]);
    const bool round = std::all_of(quarter.begin(), quarter.end(), [](double share) { return share > 0.5; });
    if (middle < 0.25 && round) return {OutlineShape::Court, 0};
    if (all >= kWhole) return {};
    for (int corner = 0; corner < 4; ++corner) {
        const bool others = [&] {
            for (int other = 0; other < 4; ++other)
                if (other != corner && quarter[static_cast<std::size_t>(other)] < kFull) return false;
            return true;
        }();
        if (others && quarter[static_cast<std::size_t>(corner)] <= kMissing)
            return {OutlineShape::CornerMissing, corner};
    }
    return {OutlineShape::Irregular, 0};
}

}  // namespace handrail::core
