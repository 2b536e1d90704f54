// Tests that reading a model gives a world or a message of one sentence, within the limits and without a crash,
// whatever the model contains.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <cstdlib>

#include "app/import/import_world.h"
#include "tests/support/names.h"
#include "tests/support/office_ifc.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/ifc/ifc_text.h"
#include "worlds/scene/honest_report.h"
#include "worlds/scene/stated_building.h"

namespace handrail {
namespace torture_test {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// Returns the processor time, in seconds, that all readers have used so far.
double readers_s() {
    rusage use{};
    getrusage(RUSAGE_CHILDREN, &use);
    return static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
}

// Returns true if HANDRAIL_LONG_TORTURE=1 is set. Then the tests try all truncations and the largest files, which takes
// minutes.
bool at_length() { return std::getenv("HANDRAIL_LONG_TORTURE") != nullptr; }

// Reads the file. Returns the error message; empty if the file gave a world. Fails if the reader crashed or used more
// processor time than its limit, which the kernel enforces within a second.
std::string outcome(const fs::path& path) {
    const double before_s = readers_s();
    const Result<ImportedWorld> world = import_world(path, {}, {});
    EXPECT_LT(readers_s() - before_s, ReaderLimits{}.cpu_s + 2.0) << path;
    if (world) {
        EXPECT_TRUE(validate(world->scene).has_value()) << path;
        return {};
    }
    EXPECT_FALSE(world.error().message.empty()) << path;
    EXPECT_THAT(world.error().sentence(), Not(HasSubstr("Reading this file failed"))) << path;
    return world.error().sentence();
}

std::string in_utf16(const std::string& text) {
    std::string wide = "\xFF\xFE";
    for (const char c : text) {
        wide += c;
        wide += '\0';
    }
    return wide;
}

TEST(ImportTorture, every_way_to_corrupt_a_model_ends_in_a_world_or_an_error_sentence) {
    const test::TemporaryFolder folder;
    const std::string house = test::small_house();
    EXPECT_EQ(outcome(folder.write("whole.ifc", house)), "");
    EXPECT_THAT(outcome(folder.write("wide.ifc", in_utf16(house))), HasSubstr("UTF-16"));
    EXPECT_THAT(outcome(folder.write("other.ifc", test::replaced(house, "IFC2X3", "AP214"))), HasSubstr("AP214"));
    EXPECT_THAT(outcome(folder.write("cut.ifc", house.substr(0, house.size() / 2))), HasSubstr("line"));
    EXPECT_NE(outcome(folder.write("text.ifc", std::string(2'000'000, '('))), "");
    EXPECT_NE(outcome(folder.write("zeros.ifc", std::string(2'000'000, '\0'))), "");
    (void)outcome(folder.write("far.ifc", test::replaced(house, "((8.2,", "((1.E308,")));
    (void)outcome(folder.write("circle.ifc", test::replaced(house, "IFCLOCALPLACEMENT($,", "IFCLOCALPLACEMENT(#13,")));
    // A tree of unions in which each node refers to the previous node twice, so the tree has two to the power of 60
    // shapes.
    std::string more;
    for (int i = 0; i < 60; ++i)
        more += fmt::format("#{}=IFCBOOLEANRESULT(.UNION.,#{},#{});\n", 5000 + i, i == 0 ? 24 : 4999 + i,
                            i == 0 ? 24 : 4999 + i);
    more +=
        "#6000=IFCSHAPEREPRESENTATION(#6,'Body','CSG',(#5059));\n#6001=IFCPRODUCTDEFINITIONSHAPE($,$,(#6000));\n"
        "#6002=IFCWALL('9000000000000000000001',$,'tree',$,$,#13,#6001,$);\n";
    (void)outcome(folder.write("tree.ifc", test::with_instances(house, more)));
}

TEST(ImportTorture, rooms_doors_and_walls_in_huge_numbers_are_read_or_refused) {
    const test::TemporaryFolder folder;
    const std::string house = test::small_house();
    const auto copies = [&](const char* kind, int otherwise) {
        const int many = at_length() ? 100'000 : test::scaled(otherwise);
        const std::size_t at = house.find(kind);
        const std::string one = house.substr(at, house.find(';', at) + 1 - at) + "\n";
        std::string more;
        for (int i = 0; i < many; ++i) more += "#" + std::to_string(1'000'000 + i) + one;
        return test::with_instances(house, more);
    };
    EXPECT_EQ(outcome(folder.write("rooms.ifc", copies("=IFCSPACE(", 5'000))), "");
    (void)outcome(folder.write("doors.ifc", copies("=IFCDOOR(", 100)));
    (void)outcome(folder.write("walls.ifc", copies("=IFCWALL(", 100)));
}

TEST(ImportTorture, models_cut_anywhere_are_reported_and_never_become_half_a_building) {
    const fs::path ours = test::project_root() / "tests/unit/ifc/worlds/small_house.ifc";
    for (const fs::path& path :
         test::with_real_worlds({ours}, {"duplex-apartment.ifc", "fzk-haus.ifc", "wall-door-column-ifc4x3.ifc"})) {
        const std::string name = path.filename().string();
        const std::string whole = test::content_of(path);
        const std::size_t step = at_length() ? 997 : 997 * 211;
        for (std::size_t at = 997; at < whole.size() - 20; at += step) {
            const Result<Scene> scene = read_ifc(whole.substr(0, at), "cut.ifc");
            ASSERT_FALSE(scene.has_value()) << name << " cut at " << at;
            ASSERT_FALSE(scene.error().message.empty());
        }
    }
}

TEST(ImportTorture, real_models_and_large_offices_are_read_within_the_limits) {
    // Reads all available models. The report must give a line for each door that nobody can pass. In these models, such
    // doors are French windows with a railing.
    constexpr int kFrenchWindows = 20;
    int shut = 0;
    std::vector<fs::path> models;
    for (const fs::path& one : test::with_real_worlds({}, {"duplex-apartment.ifc"}))
        for (const fs::directory_entry& entry : fs::directory_iterator(one.parent_path()))
            if (entry.path().extension() == ".ifc" || entry.path().extension() == ".ifczip")
                models.push_back(entry.path());
    for (const fs::path& path : models) {
        const Result<ImportedWorld> world = import_world(path, {}, {});
        ASSERT_TRUE(world.has_value()) << path << ": " << world.error().sentence();
        if (!world->scene.stated) continue;
        const HonestReport report = honest_report(world->scene);
        shut += report.doors_impassable;
        int named = 0;
        for (const CheckPoint& point : report.check)
            if (point.what == ToCheck::ImpassableDoor) {
                ++named;
                EXPECT_GT(point.source.line, 0) << path;
            }
        EXPECT_EQ(named, report.doors_impassable) << path;
    }
    EXPECT_LE(shut, kFrenchWindows) << "of " << models.size() << " models";
    const test::TemporaryFolder folder;
    const test::OfficeIfc office = test::office_ifc({2, 2, test::scaled(20), 0});
    const fs::path path = folder.write("office.ifc", office.text);
    const Result<ImportedWorld> world = import_world(path, {}, {});
    ASSERT_TRUE(world.has_value()) << world.error().sentence();
    EXPECT_EQ(static_cast<int>(world->scene.stated->rooms.size()), office.rooms);
    EXPECT_EQ(world->scene.report.doors, office.doors);
    EXPECT_EQ(static_cast<int>(world->scene.stated->windows.size()), office.windows);
    EXPECT_EQ(world->scene.stated->openings_cut, world->scene.stated->openings);
    int joined = 0;
    for (const StatedPortal& portal : world->scene.stated->portals) {
        if (portal.kind != StatedPortalKind::Door) continue;
        EXPECT_TRUE(portal.passable) << portal.source.line;
        EXPECT_FALSE(portal.opened_by_box) << portal.source.line;
        joined += portal.rooms.size() == 2 ? 1 : 0;
    }
    EXPECT_EQ(joined, office.doors - 1) << "all but the front door";
}

}  // namespace torture_test
}  // namespace handrail
