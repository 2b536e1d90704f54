// A storey on a grid of squares: where walls stop a body, where floors are, and where neither is. Pure functions over
// plain values; any thread. Time goes with the squares.
#pragma once

#include "worlds/plan/room_borders.h"
#include "worlds/plan/storey.h"

namespace handrail::plan {

// Squares of that size from Storey::min_m on.
class StoreyGrid {
public:
    StoreyGrid(const Storey& storey, double square_m) : storey_(&storey), square_m_(square_m) {}
    // As fine as walls need, coarser for a storey that is very large.
    static StoreyGrid of(const Storey& storey);

    // Walls block; squares have the room of their floor; the rim, if it has none, has as many as there are rooms.
    RoomGrid walls() const;
    void block(RoomGrid& grid, const PlanOutline& outline) const;
    double square_m() const { return square_m_; }
    Vec2 middle(int x, int y) const { return storey_->min_m + Vec2(x + 0.5, y + 0.5) * square_m_; }
    Vec2 middle(const RoomGrid& grid, std::size_t square) const {
        return middle(static_cast<int>(square % static_cast<std::size_t>(grid.wide)),
                      static_cast<int>(square / static_cast<std::size_t>(grid.wide)));
    }

private:
    void block_line(RoomGrid& grid, const Vec2& from, const Vec2& to) const;

    const Storey* storey_;
    double square_m_;
};

// Leaves out walls that no floor of the storey is near, as those of a room on another storey: they would end in the
// middle of nothing.
void drop_far_walls(Storey& storey);

// Fills StoreyFloor::beyond by the storey's floor, walls and portals.
void find_beyond(Storey& storey);

}  // namespace handrail::plan
