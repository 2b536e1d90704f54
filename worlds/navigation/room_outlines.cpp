#include "worlds/navigation/room_outlines.h"

#include <algorithm>

namespace handrail::navigation {
namespace {

constexpr double kLeastLoop_m2 = 0.05;

double area_m2(const std::vector<Vec2>& loop) {
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return 0.5 * twice;
}

}  // namespace

std::vector<RoomOutline> room_outlines(const RoomGraph& graph, const WalkSpace& space) {
    std::vector<RoomOutline> outlines(graph.rooms.size());
    std::vector<bool> met(graph.rooms.size(), false);
    // Returns the adjoining span in that direction, if people can step there and back without leaving the room; else
    // kNothing. Directions are as in WalkSpan::next: east, north, west, south.
    const auto beside = [&](std::uint32_t span, std::size_t way) {
        const std::uint32_t n = space.spans[span].next[way];
        return n != kNothing && space.spans[n].next[(way + 2) % 4] == span &&
                       graph.room_of_span[n] == graph.room_of_span[span]
                   ? n
                   : kNothing;
    };
    std::vector<bool> done(4 * space.spans.size(), false);
    for (std::uint32_t start = 0; start < space.spans.size(); ++start) {
        const std::uint32_t room = graph.room_of_span[start];
        if (room == kNothing) continue;
        RoomOutline& outline = outlines[room];
        const double floor_m = space.place_m(start).z;
        outline.lowest_m = met[room] ? std::min(outline.lowest_m, floor_m) : floor_m;
        outline.highest_m = met[room] ? std::max(outline.highest_m, floor_m) : floor_m;
        met[room] = true;
        for (std::size_t first = 0; first < 4; ++first) {
            if (done[4 * start + first] || beside(start, first) != kNothing) continue;
            // Follows the border with the room on the left. `side` is the side of the span on which the border runs.
            std::vector<Vec2> loop;
            std::uint32_t span = start;
            std::size_t side = first;
            do {
                done[4 * span + side] = true;
                const std::size_t ahead = (side + 1) % 4;
                std::uint32_t to = beside(span, ahead);
                std::size_t to_side = side;
                if (to != kNothing && beside(to, side) == kNothing) {
                    span = to;
                    continue;
                }
                // At a corner, goes from span to span around it until the next side with a border. On a stepped floor,
                // that side may belong to another span of the same step. Each side has only one predecessor, so the
                // loop ends where it began.
                if (to == kNothing) to = span, to_side = ahead;
                else
                    for (std::uint32_t on = beside(to, to_side); on != kNothing; on = beside(to, to_side))
                        to = on, to_side = (to_side + 3) % 4;
                const Vec3 middle = space.place_m(span);
                const double half_m = 0.5 * space.cell_m;
                const auto part = [&](std::size_t way) {
                    return way == 0   ? Vec2(half_m, 0.0)
                           : way == 1 ? Vec2(0.0, half_m)
                           : way == 2 ? Vec2(-half_m, 0.0)
                                      : Vec2(0.0, -half_m);
                };
                loop.push_back(Vec2(middle.x, middle.y) + part(side) + part(ahead));
                span = to;
                side = to_side;
            } while (span != start || side != first);
            // Loops around objects in the room are clockwise. Their area is negative, so they are left out.
            if (area_m2(loop) >= kLeastLoop_m2) outline.loops_m.push_back(std::move(loop));
        }
    }
    return outlines;
}

}  // namespace handrail::navigation
