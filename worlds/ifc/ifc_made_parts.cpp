#include "worlds/ifc/ifc_made_parts.h"

#include <algorithm>
#include <array>

#include "worlds/base/text.h"
#include "worlds/geometry/clip.h"

namespace handrail::ifc {
namespace {

constexpr double kFloorThick_m = 0.1, kWallThick_m = 0.05;
// Range below and above the level of a room. A surface within this range is regarded as the floor of the room,
// including a sunken floor.
constexpr double kBelow_m = 0.9, kAbove_m = 0.2;
constexpr double kStepDown_m = 0.05;  // furniture that extends this far below the level is on a sunken floor
constexpr double kLeastRoom_m2 = 0.5, kLeastHigh_m = 1.5;

bool carries(PartRole role) {
    constexpr std::array kRoles{PartRole::Slab,  PartRole::Roof,  PartRole::Cover,     PartRole::Structure,
                                PartRole::Other, PartRole::Panel, PartRole::Stairs,    PartRole::Ramp,
                                PartRole::Lift,  PartRole::Beam,  PartRole::Escalator, PartRole::Walkway};
    return std::find(kRoles.begin(), kRoles.end(), role) != kRoles.end();
}

bool is_thing(PartRole role) { return role == PartRole::Furniture || role == PartRole::Fixture; }

bool leads_up(PartRole role) {
    return role == PartRole::Stairs || role == PartRole::Ramp || role == PartRole::Lift || role == PartRole::Escalator;
}

// Returns true if a room has no floor on purpose, according to its name in English or German.
bool is_open_below(const StatedRoom& room) {
    constexpr std::array<std::string_view, 8> kWords{"void",    "shaft",  "below", "luftraum",
                                                     "schacht", "atrium", "stair", "treppe"};
    const std::string name = lower_ascii(room.name);
    // The text must be at the beginning of a word of the name: "upstairs" does not mean stairs.
    return std::any_of(kWords.begin(), kWords.end(), [&](std::string_view word) {
        const std::size_t at = name.find(word);
        return at != std::string::npos && (at == 0 || name[at - 1] < 'a' || name[at - 1] > 'z');
    });
}

// Returns evenly spread points within the outline.
std::vector<Vec3> places_in(const StatedRoom& room) {
    constexpr int kAcross = 7;
    Aabb box;
    for (const Ring& ring : room.rings)
        for (const Vec2& p : ring) box.include({p.x, p.y, room.floor_m});
    std::vector<Vec3> places;
    for (int x = 0; x < kAcross; ++x)
        for (int y = 0; y < kAcross; ++y) {
            const Vec2 at{box.min_m.x + box.size_m().x * (x + 0.5) / kAcross,
                          box.min_m.y + box.size_m().y * (y + 0.5) / kAcross};
            if (inside(room.rings, at)) places.emplace_back(at.x, at.y, room.floor_m);
        }
    return places;
}

// Returns true if there is no floor below any point of the room. Stairs and lifts that come up into the room are not
// regarded as floor.
bool lacks_floor(const IfcBuilding& building, const BoxIndex& index, const StatedRoom& room) {
    const std::vector<Vec3> places = places_in(room);
    if (places.empty()) return false;
    std::vector<std::uint32_t> near;
    for (const Vec3& place : places) {
        const Vec3 low = place - Vec3(0.0, 0.0, kBelow_m), high = place + Vec3(0.0, 0.0, kAbove_m);
        index.find({low, high}, near);
        for (const std::uint32_t p : near) {
            const IfcPart& part = building.parts[p];
            if (!leads_up(part.role) && carries(part.role) && crosses(part.body, low, high)) return false;
            if (is_thing(part.role) && crosses(part.body, low, place - Vec3(0.0, 0.0, kStepDown_m))) return false;
        }
    }
    return true;
}

void add_part(IfcBuilding& building, PartRole role, const StatedRoom& room, std::vector<ConvexSolid> solids) {
    if (solids.empty()) return;
    IfcPart part;
    part.role = role;
    part.line = room.source.line;
    part.name = room.name;
    part.body.solids = std::move(solids);
    part.box = part.body.bounds_m();
    part.whole = part.same_as = building.parts.size();
    building.parts.push_back(std::move(part));
}

// Returns the floor that is made for a room. The floor has holes above all parts that come up through it.
std::vector<ConvexSolid> floor_of(const IfcBuilding& building, const BoxIndex& index, const StatedRoom& room) {
    Frame frame;
    frame.origin_m = {0.0, 0.0, room.floor_m - kFloorThick_m};
    Body body;
    for (const Ring& part : convex_parts(room.rings))
        if (std::optional<ConvexSolid> solid = prism(part, {0.0, 0.0, kFloorThick_m}, frame))
            body.solids.push_back(std::move(*solid));
    std::vector<std::uint32_t> near;
    index.find(body.bounds_m(), near);
    for (const std::uint32_t p : near) {
        const Aabb& box = building.parts[p].box;
        if (!leads_up(building.parts[p].role) || box.min_m.z > room.floor_m - kLeastHigh_m) continue;
        cut_away(body, std::array{Plane{{1, 0, 0}, box.max_m.x}, Plane{{-1, 0, 0}, -box.min_m.x},
                                  Plane{{0, 1, 0}, box.max_m.y}, Plane{{0, -1, 0}, -box.min_m.y}});
    }
    return std::move(body.solids);
}

BoxIndex index_of(const IfcBuilding& building) {
    std::vector<Aabb> boxes;
    boxes.reserve(building.parts.size());
    for (const IfcPart& part : building.parts) boxes.push_back(part.box);
    return BoxIndex(boxes);
}

}  // namespace

std::vector<std::uint32_t> make_floors(IfcBuilding& building) {
    const BoxIndex index = index_of(building);
    std::vector<std::uint32_t> made;
    for (std::uint32_t r = 0; r < building.rooms.size(); ++r) {
        const StatedRoom& room = building.rooms[r];
        if (room.rings.empty() || room.area_m2 < kLeastRoom_m2 || room.height_m < kLeastHigh_m || is_open_below(room))
            continue;
        if (lacks_floor(building, index, room)) made.push_back(r);
    }
    // Floors are added only after all rooms were examined. The rooms of one storey adjoin, so an added floor could
    // otherwise be mistaken for the floor of the next room.
    for (const std::uint32_t r : made)
        add_part(building, PartRole::Slab, building.rooms[r], floor_of(building, index, building.rooms[r]));
    return made;
}

int make_walls(IfcBuilding& building) {
    const bool built = std::any_of(building.parts.begin(), building.parts.end(), [](const IfcPart& part) {
        return !part.body.empty() && part.role != PartRole::Furniture && part.role != PartRole::Fixture &&
               part.role != PartRole::Door && part.role != PartRole::Window;
    });
    if (built) return 0;
    int made = 0;
    for (const StatedRoom& room : std::vector<StatedRoom>(building.rooms)) {
        std::vector<ConvexSolid> solids;
        for (const Ring& ring : room.rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Vec2 from = ring[i], to = ring[(i + 1) % ring.size()], along = to - from;
                const double length_m = glm::length(along);
                if (!(length_m > kFlush_m) || !(room.height_m > kFlush_m)) continue;
                Frame frame;
                frame.x = Vec3(along.x, along.y, 0.0) / length_m;
                frame.y = glm::cross(frame.z, frame.x);
                frame.origin_m = {from.x, from.y, room.floor_m};
                // The wall is on the outer side of the edge, away from the room.
                const Vec2 out = Vec2(frame.y.x, frame.y.y) * kWallThick_m, middle = 0.5 * (from + to);
                const bool left = !inside(room.rings, middle + out);
                if (inside(room.rings, middle + out) == inside(room.rings, middle - out)) continue;
                if (std::optional<ConvexSolid> wall =
                        box_solid({-kWallThick_m, left ? 0.0 : -kWallThick_m, 0.0},
                                  {length_m + kWallThick_m, left ? kWallThick_m : 0.0, room.height_m}, frame))
                    solids.push_back(std::move(*wall));
            }
        if (solids.empty()) continue;
        add_part(building, PartRole::Wall, room, std::move(solids));
        ++made;
    }
    return made;
}

}  // namespace handrail::ifc
