#include "worlds/navigation/validate_ways.h"

#include <fmt/format.h>

#include <cmath>

namespace handrail::navigation {
namespace {

const char* fault_of_columns(const WalkSpace& space) {
    if (!(space.cell_m > 0.0) || !is_finite(space.origin_m)) return "a place that is none";
    const std::size_t cells = static_cast<std::size_t>(space.width) * space.depth;
    if (space.first.size() != cells + 1) return "another count of columns than of cells";
    if (space.first.front() != 0 || space.first.back() != space.spans.size()) return "spans outside its columns";
    for (std::size_t cell = 0; cell < cells; ++cell) {
        if (space.first[cell] > space.first[cell + 1]) return "columns out of order";
        for (std::uint32_t i = space.first[cell]; i < space.first[cell + 1]; ++i) {
            if (space.spans[i].cell != cell) return "a span in another column";
            if (i > space.first[cell] && !(space.spans[i - 1].floor_m < space.spans[i].floor_m))
                return "floors that do not rise within a column";
        }
    }
    return nullptr;
}

// Returns the first fault of a span as text; null if there is none. Directions are east, north, west, south.
const char* fault_of_span(const WalkSpace& space, const WalkSpan& span) {
    if (!std::isfinite(span.floor_m) || !(span.floor_m <= span.ceiling_m)) return "a floor above its ceiling";
    if (!(span.clearance_m >= 0.0F)) return "a clearance that is none";
    const auto is_obstacle = [&](std::uint32_t i) { return i == kNothing || i < space.obstacle_features.size(); };
    if (!is_obstacle(span.ground) || !is_obstacle(span.beside)) return "an obstacle that is not there";
    const std::uint32_t x = span.cell % space.width, y = span.cell / space.width;
    for (int side = 0; side < 4; ++side) {
        const std::uint32_t next = span.next[side];
        if (next == kNothing) continue;
        if (next >= space.spans.size()) return "a neighbour that is not there";
        const std::uint32_t nx = space.spans[next].cell % space.width, ny = space.spans[next].cell / space.width;
        const bool beside = side == 0   ? nx == x + 1 && ny == y
                            : side == 1 ? nx == x && ny == y + 1
                            : side == 2 ? nx + 1 == x && ny == y
                                        : nx == x && ny + 1 == y;
        if (!beside) return "a neighbour that is not beside it";
    }
    return nullptr;
}

}  // namespace

Result<void> validate(const WalkSpace& space) {
    if (const char* fault = fault_of_columns(space)) return fail(fmt::format("WalkSpace has {}", fault));
    for (std::size_t i = 0; i < space.spans.size(); ++i)
        if (const char* fault = fault_of_span(space, space.spans[i]))
            return fail(fmt::format("WalkSpace has a span with {}, span {}", fault, i));
    for (const WalkLink& link : space.links)
        if (link.from >= space.spans.size() || link.to >= space.spans.size())
            return fail("WalkSpace has a link to a span that is not there");
    return {};
}

Result<void> validate(const RoomGraph& graph, const WalkSpace& space) {
    if (graph.room_of_span.size() != space.spans.size())
        return fail("RoomGraph has another count of spans than its walk space");
    for (const std::uint32_t room : graph.room_of_span)
        if (room != kNothing && room >= graph.rooms.size())
            return fail("RoomGraph has a span in a room that is not there");
    for (std::size_t i = 0; i < graph.rooms.size(); ++i) {
        const Room& room = graph.rooms[i];
        if (!(room.area_m2 > 0.0) || !is_finite(room.middle_m) || room.bounds_m.empty())
            return fail(fmt::format("RoomGraph has a room without a size, room {}", i));
        if (room.name.empty()) return fail(fmt::format("RoomGraph has a room without a name, room {}", i));
    }
    for (std::size_t i = 0; i < graph.portals.size(); ++i) {
        const Portal& portal = graph.portals[i];
        if (portal.rooms[0] >= graph.rooms.size() || portal.rooms[1] >= graph.rooms.size())
            return fail(fmt::format("RoomGraph has a portal to a room that is not there, portal {}", i));
        if (!is_finite(portal.place_m) || !(portal.width_m >= 0.0))
            return fail(fmt::format("RoomGraph has a portal that is nowhere, portal {}", i));
    }
    return {};
}

}  // namespace handrail::navigation
