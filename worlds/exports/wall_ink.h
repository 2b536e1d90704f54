// The walls of a storey as black on a sheet or plate, fit for fingers: thin ones thicker, doors open and wide enough,
// what is too near joined. And where the sign of a room may stand. Pure functions; any thread.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "worlds/exports/ink.h"
#include "worlds/exports/places.h"
#include "worlds/plan/room_borders.h"
#include "worlds/plan/storey.h"

namespace handrail {

// From the world's metres to millimetres on the sheet, north up.
struct OnPaper {
    Vec2 from_m{0.0}, shift_mm{0.0};
    double mm_per_m = 1.0;

    Vec2 operator()(const Vec2& world_m) const { return shift_mm + (world_m - from_m) * mm_per_m; }
    Vec2 world(const Vec2& mm) const { return from_m + (mm - shift_mm) / mm_per_m; }
    std::vector<std::vector<Vec2>> operator()(std::vector<std::vector<Vec2>> loops_m) const;
    PlanBox operator()(PlanBox box_m) const;
};

struct WallLook {
    double line_mm = 1.5;   // at least as thick
    double clear_mm = 3.2;  // nearer to each other is joined
    double door_mm = 6.6;   // at least as wide
    double piece_mm = 4.0;  // shorter pieces are left out
};

struct WallInk {
    Ink ink;
    int thicker = 0, wider = 0, pieces_left_out = 0;
    std::size_t joined = 0;                 // places
    std::vector<std::string> narrow_doors;  // between walls that leave no room to widen them
};
WallInk ink_of_walls(const Storey& storey, const OnPaper& on_paper, double width_mm, double height_mm,
                     const WallLook& look);

// Fills what is narrower than `clear_mm` between lines. How many places there were.
std::size_t join_near(Ink& walls, double clear_mm);

// Lines across every flight of stairs, whatever pieces its floor came in, with `clear_mm` between them; each takes its
// place. Shorter ones are left out, and those of another storey's flight where they are not in the room that it leads
// to. `rooms`: see rooms_on.
struct StairInk {
    std::vector<PlanBox> lines;
    std::vector<std::uint32_t> drawn;      // places in Storey::rooms, of the storey's own flights that have lines
    std::vector<std::uint32_t> of_others;  // places in Storey::stairs_of_others, as well
};
StairInk stair_lines(const Storey& storey, const OnPaper& on_paper, const RoomGrid& rooms, Places& places,
                     double line_mm, double clear_mm, double least_mm);

// Flights too narrow for lines between their walls have lines that reach into the walls, like rungs of a ladder. Draws
// these. `free`: where lines of others would fit.
StairInk stair_rungs(const Storey& storey, const OnPaper& on_paper, const RoomGrid& rooms, Places free, Ink& walls,
                     double line_mm, double clear_mm, double least_mm);

// What of a thing's box is free; nothing where it, or what is free of it, is smaller than `least_mm`. What people find
// their way by (landmarks) counts as that large at least.
struct ThingFit {
    std::optional<PlanBox> box;
    bool shrunk = false;  // to under four fifths of it
};
ThingFit fit_of_thing(const StoreyThing& thing, const OnPaper& on_paper, const Places& places, double least_mm);

// The arrow of the base, its point first: as near to it as there is room, within 12 mm, with no wall between.
struct BaseArrow {
    std::vector<Vec2> loop_mm;
    double off_mm = 0.0;  // from where the base is
};
std::optional<BaseArrow> arrow_of_base(const StoreyBase& base, const OnPaper& on_paper, const Ink& walls,
                                       const Places& places, const Vec2& half_mm);

// Between two signs, that they are not read as one word.
inline constexpr double kBetweenSigns_mm = 6.4;

// Where a sign of such half sides fits for the how manyth room of the storey: in the room with all four corners and in
// no doorway; next to things, else where they stand; so far from the `others`. The nearest to the middle of the room.
// `rooms`: see rooms_on.
std::optional<Vec2> place_of_sign(const Storey& storey, std::size_t room, const OnPaper& on_paper,
                                  const RoomGrid& rooms, const Places& places, const Places& beside_things,
                                  const Vec2& half_mm, const std::vector<PlanBox>& others);

}  // namespace handrail
