// Represents a storey as a grid of squares: where walls stop a person, where floors are, and where neither is. Pure
// functions over plain values; any thread may call them. The time grows with the number of squares.
#pragma once

#include "worlds/plan/room_borders.h"
#include "worlds/plan/storey.h"

namespace handrail::plan {

// Squares of the size square_m, beginning at Storey::min_m.
class StoreyGrid {
public:
    StoreyGrid(const Storey& storey, double square_m) : storey_(&storey), square_m_(square_m) {}
    // Chooses squares as small as walls need, or larger ones if the storey is very large.
    static StoreyGrid of(const Storey& storey);

    // Returns the grid. Walls block squares; squares on floors have the room of the floor. A square on the rim that has
    // no room gets the number of rooms as its room.
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

// Removes walls that are not near any floor of the storey, for example walls of a room on another storey. On the plan,
// these walls would seem to stand alone.
void drop_far_walls(Storey& storey);

// Fills StoreyFloor::beyond from the floor, walls and portals of the storey.
void find_beyond(Storey& storey);

}  // namespace handrail::plan
