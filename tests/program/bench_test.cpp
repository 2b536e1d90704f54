// Tests the measuring commands: `handrail bench`, which is installed, and the comparison of renderers, which exists
// only in the source tree.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <tuple>

#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace bench_test {

using testing::HasSubstr;

ProgramRun bench(std::vector<std::string> words) {
    ProgramCall call;
    call.program = built_program("handrail");
    call.arguments = std::move(words);
    call.arguments.insert(call.arguments.begin(), "bench");
    return run_program(call);
}

TEST(Bench, reports_servo_timing_in_words_and_as_json) {
    const ProgramRun reported = bench({"--seconds", "0.5"});
    EXPECT_EQ(reported.exit_status, 0) << reported.err;
    EXPECT_THAT(reported.out, HasSubstr("The servo in "));
    EXPECT_THAT(reported.out, HasSubstr(" ticks. From tick to tick at most "));
    const ProgramRun json = bench({"house", "--seconds", "0.5", "--json"});
    ASSERT_EQ(json.exit_status, 0) << json.err;
    const auto found = nlohmann::json::parse(json.out);
    EXPECT_GT(found.at("ticks").get<int>(), 0);
    EXPECT_GT(found.at("tick").at("worst_s").get<double>(), 0.0);
    EXPECT_LE(found.at("tick").at("p50_s").get<double>(), found.at("tick").at("p999_s").get<double>());
    EXPECT_GT(found.at("touching").get<double>(), 0.0) << "the hand met nothing, so the times say little";
}

TEST(Bench, refuses_a_missing_world) {
    EXPECT_EQ(bench({"no such world"}).exit_status, 1);
    EXPECT_EQ(bench({"--seconds", "-1"}).exit_status, 2);
}

TEST(CompareRenderers, writes_tables_and_plots_and_refuses_unknown_scenes_maps_and_renderers) {
    const TemporaryFolder folder;
    const auto run = [&](std::vector<std::string> words) {
        ProgramCall call;
        call.program = built_program("compare_renderers");
        call.arguments = std::move(words);
        const ProgramRun ran = run_program(call);
        return std::tuple(ran.exit_status, ran.out, ran.err);
    };
    const auto [status, out, err] =
        run({"--quick", "--scene", "T11a", "--seconds", "0", "--svg", (folder.path() / "plots").string(), "--markdown",
             (folder.path() / "bench.md").string()});
    EXPECT_EQ(status, 0) << err;
    EXPECT_NE(out.find("T11"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "plots" / "bench-t11.svg"));
    const std::string first = content_of(folder.path() / "bench.md"),
                      families = content_of(folder.path() / "bench-families.md");
    EXPECT_NE(first.find("(bench-families.md)"), std::string::npos) << first;
    EXPECT_NE(first.find("\n## All hard cases together\n"), std::string::npos) << first;
    EXPECT_EQ(first.find("## T11"), std::string::npos) << first;
    EXPECT_EQ(first.find("At a glance"), std::string::npos) << first;
    EXPECT_NE(families.find("\n## At a glance: "), std::string::npos) << families;
    EXPECT_NE(families.find("(bench.md)"), std::string::npos) << families;
    EXPECT_NE(families.find("\n## T11"), std::string::npos) << families;
    EXPECT_EQ(std::get<0>(run({"--scene", "no such scene"})), 1);
    EXPECT_NE(std::get<2>(run({"--scene", "no such scene"})).find("--list"), std::string::npos);
    EXPECT_NE(std::get<0>(run({"--map", "missing.map"})), 0);
    EXPECT_EQ(std::get<0>(run({"--quick", "--scene", "T11a", "--count", "nobody"})), 1);
    EXPECT_NE(std::get<0>(run({"--seconds", "-1"})), 0);
    EXPECT_NE(std::get<1>(run({"--list"})).find("T16a"), std::string::npos);
    const auto [counted, line, nothing] = run({"--quick", "--scene", "T11a", "--count", "penalty_sum"});
    EXPECT_EQ(counted, 0);
    EXPECT_TRUE(line.starts_with("T11a thin wall at 2 m/s\tpenalty_sum\t128\t")) << line;
}

}  // namespace bench_test
}  // namespace handrail::test
