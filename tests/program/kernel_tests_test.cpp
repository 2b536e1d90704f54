// Runs `./run kernel-tests` on a machine that lacks what these tests need. The command must print one sentence and end
// with the status of a skipped test, never with that of a pass or a failure.
#include "tests/support/precompiled.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace kernel_tests_test {

namespace fs = std::filesystem;

// Runs the command on a simulated machine on which only `programs` are installed.
ProgramRun run_with(const TemporaryFolder& folder, std::initializer_list<const char*> programs) {
    const fs::path bin = folder.path() / "bin";
    fs::create_directories(bin);
    for (const char* program : programs)
        for (const char* from : {"/usr/bin", "/bin"})
            if (fs::exists(fs::path(from) / program) && !fs::exists(bin / program))
                fs::create_symlink(fs::path(from) / program, bin / program);
    ProgramCall call;
    call.program = "/bin/bash";
    call.arguments = {(test::project_root() / "tests/kernel/in_qemu.sh").string(), (folder.path() / "kernel").string(),
                      test::built_program("handrail")};
    call.environment["PATH"] = bin.string();
    return run_program(call);
}

TEST(KernelTests, are_skipped_with_a_message_if_qemu_is_missing) {
    const TemporaryFolder folder;
    const ProgramRun run = run_with(folder, {"bash", "dirname", "mkdir", "uname"});
    EXPECT_EQ(run.exit_status, 77);
    EXPECT_THAT(run.err, testing::HasSubstr("Skipped: QEMU is not installed."));
    EXPECT_THAT(run.err, testing::HasSubstr("apt-get install qemu-system-x86"));
}

TEST(KernelTests, are_skipped_with_a_message_if_no_kernel_can_be_downloaded) {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "bin");
    // These stand-ins only need to exist. Like a static busybox, a shell script is not a dynamically linked program.
    for (const char* name : {"qemu-system-x86_64", "busybox"}) {
        std::ofstream(folder.path() / "bin" / name) << "#!/bin/bash\n";
        fs::permissions(folder.path() / "bin" / name, fs::perms::owner_all);
    }
    const ProgramRun run = run_with(folder, {"bash", "dirname", "mkdir", "uname", "ldd", "sed", "head", "compgen"});
    EXPECT_EQ(run.exit_status, 77) << run.err;
    EXPECT_THAT(run.err, testing::HasSubstr("no kernel can be had"));
}

}  // namespace kernel_tests_test
}  // namespace handrail::test
