// Compares the session in a page with the session of the program: the same lines in the same order. The core for
// browsers runs in node, and a whole page in Chromium. Both are skipped if ./run page has not built the core.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/core/scenario/scenario_run.h"
#include "app/core/session/headless_session.h"
#include "app/core/world/walker.h"
#include "app/main/page_export.h"
#include "app/page/page_session.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/page/packed_name.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/spoken_language.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/files.h"
#include "worlds/base/typist.h"
#include "worlds/readers/reader.h"
#include "worlds/stored/stored_navigation.h"
#include "worlds/stored/stored_scene.h"

namespace handrail {
namespace page_test {

namespace fs = std::filesystem;

const fs::path kBuilt = test::project_root() / "build" / "page";
const fs::path kHere = test::project_root() / "tests" / "page" / "node";
const fs::path kMaps = test::project_root() / "worlds" / "maps";

constexpr const char* kNotBuilt = "The core for browsers has not been built; ./run page builds it.";

struct Ran {
    std::string out;
    int status = 0;
};
Ran run(const std::string& command) {
    Ran ran;
    FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
    char bytes[4096];
    for (std::size_t n; (n = std::fread(bytes, 1, sizeof bytes, pipe)) > 0;) ran.out.append(bytes, n);
    ran.status = ::pclose(pipe);
    return ran;
}

void write(const fs::path& path, const std::string& content) { std::ofstream(path, std::ios::binary) << content; }

std::shared_ptr<const Scene> world(const std::string& name) {
    auto read = read_world(kMaps / name);
    if (!read) throw std::runtime_error(read.error().sentence());
    return std::make_shared<const Scene>(std::move(*read));
}

std::string rooms_of(const Scene& scene) {
    const WalkerSize size = walker_size(scene, Settings{}.walk.body_radius_m);
    const auto found = Navigation::make(scene, walker_measures(scene, size.radius_m, size.height_m, size.step_up_m));
    const RoomGraph graph = make_rooms(scene, (*found)->space());
    (*found)->let_walls_go();
    return stored_navigation((*found)->space(), graph);
}

// Returns what is said after these lines in a session that reads the world as the program does.
std::string said_by_program(const std::shared_ptr<const Scene>& scene, const std::vector<std::string>& lines) {
    RecordingAudio audio;
    RecordingSpeech speech;
    HeadlessSession session({}, {}, audio, speech);
    session.app().apply(WorldEntered{make_ready(scene)}, 0.0);
    for (const std::string& line : lines) session.type(line);
    for (int quiet = 0; quiet < 1000; ++quiet) {
        session.advance();
        if (!session.lines().done() || !session.app().idle()) quiet = 0;
    }
    std::string said;
    for (const HeardSpeech& line : speech.lines()) said += line.utterance.text + "\n";
    return said;
}

const std::vector<std::string> kEnglish = {
    "where am i", "look",      "look",     "around",      "ahead",     "exits",      "forward 3",
    "left",       "forward 2", "where",    "rooms",       "down",      "escape",     "what is here",
    "describe",   "enter",     "overview", "storeys",     "escape",    "mark",       "My place",
    "marks",      "escape",    "heading",  "coordinates", "help",      "unexplored", "progress",
    "menu",       "down 3",    "escape",   "nonsense",    "repeat",    "trail-left", "leap-next",
    "square",     "find",      "2",        "escape",      "verbosity", "lost",       "sounds",
    "undo"};
const std::vector<std::string> kGerman = {"wo bin ich", "umsehen", "ausgänge",  "vor 3",      "links",  "routen",
                                          "runter",     "escape",  "überblick", "stockwerke", "escape", "hilfe"};

// "house.map", in this language
struct Visit {
    const char* world;
    const char* language;
};
class Visits : public ::testing::TestWithParam<Visit> {};
INSTANTIATE_TEST_SUITE_P(Of, Visits,
                         ::testing::Values(Visit{"house.map", "en"}, Visit{"house.map", "de"},
                                           Visit{"school.map", "en"}, Visit{"school.map", "de"}),
                         [](const auto& row) { return std::string(row.param.world, 5) + "_" + row.param.language; });

TEST_P(Visits, give_the_same_lines_in_a_page) {
    const test::InLanguage language(GetParam().language);
    speak_to_typist(true);
    const auto scene = world(GetParam().world);
    const std::vector<std::string>& lines = std::string(GetParam().language) == "de" ? kGerman : kEnglish;
    const std::string expected = said_by_program(scene, lines);
    EXPECT_GT(std::count(expected.begin(), expected.end(), '\n'), static_cast<long>(lines.size()) / 2);

    // The same class as in the page, compiled for this machine.
    auto page = PageSession::begin(stored::stored(*scene), rooms_of(*scene));
    ASSERT_TRUE(page) << page.error().sentence();
    for (const std::string& line : lines) (*page)->session().type(line);
    for (int quiet = 0; quiet < 1000; quiet += 10)
        if ((*page)->advance(10)) quiet = 0;
    std::string said;
    for (const auto& line : nlohmann::json::parse((*page)->take_said())) said += line["text"].get<std::string>() + "\n";
    EXPECT_EQ(said, expected);
    speak_to_typist(false);

    if (!fs::exists(kBuilt / "bin" / "page_node.js")) GTEST_SKIP() << kNotBuilt;
    const test::TemporaryFolder folder;
    write(folder.path() / "scene", stored::stored(*scene));
    write(folder.path() / "navigation", rooms_of(*scene));
    std::string script;
    for (const std::string& line : lines) script += line + "\n";
    write(folder.path() / "script", script);
    const Ran ran = run(fmt::format("node '{}' '{}' lines '{}' '{}' {} '{}'", (kHere / "run.js").string(),
                                    (kBuilt / "bin" / "page_node.js").string(), (folder.path() / "scene").string(),
                                    (folder.path() / "navigation").string(), GetParam().language,
                                    (folder.path() / "script").string()));
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.out, expected);
}

std::vector<std::string> all_scenarios() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(test::project_root() / "tests" / "scenarios"))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

// Writes each world that a scenario reads, so that the core in node can read it without our readers.
WorldReader packing_reader(const fs::path& folder) {
    return {[folder](const WorldRequest& request) {
        Result<Scene> scene = read_requested(request);
        if (scene) write(folder / test::packed_name(request), stored::stored(*scene));
        return scene;
    }};
}

class Scenarios : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(All, Scenarios, ::testing::ValuesIn(all_scenarios()),
                         [](const auto& row) { return "of_" + row.param; });

TEST_P(Scenarios, give_the_same_lines_at_the_same_times_in_a_page) {
    if (!fs::exists(kBuilt / "bin" / "page_node.js")) GTEST_SKIP() << kNotBuilt;
    const fs::path folder = test::project_root() / "tests" / "scenarios", file = folder / (GetParam() + ".toml");
    const auto scenario = read_scenario(file, {kMaps, folder / "worlds"});
    ASSERT_TRUE(scenario) << scenario.error().sentence();
    const test::TemporaryFolder packed;
    const WorldReader reader = packing_reader(packed.path());
    auto scene = reader.scene(scenario->world);
    ASSERT_TRUE(scene) << scene.error().sentence();
    RecordingAudio audio;
    RecordingSpeech speech;
    const auto log = run_scenario(*scenario, std::make_shared<const Scene>(std::move(*scene)), audio, speech, reader);
    ASSERT_TRUE(log) << log.error().sentence();
    std::string expected;
    for (const HeardSpeech& line : speech.lines())
        expected += fmt::format("{:.3f} {}\n", line.time_s, line.utterance.text);
    const Ran ran = run(fmt::format("node '{}' '{}' scenario '{}' '{}' '{}'", (kHere / "run.js").string(),
                                    (kBuilt / "bin" / "page_node.js").string(), file.string(), kMaps.string(),
                                    packed.path().string()));
    EXPECT_EQ(ran.status, 0);
    EXPECT_EQ(ran.out, expected);
}

std::string house_page(const std::string& core) {
    const auto scene = world("house.map");
    const WalkerSize size = walker_size(*scene, Settings{}.walk.body_radius_m);
    const auto found = Navigation::make(*scene, walker_measures(*scene, size.radius_m, size.height_m, size.step_up_m));
    const RoomGraph graph = make_rooms(*scene, (*found)->space());
    (*found)->let_walls_go();
    return page_of(core, *scene, graph, (*found)->space());
}

TEST(PageOfTheHouse, is_filled_in_where_the_core_has_marks) {
    const std::string page = house_page("<html lang=\"@LANGUAGE@\">@TITLE@ a@b @PLAIN@");
    EXPECT_TRUE(page.starts_with("<html lang=\"en\">")) << page;
    EXPECT_NE(page.find(" a@b <h2>"), std::string::npos) << page;
    EXPECT_NE(page.find("<li>Kitchen, "), std::string::npos) << page;
    EXPECT_NE(page.find("joined to "), std::string::npos) << page;
}

TEST(PageOfTheHouse, works_in_chromium_from_the_disk) {
    if (!fs::exists(kBuilt / "page.html")) GTEST_SKIP() << kNotBuilt;
    if (run("command -v chromium").status != 0) GTEST_SKIP() << "There is no Chromium here.";
    const test::TemporaryFolder folder;
    const std::string page = house_page(*read_whole_file(kBuilt / "page.html", 64U << 20));
    EXPECT_LT(page.size(), 6'000'000U);
    write(folder.path() / "house.html", page);
    const Ran ran = run(fmt::format("node '{}' chromium '{}'", (kHere / "browser.js").string(),
                                    (folder.path() / "house.html").string()));
    EXPECT_EQ(ran.status, 0) << ran.out;
}

}  // namespace page_test
}  // namespace handrail
