// Our reading of IFC files against that of Debian's own library, a snapshot of 2019: which parts and rooms there are,
// where they stand, and how much they hold, part by part. The library leaves some openings in their walls and some
// roofs over their rooms uncut, and makes circles of fewer sides; elsewhere ours is neither less nor more.
#include <gmock/gmock.h>

#include <set>

#include "tests/support/real_worlds.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/ifc_oracle/packaged_ifc.h"
#include "worlds/geometry/mass_properties.h"
#include "worlds/ifc/ifc_building.h"
#include "worlds/imdf/zip_archive.h"

namespace handrail {
namespace ifc_oracle_test {

namespace fs = std::filesystem;

constexpr double kSamePlace_m = 2e-3, kSameVolume = 0.01, kLeastVolume_m3 = 1e-6;
constexpr double kRound_m = 5e-3, kRoundVolume = 0.03;  // what circles of other numbers of sides differ by

struct OurPart {
    PartRole role = PartRole::Other;
    std::string name;
    Aabb box;  // from the file's own origin; empty: no form, or a piece of furniture in its place
    double volume_m3 = 0.0;
    bool solid = false;  // wholly
};

Aabb moved(const Aabb& box, const Vec3& by_m) { return box.empty() ? box : Aabb{box.min_m + by_m, box.max_m + by_m}; }

std::map<std::string, OurPart> parts_of(const IfcBuilding& building) {
    std::map<std::string, OurPart> parts;
    for (const IfcPart& part : building.parts) {
        const Body& body = building.parts[part.same_as].body;
        OurPart& ours = parts[part.guid];
        ours.role = part.role;
        ours.name = part.name;
        if (!part.prefab) ours.box = moved(body.bounds_m(), building.origin_m);
        for (const ConvexSolid& solid : body.solids) ours.volume_m3 += mass_properties(solid).volume_m3;
        ours.solid = body.sheets.empty() && !body.solids.empty();
    }
    for (const StatedRoom& room : building.rooms) {
        OurPart& ours = parts[room.guid];
        ours.role = PartRole::Space;
        ours.name = room.name;
        Aabb box;
        for (const auto& ring : room.rings)
            for (const Vec2& p : ring) {
                box.include({p.x, p.y, room.floor_m});
                box.include({p.x, p.y, room.floor_m + room.height_m});
            }
        ours.box = moved(box, building.origin_m);
    }
    return parts;
}

bool within(const Aabb& inner, const Aabb& outer, double more_m) {
    return glm::all(glm::greaterThanEqual(inner.min_m, outer.min_m - more_m)) &&
           glm::all(glm::lessThanEqual(inner.max_m, outer.max_m + more_m));
}

double apart_m(const Aabb& a, const Aabb& b) {
    const Vec3 least = glm::abs(a.min_m - b.min_m), most = glm::abs(a.max_m - b.max_m);
    const Vec3 apart = glm::max(least, most);
    return std::max({apart.x, apart.y, apart.z});
}

// What a building for touch has no use for, and a rafter or a stud that belongs to nothing.
bool is_left_out(const std::string& kind) {
    static const std::set<std::string> kinds{"IfcSite",           "IfcBuilding", "IfcBuildingStorey", "IfcAnnotation",
                                             "IfcVirtualElement", "IfcGrid",     "IfcMember",         "IfcPlate"};
    return kinds.contains(kind);
}

struct Compared {
    std::map<std::string, int> kinds;  // with a form in both
    int places = 0, other_places = 0, volumes = 0, less = 0;
};

Compared compared(const fs::path& path) {
    const std::string bytes = test::content_of(path);
    const Result<StepFile> file = StepFile::read(bytes, path.filename().string());
    EXPECT_TRUE(file.has_value());
    IfcModel model(*file);
    const IfcRelations relations(model);
    const IfcBuilding building = read_building(model, relations, {}, {});
    const std::map<std::string, OurPart> ours = parts_of(building);
    Compared all;
    for (const auto& [guid, theirs] : test::parts_by_package(path)) {
        if (theirs.box.empty()) continue;
        const auto found = ours.find(guid);
        const bool has_form = found != ours.end() && !found->second.box.empty();
        EXPECT_TRUE(has_form || is_left_out(theirs.kind)) << theirs.kind << " " << guid << " has no form with us";
        if (!has_form) continue;
        const OurPart& part = found->second;
        ++all.kinds[theirs.kind];
        ++all.places;
        if (const double apart = apart_m(theirs.box, part.box); apart > kSamePlace_m) {
            ++all.other_places;
            std::printf("%s %s lies %.3f m elsewhere\n", theirs.kind.c_str(), part.name.c_str(), apart);
            EXPECT_TRUE(within(part.box, theirs.box, kRound_m)) << part.name;
        }
        if (part.role == PartRole::Space || theirs.open > 0 || !part.solid) continue;
        ++all.volumes;
        const double more_m3 = part.volume_m3 - theirs.closed_volume_m3;
        const bool round = part.role == PartRole::Column;
        const double same_m3 = (round ? kRoundVolume : kSameVolume) * theirs.closed_volume_m3 + kLeastVolume_m3;
        if (more_m3 < -same_m3) {
            ++all.less;
            std::printf("%s %s holds %.3f m3 less\n", theirs.kind.c_str(), part.name.c_str(), -more_m3);
        }
        EXPECT_LE(more_m3, same_m3) << theirs.kind << " " << part.name << " of " << theirs.closed_volume_m3;
    }
    std::printf("%s: %d parts, %d of them elsewhere; %d volumes, %d of them less\n", path.filename().c_str(),
                all.places, all.other_places, all.volumes, all.less);
    return all;
}

TEST(PackagedIfc, reads_our_own_houses_as_we_do) {
    for (const char* name : {"small_house.ifc", "small_house_millimetres.ifc", "small_house_other_program.ifc"}) {
        const Compared all = compared(fs::path(HANDRAIL_SOURCE_DIR) / "tests/unit/ifc/worlds" / name);
        EXPECT_GE(all.places, 10) << name;
        EXPECT_EQ(all.other_places, 0) << name;
        EXPECT_GE(all.volumes, 8) << name;
        EXPECT_EQ(all.less, 0) << name;
    }
}

TEST(PackagedIfc, has_the_same_parts_of_the_duplex_in_the_same_places) {
    const auto path = test::real_world("duplex-apartment.ifc");
    if (!path) GTEST_SKIP() << "../shared/worlds is not there";
    const Compared all = compared(*path);
    EXPECT_EQ(all.kinds.at("IfcSpace"), 21);
    EXPECT_EQ(all.kinds.at("IfcDoor"), 14);
    EXPECT_EQ(all.kinds.at("IfcWindow"), 24);
    EXPECT_EQ(all.kinds.at("IfcFurnishingElement"), 61);
    EXPECT_EQ(all.other_places, 0);
    EXPECT_GE(all.volumes, 148);
    EXPECT_LE(all.less, 2) << "it leaves the corner windows upstairs in their walls";
}

TEST(PackagedIfc, has_the_same_parts_of_a_family_house) {
    const auto path = test::real_world("fzk-haus.ifc");
    if (!path) GTEST_SKIP() << "../shared/worlds is not there";
    const Compared all = compared(*path);
    EXPECT_EQ(all.kinds.at("IfcSpace"), 7);
    EXPECT_EQ(all.kinds.at("IfcDoor"), 5);
    EXPECT_EQ(all.kinds.at("IfcWindow"), 11);
    EXPECT_EQ(all.other_places, 0);
    EXPECT_GE(all.volumes, 35);
    // One of two gables alike, whose volumes are the same with us.
    EXPECT_LE(all.less, 1);
}

TEST(PackagedIfc, has_the_same_parts_of_an_institute) {
    const auto path = test::real_world("institute.ifczip");
    if (!path) GTEST_SKIP() << "../shared/worlds is not there";
    const auto files = unzip(test::content_of(*path), "institute.ifczip", [](std::string_view) { return true; });
    ASSERT_TRUE(files.has_value()) << files.error().sentence();
    ASSERT_EQ(files->size(), 1U);
    const test::TemporaryFolder folder;
    const Compared all = compared(folder.write("institute.ifc", files->begin()->second));
    EXPECT_EQ(all.kinds.at("IfcSpace"), 82);
    EXPECT_EQ(all.kinds.at("IfcDoor"), 77);
    EXPECT_EQ(all.kinds.at("IfcWindow"), 206);
    EXPECT_EQ(all.kinds.at("IfcWallStandardCase"), 119);
    EXPECT_LE(all.other_places, 3) << "two round columns, and a room under an arched roof";
    EXPECT_GE(all.volumes, 680);
    // It leaves some openings of walls uncut, other ones each time.
    EXPECT_LE(all.less, all.volumes / 25);
}

}  // namespace ifc_oracle_test
}  // namespace handrail
