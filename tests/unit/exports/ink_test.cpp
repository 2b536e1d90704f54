// Tests distances in a picture of the page: gaps that are too narrow, lines that are too thick, and outlines.
#include "worlds/exports/ink.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/names.h"
#include "worlds/exports/sheet.h"

namespace handrail::test {
namespace ink_test {

using Loops = std::vector<std::vector<Vec2>>;

std::vector<Vec2> box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

SheetPage page_of(std::vector<std::vector<std::vector<Vec2>>> shapes, bool one_part = false) {
    SheetPage page{40.0, 40.0, {}, {}, {}, {}};
    int part = 0;
    for (auto& loops : shapes) page.shapes.push_back({std::move(loops), one_part ? 1 : ++part});
    return page;
}

TEST(InkDistances, agree_with_checking_every_pixel) {
    std::mt19937 random(7);
    Ink ink(4.1, 3.3);
    for (std::uint8_t& pixel : ink.black) pixel = random() % 40 == 0 ? 1 : 0;
    std::vector<std::uint32_t> whose;
    const std::vector<float> far = distances_px(ink, &whose);
    for (int y = 0; y < ink.high; ++y)
        for (int x = 0; x < ink.wide; ++x) {
            double least = 1e9;
            for (int v = 0; v < ink.high; ++v)
                for (int u = 0; u < ink.wide; ++u)
                    if (ink.black[ink.at(u, v)]) least = std::min(least, std::hypot(u - x, v - y));
            ASSERT_NEAR(static_cast<double>(far[ink.at(x, y)]), least, 1e-4) << x << " " << y;
            const int u = static_cast<int>(whose[ink.at(x, y)]) % ink.wide;
            const int v = static_cast<int>(whose[ink.at(x, y)]) / ink.wide;
            ASSERT_NEAR(std::hypot(u - x, v - y), least, 1e-4);
            ASSERT_TRUE(ink.black[ink.at(u, v)]);
        }
    EXPECT_GT(distances_px(Ink(1.0, 1.0)).front(), 1e6F) << "nothing is black";
}

TEST(PixelsInLoops, are_those_on_the_page_however_far_the_loops_reach) {
    Ink ink(4.0, 3.0);
    const auto count = [&](const Loops& loops) {
        int pixels = 0;
        for_pixels_in(ink, loops, [&](int x, int y) { pixels += ink.holds(x, y) ? 1 : 100000; });
        return pixels;
    };
    EXPECT_EQ(count({}), 0);
    EXPECT_EQ(count({box(-1e300, -1e300, 1e300, 1e300)}), ink.wide * ink.high);
    EXPECT_EQ(count({box(1.0, -1e300, 1e300, 2.0)}), 30 * 20);
    EXPECT_EQ(count({box(5.0, 0.0, 1e300, 3.0)}), 0) << "right of the page";
    EXPECT_EQ(count({box(0.0, 4.0, 4.0, 1e300)}), 0) << "above the page";
    EXPECT_EQ(count({box(-1e300, -1e300, 4.0, -1.0)}), 0) << "below the page";
}

TEST(NearBlack, agrees_with_the_pixel_distances) {
    std::mt19937 random(11);
    Ink ink(6.3, 5.2);
    for (std::uint8_t& pixel : ink.black) pixel = random() % 300 == 0 ? 1 : 0;
    const std::vector<float> far = distances_px(ink);
    for (const double limit : {0.0, 1.0, 2.5, 5.0, 13.0, 16.5})
        for (const bool as_far : {false, true}) {
            const Ink near = near_black(ink, limit, as_far);
            for (std::size_t i = 0; i < far.size(); ++i) {
                const auto distance = static_cast<double>(far[i]);
                ASSERT_EQ(near.black[i] != 0, as_far ? distance <= limit : distance < limit) << limit << " " << i;
            }
        }
    const Ink none = near_black(Ink(1.0, 1.0), 16.5, true);
    EXPECT_EQ(std::count(none.black.begin(), none.black.end(), 1), 0) << "nothing is black";
}

TEST(CheckGaps, finds_gaps_that_are_too_narrow_and_ignores_wide_enough_ones) {
    EXPECT_TRUE(check_gaps(page_of({{box(5, 5, 10, 20)}, {box(13.1, 5, 18, 20)}}), 3.0).narrow_mm.empty());
    const GapCheck near = check_gaps(page_of({{box(5, 5, 10, 20)}, {box(12.8, 5, 18, 20)}}), 3.0);
    EXPECT_FALSE(near.narrow_mm.empty());
    EXPECT_NEAR(near.least_mm, 2.8, 0.11);
    const GapCheck joined = check_gaps(page_of({{box(5, 5, 10, 20)}, {box(9, 5, 18, 20)}}), 3.0);
    EXPECT_EQ(joined.least_mm, 0.0) << "two parts that overlap";
    const GapCheck askew = check_gaps(page_of({{{{5, 5}, {10, 5}, {7, 15}}}, {{{12, 6}, {14, 6}, {13, 12}}}}), 3.0);
    EXPECT_NEAR(askew.least_mm, 2.0, 0.35);
    EXPECT_FALSE(askew.narrow_mm.empty());
}

TEST(CheckGaps, finds_slits_within_one_part_and_ignores_its_corners) {
    // A third line joins two lines of one part. The gap between those two lines is 2 mm in the first page and 4 mm in
    // the second.
    EXPECT_FALSE(check_gaps(page_of({{box(5, 5, 20, 7)}, {box(5, 9, 20, 11)}, {box(3, 5, 5, 11)}}, true), 3.0)
                     .narrow_mm.empty());
    EXPECT_TRUE(check_gaps(page_of({{box(5, 5, 20, 7)}, {box(5, 11, 20, 13)}, {box(3, 5, 5, 13)}}, true), 3.0)
                    .narrow_mm.empty());
    // A wall with a doorway of 2 mm, then one with a doorway of 4 mm.
    EXPECT_FALSE(check_gaps(page_of({{box(3, 5, 10, 7)}, {box(12, 5, 20, 7)}}, true), 3.0).narrow_mm.empty());
    EXPECT_TRUE(check_gaps(page_of({{box(3, 5, 10, 7)}, {box(14, 5, 20, 7)}}, true), 3.0).narrow_mm.empty());
    // A pit of 2 mm, which is too narrow for any drawing, and one of 4 mm.
    EXPECT_FALSE(check_gaps(page_of({{box(3, 3, 20, 20), box(8, 8, 10, 10)}}), 3.0).narrow_mm.empty());
    EXPECT_TRUE(check_gaps(page_of({{box(3, 3, 20, 20), box(8, 8, 12, 12)}}), 3.0).narrow_mm.empty());
    // Tests corners of every angle that walls have.
    for (const double turn : {0.8, 1.2, 1.6, 2.4}) {
        const Vec2 way(std::cos(turn), std::sin(turn)), side(-way.y, way.x);
        const Vec2 at(12, 8);
        EXPECT_TRUE(check_gaps(page_of({{box(12, 7, 30, 9)},
                                        {{at - side, at + way * 18.0 - side, at + way * 18.0 + side, at + side}}},
                                       true),
                               3.0)
                        .narrow_mm.empty())
            << turn;
    }
}

TEST(CheckGaps, checks_dots_against_everything_except_their_own_sign) {
    SheetPage page = page_of({{box(5, 5, 20, 7)}});
    page.dots = {{{10, 12}, 0.75, 9}, {{12.5, 12}, 0.75, 9}};
    EXPECT_TRUE(check_gaps(page, 3.0).narrow_mm.empty());
    page.dots[1].part = 10;
    EXPECT_NEAR(check_gaps(page, 3.0).least_mm, 1.0, 0.15) << "of another sign";
    page.dots = {{{10, 9.5}, 0.75, 9}};
    EXPECT_FALSE(check_gaps(page, 3.0).narrow_mm.empty());
}

TEST(TracedInk, covers_the_same_pixels_except_on_slanting_borders) {
    Ink ink(40.0, 40.0);
    const std::vector<std::vector<std::vector<Vec2>>> shapes{{box(5, 5, 30, 8)},
                                                             {box(10, 5, 12, 30)},
                                                             {{{20, 10}, {35, 20}, {34, 21.5}, {19, 11.5}}},
                                                             {box(5, 32, 20, 38), box(8, 34, 14, 36)}};
    for (const auto& loops : shapes) fill(ink, loops, true);
    Ink again(40.0, 40.0);
    const auto loops = traced_mm(ink);
    fill(again, loops, true);
    const std::vector<float> inside = distances_px(again), outside = distances_px(ink);
    for (std::size_t i = 0; i < ink.black.size(); ++i) {
        if (ink.black[i]) {
            ASSERT_LE(inside[i], 1.5F);
        }
        if (again.black[i]) {
            ASSERT_LE(outside[i], 1.5F);
        }
    }
    std::size_t corners = 0;
    for (const auto& loop : loops) corners += loop.size();
    EXPECT_LE(corners, 60U) << "straight lines stay a few corners";
}

TEST(HollowOut, leaves_a_border_and_makes_no_pit_at_wall_crossings) {
    Ink thick(40.0, 40.0);
    fill(thick, Loops{box(5, 5, 35, 15)}, true);
    EXPECT_EQ(hollow_out(thick, 6.0, 1.5, 15.0), 1);
    EXPECT_FALSE(thick.black[thick.at(200, 100)]);
    EXPECT_TRUE(thick.black[thick.at(200, 60)]) << "1 mm inside the border";
    Ink cross(40.0, 40.0);
    fill(cross, Loops{box(5, 17, 35, 22.5)}, true);
    fill(cross, Loops{box(17, 5, 22.5, 35)}, true);
    EXPECT_EQ(hollow_out(cross, 6.0, 1.5, 15.0), 0);
    Ink pillar(40.0, 40.0);
    fill(pillar, Loops{box(5, 5, 14, 14)}, true);
    EXPECT_EQ(hollow_out(pillar, 6.0, 1.5, 15.0), 1);
    EXPECT_FALSE(pillar.black[pillar.at(95, 95)]) << "wider than where walls cross";
}

}  // namespace ink_test
}  // namespace handrail::test
