// A building whose file states its rooms, as it is written in words.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/exports/as_words.h"
#include "worlds/geometry/flat_parts.h"

namespace handrail {
namespace {

constexpr double kStatedFinest_m = 1e-4, kSlabs_m = 0.3, kLeastStorey_m = 2.3, kMostStorey_m = 12.0;
constexpr double kStepDown_m = 0.3;   // from there on an opening is a drop
constexpr double kMostRaise_m = 1.5;  // of what is said to be raised or sunk
constexpr double kStatedLevel_m = 0.02;

// "Stairs, Level 1" without the level that was put behind it.
std::string without_level(const std::string& name, const std::string& level) {
    const std::string end = phrase("plan.on_level", {{"name", ""}, {"level", level}});
    return name.size() > end.size() && name.ends_with(end) ? name.substr(0, name.size() - end.size()) : name;
}

bool same_outline(const StatedRoom& a, const StatedRoom& b) {
    if (a.rings.size() != b.rings.size()) return false;
    for (std::size_t i = 0; i < a.rings.size(); ++i) {
        if (a.rings[i].size() != b.rings[i].size()) return false;
        for (std::size_t k = 0; k < a.rings[i].size(); ++k)
            if (glm::length(a.rings[i][k] - b.rings[i][k]) > 0.01) return false;
    }
    return true;
}

// A lift without a shaft, which the file states by itself: one with a shaft has the name of that.
bool is_platform(const Scene& scene, const StatedPortal& portal) {
    const Feature* feature = scene.find(portal.feature);
    if (!feature || feature->bounds_m.empty() || portal.rooms.size() != 2 || !portal.guid.empty()) return false;
    return scene.stated->rooms[portal.rooms[0]].storey != scene.stated->rooms[portal.rooms[1]].storey;
}

// Stairs from one room to another that can be written as they stand.
bool takes_flight(const Scene& scene, const StatedPortal& portal) {
    return portal.kind == StatedPortalKind::Stairs && portal.rooms.size() == 2 &&
           scene.stated->rooms[portal.rooms[0]].storey != scene.stated->rooms[portal.rooms[1]].storey &&
           flight_of(scene, portal.feature);
}

// An opening between floors of which one lies a step below the other.
void note_drop(const WordsHouse& house, WordsHouse::Door& door) {
    const WordsHouse::Room &one = house.rooms[door.rooms[0]], &other = house.rooms[door.rooms[1]];
    if (one.kind != WordsHouse::Kind::Room || other.kind != WordsHouse::Kind::Room || one.storey != other.storey)
        return;
    const double down_m = one.raised_m - other.raised_m;
    if (std::abs(down_m) < kStepDown_m) return;
    if (down_m < 0.0) std::swap(door.rooms[0], door.rooms[1]);
    door.drop_m = std::abs(down_m);
}

}  // namespace

WordsHouse stated_house(const Scene& scene, WordLanguage language) {
    const StatedBuilding& stated = *scene.stated;
    WordsHouse house;
    house.name = spoken_name(scene);
    house.wall_m = stated.wall_m;
    house.wall_material = wall_material(scene);
    const FloorMaterials floors(scene);
    const bool german = language == WordLanguage::German;
    // Storeys that rooms lie on, from below.
    const auto storey_of = [&](const StatedRoom& room) {
        if (room.storey < stated.storeys.size()) return room.storey;
        std::uint32_t best = 0;
        for (std::uint32_t s = 0; s < stated.storeys.size(); ++s)
            if (std::abs(stated.storeys[s].floor_m - room.floor_m) <
                std::abs(stated.storeys[best].floor_m - room.floor_m))
                best = s;
        return best;
    };
    std::map<std::uint32_t, double> heights;
    for (const StatedRoom& room : stated.rooms)
        heights[storey_of(room)] = std::max(heights[storey_of(room)], room.height_m + kSlabs_m);
    std::map<std::uint32_t, std::size_t> number;
    std::vector<std::pair<double, std::uint32_t>> order;
    for (const auto& [s, height] : heights)
        order.emplace_back(s < stated.storeys.size() ? stated.storeys[s].floor_m : 0.0, s);
    std::sort(order.begin(), order.end());
    for (const auto& [floor_m, s] : order) {
        number[s] = house.storeys.size();
        std::string name = s < stated.storeys.size() ? one_line(stated.storeys[s].name) : std::string();
        if (name.empty()) name = fmt::format("{} {}", german ? "Ebene" : "Level", number[s]);
        house.storeys.push_back({name, floor_m, std::clamp(heights[s], kLeastStorey_m, kMostStorey_m)});
    }
    for (std::size_t s = 0; s + 1 < house.storeys.size(); ++s)
        house.storeys[s].height_m =
            std::clamp(house.storeys[s + 1].floor_m - house.storeys[s].floor_m, kLeastStorey_m, kMostStorey_m);
    // Stairs and lifts that have one outline on all their storeys are one.
    std::vector<std::size_t> parent(stated.rooms.size());
    for (std::size_t r = 0; r < parent.size(); ++r) parent[r] = r;
    const auto root = [&](std::size_t r) {
        while (parent[r] != r) r = parent[r];
        return r;
    };
    std::map<std::size_t, WordsHouse::Kind> kinds;
    std::vector<const StatedPortal*> platforms, flights;
    for (const StatedPortal& portal : stated.portals) {
        if (portal.kind != StatedPortalKind::Stairs && portal.kind != StatedPortalKind::Lift) continue;
        if (portal.kind == StatedPortalKind::Lift && is_platform(scene, portal)) {
            platforms.push_back(&portal);
            continue;
        }
        bool one = portal.rooms.size() > 1;
        for (const std::uint32_t r : portal.rooms) one &= same_outline(stated.rooms[r], stated.rooms[portal.rooms[0]]);
        // Stairs that fill their room on all its storeys are that room; others stand in one.
        const bool fill = one && (portal.kind == StatedPortalKind::Lift ||
                                  std::all_of(portal.rooms.begin(), portal.rooms.end(),
                                              [&](std::uint32_t r) { return stated.rooms[r].holds_stairs; }));
        if (!fill && takes_flight(scene, portal)) {
            flights.push_back(&portal);
            continue;
        }
        if (!one) {
            std::string names;
            for (const std::uint32_t r : portal.rooms) names += (names.empty() ? "" : ", ") + stated.rooms[r].name;
            house.lost.push_back(
                german ? fmt::format("Treppe oder Aufzug ohne eigenen Raum: {} ({}).", portal.name, names)
                       : fmt::format("Stairs or lift without a room of its own: {} ({}).", portal.name, names));
            continue;
        }
        for (const std::uint32_t r : portal.rooms) parent[root(r)] = root(portal.rooms[0]);
        kinds[root(portal.rooms[0])] =
            portal.kind == StatedPortalKind::Lift ? WordsHouse::Kind::Lift : WordsHouse::Kind::Stairs;
    }
    std::map<std::size_t, std::size_t> room_of_root;
    std::vector<std::size_t> room_of(stated.rooms.size());
    for (std::size_t r = 0; r < stated.rooms.size(); ++r) {
        const StatedRoom& from = stated.rooms[r];
        const std::size_t storey = number.at(storey_of(from)), top = root(r);
        if (const auto found = room_of_root.find(top); found != room_of_root.end()) {
            WordsHouse::Room& room = house.rooms[found->second];
            room.storey = std::min(room.storey, storey);
            room.to_storey = std::max(room.to_storey, storey);
            room_of[r] = found->second;
            continue;
        }
        WordsHouse::Room room;
        room.name = one_line(from.name);
        room.storey = room.to_storey = storey;
        room.rings = joined_rings(from.rings);
        room.floor_material = floors.at(from.at_m);
        if (const double raised_m = from.floor_m - house.storeys[storey].floor_m;
            std::abs(raised_m) > kStatedLevel_m && std::abs(raised_m) <= kMostRaise_m && !kinds.contains(top))
            room.raised_m = std::round(raised_m / kStatedFinest_m) * kStatedFinest_m;
        if (const auto kind = kinds.find(top); kind != kinds.end()) {
            room.kind = kind->second;
            room.name = without_level(room.name, house.storeys[storey].name);
        } else if (from.height_m > 0.0 &&
                   from.height_m < house.storeys[storey].height_m - kSlabs_m - room.raised_m - 0.01) {
            room.height_m = from.height_m;
        }
        room_of[r] = room_of_root[top] = house.rooms.size();
        house.rooms.push_back(std::move(room));
    }
    for (const StatedPortal& portal : stated.portals) {
        if (portal.kind != StatedPortalKind::Door && portal.kind != StatedPortalKind::Opening) continue;
        WordsHouse::Door door;
        door.opening = portal.kind == StatedPortalKind::Opening;
        for (const std::uint32_t r : portal.rooms)
            if (door.rooms.size() < 2) door.rooms.push_back(room_of[r]);
        // Of stairs and a room the room tells the storey.
        if (door.rooms.size() > 1 && house.rooms[door.rooms[0]].kind != WordsHouse::Kind::Room)
            std::swap(door.rooms[0], door.rooms[1]);
        if (door.opening && door.rooms.size() > 1) note_drop(house, door);
        door.at_m = Vec2(portal.place_m);
        door.width_m = std::max(portal.width_m, 0.1);
        if (const Feature* feature = scene.find(portal.feature)) {
            if (!feature->made_name) door.name = one_line(feature->name);
            for (const Mover& mover : scene.movers)
                if (mover.feature == portal.feature) {
                    door.sliding = mover.lift == Mover{}.lift && glm::length(mover.slide_m) > 0.1;
                    door.by_itself = mover.lift == Mover{}.lift && !mover.approach_m.empty();
                }
        }
        if (door.rooms.empty()) {
            house.lost.push_back(german ? fmt::format("Eine Tür ohne Raum: {}.", portal.name)
                                        : fmt::format("A door of no room: {}.", portal.name));
            continue;
        }
        house.doors.push_back(std::move(door));
    }
    for (const StatedPortal* portal : platforms) {
        WordsHouse::Lift lift{one_line(portal->name), room_of[portal->rooms[0]], room_of[portal->rooms[1]]};
        if (house.rooms[lift.from].storey > house.rooms[lift.to].storey) std::swap(lift.from, lift.to);
        const Aabb& box = scene.find(portal->feature)->bounds_m;
        lift.at_m = Vec2(box.centre_m());
        lift.size_m = Vec2(box.size_m());
        house.lifts.push_back(std::move(lift));
    }
    for (const StatedPortal* portal : flights) {
        std::optional<WordsHouse::Flight> flight = flight_of(scene, portal->feature);
        if (!flight) continue;
        flight->from = room_of[portal->rooms[0]], flight->to = room_of[portal->rooms[1]];
        if (house.rooms[flight->from].storey > house.rooms[flight->to].storey) std::swap(flight->from, flight->to);
        if (!scene.find(portal->feature)->made_name) flight->name = one_line(portal->name);
        house.flights.push_back(std::move(*flight));
    }
    furnish(house, scene, language);
    return house;
}

}  // namespace handrail
