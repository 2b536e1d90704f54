// Tests that no command releases a learner's data without consent, and that no data remain after the learner is
// deleted. The test finds the commands and options in the program's own help, so that it also tries new ones.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "app/record/gzip_pieces.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/scale.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {
namespace learner_data_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kAlias = "Quince Avocet";
constexpr const char* kMark = "quokkamark";

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words;
    for (std::size_t at = line.find_first_not_of(' '); at < line.size();) {
        const std::size_t end = std::min(line.find(' ', at), line.size());
        words.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(' ', end);
    }
    return words;
}

struct FileOption {
    std::string name, ending;
};
struct CommandWithFiles {
    std::string name;
    bool needs_path = false;  // for `touch`, which reads a second file: the hand's path
    std::vector<FileOption> outputs;
};

class LearnerData : public testing::Test {
protected:
    void SetUp() override {
        EXPECT_EQ(run({"learner", "new", kAlias, "--give", "record"}).exit_status, 0);
        const ProgramRun session =
            run({test::bundled_world("house.map"), "--no-window", "--device", "sim-t", "--learner", kAlias},
                std::string("mark\n") + kMark +
                    "\nexits\nescape\nverbosity\nfind\nkitchen\nexits\nescape\nwhere\nwhat\nahead\n");
        EXPECT_EQ(session.exit_status, 0) << session.err;
        for (const auto& entry : fs::recursive_directory_iterator(home_.path()))
            if (entry.path().filename() == "events.jsonl") recording_ = entry.path().parent_path();
        ASSERT_FALSE(recording_.empty());
        own_ = recording_.parent_path().parent_path();
        fs::create_directories(out_);
        // The results of a session for which the program stored nothing else.
        write(own_ / "results.jsonl",
              "{\"begun_utc\":\"2026-11-22T17:30:00Z\",\"lesson\":\"Corridors\",\"world\":\"House\",\"seconds\":60.0,"
              "\"tasks\":[{\"t_s\":30.0,\"kind\":\"learn\",\"name\":\"Kitchen\",\"measures\":{\"time\":12.0}}]}\n");
        // Files in the learner's folder that other commands could read. A person could make them from the learner's
        // data, and nobody expects them in that folder.
        fs::copy_file(test::project_root() / "tests/scenarios/regression_workspace_offset.toml", own_ / "own.toml");
        fs::copy_file(test::bundled_world("first_room.map"), own_ / "own.map");
        write(own_ / "path.csv", "t,x,y,z\n0,0,0,1\n0.001,0,0,1\n");
    }
    static void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }
    ProgramRun run(std::vector<std::string> words, const std::string& input = {}) const {
        ProgramCall call;
        call.program = test::built_program("handrail");
        call.arguments = std::move(words);
        call.input = input;
        call.environment = bare_environment(home_.path().string());
        for (const char* name : {"XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME"}) call.environment[name] = "";
        call.environment["XDG_CONFIG_HOME"] = (home_.path() / ".config").string();
        return run_program(call);
    }
    // Returns the commands that read a file or a folder, with their options that name a file to write.
    std::vector<CommandWithFiles> commands() const {
        std::vector<CommandWithFiles> found;
        bool listed = false;
        for (const std::string& line : lines_of(run({"--help"}).out)) {
            if (line == "Subcommands:") listed = true;
            else if (line.empty()) listed = false;
            else if (listed && line.starts_with("  ") && line[2] != ' ')
                if (CommandWithFiles one = command(words_of(line).front()); !one.outputs.empty())
                    found.push_back(std::move(one));
        }
        return found;
    }
    CommandWithFiles command(const std::string& name) const {
        CommandWithFiles one{name, false, {}};
        const std::string help = run({name, "--help"}).out;
        if (help.find("Arguments:") == std::string::npos) return one;  // the command reads no file given by name
        for (const std::string& line : lines_of(help)) {
            const std::vector<std::string> words = words_of(line);
            if (words.size() < 2 || !words[0].starts_with("--") || words[0] == "--settings") continue;
            const std::string& kind = words[1];
            one.needs_path = one.needs_path || words[0] == "--path";
            if (kind.starts_with("OUT.")) one.outputs.push_back({words[0], kind.substr(3)});
            if (kind == "FOLDER") one.outputs.push_back({words[0], ""});
            if (kind == "FILE") one.outputs.push_back({words[0], words[0] == "--swell" ? ".svg" : ".txt"});
        }
        return one;
    }
    std::vector<std::string> call_of(const CommandWithFiles& command, const fs::path& from) const {
        std::vector<std::string> words = {command.name, from.string()};
        if (command.needs_path) words.insert(words.end(), {"--path", (own_ / "path.csv").string()});
        return words;
    }
    std::string target(const CommandWithFiles& command, const FileOption& option, const fs::path& from) const {
        return (out_ / (command.name + option.name + "-" + from.filename().string() + option.ending)).string();
    }
    std::vector<fs::path> inputs() const { return {recording_, own_ / "own.toml", own_ / "own.map"}; }
    std::vector<std::string> files_out() const {
        std::vector<std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(out_))
            if (entry.is_regular_file()) files.push_back(entry.path().string());
        std::sort(files.begin(), files.end());
        return files;
    }
    // Returns the files below the home folder whose name or content contains `words`, even if the content is
    // compressed.
    std::vector<std::string> files_with(const std::string& words) const {
        std::vector<std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(home_.path())) {
            std::string text = entry.is_regular_file() ? content_of(entry.path()) : std::string();
            if (text.starts_with("\x1f\x8b")) text = gunzip_pieces(text, std::size_t{1} << 30).text;
            if (entry.path().string().find(words) != std::string::npos || text.find(words) != std::string::npos)
                files.push_back(entry.path().string());
        }
        return files;
    }

    TemporaryFolder home_;
    const fs::path out_ = home_.path() / "out";
    fs::path recording_, own_;
};

TEST_F(LearnerData, is_exported_only_with_consent_which_is_noted_and_is_gone_after_deletion) {
    if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "starts the program a hundred times";
    const std::vector<CommandWithFiles> all = commands();
    std::set<std::string> tried;
    for (const CommandWithFiles& command : all)
        for (const FileOption& option : command.outputs)
            for (const fs::path& from : inputs()) {
                tried.insert(command.name + " " + option.name);
                std::vector<std::string> words = call_of(command, from);
                words.insert(words.end(), {option.name, target(command, option, from)});
                EXPECT_NE(run(words).exit_status, 0) << command.name << option.name << " of " << from;
                ASSERT_THAT(files_out(), testing::IsEmpty()) << command.name << option.name << " of " << from;
            }
    EXPECT_NE(run({"report", "--learner", kAlias, "--csv", (out_ / "all.csv").string()}).exit_status, 0);
    EXPECT_THAT(files_out(), testing::IsEmpty());
    for (const char* known : {"replay --csv", "replay --scenario", "report --html", "report --csv", "report --json",
                              "scenario --transcripts", "scenario --junit", "export --swell", "touch --out"})
        EXPECT_TRUE(tried.contains(known)) << known << " is in no help";

    EXPECT_EQ(run({"learner", "consent", kAlias, "--give", "share"}).exit_status, 0);
    // Without the part for browsers, an export with a page writes no file at all.
    const fs::path page_core = test::build_root() / "share" / "handrail" / "page.html";
    for (const CommandWithFiles& command : all)
        for (const fs::path& from : inputs()) {
            std::vector<std::string> words = call_of(command, from);
            for (const FileOption& option : command.outputs)
                if (option.name != "--page" || fs::exists(page_core))
                    words.insert(words.end(), {option.name, target(command, option, from)});
            run(words);
        }
    EXPECT_EQ(run({"report", "--learner", kAlias, "--csv", (out_ / "all.csv").string()}).exit_status, 0);
    const std::vector<std::string> written = files_out();
    const std::string noted = content_of(own_ / "exports.jsonl");
    for (const std::string& file : written) EXPECT_THAT(noted, HasSubstr("\"" + file + "\""));
    for (const char* known : {"all.csv", "all.csv-metadata.json", "hand.csv", "frames.csv", "replay--scenario",
                              "report--html", "report--csv", "report--json", "scenario--transcripts", "scenario--junit",
                              "export--swell", "export--stl", "export--route-card", "touch--out"})
        EXPECT_TRUE(std::any_of(written.begin(), written.end(),
                                [&](const std::string& file) { return file.find(known) != std::string::npos; }))
            << known << " was not written, so nothing was tried";

    const std::string id = own_.filename().string();
    EXPECT_FALSE(files_with(kAlias).empty());
    EXPECT_FALSE(files_with(kMark).empty());
    const ProgramRun deleted = run({"learner", "delete", kAlias, "--yes"});
    EXPECT_EQ(deleted.exit_status, 0) << deleted.out << deleted.err;
    EXPECT_THAT(deleted.out, HasSubstr("Nothing is left"));
    EXPECT_THAT(files_out(), testing::IsEmpty());
    for (const std::string& words : {std::string(kAlias), id, std::string(kMark), std::string("results.jsonl"),
                                     std::string("Corridors"), std::string("2026-11-22")})
        EXPECT_THAT(files_with(words), testing::IsEmpty()) << words;
}

TEST_F(LearnerData, exported_and_then_edited_stays_after_deletion_and_is_reported_as_a_trace) {
    EXPECT_EQ(run({"learner", "consent", kAlias, "--give", "share"}).exit_status, 0);
    const std::string scenario = (out_ / "session.toml").string();
    EXPECT_EQ(run({"replay", recording_.string(), "--scenario", scenario}).exit_status, 0);
    write(scenario, content_of(scenario) + "# mine\n");
    const ProgramRun deleted = run({"learner", "delete", kAlias, "--yes"});
    EXPECT_EQ(deleted.exit_status, 1);
    EXPECT_THAT(deleted.out, HasSubstr("Traces of the learner are left in 1 file.\n" + scenario));
}

TEST_F(LearnerData, is_reported_under_no_other_name) {
    EXPECT_EQ(run({"learner", "consent", kAlias, "--give", "share"}).exit_status, 0);
    EXPECT_EQ(run({"learner", "new", "Fig Finch", "--give", "share"}).exit_status, 0);
    const std::string page = (out_ / "page.html").string();
    const ProgramRun refused = run({"report", recording_.string(), "--learner", "Fig Finch", "--html", page});
    EXPECT_EQ(refused.exit_status, 1);
    EXPECT_THAT(refused.err, HasSubstr(kAlias));
    EXPECT_FALSE(fs::exists(page));
    EXPECT_EQ(run({"report", recording_.string(), "--html", page}).exit_status, 0);
    EXPECT_THAT(content_of(page), HasSubstr(kAlias));
}

}  // namespace learner_data_test
}  // namespace handrail::test
