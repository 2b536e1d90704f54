// Tests the worlds that are shipped with the program. Every command that reads a world must accept their names. The
// worlds must have no fault that would stop a walker. If they are exported as room descriptions, reading these must
// give the same building.
#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace named_worlds_test {
namespace fs = std::filesystem;

using testing::HasSubstr;

ProgramRun run_with(std::vector<std::string> arguments) {
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = std::move(arguments);
    return run_program(call);
}

TEST(NamedWorlds, are_accepted_by_info_and_check_just_as_for_exploring) {
    const ProgramRun by_name = run_with({"info", "house", "--json"}),
                     by_path = run_with({"info", test::bundled_world("house.map"), "--json"});
    ASSERT_EQ(by_name.exit_status, 0) << by_name.err;
    ASSERT_EQ(by_path.exit_status, 0) << by_path.err;
    const auto named = nlohmann::json::parse(by_name.out), pathed = nlohmann::json::parse(by_path.out);
    EXPECT_EQ(named.at("name"), pathed.at("name"));
    EXPECT_EQ(named.at("features"), pathed.at("features"));
    const ProgramRun checked = run_with({"check", "school"});
    EXPECT_EQ(checked.exit_status, 0) << checked.out << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("school.map"));
}

TEST(NamedWorlds, that_do_not_exist_are_reported_as_missing_files) {
    for (const char* command : {"info", "check"}) {
        const ProgramRun run = run_with({command, "hous"});
        EXPECT_EQ(run.exit_status, 1) << command;
        EXPECT_THAT(run.err, HasSubstr("hous")) << command;
    }
}

TEST(BundledWorlds, have_no_fault_that_would_stop_or_mislead_anyone) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "NamedWorlds.* runs the same threads";
    std::size_t worlds = 0;
    for (const fs::directory_entry& file : fs::directory_iterator(test::project_root() / "worlds/maps")) {
        if (file.path().extension() != ".map") continue;
        ++worlds;
        const ProgramRun run = run_with({"check", file.path().string()});
        EXPECT_EQ(run.exit_status, 0) << file.path() << "\n" << run.out << run.err;
    }
    EXPECT_GE(worlds, 6U);
}

// Returns for each room where its doors and openings lead, such as "door Hall", "opening Garden" or "door outside".
std::map<std::string, std::multiset<std::string>> rooms_in(const std::string& text) {
    std::map<std::string, std::multiset<std::string>> rooms;
    const auto name_at = [](const std::string& line, std::size_t at) {
        return line[at] == '"' ? line.substr(at + 1, line.find('"', at + 1) - at - 1)
                               : line.substr(at, line.find_first_of(",", at) - at);
    };
    std::istringstream lines(text);
    std::set<std::string> described;
    std::string room;
    const auto join = [&](const std::string& kind, const std::string& other) {
        rooms[room].insert(kind + " " + other);
        rooms[other].insert(kind + " " + room);
    };
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("Room: ")) {
            room = name_at(line, 6);
            rooms[room];
            EXPECT_TRUE(described.insert(room).second) << "twice: " << room;
        }
        // The room descriptions contain the word "Drop" for an opening at an edge.
        if (line.starts_with("Drop of ")) join("Opening", name_at(line, line.find(" to ") + 4));
        for (const std::string kind : {"Door", "Sliding door", "Opening"}) {
            if (line.starts_with(kind + " outside")) rooms[room].insert(kind + " outside");
            if (line.starts_with(kind + " to ")) join(kind, name_at(line, kind.size() + 4));
        }
    }
    return rooms;
}

TEST(AsWords, written_to_a_file_the_house_is_read_back_with_the_same_rooms_and_doors) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "NamedWorlds.* runs the same threads";
    const ProgramRun written = run_with({"info", "house", "--as-words"});
    ASSERT_EQ(written.exit_status, 0) << written.err;
    const TemporaryFolder folder;
    const fs::path file = folder.write("house.rooms", written.out);
    const ProgramRun reported = run_with({"info", file.string(), "--json"});
    ASSERT_EQ(reported.exit_status, 0) << reported.err;
    const auto facts = nlohmann::json::parse(reported.out);
    EXPECT_EQ(facts.at("name"), "House with a garden");
    const auto rooms = rooms_in(written.out);
    EXPECT_GE(rooms.size(), 12U);
    EXPECT_THAT(rooms, testing::Contains(testing::Key("Kitchen")));
    std::size_t passages = 0;
    for (const auto& [name, leads] : rooms) passages += leads.size();
    EXPECT_GE(passages, 20U) << "each from both its sides";
    const ProgramRun again = run_with({"info", file.string(), "--as-words"});
    ASSERT_EQ(again.exit_status, 0) << again.err;
    EXPECT_EQ(rooms_in(again.out), rooms);
    for (const auto& warning : facts.at("warnings")) ADD_FAILURE() << warning.dump();
}

}  // namespace named_worlds_test
}  // namespace handrail::test
