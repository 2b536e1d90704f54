// Runs the whole program with a real window on a virtual display. The test sends keys and checks the announcements and
// the pixels.
#include <cstdlib>
#include <fstream>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace window_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

bool has_program(const char* name) {
    return std::system(fmt::format("command -v {} >/dev/null 2>&1", name).c_str()) == 0;
}

// A shell script that acts like a person at the window. $1 is the program, $2 a folder for its output and the pictures.
constexpr const char* kScript = R"(
said() { i=0; until grep -q "$1" "$out/said"; do
    i=$((i+1)); [ $i -gt 600 ] && { echo "never said: $1"; kill $pid; exit 9; }; sleep 0.1; done; }
out=$2
"$1" >"$out/said" 2>"$out/errors" &
pid=$!
said "facing north"
tries=0
until timeout 300 xdotool search --onlyvisible --name Handrail windowfocus --sync; do
  tries=$((tries+1)); [ $tries -gt 30 ] && { kill $pid; exit 8; }; sleep 0.5
done
sleep 1; import -window root "$out/first.png"
xdotool key F4; said "Walk: the workspace turns with you"
xdotool key Right; said "North-north-east"
xdotool key Left; sleep 0.5
xdotool key F4; said "Map: north stays up"
xdotool keydown Up; said "North wall, plaster"; sleep 8; xdotool keyup Up
sleep 1; import -window root "$out/wall.png"
xdotool key F3; said "Plan"
sleep 1; import -window root "$out/plan.png"
xdotool key F2; said "plaster, close by"
xdotool key Escape; said "Press Escape again"
xdotool key Escape
wait $pid
)";

// Returns the share of pixels that differ clearly between two pictures, as ImageMagick measures it.
double difference(const fs::path& a, const fs::path& b) {
    const fs::path result = a.parent_path() / "difference";
    (void)!std::system(
        fmt::format("compare -fuzz 10% -metric AE '{}' '{}' null: 2>'{}'", a.string(), b.string(), result.string())
            .c_str());
    double pixels = -1.0;
    std::ifstream(result) >> pixels;
    return pixels / (1024.0 * 768.0);
}

TEST(WindowOfTheProgram, accepts_keys_speaks_and_shows_the_first_person_wall_and_plan_views) {
    for (const char* needed : {"xvfb-run", "xdotool", "import", "compare"})
        if (!has_program(needed)) GTEST_SKIP() << needed << " is not installed";
    const TemporaryFolder folder;
    const fs::path script = folder.path() / "person.sh";
    std::ofstream(script) << kScript;
    ProgramCall call;
    call.program = "/usr/bin/xvfb-run";
    call.arguments = {"-a",
                      "-s",
                      "-screen 0 1024x768x24 -noreset",
                      "sh",
                      script.string(),
                      test::built_program("handrail"),
                      folder.path().string()};
    call.environment["LIBGL_ALWAYS_SOFTWARE"] = "1";
    // Mesa leaks memory. Its driver is unloaded before the sanitizer could suppress the leaks by name.
    call.environment["ASAN_OPTIONS"] = "detect_leaks=0";
    const ProgramRun run = run_program(call);
    std::ifstream said_file(folder.path() / "said");
    const std::string said((std::istreambuf_iterator<char>(said_file)), {});
    ASSERT_EQ(run.exit_status, 0) << run.out << run.err << said;
    EXPECT_THAT(said, HasSubstr("say: Press Escape again to leave."));
    EXPECT_THAT(said, HasSubstr("say: Goodbye."));
    // The picture must differ clearly when the walker has reached the wall, and again when the plan is open.
    EXPECT_GT(difference(folder.path() / "first.png", folder.path() / "wall.png"), 0.05);
    EXPECT_GT(difference(folder.path() / "wall.png", folder.path() / "plan.png"), 0.05);
}

}  // namespace window_test
}  // namespace handrail::test
