// Checks every command that a document shows. Runs commands of the program, with Handrail's worlds in place of the
// reader's files. For a command that runs a test program, checks that the filter matches a test. Scripts, presets and
// labels must exist. A mark in the document, such as "# needs a device", excludes commands that need a device, root or
// the network.
#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/run_program.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace docs_commands_test {
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const fs::path kRoot = test::project_root();

struct DocCommand {
    // `needs` is the text of the mark, such as "a device"; empty if the command has no mark.
    std::string text, where, needs;
};

bool is_command(const std::string& text) {
    static const std::regex kCommand(
        R"re(^([A-Z_]+=\S+ )*(\./run|handrail|build/release/bin/\w+|cmake|ctest|sudo|git|debootstrap|cp|valgrind)re"
        R"re(|tests/[\w/]+\.sh|\.ci/run|docs/\w+\.py|(unit|property|program|voices|window|umockdev)_\w+)( .*|$))re");
    // Lines such as "unit_m = 0.001" are keys in a scenario, and not commands.
    return std::regex_match(text, kCommand) && text.find("cp -") == std::string::npos &&
           !std::regex_search(text, std::regex(R"(^\w+ = )"));
}

// Adds the commands of one page, which are in code lines and between backticks. Inside a table, \| stands for a
// vertical bar.
void add_commands_of(const fs::path& page, std::vector<DocCommand>& all) {
    static const std::regex kSpan("`([^`]+)`"), kMark(R"(^(.*?)\s+# (.*)$)");
    std::istringstream lines(content_of(page));
    int number = 0;
    bool code = false;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        if (line.starts_with("```")) {
            code = !code;
            continue;
        }
        const std::string where = fs::relative(page, kRoot).string() + ":" + std::to_string(number);
        const auto add = [&](std::string text) {
            for (std::size_t at = text.find("\\|"); at != std::string::npos; at = text.find("\\|")) text.erase(at, 1);
            DocCommand command{text, where, {}};
            if (std::smatch mark; std::regex_match(text, mark, kMark)) {
                command.text = mark[1];
                if (const std::string words = mark[2]; words.starts_with("needs ")) command.needs = words.substr(6);
            }
            if (is_command(command.text)) all.push_back(command);
        };
        if (line.starts_with("    ") || code)
            add(line.substr(line.find_first_not_of(' ') == std::string::npos ? line.size()
                                                                             : line.find_first_not_of(' ')));
        else
            for (auto it = std::sregex_iterator(line.begin(), line.end(), kSpan); it != std::sregex_iterator(); ++it)
                add((*it)[1]);
    }
}

std::vector<DocCommand> commands() {
    std::vector<DocCommand> all;
    for (const char* page : {"README.md", "CONTRIBUTING.md", "NEWS.md"}) add_commands_of(kRoot / page, all);
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / "docs"))
        if (entry.path().extension() == ".md") add_commands_of(entry.path(), all);
    return all;
}

// Splits `text` into words as a shell does, and removes quotes and redirections.
Words words_of(const std::string& text) {
    Words words;
    std::string word;
    bool quoted = false, any = false;
    for (const char c : text + " ") {
        if (c == '\'' || c == '"') {
            quoted = !quoted;
            any = true;
        } else if (c == ' ' && !quoted) {
            if (!any && word == ">") return words;
            if ((any || !word.empty()) && word != "</dev/null" && word != ">/dev/null") words.push_back(word);
            word.clear();
            any = false;
        } else {
            word += c;
        }
    }
    return words;
}

std::string all_of(const std::string& ending) {
    std::string text;
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / "tests"))
        if (entry.path().filename() == ending) text += content_of(entry.path());
    return text;
}

// Checks that a test program exists and that its filter matches a test. Returns an empty string, or what is missing.
std::string fault_of_test_program(const std::string& name, const Words& options) {
    static const std::string kLists = all_of("CMakeLists.txt");
    if (!std::regex_search(
            kLists, std::regex(R"((handrail_test|handrail_program|bench_program|add_executable)\()" + name + "\\b")) &&
        name != "handrail")
        return "no program is named " + name;
    const fs::path program = test::built_program(name);
    if (!fs::exists(program)) return {};  // skip the check, because this preset does not build the test program
    for (const std::string& option : options) {
        const bool gtest = option.starts_with("--gtest_filter="), speed = option.starts_with("--benchmark_filter=");
        if (!gtest && !speed) continue;
        ProgramCall call;
        call.program = program.string();
        call.arguments = {option, gtest ? "--gtest_list_tests" : "--benchmark_list_tests=true"};
        const ProgramRun run = run_program(call);
        if (run.exit_status != 0) return name + " cannot list its tests: " + run.err;
        std::istringstream lines(run.out);
        bool any = false;
        for (std::string line; std::getline(lines, line);)
            any = any || (gtest ? line.starts_with("  ") : !line.empty() && line.find(' ') == std::string::npos);
        // Some benchmarks exist only on machines that have certain real maps.
        if (!any && !(speed && !test::real_world("quake-e1m1.map")))
            return name + " has nothing that " + option + " names";
    }
    return {};
}

std::string fault_of_ctest(const Words& words) {
    static const std::string kLists = all_of("CMakeLists.txt");
    static const auto kPresets = nlohmann::json::parse(content_of(kRoot / "CMakePresets.json"));
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
        const std::string &word = words[i], &next = words[i + 1];
        if (word == "--preset") {
            const char* list = words[0] == "ctest"                                               ? "testPresets"
                               : std::find(words.begin(), words.end(), "--build") != words.end() ? "buildPresets"
                                                                                                 : "configurePresets";
            const auto& presets = kPresets.at(list);
            if (std::none_of(presets.begin(), presets.end(), [&](const auto& one) { return one.at("name") == next; }))
                return "there is no preset " + next;
        }
        if (word != "-L" && word != "-R") continue;
        std::istringstream parts(next);
        for (std::string part; std::getline(parts, part, '|');)
            if (kLists.find((word == "-L" ? "LABEL " : "") + part) == std::string::npos &&
                kLists.find("LABELS " + part) == std::string::npos)
                return "nothing in the lists of tests is called " + part;
    }
    return {};
}

// A folder in which the test runs the commands of a document. It contains worlds under the names that the documents
// use.
class Reader {
public:
    Reader() {
        const fs::path maps = kRoot / "worlds" / "maps";
        for (const char* map : {"my-house.map", "MAP", "WORLD", "WELT"}) stand_in(map, maps / "house.map");
        stand_in("FILE", maps / "first_room.map");
        stand_in("school.map", maps / "school.map");
        for (const char* ifc : {"office.ifc", "FILE.ifc"})
            stand_in(ifc, kRoot / "tests" / "unit" / "ifc" / "worlds" / "small_house.ifc");
        for (const char* rooms : {"my-library.rooms", "meine-buecherei.rooms"})
            stand_in(rooms, kRoot / "tests" / "fuzz" / "inputs" / "rooms" / "seeds" / "corners.rooms");
        stand_in("city.osm", kRoot / "tests" / "unit" / "osm" / "worlds" / "test_house.osm");
        fs::create_directories(folder_.path() / "scenarios");
        fs::copy_file(kRoot / "tests" / "scenarios" / "first_contact.toml",
                      folder_.path() / "scenarios" / "first_contact.toml");
        names_["tests/scenarios"] = (folder_.path() / "scenarios").string();
        // Makes a recording for the commands that replay the newest recording or report on it. The answer to "exits"
        // waits until the rooms are known, so "where" has the same answer in a replay.
        const ProgramRun recorded =
            run({"--record", "--no-window", "--device", "none", "house"}, "forward 2\nexits\nwhere\nquit\n");
        EXPECT_EQ(recorded.exit_status, 0) << recorded.err;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / "data"))
            if (entry.path().filename() == "events.jsonl") names_["FOLDER"] = entry.path().parent_path().string();
        EXPECT_TRUE(names_.contains("FOLDER")) << recorded.out;
    }
    ProgramRun run(const Words& arguments, const std::string& input) const {
        ProgramCall call;
        call.program = test::built_program("handrail");
        call.arguments = arguments;
        call.input = input;
        call.environment["XDG_DATA_HOME"] = (folder_.path() / "data").string();
        return run_program(call);
    }
    // If `words` contain the learner whom the documents name, makes that learner. If `words` request a report, the
    // learner gets one recorded session.
    void make_learner_for(const Words& words) const {
        const std::string name = "Maple Heron";
        if (std::find(words.begin(), words.end(), name) == words.end()) return;
        run({"learner", "delete", name, "--yes"}, "");
        if (words[0] == "learner" && words[1] == "new") return;
        run({"learner", "new", name}, "");
        run({"learner", "consent", name, "--give", "remember,record,share"}, "");
        if (words[0] == "report")
            run({"house", "--no-window", "--device", "none", "--learner", name}, "forward 2\nquit\n");
    }
    // Replaces names in a command of a document by files that exist in this folder.
    Words arguments(Words words) const {
        static const std::set<std::string> kWritten{"--swell", "--stl",  "--route-card", "--html",    "--page",
                                                    "--csv",   "--json", "--junit",      "--scenario"};
        const bool json_is_a_file = !words.empty() && words.front() == "report",
                   to_is_a_file = !words.empty() && words.front() == "learner";
        for (std::size_t i = 0; i < words.size(); ++i) {
            std::string& word = words[i];
            const bool written =
                i > 0 && ((kWritten.contains(words[i - 1]) && (words[i - 1] != "--json" || json_is_a_file)) ||
                          (to_is_a_file && words[i - 1] == "--to"));
            if (written)
                word =
                    (folder_.path() / ("written-" + std::to_string(i) + fs::path(word).filename().string())).string();
            else if (const auto stand_in = names_.find(word); stand_in != names_.end()) word = stand_in->second;
            else if (word.find('/') != std::string::npos && fs::exists(kRoot / word)) word = (kRoot / word).string();
        }
        return words;
    }

private:
    void stand_in(const std::string& name, const fs::path& world) {
        ASSERT_TRUE(fs::exists(world)) << world;
        const fs::path copy =
            folder_.path() / (fs::path(name).has_extension() ? name : name + world.extension().string());
        fs::copy_file(world, copy);
        names_[name] = copy.string();
    }
    TemporaryFolder folder_;
    std::map<std::string, std::string> names_;
};

// Checks a command of `./run` or `handrail` in a document. Returns an empty string, or what is wrong.
std::string fault_of_program(const Reader& reader, Words words) {
    static const std::set<std::string> kCommands{"info",  "touch", "scenario", "settings", "calibrate", "devices",
                                                 "bench", "check", "export",   "replay",   "report",    "lesson"};
    const std::string script = content_of(kRoot / "run");
    if (!words.empty() && (words[0] == "tests" || words[0] == "package" || words[0] == "fuzz" || words[0] == "monkey" ||
                           words[0] == "kernel-tests" || words[0] == "test" || words[0] == "page")) {
        if (script.find("\n" + words[0] + ")\n") == std::string::npos) return "./run knows no " + words[0];
        return words[0] == "test" && words.size() > 1
                   ? fault_of_test_program(words[1], Words(words.begin() + 2, words.end()))
                   : "";
    }
    if (words.size() > 1 && words[0] == "bench" && words[1] == "--compare")
        return script.find("\nbench)\n") == std::string::npos ? "./run knows no bench" : "";
    if (!words.empty() && words[0] == "COMMAND") words.erase(words.begin());
    const bool command = !words.empty() && kCommands.contains(words[0]);
    // A lesson goes on for as long as its learner needs, so do not run it. Only look for the options in the command's
    // help.
    if (command && words[0] == "lesson")
        words.erase(std::remove_if(words.begin() + 1, words.end(), [](const auto& w) { return !w.starts_with("-"); }),
                    words.end());
    // If a document shows a command alone or only with options, look for the command and its options in the help.
    const bool named = command && words[0] != "settings" && words[0] != "devices" && words[0] != "calibrate" &&
                       words[0] != "replay" && words[0] != "report" &&
                       std::all_of(words.begin() + 1, words.end(), [](const auto& w) { return w.starts_with("-"); });
    if (named) {
        const ProgramRun help = reader.run({words[0], "--help"}, "");
        if (help.exit_status != 0) return help.err;
        for (std::size_t i = 1; i < words.size(); ++i)
            if (help.out.find(words[i]) == std::string::npos) return words[0] + " has no option " + words[i];
        return {};
    }
    if (command && words[0] == "bench") words.insert(words.end(), {"--seconds", "0.1"});
    if (command && words[0] == "replay" && words.size() == 1) words.insert(words.end(), {"--speed", "4"});
    if (!words.empty()) reader.make_learner_for(words);
    const bool confirms = !words.empty() && words[0] == "learner";
    const ProgramRun run = reader.run(reader.arguments(words), confirms ? "yes\n" : "");
    // Without the part for browsers, the program must say how to build it.
    if (std::find(words.begin(), words.end(), "--page") != words.end() &&
        !fs::exists(test::build_root() / "share" / "handrail" / "page.html"))
        return run.exit_status == 1 && run.err.find("./run page") != std::string::npos ? "" : run.err;
    const bool faults_are_found = command && words[0] == "check";
    if (run.timed_out || (run.exit_status != 0 && !(faults_are_found && run.exit_status == 1)))
        return "status " + std::to_string(run.exit_status) + ": " + run.out.substr(0, 500) + run.err.substr(0, 500);
    return {};
}

// Checks a command. Returns an empty string, or what is wrong. The first word of the command determines the kind of
// check.
std::string fault_of(const Reader& reader, Words words) {
    while (!words.empty() && std::regex_match(words[0], std::regex("[A-Z_]+=.*"))) words.erase(words.begin());
    if (words.empty()) return "nothing is called";
    const std::string first = words[0];
    const Words rest(words.begin() + 1, words.end());
    if (const auto also = std::find(words.begin(), words.end(), "&&"); also != words.end()) {
        const std::string before = fault_of(reader, Words(words.begin(), also));
        return before.empty() ? fault_of(reader, Words(also + 1, words.end())) : before;
    }
    if (first == "./run" || first == "handrail") return fault_of_program(reader, rest);
    if (first == "cmake" || first == "ctest") return fault_of_ctest(words);
    if (first == "valgrind") return fs::exists("/usr/bin/valgrind") ? "" : "valgrind is not installed";
    if (first.starts_with("tests/") || first.starts_with(".ci/") || first.starts_with("docs/")) {
        const auto permissions = fs::exists(kRoot / first) ? fs::status(kRoot / first).permissions() : fs::perms::none;
        return (permissions & fs::perms::owner_exec) == fs::perms::none ? first + " is no program" : "";
    }
    const std::string folder = "build/release/bin/";
    const std::string name = first.starts_with(folder) ? first.substr(folder.size()) : first;
    if (std::regex_match(first, std::regex(R"((build/release/bin/\w+|\w+_\w+))")))
        return fault_of_test_program(name, rest);
    return "it is not known how to try this";
}

TEST(DocumentedCommands, run_as_written_or_state_what_they_need) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the documents are the same under a sanitizer";
    const Reader reader;
    std::map<std::string, std::string> tried;  // maps each command to its fault
    std::size_t marked = 0;
    for (const DocCommand& command : commands()) {
        if (!command.needs.empty()) {
            ++marked;
            EXPECT_TRUE(command.needs == "a device" || command.needs == "root and the network")
                << command.where << ": needs " << command.needs << "?";
            continue;
        }
        const auto [it, is_new] = tried.try_emplace(command.text);
        if (is_new) it->second = fault_of(reader, words_of(command.text));
        EXPECT_EQ(it->second, "") << command.where << ": " << command.text;
    }
    EXPECT_GE(tried.size(), 100U) << "the documents were not understood";
    std::cout << tried.size() << " different commands tried, " << marked << " marked\n";
}

TEST(DocumentedCommands, that_are_wrong_are_detected) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "the documents are the same under a sanitizer";
    const Reader reader;
    for (const char* wrong :
         {"./run nowhere.map", "./run info my-house.map --no-such-option", "handrail export --no-such-option",
          "./run test unit_core --gtest_filter='NoSuchThing.*'", "./run test unit_nothing", "cmake --preset nothing",
          "ctest --preset release -L nothing-of-the-kind", "tests/no_such_script.sh", "./run settings --explian",
          "sudo make me a sandwich"})
        EXPECT_NE(fault_of(reader, words_of(wrong)), "") << wrong;
}

TEST(DocumentedPictures, of_the_house_match_the_output_of_the_command) {
    if (test::kThreadSanitizer) GTEST_SKIP() << "NamedWorlds.* runs the same threads";
    const TemporaryFolder folder;
    ProgramCall call;
    call.program = test::built_program("handrail");
    call.arguments = {"export", (kRoot / "worlds" / "maps" / "house.map").string(), "--swell",
                      (folder.path() / "house-plan.svg").string()};
    const ProgramRun run = run_program(call);
    ASSERT_EQ(run.exit_status, 0) << run.err;
    EXPECT_EQ(content_of(folder.path() / "house-plan.svg"), content_of(kRoot / "docs" / "house-plan.svg"))
        << "./run export worlds/maps/house.map --swell docs/house-plan.svg --force makes it anew";
}

}  // namespace docs_commands_test
}  // namespace handrail::test
