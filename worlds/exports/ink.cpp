#include "worlds/exports/ink.h"

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

namespace handrail::exports {
namespace {

constexpr float kFar = 1e9F;

// Returns the largest squared distance, in pixels, that is less than the square of `limit_px`. If `as_far` is set, it
// may be equal to that square.
int most_squared(double limit_px, bool as_far) {
    const auto counts = [&](int squared) {
        const auto far = static_cast<double>(static_cast<float>(std::sqrt(static_cast<double>(squared))));
        return as_far ? far <= limit_px : far < limit_px;
    };
    int squared = static_cast<int>(limit_px * limit_px) + 2;
    while (squared >= 0 && !counts(squared)) --squared;
    return squared;
}

// Returns, for each pixel, the distance to the nearest black pixel in the same column, at most `most`.
std::vector<std::uint8_t> heights_to_black(const Ink& ink, std::uint8_t most) {
    std::vector<std::uint8_t> far(ink.black.size());
    const auto wide = static_cast<std::size_t>(ink.wide);
    const auto sweep = [&](std::size_t row, const std::uint8_t* before) {
        std::uint8_t* mine = far.data() + row * wide;
        for (std::size_t x = 0; x < wide; ++x) {
            const auto next = static_cast<std::uint8_t>(before[x] + 1);
            mine[x] = std::min(mine[x], next);
        }
    };
    for (std::size_t i = 0; i < far.size(); ++i) far[i] = ink.black[i] ? std::uint8_t{0} : most;
    for (std::size_t row = 1; row < static_cast<std::size_t>(ink.high); ++row)
        sweep(row, far.data() + (row - 1) * wide);
    for (std::size_t row = static_cast<std::size_t>(ink.high); row-- > 1;) sweep(row - 1, far.data() + row * wide);
    return far;
}

Ink opposite(const Ink& ink) {
    Ink other = ink;
    for (std::uint8_t& pixel : other.black) pixel = pixel ? 0 : 1;
    return other;
}

// Marks the points that a simplified line needs. Source: Douglas, Peucker, Algorithms for the reduction of the number
// of points, 1973. This version uses a stack instead of recursion.
void keep_corners(const std::vector<Vec2>& points, std::size_t from, std::size_t to, double most_mm,
                  std::vector<bool>& kept) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{from, to}};
    const auto point = [&](std::size_t i) { return points[i % points.size()]; };
    while (!open.empty()) {
        const auto [a, b] = open.back();
        open.pop_back();
        const Vec2 p = point(a), way = point(b) - p;
        const double length = glm::length(way);
        double farthest = most_mm;
        std::size_t which = 0;
        for (std::size_t i = a + 1; i < b; ++i) {
            const Vec2 to_point = point(i) - p;
            const double far =
                length > 0.0 ? std::abs(way.x * to_point.y - way.y * to_point.x) / length : glm::length(to_point);
            if (far > farthest) farthest = far, which = i;
        }
        if (which == 0) continue;
        kept[which % points.size()] = true;
        open.emplace_back(a, which);
        open.emplace_back(which, b);
    }
}

std::vector<Vec2> straightened(const std::vector<Vec2>& points, double most_mm) {
    if (points.size() < 4) return points;
    std::size_t far = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        if (glm::distance(points[i], points[0]) > glm::distance(points[far], points[0])) far = i;
    std::vector<bool> kept(points.size(), false);
    kept[0] = kept[far] = true;
    keep_corners(points, 0, far, most_mm, kept);
    keep_corners(points, far, points.size(), most_mm, kept);
    std::vector<Vec2> out;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (kept[i]) out.push_back(points[i]);
    return out.size() < 3 ? points : out;
}

// Properties of a connected piece of narrow white: whether it adjoins an area that a disc can cover, and whether it is
// deeper than the requested gap.
struct Surroundings {
    bool open = false, deep = false;
};

}  // namespace

Ink::Ink(double width_mm, double height_mm)
    : wide(static_cast<int>(std::lround(width_mm / kInkPixel_mm))),
      high(static_cast<int>(std::lround(height_mm / kInkPixel_mm))),
      black(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), 0) {}

void fill(Ink& ink, std::span<const std::vector<Vec2>> loops_mm, bool black) {
    for_pixels_in(ink, loops_mm, [&](int x, int y) { ink.black[ink.at(x, y)] = black ? 1 : 0; });
}

void fill_disc(Ink& ink, const Vec2& middle_mm, double radius_mm) {
    const auto pixel = [](double mm) { return static_cast<int>(std::floor(mm / kInkPixel_mm)); };
    for (int y = pixel(middle_mm.y - radius_mm); y <= pixel(middle_mm.y + radius_mm); ++y)
        for (int x = pixel(middle_mm.x - radius_mm); x <= pixel(middle_mm.x + radius_mm); ++x)
            if (ink.holds(x, y) && glm::distance(Vec2(x + 0.5, y + 0.5) * kInkPixel_mm, middle_mm) <= radius_mm)
                ink.black[ink.at(x, y)] = 1;
}

std::vector<float> distances_px(const Ink& ink, std::vector<std::uint32_t>* whose) {
    const int wide = ink.wide, high = ink.high;
    std::vector<float> far(ink.black.size(), kFar);
    std::vector<std::int32_t> row_of(ink.black.size(), -1);  // row of the nearest black pixel in the same column
    for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x)
            row_of[ink.at(x, y)] = ink.black[ink.at(x, y)] ? y : y > 0 ? row_of[ink.at(x, y - 1)] : -1;
    std::vector<std::int32_t> above(static_cast<std::size_t>(wide), -1);
    for (int y = high - 1; y >= 0; --y)
        for (int x = 0; x < wide; ++x) {
            std::int32_t& known = row_of[ink.at(x, y)];
            std::int32_t& next = above[static_cast<std::size_t>(x)];
            if (ink.black[ink.at(x, y)]) next = y;
            if (next >= 0 && (known < 0 || next - y < y - known)) known = next;
        }
    if (whose) whose->assign(ink.black.size(), 0);
    std::vector<int> foot(static_cast<std::size_t>(wide));
    std::vector<double> from(static_cast<std::size_t>(wide) + 1), height(static_cast<std::size_t>(wide));
    for (int y = 0; y < high; ++y) {
        std::size_t count = 0;  // number of parabolas in the lower envelope
        for (int x = 0; x < wide; ++x) {
            const std::int32_t row = row_of[ink.at(x, y)];
            if (row < 0) continue;
            const double own = static_cast<double>(row - y) * (row - y);
            double begins = -1.0;
            while (count > 0) {
                const int before = foot[count - 1];
                begins = (own + static_cast<double>(x) * x - height[count - 1] - static_cast<double>(before) * before) /
                         (2.0 * (x - before));
                if (begins > from[count - 1]) break;
                --count;
            }
            foot[count] = x;
            height[count] = own;
            from[count] = count == 0 ? -std::numeric_limits<double>::infinity() : begins;
            ++count;
        }
        if (count == 0) continue;
        std::size_t k = 0;
        for (int x = 0; x < wide; ++x) {
            while (k + 1 < count && from[k + 1] < x) ++k;
            const double aside = x - foot[k];
            far[ink.at(x, y)] = static_cast<float>(std::sqrt(aside * aside + height[k]));
            if (whose) (*whose)[ink.at(x, y)] = static_cast<std::uint32_t>(ink.at(foot[k], row_of[ink.at(foot[k], y)]));
        }
    }
    return far;
}

Ink near_black(const Ink& ink, double limit_px, bool as_far) {
    Ink near = ink;
    std::fill(near.black.begin(), near.black.end(), std::uint8_t{0});
    const int most = most_squared(limit_px, as_far);
    if (most < 0 || ink.wide == 0) return near;
    const int reach = static_cast<int>(std::sqrt(static_cast<double>(most)));
    const std::vector<std::uint8_t> far = heights_to_black(ink, static_cast<std::uint8_t>(reach + 1));
    // For each horizontal distance, the greatest vertical distance of a black pixel that is still near.
    std::vector<std::uint8_t> high;
    for (int aside = 0; aside <= reach; ++aside)
        high.push_back(static_cast<std::uint8_t>(std::sqrt(static_cast<double>(most - aside * aside))));
    for (int y = 0; y < ink.high; ++y) {
        std::uint8_t* mine = near.black.data() + ink.at(0, y);
        for (int aside = -reach; aside <= reach; ++aside) {
            const std::uint8_t allowed = high[static_cast<std::size_t>(std::abs(aside))];
            const std::uint8_t* row = far.data() + ink.at(0, y);
            const int to = std::min(ink.wide, ink.wide - aside);
            for (int x = std::max(0, -aside); x < to; ++x)
                mine[x] = static_cast<std::uint8_t>(mine[x] | (row[x + aside] <= allowed ? 1 : 0));
        }
    }
    return near;
}

InkPieces pieces_of(const Ink& ink) {
    InkPieces pieces;
    pieces.of.assign(ink.black.size(), 0);
    pieces.pixels.push_back(0);
    pieces.extent.push_back(0);
    std::vector<std::uint32_t> open;
    for (std::size_t start = 0; start < ink.black.size(); ++start) {
        if (!ink.black[start] || pieces.of[start]) continue;
        const auto number = static_cast<std::uint32_t>(pieces.pixels.size());
        std::uint32_t count = 0;
        int low_x = ink.wide, low_y = ink.high, high_x = -1, high_y = -1;
        pieces.of[start] = number;
        open.assign(1, static_cast<std::uint32_t>(start));
        while (!open.empty()) {
            const int x = static_cast<int>(open.back() % static_cast<std::uint32_t>(ink.wide));
            const int y = static_cast<int>(open.back() / static_cast<std::uint32_t>(ink.wide));
            open.pop_back();
            ++count;
            low_x = std::min(low_x, x), high_x = std::max(high_x, x);
            low_y = std::min(low_y, y), high_y = std::max(high_y, y);
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    if (!ink.holds(x + dx, y + dy)) continue;
                    const std::size_t next = ink.at(x + dx, y + dy);
                    if (!ink.black[next] || pieces.of[next]) continue;
                    pieces.of[next] = number;
                    open.push_back(static_cast<std::uint32_t>(next));
                }
        }
        pieces.pixels.push_back(count);
        pieces.extent.push_back(std::max(high_x - low_x, high_y - low_y) + 1);
    }
    return pieces;
}

Ink narrow_white(const Ink& ink, double gap_mm) {
    const double radius = 0.5 * gap_mm / kInkPixel_mm;
    // White pixels that a disc can cover, or that are near such a disc. All other white pixels are narrow.
    const Ink reached = near_black(opposite(near_black(ink, radius + 0.5, false)), radius + 0.5, true);
    Ink white = ink;
    for (std::size_t i = 0; i < white.black.size(); ++i) white.black[i] = !ink.black[i] && !reached.black[i] ? 1 : 0;
    const InkPieces pieces = pieces_of(white);
    const Ink near_reached = near_black(reached, gap_mm / kInkPixel_mm, true);
    std::vector<Surroundings> found(pieces.pixels.size());
    // For each piece of narrow white, the black pixels within two pixels of it. The loop after this one counts how many
    // separate groups these pixels form.
    std::vector<std::vector<std::uint32_t>> border(pieces.pixels.size());
    for (int y = 0; y < ink.high; ++y)
        for (int x = 0; x < ink.wide; ++x) {
            const std::uint32_t piece = pieces.of[ink.at(x, y)];
            if (piece == 0) continue;
            Surroundings& mine = found[piece];
            mine.deep = mine.deep || !near_reached.black[ink.at(x, y)];
            for (int dy = -2; dy <= 2; ++dy)
                for (int dx = -2; dx <= 2; ++dx) {
                    if (!ink.holds(x + dx, y + dy)) continue;
                    const std::size_t beside = ink.at(x + dx, y + dy);
                    if (ink.black[beside]) border[piece].push_back(static_cast<std::uint32_t>(beside));
                    else if (std::abs(dx) + std::abs(dy) == 1 && reached.black[beside]) mine.open = true;
                }
        }
    std::vector<bool> narrow(pieces.pixels.size(), false);
    for (std::size_t piece = 1; piece < narrow.size(); ++piece) {
        constexpr std::uint32_t kSpeck = 6;  // pixels; a smaller piece is only a step in the border of a slanting line
        if (pieces.pixels[piece] < kSpeck) continue;
        std::vector<std::uint32_t>& around = border[piece];
        std::sort(around.begin(), around.end());
        around.erase(std::unique(around.begin(), around.end()), around.end());
        // Counts the pixels that are connected with the first one.
        std::vector<bool> seen(around.size(), false);
        std::vector<std::size_t> open;
        if (!around.empty()) open.push_back(0), seen[0] = true;
        std::size_t together = open.size();
        while (!open.empty()) {
            const std::uint32_t pixel = around[open.back()];
            open.pop_back();
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const auto next = static_cast<std::uint32_t>(static_cast<std::int64_t>(pixel) + dx +
                                                                 static_cast<std::int64_t>(dy) * ink.wide);
                    const auto it = std::lower_bound(around.begin(), around.end(), next);
                    if (it == around.end() || *it != next) continue;
                    const auto which = static_cast<std::size_t>(it - around.begin());
                    if (seen[which]) continue;
                    seen[which] = true;
                    ++together;
                    open.push_back(which);
                }
        }
        narrow[piece] = together != around.size() || !found[piece].open || found[piece].deep;
    }
    for (std::size_t i = 0; i < white.black.size(); ++i) white.black[i] = narrow[pieces.of[i]] ? 1 : 0;
    return white;
}

int hollow_out(Ink& ink, double thick_mm, double border_mm, double least_mm) {
    const double half = 0.5 * thick_mm / kInkPixel_mm, border = border_mm / kInkPixel_mm;
    const Ink hollows = near_black(opposite(near_black(opposite(ink), half + 1.0, false)), half - border, true);
    const Ink wide = opposite(near_black(opposite(ink), half * std::sqrt(2.0) + 1.0, false));
    const InkPieces pieces = pieces_of(hollows);
    std::vector<bool> long_enough(pieces.pixels.size(), false);
    for (std::size_t piece = 1; piece < long_enough.size(); ++piece)
        long_enough[piece] = pieces.extent[piece] * kInkPixel_mm >= least_mm;
    for (std::size_t i = 0; i < wide.black.size(); ++i)
        if (wide.black[i]) long_enough[pieces.of[i]] = true;
    long_enough[0] = false;
    const auto made = static_cast<int>(std::count(long_enough.begin(), long_enough.end(), true));
    for (std::size_t i = 0; i < ink.black.size(); ++i)
        if (long_enough[pieces.of[i]]) ink.black[i] = 0;
    return made;
}

void part_corners(Ink& ink) {
    for (bool again = true; again;) {
        again = false;
        for (int y = 0; y + 1 < ink.high; ++y)
            for (int x = 0; x + 1 < ink.wide; ++x) {
                std::uint8_t &a = ink.black[ink.at(x, y)], &b = ink.black[ink.at(x + 1, y)];
                std::uint8_t &c = ink.black[ink.at(x, y + 1)], &d = ink.black[ink.at(x + 1, y + 1)];
                if (a != d || b != c || a == b) continue;
                a = b = c = d = 1;
                again = true;
            }
    }
}

std::vector<std::vector<Vec2>> traced_mm(const Ink& ink, double most_mm) {
    // For each corner, the sides of pixels that begin there and have black on their left. The bits are 0 east, 1 north,
    // 2 west, 3 south.
    const auto black = [&](int x, int y) { return ink.holds(x, y) && ink.black[ink.at(x, y)] != 0; };
    const auto corner = [&](int x, int y) {
        return static_cast<std::uint64_t>(y) << 32U | static_cast<std::uint32_t>(x);
    };
    std::unordered_map<std::uint64_t, std::uint8_t> sides;
    std::vector<std::uint64_t> order;
    const auto add = [&](int x, int y, int way) {
        std::uint8_t& there = sides[corner(x, y)];
        if (there == 0) order.push_back(corner(x, y));
        there = static_cast<std::uint8_t>(there | 1U << way);
    };
    for (int y = 0; y < ink.high; ++y)
        for (int x = 0; x < ink.wide; ++x) {
            if (!black(x, y)) continue;
            if (!black(x, y - 1)) add(x, y, 0);
            if (!black(x + 1, y)) add(x + 1, y, 1);
            if (!black(x, y + 1)) add(x + 1, y + 1, 2);
            if (!black(x - 1, y)) add(x, y + 1, 3);
        }
    constexpr std::array<int, 4> kX{1, 0, -1, 0}, kY{0, 1, 0, -1};
    std::vector<std::vector<Vec2>> loops;
    for (const std::uint64_t start : order) {
        while (sides[start] != 0) {
            std::vector<Vec2> loop;
            int x = static_cast<int>(start & 0xFFFFFFFFU), y = static_cast<int>(start >> 32U), way = -1;
            for (;;) {
                std::uint8_t& there = sides[corner(x, y)];
                if (there == 0) break;
                int next = 0;
                // Turns left first, so that pixels that meet only at a corner stay separate.
                if (way < 0)
                    while (!(there >> next & 1)) ++next;
                else
                    for (const int turn : {1, 0, 3})
                        if (there >> (next = (way + turn) % 4) & 1) break;
                there = static_cast<std::uint8_t>(there & ~(1U << next));
                if (next != way) loop.push_back(Vec2(x, y) * kInkPixel_mm);
                way = next;
                x += kX[static_cast<std::size_t>(way)];
                y += kY[static_cast<std::size_t>(way)];
            }
            if (loop.size() >= 3) loops.push_back(straightened(loop, most_mm));
        }
    }
    return loops;
}

}  // namespace handrail::exports
