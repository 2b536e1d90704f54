// Divides a storey that does not fit on one sheet into several sheets, and finds the scales that its rooms need. Pure
// functions over plain values; any thread may call them. The time is proportional to the number of floor squares, below
// 0.1 s for a large building.
#pragma once

#include <array>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/plan/storey.h"

namespace handrail::exports {

struct PaperSize {
    double short_mm = 210.0, long_mm = 297.0;
};
inline constexpr PaperSize kA4{210.0, 297.0}, kA3{297.0, 420.0};

inline constexpr double kSheetMargin_mm = 12.0, kSheetHead_mm = 14.0, kSheetFoot_mm = 12.0;
// Extra height at the head and the foot of one of several sheets. Its title may have a second line, and it has marks
// and sheet numbers.
inline constexpr double kPartHead_mm = 17.0, kPartFoot_mm = 8.0;
inline constexpr double kShared_mm = 35.0;  // width of the strip that neighbouring sheets share; a sign fits into it
inline constexpr int kMostSheets = 40;
inline constexpr std::array kSheetScales{20.0,  25.0,  30.0,  40.0,  50.0,  60.0,  75.0,  90.0,  100.0,
                                         110.0, 125.0, 150.0, 175.0, 200.0, 225.0, 250.0, 275.0, 300.0,
                                         350.0, 400.0, 450.0, 500.0, 600.0, 700.0, 800.0, 900.0, 1000.0};

// Returns the size of the space for the plan on a page. `across`: the page is in landscape. `part`: the page is one of
// several sheets.
Vec2 room_on_page(const PaperSize& paper, bool across, bool part);

// A neighbouring sheet, on which the plan continues.
struct NextSheet {
    int number = 0;
    double shared_m = 0.0;  // middle of the shared strip across the border: its coordinate to the east or north
    double along_m = 0.0;   // middle of the common side along the border: its coordinate to the north or east
};

// One of several sheets of a storey. Neighbouring sheets share a strip.
struct SheetPart {
    Vec2 min_m{0.0}, max_m{0.0};  // the area that the sheet shows
    double one_to = 0.0;
    int number = 1, count = 1;                     // `number` of this sheet, from 1, and `count` of all sheets
    std::array<std::vector<NextSheet>, 4> next{};  // neighbouring sheets to the west, east, north and south
    // The sheet repeats a part of other sheets at a larger scale, so that small rooms get their signs.
    bool larger = false;
};

// Covers the storey with as few sheets as possible, all at the scale 1 to `one_to`. Borders between sheets cross as
// little floor as possible, so they run along walls and between wings. No sheet shows empty corners. Returns an empty
// list if more than kMostSheets would be needed.
std::vector<SheetPart> parts_of(const plan::Storey& storey, const PaperSize& paper, double one_to);

// Returns, for every room, the coarsest of `scales` at which a box of that size fits into the empty room; 0 if it fits
// at none. `scales` must be in rising order.
std::vector<double> scales_needed(const plan::Storey& storey, const std::vector<double>& scales, const Vec2& box_mm);

}  // namespace handrail::exports
