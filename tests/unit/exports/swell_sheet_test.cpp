// Sheets for swell paper of every storey that we have: nothing nearer than a finger parts, nothing lost in silence.
#include "worlds/exports/swell_sheet.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "tests/support/scale.h"
#include "tests/support/spoken_language.h"
#include "tests/unit/exports/plans.h"
#include "worlds/exports/ink.h"

namespace handrail::test {
namespace swell_sheet_test {

// Where a place of the world lies on the sheet, from two corners of what is shown.
struct OnSheet {
    const Storey& storey;
    const SwellSheet& sheet;
    Vec2 operator()(const Vec2& world_m) const {
        // Header and footer are not alike, so the middle of the map is not that of the page.
        const Vec2 size = (storey.max_m - storey.min_m) * (1000.0 / sheet.one_to);
        const Vec2 room(sheet.plan.width_mm - 24.0, sheet.plan.height_mm - 24.0 - 26.0);
        return Vec2(12.0, 24.0) + 0.5 * (room - size) + (world_m - storey.min_m) * (1000.0 / sheet.one_to);
    }
};

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
    const OnSheet on_sheet{storey, sheet};
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
    if (test::kSanitizerScale < 1.0 && file != "house.map") GTEST_SKIP() << "the same code as for our house";
    const NamedStoreys* world = storeys_of(file);
    if (!world) GTEST_SKIP() << needs_real_world(file);
    ASSERT_FALSE(world->storeys.empty());
    for (const Storey& storey : world->storeys) {
        if (storey.number > last) break;
        if (&storey != &world->storeys.front() && !test::tried(1, 2)) break;
        const Result<SwellSheet> sheet = swell_sheet(storey, paper, table);
        ASSERT_TRUE(sheet) << sheet.error().sentence();
        is_fit_for_fingers(storey, *sheet, file + " " + std::to_string(storey.number));
    }
}

TEST(SwellSheet, of_every_storey_of_our_house_parts_what_fingers_part) {
    all_storeys_are_fit("house.map", kA4, BrailleTable::EnUebG1);
    all_storeys_are_fit("house.map", kA3, BrailleTable::DeG2, 1);
}
TEST(SwellSheet, of_an_architects_house_of_ours_parts_what_fingers_part) {
    all_storeys_are_fit("small_house.ifc", kA4, BrailleTable::DeG1);
}
TEST(SwellSheet, of_every_storey_of_our_school_parts_what_fingers_part) {
    all_storeys_are_fit("school.map", kA4, BrailleTable::EnUebG2);
}
TEST(SwellSheet, of_a_game_map_parts_what_fingers_part) {
    all_storeys_are_fit("agdm01.map", kA4, BrailleTable::EnUebG1);
}
TEST(SwellSheet, of_every_storey_of_a_real_building_parts_what_fingers_part) {
    all_storeys_are_fit("duplex-apartment.ifc", kA4, BrailleTable::DeG1);
}

TEST(SwellSheet, of_two_rooms_has_their_signs_the_table_and_an_open_door) {
    const Storey storey = two_rooms();
    const Result<SwellSheet> sheet = swell_sheet(storey, kA4, BrailleTable::EnUebG1);
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
    // Of the door 25 mm are free.
    const Ink ink = ink_of(sheet->plan);
    const OnSheet on_sheet{storey, *sheet};
    EXPECT_TRUE(black_at(ink, on_sheet({6.1, 1.4})));
    for (const double y : {1.55, 2.0, 2.45}) EXPECT_FALSE(black_at(ink, on_sheet({6.1, y})));
}

TEST(SwellSheet, makes_doors_wide_enough_for_a_finger_and_tells) {
    Storey storey = two_rooms();
    storey.max_m = {80.0, 40.0};  // at 1 to 300 the door is 3.3 mm
    const Result<SwellSheet> sheet = swell_sheet(storey, kA4, BrailleTable::EnUebG1);
    ASSERT_TRUE(sheet);
    const Ink ink = ink_of(sheet->plan);
    const OnSheet on_sheet{storey, *sheet};
    const Vec2 door = on_sheet({6.1, 2.0});
    for (const double off : {-3.0, -1.5, 0.0, 1.5, 3.0}) EXPECT_FALSE(black_at(ink, door + Vec2(0.0, off))) << off;
    ASSERT_FALSE(sheet->simplified.empty());
    bool told = false;
    for (const std::string& sentence : sheet->simplified)
        told |= sentence == "One door is drawn wider, 6.4 millimetres.";
    EXPECT_TRUE(told);
}

TEST(SwellSheet, leaves_out_what_has_no_room_by_name) {
    Storey storey = two_rooms();
    storey.things.push_back({FeatureId{2}, "Cup", {{3.0, 1.0}, {1.0, 0.0}, {0.04, 0.04}}, false});
    storey.things.push_back({FeatureId{3}, "Fountain", {{3.0, 3.0}, {1.0, 0.0}, {0.04, 0.04}}, true});
    const Result<SwellSheet> sheet = swell_sheet(storey, kA4, BrailleTable::EnUebG1);
    ASSERT_TRUE(sheet);
    ASSERT_EQ(sheet->simplified.size(), 1U);
    EXPECT_EQ(sheet->simplified[0], "Left out for lack of room: Cup.");
    EXPECT_EQ(sheet->drawn, (std::vector<std::string>{"Table", "Fountain"})) << "a landmark becomes a symbol";
    is_fit_for_fingers(storey, *sheet, "with things");
}

TEST(SwellSheet, refuses_in_a_sentence_what_is_larger_than_a_sheet) {
    Storey storey = two_rooms();
    storey.max_m = {2000.0, 40.0};
    const Result<SwellSheet> sheet = swell_sheet(storey, kA3, BrailleTable::EnUebG1);
    ASSERT_FALSE(sheet);
    EXPECT_EQ(sheet.error().message, "This storey is 2,000.5 by 40.5 metres, too large for one sheet.");
}

TEST(RoomSigns, are_two_letters_each_and_never_alike) {
    Storey storey = two_rooms();
    storey.rooms.resize(1);
    for (const std::string name : {"Kiosk", "Kino", "Room 1", "Room 2", "Room 1", "K", "", "Übung", "12"}) {
        storey.rooms.push_back(storey.rooms[0]);
        storey.rooms.back().name = name;
    }
    std::set<std::string> signs;
    for (const RoomSign& sign : room_signs(storey)) {
        EXPECT_TRUE(signs.insert(sign.sign).second) << sign.sign;
        EXPECT_TRUE(std::regex_match(sign.sign, std::regex("[a-z]([a-z]|[0-9]+)"))) << sign.sign;
    }
    EXPECT_TRUE(signs.contains("r1") && signs.contains("r2") && signs.contains("ki") && signs.contains("ko"));
}

TEST(SwellSheet, speaks_german_where_that_is_spoken) {
    const InLanguage german("de");
    const Result<SwellSheet> sheet = swell_sheet(two_rooms(), kA4, BrailleTable::DeG2);
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

// --- files

// Tags open and close in order, attributes are quoted, no stray ampersand.
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

TEST(SvgOfSheet, is_well_formed_whatever_a_world_is_called_and_has_its_size_in_millimetres) {
    Storey storey = two_rooms();
    storey.world = "<b> & \"co\" \x01";
    const Result<SwellSheet> sheet = swell_sheet(storey, kA4, BrailleTable::EnUebG1);
    ASSERT_TRUE(sheet);
    const std::string svg = svg_of(sheet->plan, "en");
    is_xml(svg);
    EXPECT_NE(svg.find("width=\"297.000mm\" height=\"210.000mm\" viewBox=\"0 0 297.000 210.000\""), std::string::npos);
    EXPECT_NE(svg.find("&lt;b&gt; &amp; &quot;co&quot;"), std::string::npos);
    EXPECT_EQ(svg.find("<text"), std::string::npos) << "no font is asked for";
}

TEST(PdfOfSheet, has_every_page_and_its_table_points_at_its_objects) {
    const Result<SwellSheet> sheet = swell_sheet(two_rooms(), kA3, BrailleTable::EnUebG1);
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
    std::size_t line = pdf.find('\n', table + 5) + 1 + 20;  // after the first, which is free
    int objects = 0;
    while (pdf.compare(line, 7, "trailer") != 0) {
        const std::size_t place = std::stoul(pdf.substr(line, 10));
        const std::string head = std::to_string(++objects) + " 0 obj";
        EXPECT_EQ(pdf.substr(place, head.size()), head);
        line += 20;
    }
    EXPECT_EQ(objects, 3 + 2 * static_cast<int>(pages.size()));
    // Each stream is as long as it says.
    static const std::regex kLength("/Length ([0-9]+)>>stream\n");
    for (auto it = std::sregex_iterator(pdf.begin(), pdf.end(), kLength); it != std::sregex_iterator(); ++it) {
        const auto from = static_cast<std::size_t>(it->position() + it->length());
        EXPECT_EQ(pdf.compare(from + std::stoul((*it)[1]), 9, "endstream"), 0);
    }
}

}  // namespace swell_sheet_test
}  // namespace handrail::test
