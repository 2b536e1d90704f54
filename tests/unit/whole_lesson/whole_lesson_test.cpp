// Tests a lesson from its preparation to the deletion of the learner's last trace, in the bundled school and in a house
// by real architects. An instructor prepares the lesson by keys, and a learner completes its three sessions. The
// program must recognise three kinds of walks, and read its own report back. The recordings must replay with the same
// lines. Finally the learner is deleted. This is scenario 20 of the design.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/core/kept/side_file.h"
#include "app/learners/forget.h"
#include "app/main/world_files.h"
#include "app/record/compute_again.h"
#include "app/report/report_page.h"
#include "tests/support/names.h"
#include "tests/support/real_worlds.h"
#include "tests/support/scale.h"
#include "tests/unit/whole_lesson/lesson_home.h"
#include "worlds/readers/reader.h"

namespace handrail::test {
namespace whole_lesson_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

// The building of the lesson, and the words by which the session announces its places and the test types them.
struct Building {
    fs::path world;
    std::vector<std::string> stops, landmarks;  // beginnings of the entries of these places in the lists
    std::string destination;                    // the last stop of the route
    std::string door, misspelt;  // the door that the instructor blocks at the end, and its name with a typing error
    Vec3 before_m{0.0};          // a place in front of that door
    std::string not_by = {};     // a door that the route with help must avoid; empty: none
    bool base_has_walls = true;
};

class WholeLesson : public LessonHome {
protected:
    void whole(const Building& at);

    // An instructor prepares the lesson by keys. Returns the saved file.
    fs::path prepared(const Building& at) {
        ExploreArguments arguments;
        arguments.world = at.world;
        Sitting sitting(std::move(arguments));
        EXPECT_TRUE(sitting.know_rooms());
        sitting.hurry(false);
        const double begun_s = sitting.now_s();
        for (const std::string& stop : at.stops) {
            sitting.key("Shift+4");
            sitting.type(stop);
            sitting.key("Enter");
        }
        for (const char* key : {"Alt+F9", "End", "Enter", "Enter"}) sitting.key(key);
        for (const std::string& landmark : at.landmarks) {
            sitting.key("Enter");
            sitting.type(landmark);
            sitting.key("Enter");
        }
        for (const char* key : {"Enter", "Enter", "Enter", "Enter"}) sitting.key(key);
        EXPECT_TRUE(sitting.hears("has been saved as")) << sitting.all();
        EXPECT_LT(sitting.keys(), 60);
        EXPECT_LT(sitting.now_s() - begun_s, 300.0);
        RecordProperty("keys", sitting.keys());
        RecordProperty("seconds", static_cast<int>(sitting.now_s() - begun_s));
        const fs::path lessons = lessons_folder();
        std::vector<fs::path> files;
        for (const auto& entry : fs::directory_iterator(lessons)) files.push_back(entry.path());
        EXPECT_EQ(files.size(), 1U);
        return files.empty() ? fs::path() : files[0];
    }

    // The learner follows the walls, which is a task only if the base is in a room. Then the learner points at each
    // landmark.
    void first_session(const Building& at, const fs::path& file) {
        const ExploreArguments arguments = taught(file, 1);
        const TaughtWorld& world = *arguments.lesson->world;
        Sitting sitting(arguments);
        ASSERT_TRUE(sitting.know_rooms());
        ASSERT_TRUE(sitting.hears("This session is being recorded.")) << sitting.all();
        ASSERT_TRUE(sitting.hears(at.base_has_walls ? "Walls, 2 tasks." : "Walls, 1 task.")) << sitting.all();
        if (at.base_has_walls) {
            ASSERT_TRUE(sitting.hears("Get to know")) << sitting.all();
        }
        // Stops following the wall when it leads out of the hall.
        const std::string hall = sitting.app().lesson_view().room;
        for (int i = 0; i < 14 && sitting.app().lesson_view().room == hall; ++i) sitting.hold(Command::TrailRight, 2.0);
        if (sitting.app().lesson_view().room != hall) sitting.key("Home");
        EXPECT_EQ(sitting.app().lesson_view().room, hall);
        sitting.key(at.base_has_walls ? "Alt+Enter" : "Home");
        for (const LessonPlace& landmark : world.lesson().landmarks) {
            ASSERT_TRUE(sitting.hears("Face " + landmark.name)) << sitting.all();
            sitting.face(world.place(landmark.name)->middle_m);
            sitting.key("Alt+Enter");
            ASSERT_TRUE(sitting.hears("That is the right direction.")) << sitting.all();
        }
        ASSERT_TRUE(sitting.hears("Walls is over.")) << sitting.all();
        sitting.live(3.0);
    }

    // The learner walks the route four times, with less help each time.
    void second_session(const Building& at, const fs::path& file) {
        const ExploreArguments arguments = taught(file, 2);
        TaughtWorld& world = *arguments.lesson->world;
        Sitting sitting(arguments);
        ASSERT_TRUE(sitting.know_rooms());
        std::vector<FeatureId> without;
        if (!at.not_by.empty()) without.push_back(*world.door(at.not_by));
        const Route way = world.way(world.base().stand_m, {*world.place(at.destination)}, without);
        ASSERT_TRUE(way.reaches);
        for (const char* help : {"Help: 100 percent", "Help: 60 percent", "Help: 30 percent", "Without help"}) {
            ASSERT_TRUE(sitting.hears(help)) << help << "\n" << sitting.all();
            ASSERT_TRUE(sitting.walk(way.points_m)) << sitting.all();
        }
        ASSERT_TRUE(sitting.hears("Route with help is over.")) << sitting.all();
        sitting.live(3.0);
    }

    // The learner walks without help, while the instructor blocks a door. Then the learner answers the questions.
    void third_session(const Building& at, const fs::path& file) {
        const ExploreArguments arguments = taught(file, 3);
        TaughtWorld& world = *arguments.lesson->world;
        Sitting sitting(arguments);
        ASSERT_TRUE(sitting.know_rooms());
        ASSERT_TRUE(sitting.hears("Without help")) << sitting.all();
        const DeskLine desk;
        ASSERT_TRUE(desk.connected());
        EXPECT_THAT(desk.order(sitting, "block " + at.misspelt), HasSubstr("Did you mean \"" + at.door + "\"?"));
        EXPECT_THAT(desk.order(sitting, "block " + at.door), HasSubstr(" is blocked."));
        EXPECT_THAT(desk.order(sitting, "summary"), HasSubstr("contact"));
        const TaughtPlace before{"before it", at.before_m, {}};
        ASSERT_TRUE(sitting.walk(world.way(world.base().stand_m, {before}).points_m)) << sitting.all();
        sitting.hold(Command::Forward, 0.1);
        const Route round = world.way(sitting.app().feet_m(), {*world.place(at.destination)}, {*world.door(at.door)});
        ASSERT_TRUE(round.reaches);
        ASSERT_TRUE(sitting.walk(round.points_m)) << sitting.all();
        ASSERT_TRUE(sitting.hears("You reached " + at.destination + ".")) << sitting.all();
        for (int i = 0; i < 3; ++i) {
            ASSERT_TRUE(sitting.hears("How far is it to")) << sitting.all();
            sitting.type("20");
            sitting.key("Enter");
        }
        const TaughtSession& alone = world.lesson().sessions[2];
        const auto order = std::find_if(alone.steps.begin(), alone.steps.end(),
                                        [](const TaughtStep& step) { return step.kind == StepKind::Order; });
        const std::size_t places = order == alone.steps.end() ? 0 : order->to.size();
        if (places > 0) {
            ASSERT_TRUE(sitting.hears(fmt::format("Put {} places in order", places))) << sitting.all();
        }
        for (std::size_t i = 1; i < places; ++i)
            for (const char* key : {"Home", "Enter"}) sitting.key(key);
        ASSERT_TRUE(sitting.hears("How sure were you of the route?")) << sitting.all();
        sitting.type("6");
        sitting.key("Enter");
        ASSERT_TRUE(sitting.hears("Alone is over.")) << sitting.all();
        sitting.live(3.0);
    }
};

// ---- walks of one kind, by a swaying person ----

// Walks along both walls in the west of the lower corridor, and across the corridor at the ends. These walls have doors
// and no windows.
void along_walls(Sitting& sitting, TaughtWorld&, Sway& sway, std::uint64_t) {
    for (int lap = 0; lap < 6; ++lap)
        ASSERT_TRUE(sitting.walk({{4.2, 10.62, 0.0}, {11.6, 10.62, 0.0}, {11.6, 8.4, 0.0}, {4.2, 8.4, 0.0}}, &sway));
}

// Walks around a classroom along its walls, past a board and a door. The walker must go around a bookshelf and plant
// pots.
void round_a_classroom(Sitting& sitting, TaughtWorld&, Sway& sway, std::uint64_t) {
    for (int lap = 0; lap < 2; ++lap)
        ASSERT_TRUE(sitting.walk({{7.05, 0.45, 0.0},
                                  {7.05, 1.6, 0.0},
                                  {6.55, 1.7, 0.0},
                                  {6.55, 4.5, 0.0},
                                  {7.05, 4.6, 0.0},
                                  {7.05, 7.55, 0.0},
                                  {0.45, 7.55, 0.0},
                                  {0.45, 6.6, 0.0},
                                  {0.85, 6.5, 0.0},
                                  {0.85, 4.9, 0.0},
                                  {0.45, 4.8, 0.0},
                                  {0.45, 0.45, 0.0}},
                                 &sway));
}

// Walks back and forth through the free half of the assembly hall, in lanes a metre apart.
void in_lanes(Sitting& sitting, TaughtWorld&, Sway& sway, std::uint64_t) {
    bool up = true;
    for (const int lane : {0, 1, 2, 3, 4, 5, 4, 3, 2, 1, 0, 1, 2, 3, 4, 5, 4, 3, 2, 1, 0}) {
        ASSERT_TRUE(sitting.walk({{29.9 + lane, up ? 11.7 : 15.8, 0.0}, {29.9 + lane, up ? 15.8 : 11.7, 0.0}}, &sway));
        up = !up;
    }
}

// Walks from one object of the library to another, at random.
void from_thing_to_thing(Sitting& sitting, TaughtWorld& world, Sway& sway, std::uint64_t seed) {
    const std::vector<std::pair<Vec3, Vec3>> things = {{{16.0, 2.5, 3.4}, {15.3, 2.5, 3.4}},   // shelves
                                                       {{20.0, 2.55, 3.4}, {20.0, 1.6, 3.4}},  // the librarian's desk
                                                       {{18.0, 5.15, 3.4}, {18.0, 4.0, 3.4}},  // the reading table
                                                       {{19.7, 6.1, 3.4}, {20.5, 6.1, 3.4}}};  // cushions
    std::mt19937_64 draw(seed);
    std::size_t at = 0;
    for (int visit = 0; visit < 14; ++visit) {
        at = (at + 1 + draw() % (things.size() - 1)) % things.size();
        const Route way = world.way(sitting.app().feet_m(), {{"", things[at].first, things[at].second}});
        ASSERT_TRUE(way.reaches);
        ASSERT_TRUE(sitting.walk(way.points_m, &sway));
        sitting.face(things[at].second);
        sitting.live(2.0);
    }
}

struct WalkOfAKind {
    Strategy kind;
    Vec3 from_m;
    void (*walk)(Sitting&, TaughtWorld&, Sway&, std::uint64_t seed);
};

// Checks that the program recognises the kind of walk in at least 90 % of the time windows. The walks are part of a
// lesson.
void expect_right_names(const fs::path& lesson_file, const fs::path& world_file) {
    constexpr double kSway_m = 0.05;
    LessonFile lesson = *read_lesson(lesson_file, {world_file.parent_path()});
    TaughtStep free;
    free.kind = StepKind::Free;
    lesson.sessions = {{"Free", 0, false, {}, {free}, 1}};
    const auto found = TaughtWorld::find(lesson, std::make_shared<const Scene>(*read_world(world_file)));
    ASSERT_TRUE(found) << found.error().sentence();
    ExploreArguments arguments;
    arguments.world = world_file;
    Sitting sitting(std::move(arguments));
    ASSERT_TRUE(sitting.know_rooms());
    for (const WalkOfAKind& one : {WalkOfAKind{Strategy::Perimeter, {4.2, 8.4, 0.0}, along_walls},
                                   WalkOfAKind{Strategy::Perimeter, {0.45, 0.45, 0.0}, round_a_classroom},
                                   WalkOfAKind{Strategy::Grid, {29.9, 11.7, 0.0}, in_lanes},
                                   WalkOfAKind{Strategy::ObjectToObject, {18.0, 2.6, 3.4}, from_thing_to_thing}}) {
        double right = 0.0;
        constexpr int kSeeds = 2;
        for (int seed = 1; seed <= kSeeds; ++seed) {
            sitting.app().apply(Placed{one.from_m, 0.0}, sitting.now_s());
            sitting.live(1.0);
            TeachingRun run = begin_lesson(*found, 0, {}, sitting.app());
            sitting.teach(&run);
            sitting.live(0.5);
            Sway sway(kSway_m, static_cast<std::uint64_t>(seed));
            one.walk(sitting, **found, sway, static_cast<std::uint64_t>(seed));
            sitting.teach(nullptr);
            ASSERT_FALSE(testing::Test::HasFatalFailure()) << "kind " << static_cast<int>(one.kind);
            right += run.share_of(one.kind) / kSeeds;
        }
        std::printf("kind %d: %.1f %% of windows right\n", static_cast<int>(one.kind), 100.0 * right);
        EXPECT_GE(right, 0.9) << static_cast<int>(one.kind);
    }
    double square = 0.0;
    for (const double aside_m : sitting.aside_m()) square += aside_m * aside_m;
    const double sway_m = std::sqrt(square / static_cast<double>(sitting.aside_m().size()));
    std::printf("sway: %.3f m\n", sway_m);
    EXPECT_GT(sway_m, 0.8 * kSway_m);
}

// ---- what remains after the lesson ----

double value_of(const std::vector<ResultRow>& rows, const std::string& session, const std::string& task,
                const std::string& measure) {
    for (const ResultRow& row : rows)
        if (row.session == session && row.task.find(task) != std::string::npos && row.measure == measure)
            return row.value;
    ADD_FAILURE() << "session " << session << " has no " << measure << " of " << task;
    return std::nan("");
}

// Checks that a summary line came every ten seconds from the beginning of the lesson, and that one of the lines
// contains `words`. The lesson begins when the session knows the routes.
void expect_summaries(const Recording& recording, const std::string& words) {
    const auto is = [](const RecordedLine& line, const char* act) { return line.json.find(act) != std::string::npos; };
    const auto begun = std::find_if(recording.lines.begin(), recording.lines.end(),
                                    [&](const RecordedLine& line) { return is(line, "\"act\":\"begin\""); });
    ASSERT_NE(begun, recording.lines.end());
    double last_s = begun->t_s;
    int count = 0;
    bool heard = false;
    for (const RecordedLine& line : recording.lines) {
        if (!is(line, "\"act\":\"summary\"")) continue;
        EXPECT_LE(line.t_s - last_s, 10.0 + 0.2);
        last_s = line.t_s;
        ++count;
        EXPECT_TRUE(is(line, "contact")) << line.json;
        heard = heard || is(line, words.c_str());
    }
    EXPECT_GE(count, std::max(3, static_cast<int>((recording.lines.back().t_s - begun->t_s) / 10.0) - 1));
    EXPECT_TRUE(heard) << words;
}

void WholeLesson::whole(const Building& at) {
    const fs::path file = prepared(at);
    ASSERT_FALSE(file.empty());
    Learners learners(user_data_folder());
    const Learner pupil = LessonHome::pupil();

    first_session(at, file);
    ASSERT_FALSE(HasFatalFailure());
    second_session(at, file);
    ASSERT_FALSE(HasFatalFailure());
    third_session(at, file);
    ASSERT_FALSE(HasFatalFailure());

    // The replay must give the same lines in the same order.
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(learners.recordings_of(pupil.id))) folders.push_back(entry.path());
    ASSERT_EQ(folders.size(), 3U);
    std::sort(folders.begin(), folders.end());
    for (const fs::path& folder : folders) {
        const auto recording = read_recording(folder);
        ASSERT_TRUE(recording) << recording.error().sentence();
        EXPECT_TRUE(recording->ended && recording->problems.empty());
        // Under a sanitizer, the test replays only the first recording, because all run the same code.
        if (kSanitizerScale == 1.0 || folder == folders.front()) {
            const auto again = compute_again(*recording, {read_requested});
            ASSERT_TRUE(again) << again.error().sentence();
            EXPECT_THAT(again->remarks, testing::IsEmpty());
            EXPECT_GT(again->said.size(), 20U);
            const auto differs = first_difference(*recording, *again);
            EXPECT_FALSE(differs) << differs->line << "\n" << differs->recorded << "\n" << differs->computed;
        }
        const bool walls = recording->lines.end() !=
                           std::find_if(recording->lines.begin(), recording->lines.end(), [](const RecordedLine& line) {
                               return line.json.find("Walls, 2 tasks.") != std::string::npos ||
                                      line.json.find("Walls, 1 task.") != std::string::npos;
                           });
        expect_summaries(*recording, walls ? "Along the walls." : "contact");
    }

    // Makes the report. Both tables of the report must read back unchanged.
    const fs::path page = home_.path() / "page.html", csv = home_.path() / "results.csv",
                   json = home_.path() / "results.json";
    ReportArguments report;
    report.learner = kPupil;
    report.html = page;
    report.csv = csv;
    report.json = json;
    std::ostringstream out, err;
    ASSERT_EQ(run_report(report, out, err), 0) << err.str();
    const auto rows = read_results_csv(content_of(csv), csv.string()),
               same = read_results_json(content_of(json), json.string());
    ASSERT_TRUE(rows && same);
    EXPECT_EQ(*rows, *same);
    EXPECT_EQ(content_of(csv), results_csv(*rows));
    EXPECT_EQ(content_of(json), results_json(*same));
    if (at.base_has_walls) EXPECT_GT(value_of(*rows, "1", "learn", "walls_percent"), 30.0);
    else
        EXPECT_TRUE(std::none_of(rows->begin(), rows->end(),
                                 [](const ResultRow& row) { return row.measure == "walls_percent"; }));
    EXPECT_LT(value_of(*rows, "1", "point", "pointing_off"), 5.0);
    // Percent of the session's time; the learner spent 28 s along the walls.
    EXPECT_GE(value_of(*rows, "1", "session", "strategy_perimeter"), 20.0);
    const std::string go = " go " + at.destination;
    EXPECT_GT(value_of(*rows, "2", "2" + go, "led_time"), 5.0);
    EXPECT_EQ(value_of(*rows, "2", "5" + go, "led_time"), 0.0);
    for (const char* lap : {"2 go", "3 go", "4 go", "5 go"}) {
        EXPECT_EQ(value_of(*rows, "2", lap, "reached"), 1.0);
        EXPECT_GE(value_of(*rows, "2", lap, "turns_missed"), 0.0);
        EXPECT_GT(value_of(*rows, "2", lap, "path_ratio"), 0.9);  // the lap ends a little before the end of the route
        EXPECT_LT(value_of(*rows, "2", lap, "path_ratio"), 1.5);
    }
    EXPECT_EQ(value_of(*rows, "3", go.substr(1), "reached"), 1.0);
    EXPECT_EQ(value_of(*rows, "3", go.substr(1), "detour"), 1.0);
    EXPECT_GT(value_of(*rows, "3", go.substr(1), "detour_time"), 0.0);
    EXPECT_EQ(value_of(*rows, "3", "ask How sure", "answer"), 6.0);
    for (const char* measure : {"time", "contacts_hand", "help_asked", "pauses", "path_ratio", "turns_missed"})
        value_of(*rows, "3", go.substr(1), measure);
    EXPECT_THAT(content_of(page), HasSubstr("A door was blocked, and you found another route."));

    // No data of the learner may remain, but the instructor's lesson must.
    std::istringstream nobody;
    std::ostringstream deleted;
    EXPECT_EQ(run_learner({.action = "delete", .name = kPupil, .yes = true}, nobody, deleted, err), 0) << err.str();
    EXPECT_THAT(deleted.str(), HasSubstr("no traces found"));
    EXPECT_FALSE(fs::exists(page) || fs::exists(csv) || fs::exists(json));
    const std::vector<std::string> words = {kPupil, pupil.id};
    const std::vector<fs::path> everywhere = {home_.path()};
    const Search search = search_for(words, everywhere);
    EXPECT_THAT(search.hits, testing::IsEmpty());
    EXPECT_GT(search.files, 0U);
    EXPECT_TRUE(fs::exists(file));
}

Building our_school() {
    return {.world = world_folder() / "school.map",
            .stops = {"lower c", "lib"},
            .landmarks = {"trop", "drin", "libr"},
            .destination = "Library",
            .door = "Lift door",
            .misspelt = "Lift dor",
            .before_m = {14.1, 9.8, 0.0},
            // The stairs are as good a route as the lift, and the lesson directs the learner to the stairs. So the
            // route must avoid the lift door.
            .not_by = "Lift door"};
}

TEST_F(WholeLesson, is_prepared_taught_measured_replayed_and_forgotten) { whole(our_school()); }

// The test skips this under sanitizers, which would give the same shares but make the walks too slow.
TEST_F(WholeLesson, recognises_three_kinds_of_walks) {
    if (kSanitizerScale == 1.0) expect_right_names(prepared(our_school()), our_school().world);
}

// The front door is blocked, so the route must lead around the house and in through the terrace.
TEST_F(WholeLesson, in_an_architects_house_works_from_preparation_to_complete_deletion) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "under a sanitizer the lesson in our school is enough";
    const auto file = test::real_world("duplex-apartment.ifc");
    if (!file) GTEST_SKIP() << test::needs_real_world("duplex-apartment.ifc");
    // The test uses a copy of the world, because the program writes the side file next to the world.
    const fs::path copy = home_.path() / file->filename();
    fs::copy_file(*file, copy);
    whole({.world = copy,
           .stops = {"liv"},
           .landmarks = {"sof", "sto", "kit"},
           .destination = "Living Room",
           .door = "door between Foyer and ground outside",
           .misspelt = "door between Foier and ground outside",
           .before_m = {9.2, -16.18, 0.0},
           .base_has_walls = false});
}

// The lesson begins at the main entrance of a faculty with five storeys. Another entrance is around the corner.
TEST_F(WholeLesson, is_taught_in_a_faculty_of_498_rooms_mapped_by_volunteers) {
    if (kSanitizerScale < 1.0) GTEST_SKIP() << "under a sanitizer the lesson in our school is enough";
    const auto file = test::real_world("apb-tu-dresden.osm");
    if (!file) GTEST_SKIP() << test::needs_real_world("apb-tu-dresden.osm");
    const fs::path copy = home_.path() / file->filename();
    fs::copy_file(*file, copy);
    whole({.world = copy,
           .stops = {"foyer"},
           .landmarks = {"e002", "e008", "e023"},
           .destination = "Foyer E100",
           .door = "main entrance",
           .misspelt = "main entrence",
           .before_m = {20.9, 6.4, 0.0}});
}

}  // namespace whole_lesson_test
}  // namespace handrail::test
