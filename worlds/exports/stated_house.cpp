// Collects what the file of a building states about its rooms, for the text that describes the building.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/exports/as_words.h"
#include "worlds/geometry/flat_parts.h"

namespace handrail::exports {
namespace {

constexpr double kStatedFinest_m = 1e-4, kSlabs_m = 0.3, kLeastStorey_m = 2.3;
constexpr double kStepDown_m = 0.3;   // an opening between floors with at least this difference in height is a drop
constexpr double kMostRaise_m = 1.5;  // greatest height by which a room can be described as raised or sunk
constexpr double kStatedLevel_m = 0.02;

// Removes the level from the end of a name, as in "Stairs, Level 1".
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

// Returns whether a lift has no shaft. The file states such a lift separately; a lift with a shaft has the guid of the
// shaft.
bool is_platform(const Scene& scene, const StatedPortal& portal) {
    const Feature* feature = scene.find(portal.feature);
    if (!feature || feature->bounds_m.empty() || portal.rooms.size() != 2 || !portal.guid.empty()) return false;
    return scene.stated->rooms[portal.rooms[0]].storey != scene.stated->rooms[portal.rooms[1]].storey;
}

// Returns whether the portal is stairs from one room to another that the text can describe exactly.
bool takes_flight(const Scene& scene, const StatedPortal& portal) {
    return portal.kind == StatedPortalKind::Stairs && portal.rooms.size() == 2 &&
           scene.stated->rooms[portal.rooms[0]].storey != scene.stated->rooms[portal.rooms[1]].storey &&
           flight_of(scene, portal.feature);
}

// Marks an opening as a drop if one floor is a step below the other.
void note_drop(const WordsHouse& house, WordsHouse::Door& door) {
    const WordsHouse::Room &one = house.rooms[door.rooms[0]], &other = house.rooms[door.rooms[1]];
    if (one.kind != WordsHouse::Kind::Room || other.kind != WordsHouse::Kind::Room || one.storey != other.storey)
        return;
    const double down_m = one.raised_m - other.raised_m;
    if (std::abs(down_m) < kStepDown_m) return;
    if (down_m < 0.0) std::swap(door.rooms[0], door.rooms[1]);
    door.drop_m = std::abs(down_m);
}

// Returns the storey of a room. If the file states none, it is the storey with the nearest floor height.
std::uint32_t storey_of(const StatedBuilding& stated, const StatedRoom& room) {
    if (room.storey < stated.storeys.size()) return room.storey;
    std::uint32_t best = 0;
    for (std::uint32_t s = 0; s < stated.storeys.size(); ++s)
        if (std::abs(stated.storeys[s].floor_m - room.floor_m) < std::abs(stated.storeys[best].floor_m - room.floor_m))
            best = s;
    return best;
}

// Builds the house step by step, because each step depends on the previous steps: storeys, rooms that belong together,
// rooms, doors, lifts and flights.
class StatedHouse {
public:
    StatedHouse(const Scene& scene, bool german) : scene_(scene), stated_(*scene.stated), german_(german) {
        house_.name = spoken_name(scene);
        house_.wall_m = stated_.wall_m;
        house_.wall_material = wall_material(scene);
    }

    WordsHouse write() {
        add_storeys();
        part_stairs_and_lifts();
        add_rooms();
        for (const StatedPortal& portal : stated_.portals)
            if (portal.kind == StatedPortalKind::Door || portal.kind == StatedPortalKind::Opening) add_door(portal);
        for (const StatedPortal* portal : platforms_) add_lift(*portal);
        for (const StatedPortal* portal : flights_) add_flight(*portal);
        return std::move(house_);
    }

private:
    // Adds the storeys that have rooms, from the bottom up.
    void add_storeys() {
        std::map<std::uint32_t, double> heights;
        for (const StatedRoom& room : stated_.rooms) {
            double& height_m = heights[storey_of(stated_, room)];
            height_m = std::max(height_m, room.height_m + kSlabs_m);
        }
        std::vector<std::pair<double, std::uint32_t>> order;
        for (const auto& [s, height_m] : heights)
            order.emplace_back(s < stated_.storeys.size() ? stated_.storeys[s].floor_m : 0.0, s);
        std::sort(order.begin(), order.end());
        std::vector<WordsHouse::Storey>& storeys = house_.storeys;
        for (const auto& [floor_m, s] : order) {
            number_[s] = storeys.size();
            std::string name = s < stated_.storeys.size() ? one_line(stated_.storeys[s].name) : std::string();
            if (name.empty()) name = fmt::format("{} {}", german_ ? "Ebene" : "Level", number_[s]);
            storeys.push_back({name, floor_m, std::clamp(heights[s], kLeastStorey_m, kHighestStorey_m)});
        }
        for (std::size_t s = 0; s + 1 < storeys.size(); ++s)
            storeys[s].height_m =
                std::clamp(storeys[s + 1].floor_m - storeys[s].floor_m, kLeastStorey_m, kHighestStorey_m);
    }

    std::size_t root(std::size_t r) const {
        while (parent_[r] != r) r = parent_[r];
        return r;
    }

    // Joins the pieces of stairs or of a lift into one room if they have the same outline on all their storeys.
    void part_stairs_and_lifts() {
        parent_.resize(stated_.rooms.size());
        for (std::size_t r = 0; r < parent_.size(); ++r) parent_[r] = r;
        for (const StatedPortal& portal : stated_.portals)
            if (portal.kind == StatedPortalKind::Stairs || portal.kind == StatedPortalKind::Lift) part(portal);
    }

    void part(const StatedPortal& portal) {
        const bool lift = portal.kind == StatedPortalKind::Lift;
        if (lift && is_platform(scene_, portal)) return platforms_.push_back(&portal);
        bool one = portal.rooms.size() > 1;
        for (const std::uint32_t r : portal.rooms)
            one &= same_outline(stated_.rooms[r], stated_.rooms[portal.rooms[0]]);
        // Stairs that fill their room on all storeys become that room. Other stairs are described inside their room.
        const bool fill = one && (lift || std::all_of(portal.rooms.begin(), portal.rooms.end(),
                                                      [&](std::uint32_t r) { return stated_.rooms[r].holds_stairs; }));
        if (!fill && takes_flight(scene_, portal)) return flights_.push_back(&portal);
        if (!one) {
            std::string names;
            for (const std::uint32_t r : portal.rooms) names += (names.empty() ? "" : ", ") + stated_.rooms[r].name;
            return lose("Treppe oder Aufzug ohne eigenen Raum: {} ({}).",
                        "Stairs or lift without a room of its own: {} ({}).", portal.name, names);
        }
        for (const std::uint32_t r : portal.rooms) parent_[root(r)] = root(portal.rooms[0]);
        kinds_[root(portal.rooms[0])] = lift ? WordsHouse::Kind::Lift : WordsHouse::Kind::Stairs;
    }

    void add_rooms() {
        std::map<std::size_t, std::size_t> room_of_root;
        room_of_.resize(stated_.rooms.size());
        for (std::size_t r = 0; r < stated_.rooms.size(); ++r) {
            const std::size_t storey = number_.at(storey_of(stated_, stated_.rooms[r])), top = root(r);
            if (const auto found = room_of_root.find(top); found != room_of_root.end()) {
                WordsHouse::Room& room = house_.rooms[found->second];
                room.storey = std::min(room.storey, storey);
                room.to_storey = std::max(room.to_storey, storey);
                room_of_[r] = found->second;
                continue;
            }
            room_of_[r] = room_of_root[top] = house_.rooms.size();
            house_.rooms.push_back(room_of(stated_.rooms[r], storey, top));
        }
    }

    WordsHouse::Room room_of(const StatedRoom& from, std::size_t storey, std::size_t top) const {
        WordsHouse::Room room;
        room.name = one_line(from.name);
        room.storey = room.to_storey = storey;
        room.rings = joined_rings(from.rings);
        room.floor_material = floors_.at(from.at_m);
        if (const auto kind = kinds_.find(top); kind != kinds_.end()) {
            room.kind = kind->second;
            room.name = without_level(room.name, house_.storeys[storey].name);
            return room;
        }
        const double raised_m = from.floor_m - house_.storeys[storey].floor_m;
        if (std::abs(raised_m) > kStatedLevel_m && std::abs(raised_m) <= kMostRaise_m)
            room.raised_m = std::round(raised_m / kStatedFinest_m) * kStatedFinest_m;
        if (from.height_m > 0.0 && from.height_m < house_.storeys[storey].height_m - kSlabs_m - room.raised_m - 0.01)
            room.height_m = from.height_m;
        return room;
    }

    void add_door(const StatedPortal& portal) {
        WordsHouse::Door door;
        door.opening = portal.kind == StatedPortalKind::Opening;
        for (const std::uint32_t r : portal.rooms)
            if (door.rooms.size() < 2) door.rooms.push_back(room_of_[r]);
        if (door.rooms.empty()) return lose("Eine Tür ohne Raum: {}.", "A door of no room: {}.", portal.name);
        // If a door joins stairs and a room, put the room first, because it determines the storey of the door.
        if (door.rooms.size() > 1 && house_.rooms[door.rooms[0]].kind != WordsHouse::Kind::Room)
            std::swap(door.rooms[0], door.rooms[1]);
        if (door.opening && door.rooms.size() > 1) note_drop(house_, door);
        door.at_m = Vec2(portal.place_m);
        door.width_m = std::max(portal.width_m, 0.1);
        if (const Feature* feature = scene_.find(portal.feature); feature && !feature->made_name)
            door.name = one_line(feature->name);
        for (const Mover& mover : scene_.movers)
            if (scene_.find(portal.feature) && mover.feature == portal.feature) {
                door.sliding = mover.lift == Mover{}.lift && glm::length(mover.slide_m) > 0.1;
                door.by_itself = mover.lift == Mover{}.lift && !mover.approach_m.empty();
            }
        house_.doors.push_back(std::move(door));
    }

    void add_lift(const StatedPortal& portal) {
        WordsHouse::Lift lift{one_line(portal.name), room_of_[portal.rooms[0]], room_of_[portal.rooms[1]]};
        if (house_.rooms[lift.from].storey > house_.rooms[lift.to].storey) std::swap(lift.from, lift.to);
        const Aabb& box = scene_.find(portal.feature)->bounds_m;
        lift.at_m = Vec2(box.centre_m());
        lift.size_m = Vec2(box.size_m());
        house_.lifts.push_back(std::move(lift));
    }

    void add_flight(const StatedPortal& portal) {
        std::optional<WordsHouse::Flight> flight = flight_of(scene_, portal.feature);
        if (!flight) return;
        flight->from = room_of_[portal.rooms[0]], flight->to = room_of_[portal.rooms[1]];
        if (house_.rooms[flight->from].storey > house_.rooms[flight->to].storey) std::swap(flight->from, flight->to);
        if (!scene_.find(portal.feature)->made_name) flight->name = one_line(portal.name);
        house_.flights.push_back(std::move(*flight));
    }

    template <typename... Args>
    void lose(const char* german, const char* english, const Args&... args) {
        house_.lost.push_back(fmt::format(fmt::runtime(german_ ? german : english), args...));
    }

    const Scene& scene_;
    const StatedBuilding& stated_;
    const bool german_;
    const FloorMaterials floors_{scene_};
    WordsHouse house_;
    std::map<std::uint32_t, std::size_t> number_;  // for each stated storey: its index in the house
    // Union-find: for each stated room, another one that belongs to the same room of the house.
    std::vector<std::size_t> parent_;
    std::map<std::size_t, WordsHouse::Kind> kinds_;  // kind of each union-find root that is not a plain room
    std::vector<std::size_t> room_of_;               // for each stated room: its index in the house
    std::vector<const StatedPortal*> platforms_, flights_;
};

}  // namespace

WordsHouse stated_house(const Scene& scene, words::WordLanguage language) {
    WordsHouse house = StatedHouse(scene, language == words::WordLanguage::German).write();
    furnish(house, scene, language);
    return house;
}

}  // namespace handrail::exports
