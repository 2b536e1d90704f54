// Tests sheets for swell paper of all storeys of the bundled worlds. A finger must be able to distinguish all lines,
// and the sheet must not omit anything silently.
#include "worlds/exports/swell_sheet.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>
#include <set>

#include "tests/support/lay_floor.h"
#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/exports/plans.h"
#include "worlds/exports/ink.h"
#include "worlds/exports/openings.h"
#include "worlds/exports/sheet_title.h"

namespace handrail::test {
namespace swell_sheet_test {

// Checks that every sign is inside its room with all its corners, and not in a doorway.
void stand_in_their_rooms(const Storey& storey, const SwellSheet& sheet, const std::string& what) {
    Ink walls(sheet.plan.width_mm, sheet.plan.height_mm);
    for (const SheetShape& shape : sheet.plan.shapes)
        if (shape.part == kWallPart) fill(walls, shape.loops_mm, true);
    const RoomGrid rooms = rooms_on(walls, storey, sheet.on_paper);
    for (std::uint32_t i = 0; i < storey.rooms.size(); ++i) {
        const RoomSign& sign = sheet.signs[i];
        if (!sign.on_sheet) continue;
        ASSERT_GT(sign.half_mm.y, 3.0) << sign.name;
        for (const Vec2& way : {Vec2(1.0, 1.0), Vec2(-1.0, 1.0), Vec2(1.0, -1.0), Vec2(-1.0, -1.0)}) {
            const Vec2 at = (sign.at_mm + way * (sign.half_mm - Vec2(0.5))) / kInkPixel_mm;
            EXPECT_EQ(rooms.room[rooms.at(static_cast<int>(at.x), static_cast<int>(at.y))], i)
                << what << ": " << sign.sign << ", " << sign.name;
        }
        for (const StoreyGap& gap : storey.gaps)
            EXPECT_GT(glm::distance(sheet.on_paper(gap.place_m), sign.at_mm), 3.0)
                << what << ": " << sign.name << " in the doorway " << gap.name;
        for (std::uint32_t j = 0; j < i; ++j) {
            const RoomSign& other = sheet.signs[j];
            const Vec2 apart = glm::abs(sign.at_mm - other.at_mm) - sign.half_mm - other.half_mm;
            if (other.on_sheet) {
                EXPECT_GE(glm::length(glm::max(apart, Vec2(0.0))), 6.4 - 1e-6)
                    << what << ": " << sign.sign << other.sign;
            }
        }
    }
}

Ink ink_of(const SheetPage& page) {
    Ink ink(page.width_mm, page.height_mm);
    for (const SheetShape& shape : page.shapes) fill(ink, shape.loops_mm, true);
    return ink;
}

bool black_at(const Ink& ink, const Vec2& mm) {
    const int x = static_cast<int>(mm.x / kInkPixel_mm), y = static_cast<int>(mm.y / kInkPixel_mm);
    return ink.holds(x, y) && ink.black[ink.at(x, y)];
}

void is_fit_for_fingers(const Storey& storey, const SwellSheet& sheet, const std::string& what) {
    const GapCheck gaps = check_gaps(sheet.plan, kLeastGap_mm);
    EXPECT_TRUE(gaps.narrow_mm.empty()) << what << ": " << gaps.narrow_mm.size() << " pixels, the first at "
                                        << gaps.narrow_mm[0].x << " " << gaps.narrow_mm[0].y;
    EXPECT_GE(gaps.least_mm, kLeastGap_mm - 0.05) << what;
    stand_in_their_rooms(storey, sheet, what);
    std::string key;
    for (const std::string& line : sheet.key_text) key += line + "\n";
    std::set<std::string> signs;
    ASSERT_EQ(sheet.signs.size(), storey.rooms.size());
    for (const RoomSign& sign : sheet.signs) {
        EXPECT_TRUE(signs.insert(sign.sign).second) << what << ": " << sign.sign << " twice";
        EXPECT_NE(key.find(sign.name.substr(1)), std::string::npos) << what << ": the key does not name " << sign.name;
        if (sign.on_sheet) {
            EXPECT_NE(key.find(sign.sign + "  "), std::string::npos) << what << ": " << sign.sign;
        }
    }
    for (const StoreyThing& thing : storey.things) {
        const bool drawn = std::count(sheet.drawn.begin(), sheet.drawn.end(), thing.name) > 0;
        EXPECT_TRUE(drawn || key.find(thing.name) != std::string::npos) << what << " lost " << thing.name;
    }
    const Ink ink = ink_of(sheet.plan);
    const OnPaper& on_sheet = sheet.on_paper;
    for (const PlanOutline& window : storey.windows_m) {
        const PlanBox box = box_around(window);
        for (const double part : {-0.9, -0.4, 0.0, 0.4, 0.9})
            EXPECT_TRUE(black_at(ink, on_sheet(box.middle_m + box.along * (part * box.half_m.x))))
                << what << ": a window like a door at " << box.middle_m.x << " " << box.middle_m.y;
    }
    for (const StoreyGap& gap : storey.gaps)
        if (gap.kind == PassageKind::Door) {
            EXPECT_FALSE(black_at(ink, on_sheet(gap.place_m)))
                << what << ": a closed door at " << gap.place_m.x << " " << gap.place_m.y;
        }
}

void all_storeys_are_fit(const std::string& file, const PaperSize& paper, BrailleTable table, int last = 99) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for one sheet of our house, over many pixels";
    const NamedStoreys* world = storeys_of(file);
    if (!world) GTEST_SKIP() << needs_real_world(file);
    ASSERT_FALSE(world->storeys.empty());
    for (const Storey& storey : world->storeys) {
        if (storey.number > last) break;
        if (&storey != &world->storeys.front() && !test::tried(1, 2)) break;
        const Result<SwellSheet> sheet = swell_sheet(storey, {paper, table});
        ASSERT_TRUE(sheet) << sheet.error().sentence();
        is_fit_for_fingers(storey, *sheet, file + " " + std::to_string(storey.number));
    }
}

TEST(SwellSheet, of_every_storey_of_our_house_keeps_lines_far_enough_apart_for_fingers) {
    all_storeys_are_fit("house.map", kA4, BrailleTable::EnUebG1);
    all_storeys_are_fit("house.map", kA3, BrailleTable::DeG2, 1);
}
TEST(SwellSheet, of_a_generated_architects_house_keeps_lines_far_enough_apart_for_fingers) {
    all_storeys_are_fit("small_house.ifc", kA4, BrailleTable::DeG1);
}
TEST(SwellSheet, of_every_storey_of_our_school_keeps_lines_far_enough_apart_for_fingers) {
    all_storeys_are_fit("school.map", kA4, BrailleTable::EnUebG2);
}
TEST(SwellSheet, of_a_game_map_keeps_lines_far_enough_apart_for_fingers) {
    all_storeys_are_fit("agdm01.map", kA4, BrailleTable::EnUebG1);
}
TEST(SwellSheet, of_every_storey_of_a_real_building_keeps_lines_far_enough_apart_for_fingers) {
    all_storeys_are_fit("duplex-apartment.ifc", kA4, BrailleTable::DeG1);
}

TEST(SwellSheet, of_two_rooms_has_their_signs_the_table_and_an_open_door) {
    const Storey storey = two_rooms();
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet) << sheet.error().sentence();
    is_fit_for_fingers(storey, *sheet, "two rooms");
    EXPECT_EQ(sheet->signs[0].sign, "ki");
    EXPECT_EQ(sheet->signs[1].sign, "r12");
    EXPECT_TRUE(sheet->signs[0].on_sheet && sheet->signs[1].on_sheet);
    EXPECT_EQ(sheet->drawn, std::vector<std::string>{"Table"});
    EXPECT_EQ(sheet->one_to, 40.0) << "10.2 m by 5.2 m across on a sheet of A4";
    EXPECT_GT(sheet->plan.width_mm, sheet->plan.height_mm);
    EXPECT_TRUE(sheet->simplified.empty()) << sheet->simplified[0];
    ASSERT_FALSE(sheet->key.empty());
    EXPECT_NE(sheet->plan.text.find("ki  Kitchen."), std::string::npos) << sheet->plan.text;
    // The sheet must leave the doorway free over its whole width of 25 mm.
    const Ink ink = ink_of(sheet->plan);
    const OnPaper& on_sheet = sheet->on_paper;
    EXPECT_TRUE(black_at(ink, on_sheet({6.1, 1.4})));
    for (const double y : {1.55, 2.0, 2.45}) EXPECT_FALSE(black_at(ink, on_sheet({6.1, y})));
}

// Returns the braille in the head of a sheet in BRF characters. Blanks separate the lines.
std::string head_of(const SwellSheet& sheet) {
    std::string head;
    for (const double line_mm : {0.0, kBrailleLine_mm}) {
        BrailleCells cells(60, 0);
        const Vec2 first(12.0 + 0.5 * kBrailleDot_mm, sheet.plan.height_mm - 12.0 - 0.5 * kBrailleDot_mm - line_mm);
        for (const SheetDot& dot : sheet.plan.dots) {
            const Vec2 off = dot.at_mm - first;
            if (off.y < -6.0 || off.y > 1.0) continue;
            const auto cell = static_cast<std::size_t>((off.x + 1.0) / kBrailleCell_mm);
            const int column = off.x - static_cast<double>(cell) * kBrailleCell_mm > 1.0 ? 3 : 0;
            cells.at(cell) |= static_cast<std::uint8_t>(1 << (column + static_cast<int>(std::lround(-off.y / 2.5))));
        }
        std::string line = brf_of(cells);
        line.erase(line.find_last_not_of(' ') + 1);
        head += (head.empty() || line.empty() ? "" : " ") + line;
    }
    return head;
}

std::string brf_for(const std::string& text) {
    const Result<BrailleCells> cells = braille_of(text, BrailleTable::EnUebG1);
    return cells ? brf_of(*cells) : cells.error().sentence();
}

TEST(SwellSheet, keeps_the_storey_in_its_title_even_with_a_long_name) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the sheet of our house";
    Storey storey = two_rooms();
    storey.number = 2;
    storey.count = 3;
    for (const std::string name : {"Test", "A house with a garden in which there is room for more than a name",
                                   "Donaudampfschifffahrtsgesellschaftsverwaltungsgebäude am Donaudampfschiffhafen"}) {
        storey.world = name;
        const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
        ASSERT_TRUE(sheet);
        EXPECT_NE(head_of(*sheet).find(brf_for("storey 2 of 3")), std::string::npos) << name << ": " << head_of(*sheet);
    }
}

TEST(SwellSheet, wraps_its_title_and_keeps_as_much_of_a_long_name_as_fits_in_two_lines) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the sheet of our house";
    const auto head = [](const std::string& world, const Vec2& max_m) {
        Storey storey = two_rooms();
        storey.world = world;
        storey.max_m = max_m;
        const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
        return sheet ? head_of(*sheet) : sheet.error().sentence();
    };
    const Vec2 upright(9.7, 14.0);
    EXPECT_EQ(head("House with a garden", upright), brf_for("House with a garden, storey 1 of 1"));
    EXPECT_EQ(head("AGRIP Tutorial 05: Pickups, Ramps and Switches", upright),
              brf_for("AGRIP Tutorial 05..., storey 1 of 1"));
}

TEST(SwellSheet, leaves_no_single_word_for_the_second_line_of_its_title) {
    Storey storey = two_rooms();
    storey.name = "Level 1";
    for (const char* world : {"Duplex Apartment", "A building of two wings and a yard"}) {
        storey.world = world;
        const Result<std::vector<BrailleCells>> lines =
            title_lines(storey, std::nullopt, BrailleTable::EnUebG1, kA4.short_mm);
        ASSERT_TRUE(lines);
        ASSERT_EQ(lines->size(), 2U);
        EXPECT_GT(std::count((*lines)[1].begin(), (*lines)[1].end(), 0), 0) << world;
    }
}

TEST(SwellSheet, says_that_the_base_is_outside_and_which_room_has_no_route) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the sheet of our house";
    Storey storey = two_rooms();
    storey.base = StoreyBase{{40.0, 2.0}, 0.0};
    storey.rooms[1].shut = true;
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_NE(sheet->plan.text.find("The base is outside this plan."), std::string::npos) << sheet->plan.text;
    EXPECT_NE(sheet->plan.text.find("Room 12. No route leads there."), std::string::npos) << sheet->plan.text;
    EXPECT_NE(sheet->plan.text.find("Kitchen. Drawn there"), std::string::npos) << sheet->plan.text;
}

TEST(SwellSheet, names_its_storey_as_the_file_and_the_room_names_do) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the sheet of our house";
    Storey storey = two_rooms();
    storey.name = "Level 1";
    storey.number = 3;
    storey.count = 5;
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_EQ(head_of(*sheet), brf_for("Test, Level 1"));
    EXPECT_EQ(sheet->key_text.at(0), "Test, Level 1, storey 3 of 5");
}

TEST(SwellSheet, of_an_upper_storey_shows_the_stairs_that_arrive_there) {
    const NamedStoreys* house = storeys_of("house.map");
    ASSERT_TRUE(house && house->storeys.size() == 2U);
    const Storey& upper = house->storeys[1];
    ASSERT_FALSE(upper.stairs_of_others.empty());
    const Result<SwellSheet> sheet = swell_sheet(upper, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_NE(sheet->plan.text.find("Stairs of another storey begin or end in: Landing."), std::string::npos)
        << sheet->plan.text;
    // At least three lines must cross the flight of stairs.
    int lines = 0;
    for (const SheetShape& shape : sheet->plan.shapes) {
        Vec2 low(1e9), high(-1e9);
        for (const Vec2& p : shape.loops_mm[0]) low = glm::min(low, p), high = glm::max(high, p);
        const Vec2 size = high - low;
        lines += shape.loops_mm.size() == 1 && std::min(size.x, size.y) < 1.05 && std::max(size.x, size.y) > 3.0;
    }
    EXPECT_GE(lines, 3);
}

TEST(SwellSheet, of_our_house_meets_all_requirements_and_has_stairs_base_and_every_sign) {
    const NamedStoreys* house = storeys_of("house.map");
    ASSERT_TRUE(house && !house->storeys.empty());
    const Result<SwellSheet> sheet = swell_sheet(house->storeys[0], {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_TRUE(sheet->broken.empty()) << sheet->broken[0];
    EXPECT_NE(sheet->plan.text.find("The filled triangle on the plan is the base, in Hall;"), std::string::npos)
        << sheet->plan.text;
    EXPECT_NE(sheet->plan.text.find("pn  Pond."), std::string::npos) << sheet->plan.text;
}

TEST(SwellSheet, of_a_real_building_has_no_sign_for_a_niche_outside_it) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for our house";
    const NamedStoreys* duplex = storeys_of("duplex-apartment.ifc");
    if (!duplex) GTEST_SKIP() << needs_real_world("duplex-apartment.ifc");
    ASSERT_GE(duplex->storeys.size(), 2U);
    const Storey& storey = duplex->storeys[1];
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    for (std::size_t i = 0; i < storey.rooms.size(); ++i) {
        EXPECT_NE(storey.rooms[i].kind, RoomKind::Niche) << storey.rooms[i].name << " is a ledge outside of a window";
        if (!sheet->signs[i].on_sheet) continue;
        const StoreyRoom& room = storey.rooms[i];
        const Vec2 at = sheet->on_paper.world(sheet->signs[i].at_mm);
        EXPECT_TRUE(at.x > room.min_m.x - 0.4 && at.x < room.max_m.x + 0.4 && at.y > room.min_m.y - 0.4 &&
                    at.y < room.max_m.y + 0.4)
            << room.name << " has its sign at " << at.x << " " << at.y;
    }
}

TEST(SwellSheet, assigns_a_thing_to_the_room_in_which_it_is_drawn) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the sheet of our house";
    Storey storey = two_rooms();
    // No walker reaches the place of the board, which is next to the wall. The nearest walkable area is in the kitchen,
    // behind the wall.
    storey.rooms[1].loops_m = {{{7.8, 0.25}, {8.95, 0.25}, {8.95, 3.75}, {7.8, 3.75}},
                               {{6.45, 1.5}, {8.0, 1.5}, {8.0, 2.2}, {6.45, 2.2}}};
    lay_floor(storey);
    storey.things.push_back({FeatureId{2}, "Board", {{6.6, 3.3}, {0.0, 1.0}, {0.35, 0.35}}, true});
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_NE(sheet->plan.text.find("r12  Room 12. Drawn there: Board."), std::string::npos) << sheet->plan.text;
    EXPECT_NE(sheet->plan.text.find("ki  Kitchen. Drawn there: Table."), std::string::npos) << sheet->plan.text;
    EXPECT_NE(sheet->plan.text.find("the base, in Kitchen;"), std::string::npos) << sheet->plan.text;
}

// Returns rooms of 3 by 3 m in rows. Each room has a door to the next one.
Storey many_rooms(int columns, int rows) {
    Storey storey;
    storey.world = "Test";
    storey.min_m = {-0.5, -0.5};
    storey.max_m = {3.0 * columns + 0.5, 3.0 * rows + 0.5};
    const auto wall = [&](double x0, double y0, double x1, double y1) {
        storey.walls_m.push_back({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
    };
    for (int y = 0; y <= rows; ++y) wall(-0.1, 3.0 * y - 0.1, 3.0 * columns + 0.1, 3.0 * y + 0.1);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x <= columns; ++x) {
            const bool outer = x == 0 || x == columns;
            wall(3.0 * x - 0.1, 3.0 * y, 3.0 * x + 0.1, 3.0 * y + (outer ? 3.0 : 1.0));
            if (!outer) wall(3.0 * x - 0.1, 3.0 * y + 2.0, 3.0 * x + 0.1, 3.0 * y + 3.0);
        }
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x) {
            StoreyRoom room;
            const auto here = static_cast<std::uint32_t>(storey.rooms.size());
            room.room = here;
            room.name = "Room " + std::to_string(here + 1);
            room.min_m = {3.0 * x + 0.35, 3.0 * y + 0.35};
            room.max_m = room.min_m + Vec2(2.3);
            room.middle_m = room.min_m + Vec2(1.15);
            room.area_m2 = 5.3;
            room.loops_m = {{room.min_m, {room.max_m.x, room.min_m.y}, room.max_m, {room.min_m.x, room.max_m.y}}};
            storey.rooms.push_back(std::move(room));
            if (x + 1 == columns) continue;
            storey.gaps.push_back({PassageKind::Door, "Door", {3.0 * x + 3.0, 3.0 * y + 1.5}, {0.0, 1.0}, 1.0});
            storey.portals.push_back({PassageKind::Door, {here, here + 1}, {3.0 * x + 3.0, 3.0 * y + 1.5}, 1.0});
        }
    lay_floor(storey);
    return storey;
}

TEST(SwellSheets, state_that_one_is_not_enough_and_several_meet_all_requirements) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for our house";
    const Storey storey = many_rooms(16, 3);
    const SheetOptions options{kA4, BrailleTable::EnUebG1};
    const Result<SwellSheet> one = swell_sheet(storey, options);
    ASSERT_TRUE(one);
    ASSERT_FALSE(one->broken.empty()) << "49 m across a sheet of 27 cm leave 16 mm to a room";
    const Result<std::vector<SwellSheet>> sheets = swell_sheets(storey, options);
    ASSERT_TRUE(sheets);
    ASSERT_GT(sheets->size(), 1U);
    EXPECT_LE(sheets->size(), 4U) << "no more than they need";
    std::vector<int> signs(storey.rooms.size(), 0);
    for (const SwellSheet& sheet : *sheets) {
        EXPECT_TRUE(sheet.broken.empty()) << sheet.broken[0];
        EXPECT_TRUE(check_gaps(sheet.plan, kLeastGap_mm).narrow_mm.empty());
        stand_in_their_rooms(storey, sheet, "many rooms");
        for (std::size_t i = 0; i < signs.size(); ++i) signs[i] += sheet.signs[i].on_sheet ? 1 : 0;
        ASSERT_TRUE(sheet.part);
        EXPECT_NE(head_of(sheet).find("SHEET"), std::string::npos) << head_of(sheet);
        EXPECT_EQ(head_of(sheet).front(), ',') << "a capital letter, not what the name of the world left";
        // Neighbouring sheets must refer to each other, and their marks must be at the same places of the world.
        constexpr std::size_t kBack[] = {1, 0, 3, 2};
        for (std::size_t side = 0; side < 4; ++side)
            for (const NextSheet& next : sheet.part->next[side]) {
                const SheetPart& other = *(*sheets)[static_cast<std::size_t>(next.number - 1)].part;
                const auto& back = other.next[kBack[side]];
                EXPECT_EQ(std::count_if(back.begin(), back.end(),
                                        [&](const NextSheet& seen) {
                                            return seen.number == sheet.part->number &&
                                                   seen.shared_m == next.shared_m && seen.along_m == next.along_m;
                                        }),
                          1);
            }
    }
    EXPECT_EQ(std::count(signs.begin(), signs.end(), 0), 0) << "every room has its sign on a sheet";
    SheetOptions coarse = options;
    coarse.coarse = true;
    EXPECT_TRUE(swell_sheet(storey, coarse)->broken.empty()) << "rooms under 6 square metres need none";
}

TEST(SheetParts, are_cut_between_wings_and_show_no_empty_corner) {
    // Two wings of 20 by 10 m. Only a corridor joins them.
    Storey storey;
    storey.world = "Test";
    storey.max_m = {50.0, 40.0};
    const auto room = [&](double x0, double y0, double x1, double y1) {
        StoreyRoom made;
        made.room = static_cast<std::uint32_t>(storey.rooms.size());
        made.name = "Room " + std::to_string(made.room + 1);
        made.min_m = {x0, y0};
        made.max_m = {x1, y1};
        made.middle_m = 0.5 * (made.min_m + made.max_m);
        made.area_m2 = (x1 - x0) * (y1 - y0);
        made.loops_m = {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
        storey.rooms.push_back(std::move(made));
    };
    room(1.0, 1.0, 21.0, 11.0);
    room(29.0, 1.0, 49.0, 11.0);
    room(21.0, 8.0, 29.0, 10.0);
    lay_floor(storey);
    const std::vector<SheetPart> parts = parts_of(storey, kA4, 100.0);
    ASSERT_EQ(parts.size(), 2U);
    for (const SheetPart& part : parts) {
        EXPECT_LT(part.max_m.y, 13.0) << "the north is empty";
        EXPECT_EQ(part.next[0].size() + part.next[1].size(), 1U);
        EXPECT_TRUE(part.next[2].empty() && part.next[3].empty());
    }
    const double cut = parts[0].next[1].at(0).shared_m;
    EXPECT_TRUE(cut >= 20.9 && cut <= 29.1) << "in the corridor, not across a wing: " << cut;
    EXPECT_EQ(parts_of(storey, kA4, 400.0).size(), 1U);
    EXPECT_TRUE(parts_of(storey, kA4, 10.0).empty()) << "more than there may be";
}

TEST(SheetParts, have_the_scale_that_each_room_needs) {
    const Storey storey = two_rooms();
    const std::vector<double> scales{100.0, 200.0, 300.0, 1000.0};
    // Between their walls, the rooms are 6 m and 3 m wide and 4 m deep.
    EXPECT_EQ(scales_needed(storey, scales, {16.0, 13.0}), (std::vector<double>{300.0, 100.0}));
    EXPECT_EQ(scales_needed(storey, scales, {16.0, 50.0}), (std::vector<double>{0.0, 0.0}));
}

TEST(SwellSheet, gives_a_small_room_one_letter_and_describes_where_an_even_smaller_one_leads) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for our house";
    const auto sheet_of = [](Storey storey, double wide_m) {
        storey.max_m = {wide_m, 30.0};
        return swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    };
    // Between its walls, Room 12 is 3 m wide, which is 13.3 mm at 1 to 225. A sign of two cells needs 16.3 mm, a sign
    // of one cell 10.4 mm.
    const Result<SwellSheet> letter = sheet_of(two_rooms(), 57.0);
    ASSERT_TRUE(letter && letter->one_to == 225.0);
    EXPECT_EQ(letter->signs[0].sign, "ki");
    EXPECT_TRUE(letter->signs[1].on_sheet);
    EXPECT_EQ(letter->signs[1].sign, "r");
    EXPECT_NE(letter->plan.text.find("r  Room 12."), std::string::npos) << letter->plan.text;
    // At 1 to 275, the room has only 10.1 mm left, because the sheet draws lines thicker than the walls are.
    const Result<SwellSheet> none = sheet_of(two_rooms(), 72.0);
    ASSERT_TRUE(none && none->one_to == 275.0);
    EXPECT_EQ(none->signs[1].doors_to, std::vector<std::string>{"Kitchen"});
    EXPECT_NE(none->plan.text.find("Room 12: not labelled on the plan. It leads to: Kitchen."), std::string::npos)
        << none->plan.text;
    EXPECT_TRUE(none->broken.empty()) << none->broken[0];
    // If two rooms of this size have no sign, nobody can tell which is which.
    Storey both = two_rooms();
    both.rooms.push_back(both.rooms[1]);
    both.rooms[1].loops_m = {{{6.45, 0.25}, {8.95, 0.25}, {8.95, 1.75}, {6.45, 1.75}}};
    both.rooms[2].loops_m = {{{6.45, 2.25}, {8.95, 2.25}, {8.95, 3.75}, {6.45, 3.75}}};
    both.rooms[1].max_m.y = 1.75;
    both.rooms[2].min_m.y = 2.25;
    both.rooms[2].name = "Room 13";
    both.walls_m.push_back({{6.0, 1.9}, {9.2, 1.9}, {9.2, 2.1}, {6.0, 2.1}});
    both.portals[0].place_m = {6.1, 1.7};
    both.portals.push_back({PassageKind::Door, {0, 2}, {6.1, 2.3}, 1.0});
    lay_floor(both);
    const Result<SwellSheet> alike = sheet_of(both, 72.0);
    ASSERT_TRUE(alike && !alike->broken.empty());
    EXPECT_EQ(alike->broken[0], "There is no room for the signs of these rooms: Room 12; Room 13.");
    EXPECT_NE(alike->plan.text.find("Room 12: not labelled on the plan. It leads to: Kitchen."), std::string::npos)
        << alike->plan.text;
    EXPECT_NE(alike->plan.text.find("Room 13: not labelled on the plan. It leads to: Kitchen."), std::string::npos);
    both.portals.clear();
    both.gaps.clear();
    for (StoreyRoom& room : both.rooms) room.shut = true;
    const Result<SwellSheet> shut = sheet_of(both, 72.0);
    ASSERT_TRUE(shut);
    EXPECT_NE(shut->plan.text.find("Room 12: not labelled on the plan. No route leads there."), std::string::npos)
        << shut->plan.text;
}

TEST(SwellSheets, repeat_at_a_larger_scale_what_is_too_small_for_its_sign) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for our house";
    // Two closets of 1.5 by 1.5 m are inside a room. For all other rooms, one scale is enough.
    Storey storey = many_rooms(8, 10);
    for (std::size_t i = 0; i < storey.rooms.size(); ++i)
        storey.rooms[i].name = {static_cast<char>('A' + i / 10), static_cast<char>('a' + i % 10)};
    const auto closet = [&](const std::string& name, double x, double y) {
        StoreyRoom room;
        room.room = static_cast<std::uint32_t>(storey.rooms.size());
        room.name = name;
        room.min_m = {x, y};
        room.max_m = {x + 1.0, y + 1.0};
        room.middle_m = room.min_m + Vec2(0.5);
        room.area_m2 = 1.0;
        room.loops_m = {{room.min_m, {x + 1.0, y}, room.max_m, {x, y + 1.0}}};
        storey.rooms.push_back(std::move(room));
        // Cuts the closet out of the room around it.
        storey.rooms[0].loops_m.push_back(
            {{x - 0.3, y - 0.3}, {x - 0.3, y + 1.3}, {x + 1.3, y + 1.3}, {x + 1.3, y - 0.3}});
    };
    closet("Closet one", 0.35, 0.35);
    closet("Closet two", 0.35, 1.9);
    for (const double y : {1.5, 1.75})
        storey.walls_m.push_back({{0.0, y - 0.05}, {1.5, y - 0.05}, {1.5, y + 0.05}, {0.0, y + 0.05}});
    storey.walls_m.push_back({{1.5, 0.0}, {1.6, 0.0}, {1.6, 1.55}, {1.5, 1.55}});
    storey.walls_m.push_back({{1.5, 1.7}, {1.6, 1.7}, {1.6, 3.0}, {1.5, 3.0}});
    lay_floor(storey);
    storey.portals.push_back({PassageKind::Door, {0, 80}, {1.55, 0.75}, 0.8});
    storey.portals.push_back({PassageKind::Door, {0, 81}, {1.55, 2.3}, 0.8});
    storey.gaps.push_back({PassageKind::Door, "Door", {1.55, 0.75}, {0.0, 1.0}, 0.8});
    storey.gaps.push_back({PassageKind::Door, "Door", {1.55, 2.3}, {0.0, 1.0}, 0.8});
    const Result<std::vector<SwellSheet>> sheets = swell_sheets(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheets);
    ASSERT_TRUE(sheets->size() >= 2U && sheets->size() <= 5U) << sheets->size();
    const SwellSheet& larger = sheets->back();
    EXPECT_TRUE(larger.part->larger);
    EXPECT_LT(larger.one_to, sheets->front().one_to);
    EXPECT_NE(larger.plan.text.find("This sheet shows part of the storey at a larger scale"), std::string::npos);
    std::string keys;
    std::array<int, 2> signs{};
    for (const SwellSheet& sheet : *sheets) {
        EXPECT_TRUE(sheet.broken.empty()) << sheet.broken[0];
        keys += sheet.plan.text;
        for (const std::size_t closet_number : {std::size_t{0}, std::size_t{1}})
            if (sheet.signs[80 + closet_number].on_sheet) {
                EXPECT_TRUE(sheet.part->larger);
                ++signs[closet_number];
            }
    }
    EXPECT_TRUE(signs[0] > 0 && signs[1] > 0);
    EXPECT_NE(keys.find("Closet one: its sign is on sheet "), std::string::npos) << keys;
    stand_in_their_rooms(storey, larger, "larger");
}

TEST(LargePlan, comes_out_as_several_sheets_that_keep_their_promises) {
    if (!std::getenv("HANDRAIL_ALL_ROUTES")) GTEST_SKIP() << "takes minutes; HANDRAIL_ALL_ROUTES=1 tries it";
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for one sheet of our house, over many pixels";
    const NamedStoreys* world = storeys_of("apb-tu-dresden.osm");
    if (!world) GTEST_SKIP() << needs_real_world("apb-tu-dresden.osm");
    ASSERT_GE(world->storeys.size(), 2U);
    const Result<std::vector<SwellSheet>> sheets = swell_sheets(world->storeys[1], {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheets) << sheets.error().sentence();
    EXPECT_GT(sheets->size(), 5U);
    for (const SwellSheet& sheet : *sheets)
        EXPECT_THAT(sheet.broken, testing::IsEmpty()) << "sheet " << sheet.part->number;
}

TEST(SwellSheet, makes_doors_wide_enough_for_a_finger_and_reports_it) {
    Storey storey = two_rooms();
    storey.max_m = {80.0, 40.0};  // makes the scale 1 to 300, at which the door is 3.3 mm wide
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    const Ink ink = ink_of(sheet->plan);
    const OnPaper& on_sheet = sheet->on_paper;
    const Vec2 door = on_sheet({6.1, 2.0});
    for (const double off : {-3.0, -1.5, 0.0, 1.5, 3.0}) EXPECT_FALSE(black_at(ink, door + Vec2(0.0, off))) << off;
    ASSERT_FALSE(sheet->simplified.empty());
    bool reported = false;
    for (const std::string& sentence : sheet->simplified)
        reported |= sentence == "One door is drawn wider, at 6.4 millimetres.";
    EXPECT_TRUE(reported);
}

TEST(SwellSheet, names_things_that_are_omitted_for_lack_of_space) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the sheet of our house";
    Storey storey = two_rooms();
    storey.things.push_back({FeatureId{2}, "Cup", {{3.0, 1.0}, {1.0, 0.0}, {0.04, 0.04}}, false});
    storey.things.push_back({FeatureId{3}, "Fountain", {{3.0, 3.0}, {1.0, 0.0}, {0.04, 0.04}}, true});
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    ASSERT_EQ(sheet->simplified.size(), 1U);
    EXPECT_EQ(sheet->simplified[0], "Left out for lack of space: Cup.");
    EXPECT_EQ(sheet->drawn, (std::vector<std::string>{"Table", "Fountain"})) << "a landmark becomes a symbol";
    is_fit_for_fingers(storey, *sheet, "with things");
}

// Earlier, the sheet drew a wall through its title. The wall belonged to another part of the building, far beyond the
// rooms of the storey.
TEST(SwellSheet, draws_no_wall_through_its_title_or_its_footer) {
    Storey storey = two_rooms();
    storey.walls_m.push_back({{3.0, -40.0}, {3.2, -40.0}, {3.2, 60.0}, {3.0, 60.0}});
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    for (const SheetShape& shape : sheet->plan.shapes) {
        if (shape.part != kWallPart) continue;
        for (const std::vector<Vec2>& loop : shape.loops_mm)
            for (const Vec2& at : loop) {
                EXPECT_LE(at.y, sheet->plan.height_mm - kSheetMargin_mm - kSheetHead_mm + 0.2);
                EXPECT_GE(at.y, kSheetMargin_mm + kSheetFoot_mm - 0.2);
            }
    }
}

TEST(SwellSheet, refuses_in_one_sentence_a_storey_larger_than_a_sheet) {
    Storey storey = two_rooms();
    storey.max_m = {2000.0, 40.0};
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA3, BrailleTable::EnUebG1});
    ASSERT_FALSE(sheet);
    EXPECT_EQ(sheet.error().message, "This storey is 2,000.5 by 40.5 metres, which is too large for one sheet.");
}

TEST(RoomSigns, have_two_letters_each_and_are_unique) {
    Storey storey = two_rooms();
    storey.rooms.resize(1);
    for (const std::string name : {"Kiosk", "Kino", "Room 1", "Room 2", "Room 1", "K", "", "Übung", "12"}) {
        storey.rooms.push_back(storey.rooms[0]);
        storey.rooms.back().name = name;
    }
    std::set<std::string> signs;
    for (const RoomSign& sign : room_signs(storey)) {
        EXPECT_TRUE(signs.insert(sign.sign).second) << sign.sign;
        EXPECT_TRUE(std::regex_match(sign.sign, std::regex("[a-z][a-z]|[a-z]?[0-9]+"))) << sign.sign;
    }
    EXPECT_TRUE(signs.contains("r1") && signs.contains("r2") && signs.contains("ki") && signs.contains("ko"));
    EXPECT_TRUE(signs.contains("12"));
}

TEST(RoomSigns, use_a_number_only_if_the_name_has_just_one_and_never_run_out) {
    Storey storey = two_rooms();
    storey.rooms.resize(1);
    for (int i = 0; i < 900; ++i) {
        storey.rooms.push_back(storey.rooms[0]);
        storey.rooms.back().name = "Cellar " + std::to_string(i % 30 + 1) + "-" + std::to_string(i / 30 + 1);
    }
    std::set<std::string> signs;
    for (const RoomSign& sign : room_signs(storey)) {
        EXPECT_TRUE(signs.insert(sign.sign).second) << sign.sign;
        EXPECT_TRUE(std::regex_match(sign.sign, std::regex("[a-z]{2,3}"))) << sign.sign << " for " << sign.name;
    }
}

TEST(RoomSigns, do_not_contain_the_number_of_the_storey) {
    Storey storey = two_rooms();
    storey.number = 4;
    storey.name = "Level 3";
    storey.rooms[0].name = "hall, west, storey 4";
    storey.rooms[1].name = "Stairs, Level 3";
    const std::vector<RoomSign> signs = room_signs(storey);
    EXPECT_EQ(signs[0].sign, "ha");
    EXPECT_EQ(signs[1].sign, "st");
}

TEST(SwellSheet, gives_two_letters_to_a_room_whose_number_does_not_fit) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for our house";
    Storey storey = many_rooms(8, 10);
    for (std::size_t i = 0; i < storey.rooms.size(); ++i) storey.rooms[i].name = "Office " + std::to_string(101 + i);
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    for (const RoomSign& sign : sheet->signs) {
        EXPECT_TRUE(sign.on_sheet) << sign.name;
        EXPECT_TRUE(std::regex_match(sign.sign, std::regex("[a-z]{2}"))) << sign.sign << " for " << sign.name;
    }
    is_fit_for_fingers(storey, *sheet, "offices");
}

bool says(const SwellSheet& sheet, const std::string& text) { return sheet.plan.text.find(text) != std::string::npos; }

TEST(SwellSheet, draws_stairs_between_narrow_walls_from_wall_to_wall) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for our house";
    // This storey is drawn at 1 to 350, so the 3 m between the walls are 8.6 mm. Lines that keep a distance from both
    // walls would be too short.
    Storey storey = two_rooms();
    storey.rooms[1].kind = RoomKind::Stairs;
    storey.max_m = {90.0, 30.0};
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet && sheet->one_to == 350.0);
    EXPECT_TRUE(says(*sheet, "Room 12: drawn in thin lines, not labelled.")) << sheet->plan.text;
    EXPECT_TRUE(says(*sheet, "Thin parallel lines are stairs."));
    const Ink ink = ink_of(sheet->plan);
    int lines = 0;
    for (double y = 0.1; y < 3.9; y += 0.02)
        lines += black_at(ink, sheet->on_paper({7.7, y})) && !black_at(ink, sheet->on_paper({7.7, y - 0.02})) ? 1 : 0;
    EXPECT_GE(lines, 2);
    is_fit_for_fingers(storey, *sheet, "narrow stairs");
}

TEST(SwellSheet, keeps_stairs_that_reach_into_a_wall_away_from_what_is_at_their_other_end) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for our house";
    // The east side has no wall. A piece of wall ends next to it, between two lines of the stairs.
    Storey storey = two_rooms();
    storey.rooms[1].kind = RoomKind::Stairs;
    for (Vec2& p : storey.walls_m[3]) p.x += 6.0;
    for (const std::size_t long_wall : {std::size_t{0}, std::size_t{1}})
        for (Vec2& p : storey.walls_m[long_wall])
            if (p.x > 9.0) p.x += 6.0;
    storey.max_m = {90.0, 30.0};
    int with_lines = 0;
    for (const double y : {0.9, 1.3, 1.7, 2.1, 2.5}) {
        storey.walls_m.resize(6);
        storey.walls_m.push_back({{9.4, y}, {9.6, y}, {9.6, 4.0}, {9.4, 4.0}});
        const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
        ASSERT_TRUE(sheet && sheet->one_to == 350.0);
        EXPECT_TRUE(check_gaps(sheet->plan, kLeastGap_mm).narrow_mm.empty()) << y;
        with_lines += says(*sheet, "Thin parallel lines are stairs.") ? 1 : 0;
    }
    EXPECT_GT(with_lines, 0);
}

TEST(SwellSheet, of_several_joins_no_rooms_by_ending_in_a_third) {
    // Kitchen and Room 12 both lead to the south end of a hall. The floor of the hall is on another sheet.
    Storey storey = two_rooms();
    storey.things.clear();
    storey.gaps.clear();
    storey.base.reset();
    storey.max_m = {6.7, 8.7};
    const auto box = [](double x0, double y0, double x1, double y1) {
        return std::vector<Vec2>{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    };
    storey.walls_m = {box(-0.2, -0.2, 6.4, 0.0), box(-0.2, 8.0, 6.4, 8.2), box(-0.2, 0.0, 0.0, 8.0),
                      box(6.2, 0.0, 6.4, 8.0),   box(2.0, 0.0, 4.2, 2.0),  box(0.0, 3.2, 2.2, 3.4),
                      box(4.0, 3.2, 6.2, 3.4)};
    storey.rooms[0].loops_m = {box(0.25, 0.25, 1.75, 2.95)};
    storey.rooms[1].loops_m = {box(4.45, 0.25, 5.95, 2.95)};
    storey.rooms.push_back(storey.rooms[0]);
    storey.rooms[2].name = "Hall";
    storey.rooms[2].loops_m = {box(0.25, 3.65, 5.95, 7.75)};
    for (StoreyRoom& room : storey.rooms) {
        room.min_m = room.loops_m[0][0];
        room.max_m = room.loops_m[0][2];
        room.middle_m = 0.5 * (room.min_m + room.max_m);
    }
    storey.portals = {{PassageKind::Opening, {0, 2}, {2.1, 2.6}, 1.0}, {PassageKind::Opening, {1, 2}, {4.1, 2.6}, 1.0}};
    lay_floor(storey);
    SheetPart part;
    part.min_m = storey.min_m;
    part.max_m = {6.7, 3.2};
    part.one_to = 50.0;
    std::vector<std::string> letters;
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1}, part, letters);
    ASSERT_TRUE(sheet);
    EXPECT_THAT(sheet->broken, testing::IsEmpty());
}

TEST(SwellSheet, of_several_has_no_specks_of_walls_at_its_rim) {
    Storey storey = two_rooms();
    storey.things.clear();
    storey.base.reset();
    SheetPart part;
    part.min_m = storey.min_m;
    part.max_m = {9.7, 2.0};
    part.one_to = 50.0;
    // Walls of another part of the building reach 3 mm into the sheet. At the corner of two of them, a finger would not
    // fit in between.
    storey.walls_m.push_back({{1.0, 1.85}, {2.0, 1.85}, {2.0, 3.0}, {1.0, 3.0}});
    storey.walls_m.push_back({{3.5, 1.82}, {5.43, 2.34}, {5.41, 2.41}, {3.48, 1.89}});
    storey.walls_m.push_back({{3.5, 1.82}, {3.24, 2.79}, {3.31, 2.81}, {3.57, 1.84}});
    std::vector<std::string> letters;
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1}, part, letters);
    ASSERT_TRUE(sheet);
    EXPECT_THAT(sheet->broken, testing::IsEmpty());
    const Ink ink = ink_of(sheet->plan);
    EXPECT_FALSE(black_at(ink, sheet->on_paper({1.5, 1.92})));
    EXPECT_FALSE(black_at(ink, sheet->on_paper({3.55, 1.87})));
}

TEST(SwellSheet, states_which_stairs_have_no_lines) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the sheet of our house";
    Storey storey = two_rooms();
    storey.stairs_of_others.push_back({0, {{{1.0, 1.0}, {2.0, 1.0}, {2.0, 3.0}, {1.0, 3.0}}}});
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_TRUE(says(*sheet, "Stairs without lines, for lack of space: Kitchen.")) << sheet->plan.text;
}

TEST(SwellSheet, draws_no_wall_in_the_well_of_stairs_that_two_rooms_lead_to) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the sheet of our house";
    // North of both rooms, instead of their wall, is one wide flight down to another storey.
    Storey storey = two_rooms();
    const auto box = [](double x0, double y0, double x1, double y1) {
        return PlanOutline{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    };
    storey.things.clear();
    storey.base.reset();
    storey.walls_m[1] = box(-0.2, 14.0, 9.4, 14.2);
    for (const std::size_t side : {std::size_t{2}, std::size_t{3}})
        for (Vec2& p : storey.walls_m[side]) p.y = p.y > 0.0 ? 14.0 : p.y;
    storey.max_m.y = 14.7;
    lay_floor(storey);
    storey.stairs_of_others.push_back({1, {box(0.25, 3.75, 8.95, 13.75)}});
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet) << sheet.error().sentence();
    EXPECT_FALSE(says(*sheet, "Drawn closed")) << sheet->plan.text;
    EXPECT_FALSE(says(*sheet, "Stairs without lines")) << sheet->plan.text;
    const Ink ink = ink_of(sheet->plan);
    for (const double x : {1.0, 6.1, 8.0}) {
        double black_m = 0.0;
        for (double y = 4.5; y < 13.5; y += 0.01) black_m += black_at(ink, sheet->on_paper({x, y})) ? 0.01 : 0.0;
        EXPECT_GT(black_m, 0.1) << "no lines of stairs at " << x;
        EXPECT_LT(black_m, 4.5) << "a wall along the stairs at " << x;
    }
}

TEST(SwellSheet, states_where_it_leads_to_other_storeys) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the sheet of our house";
    Storey storey = two_rooms();
    storey.exits.push_back({PassageKind::Opening, 0, "Cellar", {1.0, 1.0}});
    storey.exits.push_back({PassageKind::Lift, 1, "Attic", {8.0, 1.0}});
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_TRUE(says(*sheet, "Routes to other storeys: from Kitchen to Cellar; from Room 12 to Attic by lift."))
        << sheet->plan.text;
}

TEST(SwellSheet, states_between_which_rooms_it_is_drawn_closed) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the sheet of our house";
    Storey storey = two_rooms();
    storey.portals.clear();
    storey.gaps.clear();
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_TRUE(says(*sheet, "Drawn closed, because nobody can walk through, between: Kitchen and Room 12."))
        << sheet->plan.text;
}

TEST(SwellSheet, states_which_floors_end_without_a_wall) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the sheet of our house";
    Storey storey = two_rooms();
    storey.walls_m.erase(storey.walls_m.begin() + 1);  // removes the north wall
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    EXPECT_TRUE(says(*sheet, "Floors that end without a wall, but have no lines there: Kitchen; Room 12."))
        << sheet->plan.text;
    const Result<SwellSheet> walled = swell_sheet(two_rooms(), {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(walled);
    EXPECT_FALSE(says(*walled, "without a wall")) << walled->plan.text;
}

TEST(SwellSheet, explains_signs_that_differ_on_the_matching_plate) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the same code as for the sheet of our house";
    Storey storey = two_rooms();
    storey.max_m = {57.0, 30.0};
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1, false, {"ki", "r12"}});
    ASSERT_TRUE(sheet);
    EXPECT_TRUE(says(*sheet, "ki  Kitchen.\n")) << sheet->plan.text;
    EXPECT_NE(sheet->signs[1].sign, "r12");
    EXPECT_TRUE(says(*sheet, "Room 12. On the plate: r12.\n")) << sheet->plan.text;
}

TEST(SwellSheet, is_german_in_a_german_session) {
    const InLanguage german("de");
    const Result<SwellSheet> sheet = swell_sheet(two_rooms(), {kA4, BrailleTable::DeG2});
    ASSERT_TRUE(sheet);
    EXPECT_EQ(sheet->plan.title, "Test, Stockwerk 1 von 1");
}

TEST(CalibrationStrip, has_samples_of_every_size_with_their_numbers) {
    const Result<SheetPage> strip = calibration_strip(kA4, BrailleTable::EnUebG1);
    ASSERT_TRUE(strip) << strip.error().sentence();
    std::set<double> radii;
    for (const SheetDot& dot : strip->dots) {
        radii.insert(dot.radius_mm);
        EXPECT_TRUE(dot.at_mm.x > 5.0 && dot.at_mm.y > 5.0 && dot.at_mm.x < 205.0 && dot.at_mm.y < 292.0);
    }
    EXPECT_EQ(radii, (std::set<double>{0.6, 0.7, 0.75, 0.8, 0.9}));
    EXPECT_EQ(strip->shapes.size(), 4U + 10U);
    EXPECT_NEAR(check_gaps(*strip, 1.5).least_mm, 2.0, 0.15) << "the narrowest sample, and nothing beside it";
}

// ---- files ----

// Checks that tags open and close in order, attributes have quotation marks, and every ampersand is escaped.
void is_xml(const std::string& text) {
    static const std::regex kTag(R"re(<(\?xml[^>]*\?|/?[a-zA-Z]+((\s+[a-zA-Z:_-]+="[^"<]*")*)\s*/?)>)re");
    std::vector<std::string> open;
    std::size_t at = 0;
    while ((at = text.find('<', at)) != std::string::npos) {
        const std::size_t end = text.find('>', at);
        ASSERT_NE(end, std::string::npos);
        const std::string tag = text.substr(at, end - at + 1);
        ASSERT_LT(tag.size(), 1'000'000U);
        if (tag.size() < 5000) {
            ASSERT_TRUE(std::regex_match(tag, kTag)) << tag;
        }
        if (tag[1] == '/') {
            ASSERT_FALSE(open.empty());
            EXPECT_EQ("/" + open.back(), tag.substr(1, tag.size() - 2));
            open.pop_back();
        } else if (tag[1] != '?' && tag[tag.size() - 2] != '/') {
            open.push_back(tag.substr(1, tag.find_first_of(" >") - 1));
        }
        at = end + 1;
    }
    EXPECT_TRUE(open.empty());
    for (std::size_t i = 0; (i = text.find('&', i)) != std::string::npos; ++i) EXPECT_LT(text.find(';', i) - i, 7U);
}

TEST(SvgOfSheet, is_well_formed_for_any_world_name_and_has_its_size_in_millimetres) {
    Storey storey = two_rooms();
    storey.world = "<b> & \"co\" \x01";
    const Result<SwellSheet> sheet = swell_sheet(storey, {kA4, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    const std::string svg = svg_of(sheet->plan, "en");
    is_xml(svg);
    EXPECT_NE(svg.find("width=\"297.000mm\" height=\"210.000mm\" viewBox=\"0 0 297.000 210.000\""), std::string::npos);
    EXPECT_NE(svg.find("&lt;b&gt; &amp; &quot;co&quot;"), std::string::npos);
    EXPECT_EQ(svg.find("<text"), std::string::npos) << "no font is asked for";
}

TEST(PdfOfSheet, contains_every_page_and_a_table_that_points_at_its_objects) {
    const Result<SwellSheet> sheet = swell_sheet(two_rooms(), {kA3, BrailleTable::EnUebG1});
    ASSERT_TRUE(sheet);
    std::vector<SheetPage> pages{sheet->plan};
    pages.insert(pages.end(), sheet->key.begin(), sheet->key.end());
    const std::string pdf = pdf_of(pages, "en");
    EXPECT_EQ(pdf.substr(0, 8), "%PDF-1.7");
    EXPECT_NE(pdf.find("/Count " + std::to_string(pages.size())), std::string::npos);
    EXPECT_NE(pdf.find("/MediaBox[0 0 1190.551 841.890]"), std::string::npos) << "A3 across, in points";
    const std::size_t start = pdf.rfind("startxref\n") + 10;
    const std::size_t table = std::stoul(pdf.substr(start));
    ASSERT_EQ(pdf.substr(table, 5), "xref\n");
    std::size_t line = pdf.find('\n', table + 5) + 1 + 20;  // skips the first entry of the table, which is the free one
    int objects = 0;
    while (pdf.compare(line, 7, "trailer") != 0) {
        const std::size_t place = std::stoul(pdf.substr(line, 10));
        const std::string head = std::to_string(++objects) + " 0 obj";
        EXPECT_EQ(pdf.substr(place, head.size()), head);
        line += 20;
    }
    EXPECT_EQ(objects, 3 + 2 * static_cast<int>(pages.size()));
    // Each stream must have the length that it states.
    static const std::regex kLength("/Length ([0-9]+)>>stream\n");
    for (auto it = std::sregex_iterator(pdf.begin(), pdf.end(), kLength); it != std::sregex_iterator(); ++it) {
        const auto from = static_cast<std::size_t>(it->position() + it->length());
        EXPECT_EQ(pdf.compare(from + std::stoul((*it)[1]), 9, "endstream"), 0);
    }
}

}  // namespace swell_sheet_test
}  // namespace handrail::test
