// Tests each kind of part that the reader once lost, left uncut or put in the wrong place.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <optional>
#include <random>

#include "tests/support/names.h"
#include "tests/unit/ifc/ifc_hut.h"
#include "worlds/base/language.h"
#include "worlds/check/faults.h"
#include "worlds/ifc/body.h"
#include "worlds/ifc/step_file.h"
#include "worlds/navigation/reach.h"
#include "worlds/navigation/rooms.h"
#include "worlds/scene/honest_report.h"

namespace handrail {
namespace parts_test {

using test::Hut;
using test::in_a_solid;
using test::volume_within_m3;

constexpr Aabb kWall{{0.0, 0.0, 0.0}, {6.0, 0.3, 2.5}};

TEST(PartsOfIfc, survive_any_number_of_nested_cuts) {
    for (const int cuts : {1, 24, 25, 400}) {
        SCOPED_TRACE(cuts);
        Hut hut;
        int wall = hut.block(kWall.min_m, kWall.max_m);
        for (int i = 0; i < cuts; ++i) {
            const double at = 0.01 + 0.01 * (i % 30);
            wall = hut.less(wall, hut.block({at, -1.0, 1.0}, {at + 0.005, 1.0, 1.1}));
        }
        hut.part("IFCWALL", "North", wall, ",$");
        const Scene scene = hut.scene();
        EXPECT_NEAR(volume_within_m3(scene, kWall), 4.5 - std::min(cuts, 30) * 0.005 * 0.3 * 0.1, 1e-4);
    }
}

TEST(PartsOfIfc, survive_deeply_nested_cutting_solids) {
    Hut hut;
    int cutter = hut.block({1.0, -1.0, 0.0}, {2.0, 1.0, 2.0});
    // An even number of cutters, each cut by the one before: the last one leaves what the first one removes.
    for (int i = 0; i < 60; ++i) cutter = hut.less(hut.block({1.0, -1.0, 0.0}, {2.0, 1.0, 2.0}), cutter);
    hut.part("IFCWALL", "North", hut.less(hut.block(kWall.min_m, kWall.max_m), cutter), ",$");
    EXPECT_NEAR(volume_within_m3(hut.scene(), kWall), 4.5 - 0.3 * 2.0, 1e-4);
}

// A partition is named after its two sides, whether the wall in front of it is a solid or a sheet. The partition's
// front is the outer side of the building only if that wall is missing.
TEST(PartsOfIfc, behind_a_sheet_get_the_same_names_as_behind_a_solid_wall) {
    enum class Before { Nothing, Solid, Sheet };
    for (const Before before : {Before::Nothing, Before::Solid, Before::Sheet}) {
        SCOPED_TRACE(static_cast<int>(before));
        Hut hut;
        hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {8.0, 8.2, 0.0}), ",$");
        hut.part("IFCWALL", "North", hut.block({0.0, 8.0, 0.0}, {8.0, 8.2, 3.0}), ",$");
        hut.part("IFCWALL", "Partition", hut.block({0.0, 4.0, 0.0}, {3.0, 4.2, 3.0}), ",$");
        if (before == Before::Solid) hut.part("IFCWALL", "South", hut.block({0.0, 0.0, 0.0}, {3.0, 0.1, 3.0}), ",$");
        if (before == Before::Sheet)
            hut.part("IFCWALL", "South",
                     hut.sheet({{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {3.0, 0.0, 3.0}, {0.0, 0.0, 3.0}}}), ",$");
        const Scene scene = hut.scene();
        std::string front;
        for (const SurfacePolygon& surface : scene.surfaces)
            if (surface.normal.y < -0.99 && std::abs(surface.polygon.points_m.front().y - 4.0) < 1e-6)
                front = spoken_name(scene.features[surface.feature.value]);
        EXPECT_EQ(front, before == Before::Nothing ? "south wall" : "north wall");
    }
}

TEST(PartsOfIfc, are_reported_if_a_cut_refers_to_itself) {
    Hut hut;
    hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {6.0, 6.0, 0.0}), ",$");
    const int tool = hut.block({1.0, -1.0, 0.0}, {2.0, 1.0, 2.0});
    hut.part("IFCWALL", "North", hut.less(tool + 1, tool), ",$");
    const Scene scene = hut.scene();
    EXPECT_THAT(scene.report.left_out, testing::Contains(testing::HasSubstr("IFCBOOLEANRESULT")));
}

TEST(PartsOfIfc, can_be_cut_by_non_convex_shells) {
    const Ring rebated{{1.5, -0.3}, {1.5, 0.1}, {1.7, 0.1}, {1.7, 0.6},
                       {2.7, 0.6},  {2.7, 0.1}, {2.9, 0.1}, {2.9, -0.3}};
    Hut by_cut;
    by_cut.part("IFCWALL", "North", by_cut.less(by_cut.block(kWall.min_m, kWall.max_m), by_cut.brep(rebated, 0.0, 2.1)),
                ",$");
    const double right_m3 = 4.5 - 2.1 * (1.4 * 0.1 + 1.0 * 0.2);
    EXPECT_NEAR(volume_within_m3(by_cut.scene(), kWall), right_m3, 1e-4);
    Hut by_opening;
    const int wall = by_opening.part("IFCWALL", "North", by_opening.block(kWall.min_m, kWall.max_m), ",$");
    by_opening.opening(wall, by_opening.brep(rebated, 0.0, 2.1));
    const Scene scene = by_opening.scene();
    EXPECT_NEAR(volume_within_m3(scene, kWall), right_m3, 0.01);
    EXPECT_TRUE(in_a_solid(scene, {1.6, 0.2, 1.0}));
    EXPECT_FALSE(in_a_solid(scene, {1.6, 0.05, 1.0}));
    EXPECT_FALSE(in_a_solid(scene, {2.2, 0.2, 1.0}));
}

// The cutting solid is a wedge with a step, so it is neither convex nor a prism.
TEST(PartsOfIfc, can_be_cut_by_any_closed_shell) {
    Hut hut;
    const int step = hut.brep({{1.0, -1.0}, {2.0, -1.0}, {2.0, 1.0}, {1.0, 1.0}}, 0.5, 1.0);
    const int tool = hut.less(hut.brep({{1.0, -1.0}, {2.0, -1.0}, {2.0, 1.0}, {1.0, 1.0}}, 0.0, 2.0), step);
    hut.part("IFCWALL", "North", hut.less(hut.block(kWall.min_m, kWall.max_m), tool), ",$");
    EXPECT_NEAR(volume_within_m3(hut.scene(), kWall), 4.5 - 0.3 * 1.5, 1e-4);
}

TEST(PartsOfIfc, keep_the_wall_behind_a_niche_with_any_filling) {
    for (const std::string filling : {"IFCFURNISHINGELEMENT", "IFCBUILDINGELEMENTPROXY", "IFCDOOR", "IFCWINDOW"}) {
        SCOPED_TRACE(filling);
        Hut hut;
        const int wall = hut.part("IFCWALL", "South", hut.block(kWall.min_m, kWall.max_m), ",$");
        const int thing = hut.part(filling, "Cupboard", hut.block({1.1, 0.15, 0.5}, {1.9, 0.3, 1.5}),
                                   filling == "IFCDOOR" || filling == "IFCWINDOW" ? ",1.,1.,$,$,$" : ",$");
        hut.opening(wall, hut.block({1.0, 0.15, 0.4}, {2.0, 0.31, 1.6}), thing);
        const Scene scene = hut.scene();
        // A door in a niche leads nowhere, so the reader must cut a passage through the wall behind it and report that.
        const bool leads_through = filling == "IFCDOOR";
        EXPECT_EQ(in_a_solid(scene, {1.05, 0.1, 1.2}), true);
        EXPECT_EQ(in_a_solid(scene, {1.5, 0.1, 1.2}), !leads_through);
        if (filling != "IFCWINDOW") {
            EXPECT_FALSE(in_a_solid(scene, {1.05, 0.2, 1.2}));  // a window has its pane at this place
        }
    }
}

TEST(PartsOfIfc, are_cut_through_by_windows_that_are_flush_with_their_faces) {
    Hut hut;
    const int wall = hut.part("IFCWALL", "South", hut.block(kWall.min_m, kWall.max_m), ",$");
    const int window = hut.part("IFCWINDOW", "Window", hut.block({1.0, 0.1, 1.0}, {2.0, 0.2, 2.0}), ",1.,1.,$,$,$");
    // The opening ends 5 mm before each face of the wall.
    hut.opening(wall, hut.block({1.0, 0.005, 1.0}, {2.0, 0.295, 2.0}), window);
    EXPECT_FALSE(in_a_solid(hut.scene(), {1.5, 0.002, 1.5}));
}

// Two walls are stored already cut. The opening of the first is where its cut is; the opening of the second is next to
// the wall.
TEST(PartsOfIfc, that_are_stored_already_cut_need_no_cut) {
    for (const bool beside : {false, true}) {
        Hut hut;
        const int wall =
            hut.part("IFCWALL", "Wall",
                     hut.less(hut.block({0, 0, 0}, {5, 0.3, 2.5}), hut.block({2, -0.1, -0.1}, {3, 0.4, 2.1})));
        const double x = beside ? 7.0 : 2.0;
        hut.opening(wall, hut.block({x, 0, 0}, {x + 1.0, 0.3, 2.1}));
        const Scene scene = hut.scene();
        ASSERT_TRUE(scene.stated);
        EXPECT_EQ(scene.stated->openings, 1);
        EXPECT_EQ(scene.stated->openings_cut, beside ? 0 : 1);
        const auto uncut =
            std::count_if(scene.report.warnings.begin(), scene.report.warnings.end(),
                          [](const Diagnostic& warning) { return warning.message == phrase("ifc.opening_uncut"); });
        EXPECT_EQ(uncut, beside ? 1 : 0);
    }
}

TEST(DoorsOfIfc, without_an_opening_are_cut_at_the_size_of_the_leaf) {
    for (const double off : {0.0, 0.1, 0.25}) {  // the door is in the wall, or hung in front of it
        SCOPED_TRACE(off);
        Hut hut;
        hut.part("IFCSLAB", "Floor", hut.block({-3.0, -3.0, -0.2}, {9.0, 5.0, 0.0}), ",$");
        hut.part("IFCWALL", "South", hut.block(kWall.min_m, kWall.max_m), ",$");
        hut.part("IFCDOOR", "Entrance", hut.block({2.5, 0.1 + off, 0.0}, {3.5, 0.2 + off, 2.1}), ",2.1,1.,.DOOR.,$,$");
        const Scene scene = hut.scene();
        for (const double x : {2.52, 3.0, 3.48})
            for (const double z : {0.05, 1.0, 2.05})
                for (const double y : {0.01, 0.29})
                    EXPECT_FALSE(in_a_solid(scene, {x, y, z})) << x << " " << y << " " << z;
        EXPECT_TRUE(in_a_solid(scene, {2.48, 0.15, 1.0}));
        EXPECT_TRUE(in_a_solid(scene, {3.0, 0.15, 2.15}));
        EXPECT_TRUE(in_a_solid(scene, {3.0, 0.15, -0.1}));  // the cut must not remove the floor
        const HonestReport report = honest_report(scene);
        EXPECT_EQ(report.doors_cut_free, 1);
        EXPECT_EQ(report.doors_impassable, 0);
    }
}

TEST(DoorsOfIfc, that_lead_against_a_wall_are_reported_with_that_wall) {
    for (const double behind : {0.1, 0.3, 2.0}) {
        SCOPED_TRACE(behind);
        Hut hut;
        hut.part("IFCSLAB", "Floor", hut.block({-3.0, -3.0, -0.2}, {9.0, 5.0, 0.0}), ",$");
        const int wall = hut.part("IFCWALL", "South", hut.block(kWall.min_m, kWall.max_m), ",$");
        const int door =
            hut.part("IFCDOOR", "Entrance", hut.block({2.5, 0.1, 0.0}, {3.5, 0.2, 2.1}), ",2.1,1.,.DOOR.,$,$");
        hut.opening(wall, hut.block({2.5, 0.0, 0.0}, {3.5, 0.3, 2.1}), door);
        hut.part("IFCWALL", "Lining", hut.block({0.0, 0.3 + behind, 0.0}, {6.0, 0.4 + behind, 2.5}), ",$");
        const Scene scene = hut.scene();
        const HonestReport report = honest_report(scene);
        EXPECT_EQ(report.doors_impassable, behind < 0.5 ? 1 : 0);
        const auto named = [](const Diagnostic& d) { return d.message.find("Lining") != std::string::npos; };
        EXPECT_EQ(std::any_of(scene.report.warnings.begin(), scene.report.warnings.end(), named), behind < 0.5);
    }
}

// The report, the list of things to check, and the warnings must each name the door.
TEST(DoorsOfIfc, too_small_for_a_body_are_named_with_the_reason) {
    struct Row {
        Vec3 least, most;  // opposite corners of the door's box
        std::string reason;
        std::string kind = {}, name = {};  // IFC class and name of another part in the doorway
        Vec3 from = Vec3(0.0), to = Vec3(0.0);
    };
    const Row rows[] = {
        {{2.5, 0.1, 0.0}, {3.5, 0.2, 2.1}, ""},
        {{2.5, 0.1, 0.0}, {2.9, 0.2, 2.1}, "its opening is 0.4 metres wide and 2.1 metres high"},
        {{2.5, 0.1, 0.0}, {3.5, 0.2, 1.2}, "its opening is 1 metre wide and 1.2 metres high"},
        {{2.5, 0.1, 0.0}, {3.5, 0.2, 2.1}, "Rack in the way", "IFCFURNISHINGELEMENT", "Rack", {2, 0.6, 0}, {4, 0.9, 2}},
        {{2.5, 0.1, 0.0},
         {3.5, 0.2, 2.1},
         "there is a step of 0.4 metres",
         "IFCSLAB",
         "Landing",
         {2, 0.3, 0},
         {4, 2, 0.6}},
        {{2.5, 0.1, 2.0}, {3.5, 0.2, 4.1}, "there is no floor on one side of it"},
        {{2.5, 0.1, 0.0}, {2.51, 0.2, 2.1}, "the file gives neither its shape nor its size"},
    };
    for (const Row& row : rows) {
        SCOPED_TRACE(row.reason);
        Hut hut;
        hut.part("IFCSLAB", "Floor", hut.block({-3.0, -3.0, -0.2}, {9.0, 5.0, 0.0}), ",$");
        const int wall = hut.part("IFCWALL", "South", hut.block({0.0, 0.0, 0.0}, {6.0, 0.3, 5.0}), ",$");
        const int door = hut.part("IFCDOOR", "Entrance", hut.block(row.least, row.most), ",2.1,1.,.DOOR.,$,$");
        hut.opening(wall, hut.block({row.least.x, 0.0, row.least.z}, {row.most.x, 0.3, row.most.z}), door);
        const int back =
            hut.part("IFCDOOR", "Back door", hut.block({4.5, 0.1, 0.0}, {5.5, 0.2, 2.1}), ",2.1,1.,.DOOR.,$,$");
        hut.opening(wall, hut.block({4.5, 0.0, 0.0}, {5.5, 0.3, 2.1}), back);
        if (!row.kind.empty()) hut.part(row.kind, row.name, hut.block(row.from, row.to), ",$");
        const Scene scene = hut.scene();
        const HonestReport report = honest_report(scene);
        EXPECT_EQ(report.doors, 2);
        EXPECT_EQ(report.doors_impassable, row.reason.empty() ? 0 : 1);
        const auto reported = [&](const std::string& text) { return text.find(row.reason) != std::string::npos; };
        if (row.reason.empty()) continue;
        ASSERT_FALSE(report.check.empty());
        EXPECT_EQ(check_words(scene, report.check[0]), "nobody can get through the door Entrance: " + row.reason);
        EXPECT_TRUE(std::any_of(scene.report.warnings.begin(), scene.report.warnings.end(),
                                [&](const Diagnostic& d) { return reported(d.message); }));
        const std::vector<WorldFault> faults = find_faults(scene, nullptr, nullptr);
        EXPECT_TRUE(std::any_of(faults.begin(), faults.end(), [&](const WorldFault& fault) {
            return fault.kind == FaultKind::ImpassableDoor && reported(fault_words(scene, fault));
        }));
    }
}

TEST(PartsOfIfc, can_be_placed_at_crossings_of_grid_axes) {
    for (const bool relative : {false, true}) {  // in IFC 4.3, the grid placement has an additional attribute
        SCOPED_TRACE(relative);
        Hut hut;
        const auto axis = [&](const Vec3& from, const Vec3& to, const char* same = ".T.") {
            return hut.add("IFCGRIDAXIS('1'," +
                           Hut::ref(hut.add("IFCPOLYLINE(" + Hut::refs({hut.point(from), hut.point(to)}) + ")")) + "," +
                           same + ")");
        };
        const int one = axis({0, -2, 0}, {0, 12, 0}), two = axis({6, -2, 0}, {6, 5, 0}),
                  back = axis({12.5, -2, 0}, {12.5, 12, 0}, ".F."), a = axis({-2, 0, 0}, {30, 0, 0}),
                  b = axis({-2, 7, 0}, {30, 7, 0});
        const int moved = hut.add("IFCLOCALPLACEMENT($," + Hut::ref(hut.placed({100.0, 0.0, 0.0})) + ")");
        hut.add("IFCGRID('G',$,'Grid',$,$," + Hut::ref(moved) + ",$," + Hut::refs({one, two, back}) + "," +
                Hut::refs({a, b}) + ",$,$)");
        hut.part("IFCSLAB", "Floor", hut.block({98.0, -2.0, -0.2}, {120.0, 10.0, 0.0}), ",$");
        const auto column = [&](int first, int second, const char* offsets) {
            const int crossing =
                hut.add("IFCVIRTUALGRIDINTERSECTION(" + Hut::refs({first, second}) + "," + offsets + ")");
            const int at =
                hut.add(std::string("IFCGRIDPLACEMENT(") + (relative ? "$," : "") + Hut::ref(crossing) + ",$)");
            hut.part("IFCCOLUMN", "Column", hut.block({-0.2, -0.2, 0.0}, {0.2, 0.2, 3.0}), ",$", at);
        };
        column(one, a, "(0.,0.)");
        column(two, b, "(0.,0.)");  // the axis ends before it reaches the column
        // An offset to the left of an axis that runs in the opposite direction, and upwards.
        column(back, b, "(0.5,0.,0.25)");
        const Scene scene = hut.scene();
        EXPECT_TRUE(in_a_solid(scene, {100.0, 0.0, 1.5}));
        EXPECT_TRUE(in_a_solid(scene, {106.0, 7.0, 1.5}));
        EXPECT_TRUE(in_a_solid(scene, {113.0, 7.0, 3.1}));
        EXPECT_FALSE(in_a_solid(scene, {112.5, 7.0, 0.1}));
        EXPECT_TRUE(std::none_of(scene.report.left_out.begin(), scene.report.left_out.end(),
                                 [](const std::string& s) { return s.find("plac") != std::string::npos; }));
    }
}

TEST(PartsOfIfc, appear_even_if_no_curtain_wall_contains_them) {
    Hut hut;
    hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {6.0, 6.0, 0.0}), ",$");
    hut.part("IFCPLATE", "Pane", hut.block({1.0, 2.0, 0.0}, {1.05, 4.0, 2.0}), ",$");
    hut.part("IFCMEMBER", "Post", hut.block({3.0, 2.0, 0.0}, {3.1, 2.1, 2.0}), ",$");
    const Scene scene = hut.scene();
    EXPECT_TRUE(in_a_solid(scene, {1.02, 3.0, 1.0}));
    EXPECT_TRUE(in_a_solid(scene, {3.05, 2.05, 1.0}));
    EXPECT_TRUE(scene.report.left_out.empty());
}

TEST(PartsOfIfc, that_carry_people_get_their_correct_names) {
    Hut hut;
    hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {16.0, 6.0, 0.0}), ",$");
    hut.part("IFCTRANSPORTELEMENT", "Up", hut.block({1.0, 1.0, 0.0}, {2.0, 2.0, 1.0}), ",.ESCALATOR.");
    hut.part("IFCTRANSPORTELEMENT", "Along", hut.block({5.0, 1.0, 0.0}, {9.0, 2.0, 0.1}), ",.MOVINGWALKWAY.");
    hut.part("IFCTRANSPORTELEMENT", "Cabin", hut.block({11.0, 1.0, 0.0}, {12.0, 2.0, 2.0}), ",.ELEVATOR.");
    const Scene scene = hut.scene();
    const HonestReport report = honest_report(scene);
    EXPECT_EQ(report.lifts, 1);
    EXPECT_EQ(report.escalators, 1);
    EXPECT_EQ(report.walkways, 1);
    EXPECT_THAT(honest_sentence(scene, report),
                testing::AllOf(testing::HasSubstr(", one lift and "),
                               testing::HasSubstr("There is one escalator. There is one moving walkway.")));
    for (const std::string name : {"escalator", "moving walkway", "lift"})
        EXPECT_TRUE(std::any_of(scene.features.begin(), scene.features.end(), [&](const Feature& feature) {
            return spoken_name(feature) == name;
        })) << name;
}

TEST(PartsOfIfc, are_read_at_national_coordinates_in_every_class) {
    for (const std::string kind : {"IFCBUILDINGELEMENTPROXY", "IFCCOLUMN", "IFCFURNISHINGELEMENT", "IFCWALL"}) {
        SCOPED_TRACE(kind);
        Hut hut;
        const int far = hut.add("IFCLOCALPLACEMENT($," + Hut::ref(hut.placed({412300.0, 5654100.0, 71.0})) + ")");
        hut.part(kind, "One", hut.block({0.0, 0.0, 0.0}, {6.0, 0.2, 2.7}), ",$", far);
        hut.part(kind, "Other", hut.block({0.0, 4.0, 0.0}, {6.0, 4.2, 2.7}), ",$", far);
        const Scene scene = hut.scene();
        EXPECT_NEAR(volume_within_m3(scene, {{-100.0, -100.0, 0.0}, Vec3(100.0)}), 2 * 6.0 * 0.2 * 2.7, 1e-4);
    }
}

TEST(StepFile, decodes_a_shifted_apostrophe_as_a_letter) {
    struct Row {
        std::string raw, right;
    };
    const Row rows[] = {
        {R"('\S\' 5',$)", "§ 5"},    {R"('\S\'',$)", "§"},     {R"('\S\'' 5',$)", "§ 5"}, {R"('a\S\D',$)", "aÄ"},
        {R"('D:\S\',$)", "D:\\S\\"}, {R"('it''s',$)", "it's"}, {R"('\\S\\',$)", "\\S\\"}, {R"('',$)", ""}};
    for (const Row& row : rows) {
        SCOPED_TRACE(row.raw);
        const std::string text = "ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('ifc4'));\nENDSEC;\nDATA;\n#1=IFCMATERIAL(" +
                                 row.raw + ");\nENDSEC;\nEND-ISO-10303-21;\n";
        const Result<StepFile> file = StepFile::read(text, "text.ifc");
        ASSERT_TRUE(file.has_value()) << file.error().message;
        EXPECT_EQ(file->schema(), "IFC4");
        const std::vector<StepValue> values = file->values_of(*file->find(1));
        ASSERT_EQ(values.size(), 2U);
        EXPECT_EQ(decoded(values[0].text), row.right);
    }
}

TEST(PartsOfIfc, are_read_for_any_letter_case_of_the_schema) {
    Hut hut;
    hut.part("IFCWALL", "South", hut.block(kWall.min_m, kWall.max_m), ",$");
    for (const std::string schema : {"ifc4", "Ifc2x3", "IFC4X3_ADD2"})
        EXPECT_NEAR(volume_within_m3(hut.scene(schema), kWall), 4.5, 1e-6) << schema;
}

TEST(MissingParts, are_reported_with_their_guid_storey_and_reason) {
    Hut hut;
    hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {6.0, 6.0, 0.0}), ",$");
    const int odd = hut.add("IFCSPHERE(" + Hut::ref(hut.placed({3.0, 3.0, 1.0})) + ",0.5)");
    const int lost = hut.part("IFCWALL", "Round", odd, ",$");
    const int flat = hut.part("IFCWALL", "Flat", hut.block({0.0, 0.0, 0.0}, {6.0, 0.0, 2.5}), ",$");
    const int away = hut.part("IFCWALL", "Away", hut.block({0.0, 0.0, 0.0}, {1.0, 0.2, 2.5}), ",$",
                              hut.add("IFCLOCALPLACEMENT($," + Hut::ref(hut.placed({2e6, 0.0, 0.0})) + ")"));
    const Scene scene = hut.scene();
    const HonestReport report = honest_report(scene);
    EXPECT_EQ(report.parts_missing, 3);
    std::string said;
    for (const CheckPoint& point : report.check) said += check_words(scene, point) + "\n";
    EXPECT_THAT(said, testing::HasSubstr("Round, E" + std::to_string(lost) + ", on Ground, is missing"));
    EXPECT_THAT(said, testing::HasSubstr("IFCSPHERE"));
    EXPECT_THAT(said, testing::HasSubstr("Flat, E" + std::to_string(flat) + ", on Ground, is missing"));
    EXPECT_THAT(said, testing::HasSubstr("Away, E" + std::to_string(away) + ", on Ground, is missing: it is too far"));
    EXPECT_THAT(said, testing::Not(testing::HasSubstr("Floor")));
}

// The reader treats tapered sweeps as straight. So a growing sweep gives a part with too little volume, and a shrinking
// one a part with too much.
TEST(MissingParts, with_a_wrong_volume_are_reported) {
    struct Row {
        double from, to;  // side of the square profile at each end
        std::string said;
        bool mapped = false;
    };
    const Row rows[] = {{1.0, 1.0, ""},
                        {1.0, 2.0, "lacks 57 percent of its volume"},
                        {2.0, 1.0, "has 71 percent more volume than in the file"},
                        {1.0, 2.0, "lacks 57 percent of its volume", true}};
    for (const Row& row : rows) {
        SCOPED_TRACE(row.said);
        Hut hut;
        hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {6.0, 6.0, 0.0}), ",$");
        const auto square = [&](double side) {
            return hut.add("IFCRECTANGLEPROFILEDEF(.AREA.,$,$," + std::to_string(side) + "," + std::to_string(side) +
                           ")");
        };
        const int up = hut.add("IFCDIRECTION((0.,0.,1.))"), from = square(row.from), to = square(row.to);
        int item = hut.add("IFCEXTRUDEDAREASOLIDTAPERED(" + Hut::ref(from) + ",#2," + Hut::ref(up) + ",3.," +
                           Hut::ref(to) + ")");
        if (row.mapped) {  // the part is a copy of this shape in another size
            const int shape = hut.add("IFCSHAPEREPRESENTATION(#5,'Body','SweptSolid',(" + Hut::ref(item) + "))");
            const int map = hut.add("IFCREPRESENTATIONMAP(#2," + Hut::ref(shape) + ")");
            item = hut.add("IFCMAPPEDITEM(" + Hut::ref(map) + "," +
                           Hut::ref(hut.add("IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,#1,0.5,$)")) + ")");
        }
        hut.part("IFCCOLUMN", "Post", item, ",$");
        const Scene scene = hut.scene();
        std::string said;
        for (const CheckPoint& point : honest_report(scene).check) said += check_words(scene, point) + "\n";
        EXPECT_EQ(honest_report(scene).parts_missing, row.said.empty() ? 0 : 1) << said;
        EXPECT_THAT(said, testing::HasSubstr(row.said));
        const std::vector<WorldFault> faults = find_faults(scene, nullptr, nullptr);
        EXPECT_EQ(std::count_if(faults.begin(), faults.end(),
                                [&](const WorldFault& fault) {
                                    return fault.kind == FaultKind::MissingPart &&
                                           fault_words(scene, fault).find(row.said) != std::string::npos;
                                }),
                  row.said.empty() ? 0 : 1);
    }
}

// The report compares the cuts with the file place by place, whatever kind of solid made them.
TEST(MissingParts, are_not_reported_if_all_cuts_were_made) {
    std::mt19937 random(7);
    const auto at = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
    for (int round = 0; round < 20; ++round) {
        Hut hut;
        int wall = hut.block(kWall.min_m, kWall.max_m);
        for (int i = 0; i < 4; ++i) {
            const double x = at(0.0, 5.0), z = at(0.0, 2.0);
            if (i == 0)
                wall = hut.less(
                    wall, hut.brep({{x, -1.0}, {x + 1.0, -1.0}, {x + 0.6, 0.2}, {x + 0.5, 1.0}, {x, 0.5}}, z, z + 1.0));
            else if (i == 1)
                wall = hut.less(wall, hut.less(hut.block({x, -1.0, z}, {x + 1.5, 1.0, z + 1.0}),
                                               hut.block({x + 0.3, -1.0, z}, {x + 0.8, 1.0, z + 0.5})));
            else wall = hut.less(wall, hut.block({x, -1.0, z}, {x + 0.8, at(0.1, 0.5), z + 0.6}));
        }
        hut.part("IFCWALL", "North", wall, ",$");
        EXPECT_EQ(honest_report(hut.scene()).parts_missing, 0) << round;
    }
}

TEST(MissingParts, without_their_cuts_are_reported) {
    Hut round;  // the cut is made by a surface of a kind that the reader does not support
    const int surface = round.add("IFCCYLINDRICALSURFACE(" + Hut::ref(round.placed({3.0, 0.0, 0.0})) + ",1.)");
    const int half = round.add("IFCHALFSPACESOLID(" + Hut::ref(surface) + ",.T.)");
    round.part("IFCWALL", "North", round.less(round.block(kWall.min_m, kWall.max_m), half), ",$");
    const Scene uncut = round.scene();
    ASSERT_EQ(honest_report(uncut).parts_missing, 1);
    EXPECT_THAT(check_words(uncut, honest_report(uncut).check[0]),
                testing::HasSubstr("has not been cut: IFCHALFSPACESOLID could not be cut away"));
    Hut far;  // the cut is made by an outline whose corners are too far away for the reader
    std::vector<int> corners;
    for (const Vec2& p : {Vec2(-2e7, -2e7), Vec2(2e7, -2e7), Vec2(2e7, 2e7), Vec2(-2e7, 2e7), Vec2(-2e7, -2e7)})
        corners.push_back(far.point({p.x, p.y, 0.0}));
    const int plane = far.add("IFCPLANE(" + Hut::ref(far.placed({0.0, 0.0, 2.0})) + ")");
    const int bounded = far.add("IFCPOLYGONALBOUNDEDHALFSPACE(" + Hut::ref(plane) + ",.F.,#2," +
                                Hut::ref(far.add("IFCPOLYLINE(" + Hut::refs(corners) + ")")) + ")");
    far.part("IFCWALL", "North", far.less(far.block(kWall.min_m, kWall.max_m), bounded), ",$");
    const Scene whole = far.scene();
    ASSERT_EQ(honest_report(whole).parts_missing, 1);
    EXPECT_THAT(check_words(whole, honest_report(whole).check[0]),
                testing::HasSubstr("has 25 percent more volume than in the file"));
}

TEST(MissingParts, are_compared_with_the_volume_of_a_closed_skin) {
    const auto cube = [](bool holed) {
        std::vector<FlatFace> faces;
        const auto corner = [](int i) {
            return Vec3(i & 1 ? 2.0 : 0.0, i & 2 ? 3.0 : 0.0, i & 4 ? 4.0 : 0.0) + Vec3(1e4);
        };
        for (const std::array<int, 4>& f : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                                            std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}})
            if (!holed || f[0] != 4) faces.push_back({{{corner(f[0]), corner(f[1]), corner(f[2]), corner(f[3])}}});
        return faces;
    };
    ASSERT_TRUE(enclosed_m3(cube(false)).has_value());
    EXPECT_NEAR(*enclosed_m3(cube(false)), 24.0, 1e-9);
    EXPECT_FALSE(enclosed_m3(cube(true)).has_value());
    std::vector<FlatFace> turned = cube(false);
    std::reverse(turned[2].rings[0].begin(), turned[2].rings[0].end());
    EXPECT_FALSE(enclosed_m3(turned).has_value());
    EXPECT_NEAR(volume_m3(body_of_faces(cube(false))), 24.0, 1e-6);
}

TEST(RoomsOfIfc, without_a_slab_get_a_floor_that_is_reported) {
    for (const double high : {3.0, 0.5}) {  // a space that is too low for a room must not get a floor
        SCOPED_TRACE(high);
        Hut hut;
        hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {10.0, 5.0, 0.0}), ",$");
        hut.part("IFCWALL", "South", hut.block({0.0, -0.3, 0.0}, {10.0, 0.0, 6.0}), ",$");
        hut.part("IFCSTAIR", "Stairs", hut.block({0.0, 0.0, 0.0}, {1.0, 4.0, 3.0}), ",$");
        hut.space("Hall", hut.block({0.0, 0.0, 0.0}, {10.0, 5.0, 2.8}));
        hut.space("Office upstairs", hut.block({0.0, 0.0, 3.0}, {5.0, 5.0, 3.0 + high}));
        hut.space("Void over the hall", hut.block({5.0, 0.0, 3.0}, {10.0, 5.0, 6.0}));
        const Scene scene = hut.scene();
        EXPECT_EQ(in_a_solid(scene, {2.5, 2.5, 2.95}), high > 1.0);
        EXPECT_FALSE(in_a_solid(scene, {2.5, 2.5, 3.05}));
        EXPECT_EQ(in_a_solid(scene, {0.5, 4.5, 2.95}), high > 1.0);
        EXPECT_FALSE(in_a_solid(scene, {7.5, 2.5, 2.95}));
        EXPECT_EQ(std::any_of(scene.report.guessed.begin(), scene.report.guessed.end(),
                              [](const std::string& s) { return s.find("Office upstairs") != std::string::npos; }),
                  high > 1.0);
    }
}

// A hut stands over a cellar with three inner doors. One door leads out of the hut.
TEST(StartsOfIfc, without_rooms_are_in_front_of_doors_to_the_open_air) {
    for (const bool out_to_south : {true, false}) {
        SCOPED_TRACE(out_to_south);
        Hut hut;
        hut.part("IFCSLAB", "Cellar floor", hut.block({0.0, 0.0, -3.2}, {8.0, 6.0, -3.0}), ",$");
        hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {8.0, 6.0, 0.0}), ",$");
        hut.part("IFCROOF", "Roof", hut.block({0.0, 0.0, 3.0}, {8.0, 6.0, 3.2}), ",$");
        const double outer_y = out_to_south ? 0.0 : 5.7;
        const int outer =
                      hut.part("IFCWALL", "Outer", hut.block({0.0, outer_y, -3.0}, {8.0, outer_y + 0.3, 3.0}), ",$"),
                  inner = hut.part("IFCWALL", "Inner", hut.block({0.0, 3.0, -3.0}, {8.0, 3.2, -0.2}), ",$");
        const auto door = [&](int wall, const std::string& name, const Vec3& at) {
            const int made = hut.part("IFCDOOR", name, hut.block(at + Vec3(0.0, 0.1, 0.0), at + Vec3(1.0, 0.15, 2.1)),
                                      ",2.1,1.,.DOOR.,$,$");
            hut.opening(wall, hut.block(at, at + Vec3(1.0, 0.3, 2.1)), made);
        };
        for (const double x : {1.0, 3.0, 5.0}) door(inner, "Cellar door", {x, 3.0, -3.0});
        door(outer, "Entrance", {3.0, outer_y, 0.0});
        const Scene scene = hut.scene();
        ASSERT_FALSE(scene.starts.empty());
        EXPECT_NEAR(scene.starts.front().feet_m.z, 0.0, 0.1);
        EXPECT_TRUE(scene.starts.front().base);
        if (out_to_south) EXPECT_LT(scene.starts.front().feet_m.y, 0.0);
        else EXPECT_GT(scene.starts.front().feet_m.y, 6.0);
        EXPECT_TRUE(in_a_solid(scene, scene.starts.front().feet_m - Vec3(0.0, 0.0, 0.1)));
    }
}

// Two doors lead to the ground under a porch. A balcony is above one of them. Another door leads from the cellar to a
// sunken yard.
TEST(StartsOfIfc, without_rooms_are_on_the_ground_even_under_a_porch_or_over_a_sunken_yard) {
    for (const bool porch : {false, true}) {
        SCOPED_TRACE(porch);
        Hut hut;
        hut.part("IFCSLAB", "Cellar floor", hut.block({0.0, -4.0, -3.2}, {8.0, 6.0, -3.0}), ",$");
        hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {8.0, 6.0, 0.0}), ",$");
        hut.part("IFCSLAB", "Upper floor", hut.block({0.0, 0.0, 2.8}, {8.0, 6.0, 3.0}), ",$");
        hut.part("IFCROOF", "Roof", hut.block({0.0, 0.0, 6.0}, {8.0, 6.0, 6.2}), ",$");
        if (porch) hut.part("IFCROOF", "Porch", hut.block({2.5, 6.0, 2.5}, {8.0, 7.5, 2.6}), ",$");
        const int north = hut.part("IFCWALL", "North", hut.block({0.0, 5.7, -3.0}, {8.0, 6.0, 6.0}), ",$"),
                  south = hut.part("IFCWALL", "South", hut.block({0.0, 0.0, -3.0}, {8.0, 0.3, 6.0}), ",$"),
                  inner = hut.part("IFCWALL", "Inner", hut.block({0.0, 4.5, 0.0}, {8.0, 4.7, 2.8}), ",$");
        const auto door = [&](int wall, const std::string& name, const Vec3& at, double thick) {
            const int made = hut.part("IFCDOOR", name, hut.block(at + Vec3(0.0, 0.05, 0.0), at + Vec3(1.0, 0.1, 2.1)),
                                      ",2.1,1.,.DOOR.,$,$");
            hut.opening(wall, hut.block(at, at + Vec3(1.0, thick, 2.1)), made);
        };
        door(north, "Entrance", {3.0, 5.7, 0.0}, 0.3);
        door(north, "Side entrance", {6.0, 5.7, 0.0}, 0.3);
        door(inner, "Behind the entrance", {3.0, 4.5, 0.0}, 0.2);
        door(south, "Cellar", {1.0, 0.0, -3.0}, 0.3);
        door(south, "Balcony", {5.0, 0.0, 3.0}, 0.3);
        const Scene scene = hut.scene();
        ASSERT_EQ(scene.starts.size(), 4U) << "and none before the door within";
        EXPECT_TRUE(scene.starts.front().base);
        EXPECT_NEAR(scene.starts.front().feet_m.z, 0.0, 0.1);
        EXPECT_GT(scene.starts.front().feet_m.y, 6.0);
        EXPECT_TRUE(in_a_solid(scene, scene.starts.front().feet_m - Vec3(0.0, 0.0, 0.1))) << "the ground is there";
        EXPECT_FALSE(in_a_solid(scene, scene.starts.front().feet_m + Vec3(0.0, 0.0, 1.0)));
    }
}

TEST(RoomsOfIfc, without_walls_or_floors_get_them_from_their_outlines) {
    Hut hut;
    hut.space("Hall", hut.block({0.0, 0.0, 0.0}, {10.0, 5.0, 2.8}));
    hut.space("Office", hut.block({10.1, 0.0, 0.0}, {15.0, 5.0, 2.8}));
    const Scene scene = hut.scene();
    EXPECT_TRUE(in_a_solid(scene, {5.0, 2.5, -0.05}));
    EXPECT_FALSE(in_a_solid(scene, {5.0, 2.5, 1.0}));
    for (const Vec3& at : {Vec3(5.0, -0.03, 1.0), Vec3(5.0, 5.03, 1.0), Vec3(-0.03, 2.0, 1.0), Vec3(10.03, 2.0, 1.0),
                           Vec3(15.03, 2.0, 1.0)})
        EXPECT_TRUE(in_a_solid(scene, at)) << at.x << " " << at.y;
    EXPECT_EQ(honest_report(scene).rooms, 2);
    EXPECT_THAT(scene.report.guessed, testing::Contains(testing::HasSubstr("around 2 rooms")));
    Hut far;
    far.space("Hall", far.block({0.0, 0.0, 0.0}, {10.0, 5.0, 2.8}),
              far.add("IFCLOCALPLACEMENT($," + Hut::ref(far.placed({412300.0, 5654100.0, 71.0})) + ")"));
    EXPECT_EQ(honest_report(far.scene()).rooms, 1);
}

TEST(RoomsOfIfc, as_high_as_their_storey_do_not_contain_the_floor_above_them) {
    StatedRoom room;
    room.rings = {{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}}};
    room.height_m = 3.0;
    EXPECT_TRUE(holds(room, {2.0, 2.0, 0.0}));
    EXPECT_TRUE(holds(room, {2.0, 2.0, -0.3}));
    EXPECT_TRUE(holds(room, {2.0, 2.0, 1.5}));
    EXPECT_FALSE(holds(room, {2.0, 2.0, 3.0}));
    EXPECT_FALSE(holds(room, {2.0, 2.0, 2.8}));
    EXPECT_FALSE(holds(room, {5.0, 2.0, 1.0}));
}

TEST(RoomsOfIfc, have_a_goal_that_can_be_reached_from_the_base) {
    Scene placed = test::hall_with_gallery().scene();
    placed.starts = {Start{{-2.0, 0.6, 0.0}, 0.0, true, "", {}}, Start{{6.0, 4.0, 2.6}, 0.0, false, "", {}}};
    const Result<WalkSpace> space = make_walk_space(placed, WalkerMeasures{});
    ASSERT_TRUE(space.has_value());
    const RoomGraph graph = make_rooms(placed, *space);
    const auto hall =
        std::find_if(graph.rooms.begin(), graph.rooms.end(), [](const Room& room) { return room.name == "Hall"; });
    ASSERT_NE(hall, graph.rooms.end());
    const std::vector<bool> reached = spans_reached(*space, space->at(placed.starts[0].feet_m));
    EXPECT_TRUE(reached[space->at(hall->middle_m)]);
    // The route to this room from the gallery must end at the nearest place of the room on the gallery itself.
    const auto room = static_cast<std::uint32_t>(hall - graph.rooms.begin());
    const Result<std::shared_ptr<Navigation>> ways = Navigation::make(placed, WalkerMeasures{});
    ASSERT_TRUE(ways.has_value());
    std::optional<Vec3> above;
    for (std::uint32_t s = 0; s < space->spans.size() && !above; ++s)
        if (graph.room_of_span[s] == room && space->place_m(s).z > 2.0) above = space->place_m(s);
    ASSERT_TRUE(above.has_value());
    const Vec3 on_gallery = *above;
    ASSERT_FALSE((*ways)->reachable(on_gallery, hall->middle_m));
    const Vec3 goal = goal_in_room(**ways, graph, room, on_gallery);
    EXPECT_EQ(room_at(graph, *space, goal), room);
    EXPECT_TRUE((*ways)->plan(on_gallery, goal).reaches);
    EXPECT_EQ(goal_in_room(**ways, graph, room, placed.starts[0].feet_m), hall->middle_m);
}

// Some programs give the parts national coordinates but leave the storeys at zero.
TEST(StoreysOfIfc, are_at_the_height_of_their_parts_on_a_national_grid) {
    for (const std::string kind : {"IFCBUILDINGELEMENTPROXY", "IFCWALL"})
        for (const double height_m : {0.0, 71.0, -3.0, 2412.5})
            for (const bool storeys_too : {false, true}) {
                SCOPED_TRACE(kind + " at " + std::to_string(height_m) + (storeys_too ? ", all" : ", parts only"));
                const Vec3 grid{412300.0, 5654100.0, height_m};
                Hut hut;
                const int there = hut.add("IFCLOCALPLACEMENT($," + Hut::ref(hut.placed(grid)) + ")");
                if (!storeys_too) hut.storey("Upper", 2.8);
                hut.part(kind, "Wall", hut.block({0.0, 0.0, 0.0}, {6.0, 0.2, 5.6}), ",$", there);
                hut.part(kind, "Slab", hut.block({0.0, 0.0, 2.6}, {6.0, 4.0, 2.8}), ",$", there);
                const Scene scene = hut.scene("IFC4", storeys_too ? grid : Vec3(0.0));
                ASSERT_TRUE(scene.stated);
                // The wall is 5.6 m high, and the ground under it is a little lower.
                EXPECT_NEAR(scene.bounds_m.max_m.z, 5.6, 1e-6);
                EXPECT_NEAR(scene.stated->storeys.front().floor_m, 0.0, 1e-6);
                EXPECT_NEAR(scene.stated->storeys.back().floor_m, storeys_too ? 0.0 : 2.8, 1e-6);
            }
}

// Rooms of a house with half-storeys next to each other. The file may omit the storey of the sunken part.
TEST(RoomsOfIfc, on_half_storeys_get_separate_storeys) {
    for (const bool stated : {true, false}) {
        SCOPED_TRACE(stated);
        Hut hut;
        const int half = hut.storey("Half", 1.4), upper = hut.storey("Upper", 2.8);
        const auto room = [&](const std::string& name, double x, double z, int storey) {
            hut.part("IFCSLAB", "Floor", hut.block({x, 0.0, z - 0.2}, {x + 4.0, 4.0, z}), ",$");
            hut.part("IFCWALL", "Wall", hut.block({x + 4.0, 0.0, z - 0.2}, {x + 4.2, 4.0, z + 2.4}), ",$");
            hut.space(name, hut.block({x, 0.0, z}, {x + 4.0, 4.0, z + 2.4}), Hut::kPlacement, storey);
        };
        room("Hall", 0.0, 0.0, 0);
        room("Study", 4.2, 1.4, stated ? half : 0);
        room("Attic", 8.4, 2.8, upper);
        const Scene scene = hut.scene();
        const Result<WalkSpace> space = make_walk_space(scene, WalkerMeasures{});
        ASSERT_TRUE(space.has_value());
        std::map<std::string, int> level;
        for (const Room& found : make_rooms(scene, *space).rooms) level[found.name] = found.level;
        ASSERT_TRUE(level.contains("Hall") && level.contains("Study") && level.contains("Attic"));
        EXPECT_EQ(level["Study"] - level["Hall"], stated ? 1 : 0);
        EXPECT_EQ(level["Attic"] - level["Study"], 1);
    }
}

TEST(RoomsOfIfc, are_on_storeys_at_their_elevation_if_all_storeys_are_placed_alike) {
    for (const bool placed : {true, false}) {
        SCOPED_TRACE(placed);
        Hut hut;
        const int upper = hut.storey("Upper", placed ? 2.8 : 0.0, 3.0);
        for (const double z : {0.0, placed ? 2.8 : 3.0}) {
            hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, z - 0.2}, {4.0, 4.0, z}), ",$");
            hut.part("IFCWALL", "Wall", hut.block({4.0, 0.0, z - 0.2}, {4.2, 4.0, z + 2.4}), ",$");
            hut.space(z > 0.0 ? "Attic" : "Hall", hut.block({0.0, 0.0, z}, {4.0, 4.0, z + 2.4}), Hut::kPlacement,
                      z > 0.0 ? upper : 0);
        }
        const Scene scene = hut.scene();
        ASSERT_TRUE(scene.stated);
        ASSERT_EQ(scene.stated->storeys.size(), 2U);
        EXPECT_EQ(scene.stated->storeys[1].name, "Upper");
        EXPECT_NEAR(scene.stated->storeys[1].floor_m, placed ? 2.8 : 3.0, 1e-9) << "what places it counts first";
    }
}

TEST(DoorsOfIfc, without_names_are_described_in_whole_sentences) {
    for (const std::string name : {"", "Entrance"}) {
        Hut hut;
        hut.part("IFCSLAB", "Floor", hut.block({0.0, -3.0, -0.2}, {6.0, 3.0, 0.0}), ",$");
        const int wall = hut.part("IFCWALL", "South", hut.block({0.0, 0.0, 0.0}, {6.0, 0.3, 3.0}), ",$");
        const int door = hut.part("IFCDOOR", name, hut.block({2.0, 0.1, 0.0}, {3.0, 0.15, 2.1}), ",2.1,1.,.DOOR.,$,$");
        hut.opening(wall, hut.block({2.0, 0.0, 0.0}, {3.0, 0.3, 2.1}), door);
        hut.part("IFCWALL", name, hut.block({2.0, 0.1, 0.0}, {3.0, 0.2, 2.1}), ",$");  // a wall that blocks the doorway
        const Scene scene = hut.scene();
        std::string said;
        for (const Diagnostic& warning : scene.report.warnings) said += warning.message + "\n";
        for (const CheckPoint& point : honest_report(scene).check) said += check_words(scene, point) + "\n";
        if (name.empty()) {
            EXPECT_THAT(said, testing::HasSubstr("Nobody could pass through a door without a name. A part without a "
                                                 "name was in the way."));
            EXPECT_THAT(said, testing::HasSubstr("something that blocked a door without a name was cut away"));
            EXPECT_THAT(said, testing::Not(testing::HasSubstr("door  ")));
            EXPECT_THAT(said, testing::Not(testing::HasSubstr(" .")));
        } else {
            EXPECT_THAT(said, testing::HasSubstr("Nobody could pass through the door Entrance. In the way: Entrance."));
        }
    }
}

// An open surface encloses no volume, so the report compares the surface by its faces. The report counts the faces that
// cannot be read.
TEST(MissingParts, are_reported_for_open_skins_and_lost_faces) {
    for (const bool damaged : {false, true}) {
        SCOPED_TRACE(damaged);
        Hut hut;
        hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {6.0, 6.0, 0.0}), ",$");
        const int points = hut.add("IFCCARTESIANPOINTLIST3D(((0.,0.,0.),(3.,0.,0.),(3.,0.,2.),(0.,0.,2.)))");
        hut.part("IFCWALL", "Sheet",
                 hut.add("IFCTRIANGULATEDFACESET(" + Hut::ref(points) + ",$,.F.,((1,2,3),(1,3," +
                         (damaged ? "9" : "4") + ")),$)"),
                 ",$");
        const Scene scene = hut.scene();
        ASSERT_EQ(honest_report(scene).parts_missing, damaged ? 1 : 0);
        if (damaged) {
            EXPECT_THAT(check_words(scene, honest_report(scene).check[0]),
                        testing::HasSubstr("lacks faces that are damaged or have too many corners; their number is 1"));
        }
    }
}

// The volume of revolved and swept solids must follow from their outlines and the lengths of their paths.
TEST(MissingParts, are_compared_with_the_volumes_of_turned_and_swept_solids) {
    for (const double inner : {0.0, 0.1}) {
        Hut hut;
        hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {6.0, 6.0, 0.0}), ",$");
        const int line = hut.add(
            "IFCPOLYLINE(" +
            Hut::refs({hut.point({0.0, 0.0, 1.0}), hut.point({3.0, 0.0, 1.0}), hut.point({3.0, 4.0, 1.0})}) + ")");
        hut.part("IFCRAILING", "Pipe",
                 hut.add("IFCSWEPTDISKSOLID(" + Hut::ref(line) + ",0.2," + (inner > 0.0 ? "0.1" : "$") + ",$,$)"), "");
        const Scene pipe = hut.scene();
        EXPECT_EQ(honest_report(pipe).parts_missing, 0);
        EXPECT_NEAR(volume_within_m3(pipe, {{-1.0, -1.0, 0.5}, {4.0, 5.0, 1.5}}),
                    kPi * (0.2 * 0.2 - inner * inner) * 7.0, 0.01);
    }
    Hut hut;
    hut.part("IFCSLAB", "Floor", hut.block({0.0, 0.0, -0.2}, {6.0, 6.0, 0.0}), ",$");
    const int at = hut.add("IFCAXIS2PLACEMENT2D(" + Hut::ref(hut.add("IFCCARTESIANPOINT((1.,0.))")) + ",$)");
    const int profile = hut.add("IFCRECTANGLEPROFILEDEF(.AREA.,$," + Hut::ref(at) + ",0.4,0.4)");
    const int axis = hut.add("IFCAXIS1PLACEMENT(#1," + Hut::ref(hut.add("IFCDIRECTION((0.,1.,0.))")) + ")");
    hut.part("IFCRAILING", "Bend",
             hut.add("IFCREVOLVEDAREASOLID(" + Hut::ref(profile) + "," + Hut::ref(hut.placed({2.0, 2.0, 5.0})) + "," +
                     Hut::ref(axis) + ",1.5707963267948966)"),
             "");
    const Scene bend = hut.scene();
    EXPECT_EQ(honest_report(bend).parts_missing, 0);
    EXPECT_NEAR(volume_within_m3(bend, {{0.0, 0.0, 2.0}, {6.0, 6.0, 8.0}}), 0.5 * kPi * 0.16, 0.01);
}

TEST(PartsOfIfc, keep_slanted_outlines) {
    Hut hut;
    const auto slab = [&](const Ring& outline) {
        std::vector<int> points;
        for (const Vec2& p : outline) points.push_back(hut.point({p.x, p.y, 0.0}));
        points.push_back(points.front());
        const int profile = hut.add("IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$," +
                                    Hut::ref(hut.add("IFCPOLYLINE(" + Hut::refs(points) + ")")) + ")");
        const int up = hut.add("IFCDIRECTION((0.,0.,1.))");
        hut.part("IFCSLAB", "Terrace",
                 hut.add("IFCEXTRUDEDAREASOLID(" + Hut::ref(profile) + ",#2," + Hut::ref(up) + ",0.2)"), ",$");
    };
    slab({{14.4, 18.6}, {22.8, 24.6}, {14.4, 24.6}});
    slab({{4.0, 16.0}, {14.0, 16.0}, {14.0, 26.0}, {4.0, 26.0}});
    const Scene scene = hut.scene();
    EXPECT_NEAR(volume_within_m3(scene, {{14.4, 18.6, 0.0}, {22.8, 24.6, 0.2}}), 5.04, 1e-6);
    EXPECT_NEAR(volume_within_m3(scene, {{4.0, 16.0, 0.0}, {14.0, 26.0, 0.2}}), 20.0, 1e-6);
    EXPECT_EQ(honest_report(scene).parts_missing, 0);
}

}  // namespace parts_test
}  // namespace handrail
