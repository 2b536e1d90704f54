// Draws the walls of a storey in black on a sheet or plate, so that fingers can read them. Thin walls are thickened,
// doors are open and wide enough, and walls that are too close are joined. Another function finds where the sign of a
// room fits. Pure functions; any thread may call them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "worlds/exports/ink.h"
#include "worlds/exports/places.h"
#include "worlds/plan/room_borders.h"
#include "worlds/plan/storey.h"

namespace handrail::exports {

// Converts metres of the world to millimetres on the sheet, north up.
struct OnPaper {
    Vec2 from_m{0.0}, shift_mm{0.0};
    double mm_per_m = 1.0;

    Vec2 operator()(const Vec2& world_m) const { return shift_mm + (world_m - from_m) * mm_per_m; }
    Vec2 world(const Vec2& mm) const { return from_m + (mm - shift_mm) / mm_per_m; }
    std::vector<std::vector<Vec2>> operator()(std::vector<std::vector<Vec2>> loops_m) const;
    plan::PlanBox operator()(plan::PlanBox box_m) const;
};

struct WallLook {
    double line_mm = 1.5;   // least thickness of a wall
    double clear_mm = 3.2;  // walls that are closer to each other are joined
    double door_mm = 6.6;   // least width of a door
    double piece_mm = 4.0;  // pieces of wall that are shorter than this are left out
};

struct WallInk {
    Ink ink;
    int thicker = 0, wider = 0, pieces_left_out = 0;
    std::size_t joined = 0;  // number of places at which walls were joined
    // Indices in Storey::gaps of gaps that cannot be widened, because the walls leave no space for that.
    std::vector<std::size_t> narrow_gaps;
};
// Returns the names of gaps for use in a sentence.
std::string gap_names(const plan::Storey& storey, const std::vector<std::size_t>& gaps);
WallInk ink_of_walls(const plan::Storey& storey, const OnPaper& on_paper, double width_mm, double height_mm,
                     const WallLook& look);

// Fills the gaps between lines that are narrower than `clear_mm`. Returns the number of gaps.
std::size_t join_near(Ink& walls, double clear_mm);

// Removes the walls outside a rectangle. Also removes the ends of cut walls that reach less than `least_mm` into it,
// because a finger would take them for things.
void cut_off(Ink& walls, const Vec2& low_mm, const Vec2& high_mm, double least_mm);

// The lines across flights of stairs. stair_lines draws lines `clear_mm` apart across every flight, even if its floor
// is in several pieces, and marks their space in `places` as used. It leaves out lines shorter than `least_mm`. It also
// leaves out lines of another storey's flight outside the room to which that flight leads. `rooms`: see rooms_on.
struct StairInk {
    std::vector<plan::PlanBox> lines;
    std::vector<std::uint32_t> drawn;      // indices in Storey::rooms of the flights of this storey that have lines
    std::vector<std::uint32_t> of_others;  // indices in Storey::stairs_of_others of the flights that have lines
};
StairInk stair_lines(const plan::Storey& storey, const OnPaper& on_paper, const plan::RoomGrid& rooms, Places& places,
                     double line_mm, double clear_mm, double least_mm);

// Draws the lines of flights that are too narrow for lines between their walls. These lines reach into the walls, like
// the rungs of a ladder. `free`: the space in which stair_lines would draw its lines.
StairInk stair_rungs(const plan::Storey& storey, const OnPaper& on_paper, const plan::RoomGrid& rooms, Places free,
                     Ink& walls, double line_mm, double clear_mm, double least_mm);

// The free part of an object's box; nothing if the box or its free part is smaller than `least_mm`. A landmark's box is
// enlarged to at least that size.
struct ThingFit {
    std::optional<plan::PlanBox> box;
    bool shrunk = false;  // the free part has less than four fifths of the area of the box
};
ThingFit fit_of_thing(const plan::StoreyThing& thing, const OnPaper& on_paper, const Places& places, double least_mm);

// The arrow at the base, with its tip first in the loop. It is as close to the base as possible, at most 12 mm away,
// and no wall is between the two.
struct BaseArrow {
    std::vector<Vec2> loop_mm;
    double off_mm = 0.0;  // distance of the arrow from the base
};
std::optional<BaseArrow> arrow_of_base(const plan::StoreyBase& base, const OnPaper& on_paper, const Ink& walls,
                                       const Places& places, const Vec2& half_mm);

// Least distance between two signs, so that readers do not read them as one word.
inline constexpr double kBetweenSigns_mm = 6.4;

// Returns where a sign with these half sides fits into the room with index `room`. All four corners must be in the room
// and outside doorways, at a distance from the `others`. The sign avoids objects if possible. Of all such places, the
// function returns the one nearest to the middle of the room. `rooms`: see rooms_on.
std::optional<Vec2> place_of_sign(const plan::Storey& storey, std::size_t room, const OnPaper& on_paper,
                                  const plan::RoomGrid& rooms, const Places& places, const Places& things_apart,
                                  const Vec2& half_mm, const std::vector<plan::PlanBox>& others);

}  // namespace handrail::exports
