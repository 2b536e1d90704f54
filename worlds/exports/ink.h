// Represents a page as a picture of black and white pixels. Functions on the picture find, for shapes of any form,
// where something still fits, where black is too near to other black, and where black is too thick. Pure functions; any
// thread may call them. Lengths are in pixels unless the name says millimetres.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "worlds/base/vec.h"

namespace handrail::exports {

inline constexpr double kInkPixel_mm = 0.1;

struct Ink {
    int wide = 0, high = 0;
    std::vector<std::uint8_t> black;  // the pixels row by row from the bottom; 0 is white, 1 is black

    Ink() = default;
    Ink(double width_mm, double height_mm);
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(wide) + static_cast<std::size_t>(x);
    }
    bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < wide && y < high; }
};

// Calls `each(x, y)` for every pixel whose centre is inside an odd number of the loops.
template <class Each>
void for_pixels_in(const Ink& ink, std::span<const std::vector<Vec2>> loops_mm, Each each) {
    const double top_mm = ink.high * kInkPixel_mm;
    double low = top_mm, high = 0.0;
    for (const auto& loop : loops_mm)
        for (const Vec2& p : loop) low = std::min(low, p.y), high = std::max(high, p.y);
    const int first = static_cast<int>(std::floor(std::max(low, 0.0) / kInkPixel_mm));
    const int last = std::min(ink.high - 1, static_cast<int>(std::ceil(std::min(high, top_mm) / kInkPixel_mm)));
    std::vector<double> crossings;
    for (int y = first; y <= last; ++y) {
        const double at_mm = (y + 0.5) * kInkPixel_mm;
        crossings.clear();
        for (const auto& loop : loops_mm)
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
                if ((a.y > at_mm) == (b.y > at_mm)) continue;
                crossings.push_back((a.x + (b.x - a.x) * ((at_mm - a.y) / (b.y - a.y))) / kInkPixel_mm - 0.5);
            }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const double right = ink.wide;  // a double, because a crossing can be further than any int
            const int from = static_cast<int>(std::ceil(std::clamp(crossings[i], 0.0, right)));
            const int to =
                std::min(ink.wide - 1, static_cast<int>(std::floor(std::clamp(crossings[i + 1], -1.0, right))));
            for (int x = from; x <= to; ++x) each(x, y);
        }
    }
}

void fill(Ink& ink, std::span<const std::vector<Vec2>> loops_mm, bool black);
void fill_disc(Ink& ink, const Vec2& middle_mm, double radius_mm);

// Returns the distance from each pixel to the nearest black one, centre to centre. It is 0 on black, and a large number
// if nothing is black. Exact; the time is proportional to the number of pixels. `whose`, if not null, receives the
// index of that black pixel. Source: Felzenszwalb, Huttenlocher, Distance transforms of sampled functions, Theory of
// Computing 8, 2012.
std::vector<float> distances_px(const Ink& ink, std::vector<std::uint32_t>* whose = nullptr);

// Returns the pixels that have a black pixel nearer than `limit_px`, centre to centre. If `as_far` is set, a black
// pixel at exactly that distance is near too. `limit_px` is at most 250. Much faster than distances_px.
Ink near_black(const Ink& ink, double limit_px, bool as_far);

// Returns the white pixels in gaps and slits between black that are narrower than `gap_mm`, so that no disc of that
// size fits through. A disc does not fill inner corners either. Inner corners are included only if they are deeper than
// `gap_mm`.
Ink narrow_white(const Ink& ink, double gap_mm);

// The connected pieces of black. Pixels that touch at a side or a corner are connected. Piece 0 is white; pieces count
// from 1.
struct InkPieces {
    std::vector<std::uint32_t> of;      // for each pixel: its piece
    std::vector<std::uint32_t> pixels;  // for each piece: its number of pixels; [0] is unused
    std::vector<int> extent;            // for each piece: the longer side of its bounding box
};
InkPieces pieces_of(const Ink& ink);

// Makes black that is thicker than `thick_mm` hollow, with a border of `border_mm`. An area stays black if its hollow
// would be shorter than `least_mm`, unless the area is wider than the crossing of two walls of that thickness. So there
// are no hollows where walls merely meet. Returns the number of hollows.
int hollow_out(Ink& ink, double thick_mm, double border_mm, double least_mm);

// If two black pixels meet only at a corner, fills in a pixel next to them. Pieces then touch along sides or not at
// all.
void part_corners(Ink& ink);

// Traces the borders of black as closed lines, which are filled by the even-odd rule. The lines deviate at most
// `most_mm` from the pixels.
std::vector<std::vector<Vec2>> traced_mm(const Ink& ink, double most_mm = 0.13);

}  // namespace handrail::exports
