#include "app/core/whereabouts/room_things.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace handrail::core {
namespace {

constexpr double kBeforeDoor_m[] = {0.6, 0.8, 1.0, 1.3};

std::optional<Vec3> before_door(const SessionContext& context, const Rooms& rooms, std::uint32_t room,
                                const Vec3& door_m) {
    const WalkerShape shape = context.avatar.walker->shape();
    // If possible, the place is straight in front of the thing. So the quarters of the compass are tried first, then
    // the directions between them.
    for (int i = 0; i < 16; ++i) {
        const int sixteenth = i < 4 ? 4 * i : i < 8 ? 4 * (i - 4) + 2 : 2 * (i - 8) + 1;
        for (const double far_m : kBeforeDoor_m) {
            const Vec3 beside = door_m + forward_of_heading(sixteenth * kPi / 8.0) * far_m;
            const std::uint32_t span = rooms.space().nearest(beside, 0.15, 0.6, 0.6);
            if (span == navigation::kNothing) continue;
            const Vec3 feet(beside.x, beside.y, rooms.space().place_m(span).z);
            if (navigation::room_at(rooms.graph(), rooms.space(), feet) != room) continue;
            if (!context.world.solids->blocked(feet, shape)) return feet;
        }
    }
    return std::nullopt;
}

}  // namespace

std::uint32_t room_of(const Rooms& rooms, const Aabb& box) {
    const Vec3 middle = box.centre_m(), size = box.size_m();
    const double beside_m = std::min(0.5 * std::max(size.x, size.y) + 1.0, 5.0);
    const std::uint32_t span = rooms.space().nearest({middle.x, middle.y, box.min_m.z}, beside_m, 0.6, 2.0);
    return span == navigation::kNothing
               ? navigation::kNothing
               : navigation::room_at(rooms.graph(), rooms.space(), rooms.space().place_m(span));
}

std::vector<RoomDoor> doors_of_room(const SessionContext& context, const Rooms& rooms) {
    std::vector<RoomDoor> doors;
    if (!rooms.found()) return doors;
    const navigation::RoomGraph& graph = rooms.graph();
    const std::uint32_t room = navigation::room_at(graph, rooms.space(), context.avatar.feet_m());
    if (room == navigation::kNothing) return doors;
    for (const navigation::Portal& portal : graph.portals) {
        if (portal.kind != navigation::PassageKind::Door || !portal.feature) continue;
        if (portal.rooms[0] != room && portal.rooms[1] != room) continue;
        if (const auto feet = before_door(context, rooms, room, portal.place_m))
            doors.push_back({portal.feature, portal.place_m, *feet});
    }
    return doors;
}

}  // namespace handrail::core
