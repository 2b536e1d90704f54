// Tests outlines, cuts and shells. A test of many single points is the reference.
#include <gmock/gmock.h>

#include <random>

#include "tests/support/names.h"
#include "tests/unit/ifc/ifc_text.h"
#include "worlds/geometry/clip.h"
#include "worlds/geometry/mass_properties.h"
#include "worlds/ifc/body.h"
#include "worlds/ifc/ifc_curves.h"

namespace handrail {
namespace shapes_test {

bool in_part(const Ring& part, const Vec2& at) {
    for (std::size_t i = 0; i < part.size(); ++i) {
        const Vec2 side = part[(i + 1) % part.size()] - part[i], off = at - part[i];
        if (side.x * off.y - side.y * off.x < 0.0) return false;
    }
    return true;
}

double from_edges(const std::vector<Ring>& rings, const Vec2& at) {
    double least = 1e300;
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 side = ring[(i + 1) % ring.size()] - ring[i];
            const double t =
                std::clamp(glm::dot(at - ring[i], side) / std::max(glm::dot(side, side), 1e-300), 0.0, 1.0);
            least = std::min(least, glm::length(at - ring[i] - side * t));
        }
    return least;
}

double volume(const ConvexSolid& solid) {
    double six = 0.0;
    for (std::size_t f = 0; f < solid.faces.size(); ++f)
        six += 2.0 * area_m2(solid.faces[f]) * solid.planes[f].offset_m;
    return six / 6.0;
}

TEST(ConvexParts, contain_each_point_of_the_outline_exactly_once) {
    std::mt19937 random(20261123);
    std::uniform_real_distribution<double> place(-10.0, 10.0);
    for (int round = 0; round < 200; ++round) {
        SCOPED_TRACE(round);
        std::vector<Ring> rings(1 + random() % 3);
        for (Ring& ring : rings)
            for (std::size_t n = 3 + random() % 8; n > 0; --n)
                ring.emplace_back(std::round(place(random)), round % 2 ? place(random) : std::round(place(random)));
        const std::vector<Ring> parts = convex_parts(rings);
        for (int k = 0; k < 200; ++k) {
            const Vec2 at{place(random), place(random)};
            if (from_edges(rings, at) < 1e-3) continue;
            const auto in =
                std::count_if(parts.begin(), parts.end(), [&](const Ring& part) { return in_part(part, at); });
            const bool on_a_cut = std::any_of(parts.begin(), parts.end(),
                                              [&](const Ring& part) { return from_edges({part}, at) < 1e-4; });
            if (on_a_cut) continue;
            EXPECT_EQ(in, inside(rings, at) ? 1 : 0) << at.x << " " << at.y;
        }
    }
}

TEST(ConvexParts, leave_a_convex_outline_whole_and_cut_an_l_shape_in_two) {
    EXPECT_EQ(convex_parts({{{0, 0}, {0, 2}, {2, 2}, {2, 1}, {2, 0}}}).size(), 1U);
    EXPECT_EQ(convex_parts({{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}}).size(), 2U);
    EXPECT_EQ(convex_parts({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}}).size(), 4U);
    EXPECT_TRUE(convex_parts({{{0, 0}, {1, 0}, {2, 0}}}).empty());
}

// Returns an outline whose corners are at rising angles about a centre, at random distances. The outlines include
// triangles, slivers and concave ones.
Ring outline_around(std::mt19937& random, const Vec2& middle, double least_m, double most_m, std::size_t fewest) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<double> angles(fewest + random() % 10);
    for (std::size_t i = 0; i < angles.size(); ++i)
        angles[i] = 2.0 * kPi * (static_cast<double>(i) + 0.9 * share(random)) / static_cast<double>(angles.size());
    Ring ring;
    for (const double angle : angles)
        ring.push_back(middle +
                       Vec2(std::cos(angle), std::sin(angle)) * (least_m + (most_m - least_m) * share(random)));
    return ring;
}
Ring sliver(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const double length_m = 0.5 + 20.0 * share(random), width_m = std::pow(10.0, -3.0 * share(random));
    const double angle = 2.0 * kPi * share(random), at = share(random);
    const Vec2 along{std::cos(angle), std::sin(angle)}, out{-along.y, along.x};
    return {{0.0, 0.0}, along * length_m, along * (length_m * at) + out * width_m};
}

TEST(Prism, keeps_the_area_of_any_outline) {
    std::mt19937 random(20261129);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int round = 0; round < 2000; ++round) {
        SCOPED_TRACE(round);
        std::vector<Ring> rings;
        if (round % 4 == 0) rings.push_back(sliver(random));
        else rings.push_back(outline_around(random, {share(random), share(random)}, 2.5, 15.0, round % 4 == 3 ? 6 : 3));
        // The second outline becomes a hole.
        if (round % 4 == 3) rings.push_back(outline_around(random, {0.5, 0.5}, 0.05, 0.4, 3));
        if (round % 3 == 0) std::reverse(rings.front().begin(), rings.front().end());
        double right_m2 = std::abs(signed_area(rings.front()));
        if (rings.size() > 1) right_m2 -= std::abs(signed_area(rings.back()));
        Frame frame;
        const double angle = round % 5 == 0 ? 0.0 : 2.0 * kPi * share(random);
        frame.x = {std::cos(angle), std::sin(angle), 0.0};
        frame.y = {-std::sin(angle), std::cos(angle), 0.0};
        if (round % 7 == 0) frame.y = -frame.y;  // makes the frame a mirror image
        const double high_m = round % 2 ? 0.25 : -3.0;
        double held_m3 = 0.0;
        for (const Ring& part : convex_parts(rings)) {
            const std::optional<ConvexSolid> solid = prism(part, {0.0, 0.0, high_m}, frame);
            if (solid) held_m3 += mass_properties(*solid).volume_m3;
        }
        EXPECT_NEAR(held_m3 / std::abs(high_m), right_m2, 1e-9 * std::max(right_m2, 1.0));
    }
}

TEST(CutAway, removes_exactly_the_intersection_of_both_solids) {
    std::mt19937 random(20261124);
    std::uniform_real_distribution<double> place(-2.0, 2.0), size(0.2, 2.0), turn(0.0, 2.0 * kPi);
    for (int round = 0; round < 100; ++round) {
        SCOPED_TRACE(round);
        const auto any_box = [&] {
            Frame frame;
            const double angle = round % 2 ? turn(random) : 0.0;
            frame.x = {std::cos(angle), std::sin(angle), 0.0};
            frame.y = {-std::sin(angle), std::cos(angle), 0.0};
            frame.origin_m = {place(random), place(random), place(random)};
            return *box_solid({0, 0, 0}, {size(random), size(random), size(random)}, frame);
        };
        const ConvexSolid host = any_box(), cutter = any_box();
        Body body{{host}, {}};
        cut_away(body, cutter.planes);
        for (int k = 0; k < 300; ++k) {
            const Vec3 at{place(random) * 2.0, place(random) * 2.0, place(random) * 2.0};
            const bool near_a_side = contains(host, at, 1e-3) != contains(host, at, -1e-3) ||
                                     contains(cutter, at, 1e-3) != contains(cutter, at, -1e-3);
            if (near_a_side) continue;
            const auto in = std::count_if(body.solids.begin(), body.solids.end(),
                                          [&](const ConvexSolid& s) { return contains(s, at, 1e-9); });
            EXPECT_EQ(in > 0, contains(host, at) && !contains(cutter, at));
        }
    }
}

// Returns the faces of an L-shaped solid of 3 by 3 m. The arms of the solid are 1 m thick, and the solid is 2 m high.
std::vector<FlatFace> l_shell() {
    const Ring outline{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    std::vector<FlatFace> faces(2);
    for (FlatFace& face : faces) face.rings.resize(1);
    for (const Vec2& p : outline) {
        faces[0].rings[0].insert(faces[0].rings[0].begin(), {p.x, p.y, 0.0});
        faces[1].rings[0].push_back({p.x, p.y, 2.0});
    }
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
        faces.push_back({{{{a.x, a.y, 0.0}, {b.x, b.y, 0.0}, {b.x, b.y, 2.0}, {a.x, a.y, 2.0}}}});
    }
    return faces;
}

TEST(BodyOfFaces, is_solid_if_its_shells_are_prisms_and_a_sheet_if_they_are_open) {
    const Body whole = body_of_faces(l_shell());
    EXPECT_TRUE(whole.sheets.empty());
    ASSERT_EQ(whole.solids.size(), 2U);
    EXPECT_NEAR(volume(whole.solids[0]) + volume(whole.solids[1]), 10.0, 1e-6);
    std::vector<FlatFace> open = l_shell();
    open.pop_back();
    EXPECT_TRUE(body_of_faces(open).solids.empty());
    EXPECT_FALSE(body_of_faces(open).sheets.empty());
}

TEST(Profiles, of_every_kind_have_the_correct_area) {
    struct Row {
        const char* profile;
        double area_m2;
    };
    const Row rows[] = {
        {"IFCRECTANGLEPROFILEDEF(.AREA.,$,$,2.,3.)", 6.0},
        {"IFCROUNDEDRECTANGLEPROFILEDEF(.AREA.,$,$,2.,3.,0.5)", 6.0 - 0.25 * (4.0 - kPi)},
        {"IFCRECTANGLEHOLLOWPROFILEDEF(.AREA.,$,$,2.,3.,0.5,$,$)", 4.0},
        {"IFCCIRCLEPROFILEDEF(.AREA.,$,$,1.)", kPi},
        {"IFCCIRCLEHOLLOWPROFILEDEF(.AREA.,$,$,1.,0.5)", 0.75 * kPi},
        {"IFCELLIPSEPROFILEDEF(.AREA.,$,$,2.,1.)", 2.0 * kPi},
        {"IFCISHAPEPROFILEDEF(.AREA.,$,$,2.,3.,0.5,0.5,$)", 3.0},
        {"IFCLSHAPEPROFILEDEF(.AREA.,$,$,3.,2.,0.5,$,$,$)", 2.25},
        {"IFCTSHAPEPROFILEDEF(.AREA.,$,$,3.,2.,0.5,0.5,$,$,$,$,$)", 2.25},
        {"IFCUSHAPEPROFILEDEF(.AREA.,$,$,3.,2.,0.5,0.5,$,$,$)", 3.0},
        {"IFCCSHAPEPROFILEDEF(.AREA.,$,$,3.,2.,0.5,1.,$)", 3.5},
        {"IFCZSHAPEPROFILEDEF(.AREA.,$,$,3.,2.,0.5,0.5,$,$)", 3.0},
        {"IFCTRAPEZIUMPROFILEDEF(.AREA.,$,$,3.,1.,2.,1.)", 4.0},
    };
    for (const Row& row : rows) {
        const std::string text = std::string("ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n#1=") +
                                 row.profile + ";\nENDSEC;\nEND-ISO-10303-21;\n";
        const Result<StepFile> file = StepFile::read(text, "profile.ifc");
        ASSERT_TRUE(file.has_value()) << row.profile;
        const IfcModel model(*file);
        double area_m2 = 0.0;
        for (const std::vector<Ring>& rings : profile_rings(model, 1))
            for (const Ring& part : convex_parts(rings)) area_m2 += signed_area(part);
        EXPECT_NEAR(area_m2, row.area_m2, 0.02 * row.area_m2) << row.profile;
    }
}

}  // namespace shapes_test
}  // namespace handrail
