// Tests exports with a disk that fails at any step. Each file must be either the old one or complete. The command must
// write exactly the files that it reports. Whenever it exports a learner's data, a note of the export must be in the
// learner's folder.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <map>
#include <sstream>

#include "app/learners/export_gate.h"
#include "app/learners/exported.h"
#include "app/main/commands.h"
#include "tests/support/environment.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/save_faults/injected.h"
#include "worlds/base/files.h"

namespace handrail {
namespace export_faults_test {

namespace fs = std::filesystem;
using test::BrokenDisk;
using test::TemporaryFolder;
using test::WriteFault;

constexpr const char* kRooms =
    "Building: Two rooms.\n\nHall, 3 by 3 metres. Door outside in the south wall.\nStart in the middle, facing "
    "north.\n\nStudy, 3 by 3 metres, north of Hall. Door to Hall.\n";
constexpr std::array kFiles = {"plate.stl", "ways.txt"};

ExportArguments exports_to(const fs::path& folder) {
    ExportArguments arguments;
    arguments.world = folder / "two.rooms";
    arguments.stl = folder / kFiles[0];
    arguments.route_card = folder / kFiles[1];
    arguments.force = true;
    return arguments;
}

TEST(ExportFaults, each_file_of_a_world_is_the_old_one_or_complete_and_only_complete_ones_are_reported) {
    const TemporaryFolder home;
    const test::WithEnvironment cache("XDG_CACHE_HOME", (home.path() / "cache").c_str()),
        data("XDG_DATA_HOME", (home.path() / "data").c_str());
    home.write("two.rooms", kRooms);
    const ExportArguments arguments = exports_to(home.path());
    std::ostringstream whole_out, whole_err;
    ASSERT_EQ(run_export(arguments, whole_out, whole_err), 0) << whole_err.str();
    std::map<std::string, std::string> whole;
    for (const char* name : kFiles) whole[name] = test::content_of(home.path() / name);

    // Under a sanitizer, the test tries only a few of the steps, because all of them run the same code.
    const long stride = test::kSanitizerScale < 1.0 ? 5 : 1;
    for (const WriteFault fault : {WriteFault::Error, WriteFault::ShortThenError}) {
        int failures = 0;
        long step = 0;
        for (bool struck = true; struck; step += stride) {
            ASSERT_LT(step, 200);
            for (const char* name : kFiles) home.write(name, "old");
            std::ostringstream out, err;
            int status = 0;
            {
                const BrokenDisk broken(fault, step, ENOSPC);
                status = run_export(arguments, out, err);
                struck = BrokenDisk::struck();
            }
            SCOPED_TRACE(testing::Message() << "step " << step);
            bool all_new = true;
            for (const char* name : kFiles) {
                const std::string now = test::content_of(home.path() / name);
                EXPECT_TRUE(now == "old" || now == whole[name]) << name << " is half a file: " << now;
                EXPECT_EQ(now != "old", out.str().find(name) != std::string::npos) << out.str();
                all_new = all_new && now != "old";
            }
            EXPECT_EQ(status, all_new ? 0 : 1) << err.str();
            if (status == 0) continue;
            ++failures;
            EXPECT_THAT(err.str(), testing::HasSubstr("No space left"));
            for (const auto& file : fs::directory_iterator(home.path()))
                EXPECT_TRUE(file.is_directory() || file.path().filename() == "two.rooms" ||
                            whole.contains(file.path().filename().string()))
                    << file.path() << " was left";
        }
        EXPECT_GE(failures, 2) << "each of the files failed at least once";
    }
}

TEST(ExportFaults, exported_files_of_a_learner_are_always_noted_if_they_exist) {
    for (const WriteFault fault : {WriteFault::Error, WriteFault::ShortThenError}) {
        long step = 0;
        for (bool struck = true; struck; ++step) {
            ASSERT_LT(step, 100);
            const TemporaryFolder home;
            const Learners learners(home.path() / "data");
            const auto made = learners.make("Rook", {});
            ASSERT_TRUE(made) << made.error().sentence();
            ASSERT_TRUE(learners.change(made->id, [](Learner& one) {
                one.consent(Purpose::Share) = Consent{today(), {}, {}};
            }));
            const ExportGate way = ExportGate::of(learners, *learners.find("Rook"));
            const fs::path file = home.path() / "report.html";
            bool worked = false;
            {
                const BrokenDisk broken(fault, step, EIO);
                worked = way.write(file, "what was learnt", write_file_atomically).has_value();
                struck = BrokenDisk::struck();
            }
            SCOPED_TRACE(testing::Message() << "step " << step);
            const bool there = fs::exists(file);
            EXPECT_EQ(test::content_of(file), there ? "what was learnt" : "");
            EXPECT_TRUE(there || !worked);
            std::vector<Error> faults;
            const std::vector<Exported> noted = exported_of(learners.folder_of(made->id), faults);
            EXPECT_TRUE(faults.empty());
            EXPECT_TRUE(!there || std::any_of(noted.begin(), noted.end(),
                                              [&](const Exported& one) { return one.file == file && unchanged(one); }));
        }
        EXPECT_GE(step, 6);
    }
}

}  // namespace export_faults_test
}  // namespace handrail
