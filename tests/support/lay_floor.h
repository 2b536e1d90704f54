// Lays the floor of a storey that a test draws by hand. Storeys made from a world have their floor from the walkable
// area.
#pragma once

#include <algorithm>
#include <cmath>

#include "worlds/plan/plan_shapes.h"
#include "worlds/plan/storey.h"

namespace handrail::test {

// Fills Storey::floor from the outlines of the rooms. Where rooms overlap, the last one is taken.
inline void lay_floor(plan::Storey& storey) {
    plan::StoreyFloor& floor = storey.floor;
    const Vec2 size = storey.max_m - storey.min_m;
    floor.wide = std::max(0, static_cast<int>(std::ceil(size.x / floor.cell_m)));
    floor.high = std::max(0, static_cast<int>(std::ceil(size.y / floor.cell_m)));
    floor.room.clear();
    for (int y = 0; y < floor.high; ++y)
        for (int x = 0; x < floor.wide; ++x) {
            const Vec2 middle = storey.min_m + Vec2(x + 0.5, y + 0.5) * floor.cell_m;
            floor.room.push_back(navigation::kNothing);
            for (std::uint32_t room = 0; room < storey.rooms.size(); ++room)
                for (const auto& loop : storey.rooms[room].loops_m)
                    if (plan::within_loop(loop, middle)) floor.room.back() = room;
        }
}

}  // namespace handrail::test
