// Tests what happens if a person requests a device that is missing, or whose maker's library is missing, incomplete or
// a stand-in. The program must continue or say why it cannot.
#include <nlohmann/json.hpp>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "worlds/confine/confine.h"

namespace handrail::test {
namespace devices_test {

using testing::HasSubstr;
using testing::Not;

ProgramRun run(std::vector<std::string> arguments, const std::filesystem::path& libraries = {}) {
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = std::move(arguments);
    // At the end of the input, the program waits until it has searched for devices; after "quit" it would not wait.
    call.input = "where\n";
    if (!libraries.empty()) call.environment["LD_LIBRARY_PATH"] = libraries.string();
    return run_program(call);
}

TEST(Devices, command_reports_their_absence_in_words_and_as_data) {
    const ProgramRun words = run({"devices"});
    EXPECT_EQ(words.exit_status, 0) << words.err;
    EXPECT_THAT(words.out, HasSubstr("sim-t"));
    const ProgramRun data = run({"devices", "--json"});
    EXPECT_EQ(data.exit_status, 0) << data.err;
    const auto json = nlohmann::json::parse(data.out);
    EXPECT_TRUE(json["devices"].is_array());
    EXPECT_EQ(json["udev_rule"], "70-handrail.rules");
}

// The kernel determines which means can confine a process. If it offers none, the program must say so and continue.
TEST(Devices, command_describes_the_confinement_of_processes_that_handle_files_and_devices) {
    const auto on_old_kernel = [](std::vector<std::string> arguments) {
        ProgramCall call;
        call.program = test::built_program("standin_old_kernel");
        arguments.insert(arguments.begin(), test::built_program("handrail"));
        call.arguments = std::move(arguments);
        const ProgramRun said = run_program(call);
        EXPECT_EQ(said.exit_status, 0) << said.err;
        return said.out;
    };
    const nlohmann::json none{{"seccomp", false}, {"landlock", 0}};
    EXPECT_THAT(on_old_kernel({"devices"}), HasSubstr("neither seccomp nor Landlock"));
    EXPECT_EQ(nlohmann::json::parse(on_old_kernel({"devices", "--json"}))["confinement"], none);
    const std::string house = (test::project_root() / "tests/unit/ifc/worlds/small_house.ifc").string();
    EXPECT_EQ(nlohmann::json::parse(on_old_kernel({"info", "--json", house}))["confinement"], none);

    const Confinement here = confinement_offered();
    EXPECT_THAT(run({"devices"}).out, HasSubstr(confinement_sentence(here)));
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"devices", "--json"}, {"info", "--json", house}}) {
        const auto confinement = nlohmann::json::parse(run(command).out)["confinement"];
        EXPECT_EQ(confinement["seccomp"], here.seccomp);
        EXPECT_EQ(confinement["landlock"], here.landlock);
    }
}

TEST(Devices, udev_rule_for_access_is_installed) {
    const TemporaryFolder prefix;
    ProgramCall call;
    call.program = CMAKE_PROGRAM;
    call.arguments = {"--install", test::build_root().string(), "--prefix", prefix.path().string()};
    const ProgramRun installed = run_program(call);
    ASSERT_EQ(installed.exit_status, 0) << installed.err;
    const std::string rule = content_of(prefix.path() / "lib/udev/rules.d/70-handrail.rules");
    EXPECT_EQ(rule, content_of(test::project_root() / "haptic/drivers/70-handrail.rules"));
    EXPECT_THAT(rule, HasSubstr("uaccess"));
    EXPECT_TRUE(std::filesystem::exists(prefix.path() / "bin/handrail"));
    EXPECT_TRUE(std::filesystem::exists(prefix.path() / "libexec/handrail/handrail-guard"));
    EXPECT_TRUE(std::filesystem::exists(prefix.path() / "libexec/handrail/handrail-reader"));
}

TEST(Devices, an_unplugged_pad_costs_one_sentence) {
    for (const char* name : {"dualsense", "SpaceMouse"}) {
        const ProgramRun said = run({"--no-window", "--device", name});
        EXPECT_EQ(said.exit_status, 0) << said.err;
        EXPECT_THAT(said.out, HasSubstr("Plug it in whenever you like"));
        EXPECT_THAT(said.out, HasSubstr("First room, 6 by 4 metres."));
    }
}

TEST(Devices, an_unplugged_one_is_reported_as_such) {
    for (const char* name : {"falcon", "Omega", "inverse3", "force-stick"}) {
        const ProgramRun said = run({"--no-window", "--device", name});
        EXPECT_EQ(said.exit_status, 1);
        EXPECT_THAT(said.err, HasSubstr("is not plugged in")) << name;
    }
    EXPECT_THAT(run({"--no-window", "--device", "wooden-haptics"}).err, HasSubstr("is not supported yet"));
    EXPECT_THAT(run({"--no-window", "--device", "falcoln"}).err, HasSubstr("Did you mean \"falcon\"?"));
}

TEST(Devices, without_a_working_vendor_library_lose_its_force_and_report_one_sentence) {
    const ProgramRun missing = run({"--no-window", "--device", "touch"});
    EXPECT_EQ(missing.exit_status, 0) << missing.err;
    EXPECT_THAT(missing.out, HasSubstr("libHD.so by 3D Systems is not installed"));
    EXPECT_THAT(missing.out, HasSubstr("First room, 6 by 4 metres.")) << "the program goes on";
    const TemporaryFolder folder;
    std::filesystem::create_symlink(test::built_standin("standin_hd_lacking"), folder.path() / "libHD.so");
    const ProgramRun lacking = run({"--no-window", "--device", "omni"}, folder.path());
    EXPECT_EQ(lacking.exit_status, 0) << lacking.err;
    EXPECT_THAT(lacking.out, HasSubstr("does not contain hdUnschedule"));
    EXPECT_THAT(lacking.out, HasSubstr("First room, 6 by 4 metres."));
}

TEST(Devices, with_a_working_vendor_library_provide_a_hand) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink(test::built_standin("standin_hd"), folder.path() / "libHD.so");
    const ProgramRun played = run({"--no-window", "--device", "omni"}, folder.path());
    EXPECT_EQ(played.exit_status, 0) << played.err;
    EXPECT_THAT(played.out, HasSubstr("First room, 6 by 4 metres."));
    EXPECT_THAT(played.out, Not(HasSubstr("not installed")));
    EXPECT_THAT(played.out, Not(HasSubstr("unplugged")));
}

}  // namespace devices_test
}  // namespace handrail::test
