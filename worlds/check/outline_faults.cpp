#include <algorithm>
#include <cmath>

#include "worlds/check/examined.h"
#include "worlds/navigation/stated_rooms.h"
#include "worlds/scene/honest_report.h"
#include "worlds/scene/stated_building.h"

namespace handrail::check {
namespace {

constexpr double kLeastOverlap_m2 = 0.5;
constexpr double kSamples = 2000.0;  // approximate limit on the number of sample points for a room
constexpr std::size_t kMostCorners = 2000;
constexpr double kBeyondDoor_m = 0.8;  // distance from the middle of a doorway to where a person stands in front of it

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return turn(a, b, c) * turn(a, b, d) < -1e-12 && turn(c, d, a) * turn(c, d, b) < -1e-12;
}

// Returns the first place where the ring crosses itself. Empty if it does not.
std::optional<Vec2> crossing(const std::vector<Vec2>& ring) {
    const std::size_t n = std::min(ring.size(), kMostCorners);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = i + 2; k < n; ++k) {
            const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()], &c = ring[k], &d = ring[(k + 1) % ring.size()];
            if ((k + 1) % ring.size() == i || !cross(a, b, c, d)) continue;
            const double ratio = turn(c, d, a) / (turn(c, d, a) - turn(c, d, b));
            return a + ratio * (b - a);
        }
    return std::nullopt;
}

std::string name_of(const StatedRoom& room) { return room.name.empty() ? room.number : room.name; }

Aabb bounds_of_room(const StatedRoom& room) {
    Aabb box;
    for (const std::vector<Vec2>& ring : room.rings)
        for (const Vec2& p : ring) {
            box.include(Vec3(p, room.floor_m));
            box.include(Vec3(p, room.floor_m + std::max(room.height_m, 1.0)));
        }
    return box;
}

// Returns the floor area that both rooms share. `at_m` receives a place within it.
double shared_m2(const StatedRoom& one, const StatedRoom& other, const Aabb& both, Vec3& at_m) {
    const Vec3 size = both.size_m();
    const double step_m = std::max(0.1, std::sqrt(size.x * size.y / kSamples));
    double shared = 0.0;
    for (double y = both.min_m.y + 0.5 * step_m; y < both.max_m.y; y += step_m)
        for (double x = both.min_m.x + 0.5 * step_m; x < both.max_m.x; x += step_m) {
            const double z = std::max(one.floor_m, other.floor_m) + 0.1;
            if (!holds(one, {x, y, z}) || !holds(other, {x, y, z})) continue;
            if (shared == 0.0) at_m = {x, y, std::max(one.floor_m, other.floor_m)};
            shared += step_m * step_m;
        }
    return shared;
}

void crossing_outlines(const StatedBuilding& stated, std::vector<WorldFault>& faults) {
    for (const StatedRoom& room : stated.rooms)
        for (const std::vector<Vec2>& ring : room.rings)
            if (const auto at = crossing(ring)) {
                WorldFault fault{FaultKind::CrossingOutline, Vec3(*at, room.floor_m), room.source};
                fault.name = name_of(room);
                faults.push_back(std::move(fault));
                break;
            }
}

void overlapping(const StatedBuilding& stated, std::vector<WorldFault>& faults) {
    std::vector<Aabb> boxes;
    for (const StatedRoom& room : stated.rooms) boxes.push_back(bounds_of_room(room));
    const BoxIndex index(boxes);
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        index.find(boxes[i], near);
        for (const std::uint32_t k : near) {
            if (k >= i || std::abs(stated.rooms[i].floor_m - stated.rooms[k].floor_m) > 0.5) continue;
            const Aabb both{glm::max(boxes[i].min_m, boxes[k].min_m), glm::min(boxes[i].max_m, boxes[k].max_m)};
            Vec3 at_m{0.0};
            const double shared = both.empty() ? 0.0 : shared_m2(stated.rooms[i], stated.rooms[k], both, at_m);
            if (shared < kLeastOverlap_m2) continue;
            WorldFault fault{FaultKind::OverlappingRooms, at_m, stated.rooms[i].source};
            fault.name = name_of(stated.rooms[k]);
            fault.other = name_of(stated.rooms[i]);
            fault.amount = shared;
            faults.push_back(std::move(fault));
        }
    }
}

// True for a door from a room of an upper storey to a balcony on which nobody can stand, because it is narrower than a
// person or has no floor. Nobody is meant to walk through it.
bool is_balcony_door(const Examined& world, const StatedPortal& portal) {
    constexpr int kAround = 16;  // number of places around the doorway
    // Cosine of the largest angle between the way out and a place in front of the door.
    constexpr double kInFront = 0.6;
    if (!world.space || world.scene.starts.empty() || portal.kind != StatedPortalKind::Door) return false;
    if (portal.rooms.size() != 1 || portal.place_m.z < world.scene.starts.front().feet_m.z + kUpperDoor_m) return false;
    const auto direction = [](int i) {
        const double angle_rad = 2.0 * kPi * i / kAround;
        return Vec3(std::cos(angle_rad), std::sin(angle_rad), 0.0);
    };
    Vec3 out(0.0);
    for (int i = 0; i < kAround; ++i)
        if (navigation::stated_room_at(world.scene, portal.place_m + kBeyondDoor_m * direction(i))) out -= direction(i);
    if (glm::length(out) < 0.5) return false;
    out = glm::normalize(out);
    for (int i = 0; i < kAround; ++i)
        if (glm::dot(direction(i), out) > kInFront &&
            world.space->nearest(portal.place_m + kBeyondDoor_m * direction(i), 0.2, 0.5, 0.5) != navigation::kNothing)
            return false;
    return true;
}

// Adds the faults that only the report of the reader contains, because they come from statements of the file.
void from_the_report(const Examined& world, std::vector<WorldFault>& faults) {
    const Scene& scene = world.scene;
    const StatedBuilding& stated = *scene.stated;
    for (const CheckPoint& point : honest_report(scene).check) {
        WorldFault fault{FaultKind::OddName, point.at_m, point.source};
        if (point.what == ToCheck::MissingPart) {
            fault.kind = FaultKind::MissingPart;
            fault.name = missing_words(stated.missing[point.index]);
            faults.push_back(std::move(fault));
            continue;
        }
        if (point.what == ToCheck::ImpassableDoor && is_balcony_door(world, stated.portals[point.index])) continue;
        if (point.what == ToCheck::ImpassableDoor) fault.kind = FaultKind::ImpassableDoor;
        else if (point.what == ToCheck::DoorToNoRoom) fault.kind = FaultKind::DoorToNoRoom;
        else if (point.what == ToCheck::DoorCutFree) fault.kind = FaultKind::DoorCutFree;
        // All other findings of the report are left out here, because the search of the rooms finds them too.
        else if (point.what != ToCheck::OddName) continue;
        if (is_of_a_room(point.what)) {
            fault.name = name_of(stated.rooms[point.index]);
        } else {
            fault.name = stated.portals[point.index].name;
            fault.feature = stated.portals[point.index].feature;
            fault.amount = stated.portals[point.index].width_m;
            if (fault.kind == FaultKind::ImpassableDoor) fault.why = door_trial_words(stated.portals[point.index]);
        }
        faults.push_back(std::move(fault));
    }
}

}  // namespace

void find_outline_faults(const Examined& world, std::vector<WorldFault>& faults) {
    if (!world.scene.stated) return;
    crossing_outlines(*world.scene.stated, faults);
    overlapping(*world.scene.stated, faults);
    from_the_report(world, faults);
}

}  // namespace handrail::check
