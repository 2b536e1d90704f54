#include "app/core/whereabouts/drawn_rooms.h"

#include "app/core/dialogue/words.h"

namespace handrail::core {
namespace {

constexpr double kHighestCeiling_m = 60.0;

bool has_ceiling(const navigation::Room& room, const WalkerWorld& solids) {
    const Vec3 from = room.middle_m + Vec3(0.0, 0.0, 1.0);
    return solids.trace(from, from + Vec3(0.0, 0.0, kHighestCeiling_m), WalkerShape{}, true).hit;
}

bool same_storey(const DrawnRoom& a, const DrawnRoom& b) {
    constexpr double kSameStorey_m = 1.0;
    return a.outline.lowest_m < b.outline.highest_m + kSameStorey_m &&
           b.outline.lowest_m < a.outline.highest_m + kSameStorey_m;
}

}  // namespace

std::vector<DrawnRoom> drawn_rooms(const navigation::RoomGraph& graph, const navigation::WalkSpace& space,
                                   const Scene& scene, const WalkerWorld& solids) {
    std::vector<navigation::RoomOutline> outlines = navigation::room_outlines(graph, space);
    std::vector<DrawnRoom> drawn;
    std::vector<bool> covered;
    for (std::size_t r = 0; r < outlines.size(); ++r) {
        const navigation::Room& room = graph.rooms[r];
        drawn.push_back({sentence_case(room.name), room.middle_m, room.area_m2,
                         navigation::is_outside(room, space, scene), std::move(outlines[r])});
        covered.push_back(has_ceiling(room, solids));
    }
    // Many floor plans have no ceilings at all, so a missing ceiling alone says nothing.
    for (std::size_t r = 0; r < drawn.size(); ++r) {
        if (drawn[r].outside || covered[r]) continue;
        std::size_t rooms = 0, with_ceiling = 0;
        for (std::size_t other = 0; other < drawn.size(); ++other)
            if (same_storey(drawn[r], drawn[other])) {
                ++rooms;
                with_ceiling += covered[other] ? 1 : 0;
            }
        drawn[r].outside = 2 * with_ceiling > rooms;
    }
    return drawn;
}

}  // namespace handrail::core
