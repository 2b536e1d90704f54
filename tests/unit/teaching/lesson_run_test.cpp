// Runs lessons in a headless session of the bundled school. There are scripted learners, a learner who walks the route,
// a blocked door, and a second run that must give the same announcements.
#include "app/teaching/lesson_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/core/session/headless_session.h"
#include "app/teaching/desk.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/real_worlds.h"
#include "tests/support/worlds_once.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace lesson_run_test {

const std::filesystem::path kWorlds = test::project_root() / "worlds/maps";

std::shared_ptr<const Scene> scene_of(const char* name) { return test::world_once(kWorlds / name); }
Result<std::shared_ptr<TaughtWorld>> taught(LessonFile lesson, const std::shared_ptr<const Scene>& scene) {
    return TaughtWorld::find(std::move(lesson), scene, {}, &test::rooms_of_this_process);
}
const std::shared_ptr<TaughtWorld>& school() {
    static const std::shared_ptr<TaughtWorld> kWorld =
        *taught(*read_lesson(kWorlds / "school.lesson.toml", {}), scene_of("school.map"));
    return kWorld;
}

// Simulates a learner who walks with a stick, opens closed doors, and hears the announcements.
class Walker20 {
public:
    Walker20(const std::shared_ptr<TaughtWorld>& world, std::size_t session, const HandFacts& hand = {},
             bool hand_is_known = true)
        : world_(world), headless_(Settings{}, hand, audio_, speech_, test::with_known_rooms()) {
        headless_.app().apply(
            WorldEntered{make_ready_at(world->scene(), world->base().stand_m, world->base_heading_rad())}, 0.0);
        run_.emplace(begin_lesson(world, session, {}, headless_.app()));
        for (int i = 0; hand.present && hand_is_known && i < 50; ++i)
            headless_.advance();  // waits until the session knows where the hand is
    }
    TeachingRun& run() { return *run_; }
    HeadlessSession& headless() { return headless_; }
    void live(double seconds) {
        for (const double until_s = headless_.now_s() + seconds; headless_.now_s() < until_s - 1e-9;) {
            if (ms_++ % 100 == 0) teach_on(*run_, headless_.app(), headless_.app().take_events(), headless_.now_s());
            headless_.advance();
        }
    }
    // Walks to the places in turn. Returns true when the learner has reached the last place, or when the lesson has put
    // the walker elsewhere.
    bool walk(const std::vector<Vec3>& places, double at_most_s = 120.0) {
        std::size_t next = 0;
        double stuck_s = 0.0;
        const double until_s = headless_.now_s() + at_most_s;
        while (next < places.size() && headless_.now_s() < until_s) {
            const Vec3 feet = headless_.app().feet_m(), way = places[next] - feet;
            if (std::hypot(way.x, way.y) < 0.25) {
                ++next;
                continue;
            }
            const double off = wrap_angle(std::atan2(way.x, way.y) - headless_.app().heading_rad());
            headless_.app().apply(Steered{{std::abs(off) < 0.3 ? 1.0 : 0.0, 0.0, std::clamp(3.0 * off, -1.0, 1.0)}},
                                  headless_.now_s());
            live(0.02);
            const Vec3 moved = headless_.app().feet_m() - feet;
            const double moved_m = glm::length(moved);
            if (moved_m > 1.0) return true;  // the lesson has moved the walker back
            gone_m_ += std::hypot(moved.x, moved.y);
            stuck_s = std::abs(off) < 0.3 && moved_m < 1e-3 ? stuck_s + 0.02 : 0.0;
            if (stuck_s < 0.5) continue;
            stuck_s = 0.0;
            headless_.app().apply(Steered{}, headless_.now_s());
            headless_.press(Command::Use);
            live(0.1);
            headless_.app().apply(CommandUp{Command::Use}, headless_.now_s());
            live(3.0);
        }
        headless_.app().apply(Steered{}, headless_.now_s());
        return next == places.size();
    }
    // Turns to a heading in degrees from north, and answers "I am done".
    void answer_facing(double heading_deg) {
        headless_.app().apply(Placed{headless_.app().feet_m(), radians_from_degrees(heading_deg)}, headless_.now_s());
        live(0.3);
        answer();
    }
    void answer() {
        headless_.press(Command::TaskDone);
        headless_.app().apply(CommandUp{Command::TaskDone}, headless_.now_s());
        live(0.3);
    }
    // Moves the device's hand to `to_m` in the device's frame. The hand stays there.
    void move_hand(const Vec3& to_m) {
        HandCommand command;
        command.mode = HandMode::Move;
        command.target_m = to_m;
        command.speed_m_per_s = 0.1;
        headless_.hand().command.publish(command);
        live(1.0);
    }
    // Returns the horizontal distance that walk() has covered, as the sum of all its steps.
    double gone_m() const { return gone_m_; }
    bool heard(const std::string& words) const {
        return std::any_of(speech_.lines().begin(), speech_.lines().end(),
                           [&](const auto& one) { return one.utterance.text.find(words) != std::string::npos; });
    }
    std::string all() const {
        std::string text;
        for (const auto& one : speech_.lines()) text += one.utterance.text + "\n";
        return text;
    }

private:
    std::shared_ptr<TaughtWorld> world_;
    RecordingAudio audio_;
    RecordingSpeech speech_;
    HeadlessSession headless_;
    std::optional<TeachingRun> run_;
    int ms_ = 0;
    double gone_m_ = 0.0;
};

TEST(LessonTaught, meets_the_expectations_of_its_pupils_and_speaks_the_same_words_a_second_time) {
    for (const LessonPupil& pupil : school()->lesson().pupils) {
        std::vector<std::vector<std::string>> said;
        for (int time = 0; time < 2; ++time) {
            RecordingAudio audio;
            RecordingSpeech speech;
            const auto outcome =
                run_pupil(school(), pupil, audio, speech, {read_requested}, &test::rooms_of_this_process);
            ASSERT_TRUE(outcome) << outcome.error().sentence();
            said.emplace_back();
            for (const auto& one : speech.lines()) said.back().push_back(one.utterance.text);
            std::string all;
            for (const std::string& line : said.back()) all += line + "\n";
            for (const std::string& failure : outcome->failures) ADD_FAILURE() << pupil.name << ": " << failure << all;
        }
        EXPECT_GT(said[0].size(), 4U);
        EXPECT_EQ(said[0], said[1]);
    }
}

TEST(LessonTaught, reduces_its_help_lap_by_lap_and_measures_the_route) {
    Walker20 pupil(school(), 1);
    pupil.live(1.0);
    const Route way = school()->way(school()->base().stand_m, school()->stops_of(school()->lesson().routes[0]));
    ASSERT_TRUE(way.reaches);
    for (int lap = 0; lap < 4; ++lap) ASSERT_TRUE(pupil.walk(way.points_m)) << pupil.all();
    pupil.live(1.0);
    ASSERT_EQ(pupil.run().results().size(), 4U) << pupil.all();
    for (const TaskResult& lap : pupil.run().results()) {
        EXPECT_EQ(lap.measures.at("reached"), 1.0);
        EXPECT_GT(lap.measures.at("path_ratio"), 0.8);
        EXPECT_LT(lap.measures.at("path_ratio"), 1.3);
        EXPECT_EQ(lap.measures.at("turns_missed"), 0.0);
    }
    EXPECT_GT(pupil.run().results()[0].measures.at("led_time"), 10.0);
    EXPECT_EQ(pupil.run().results()[3].measures.at("led_time"), 0.0);
    for (const char* words : {"Help: 100 percent", "Help: 60 percent", "Help: 30 percent", "Without help"})
        EXPECT_TRUE(pupil.heard(words)) << words << pupil.all();
    EXPECT_TRUE(pupil.run().over());
}

TEST(LessonTaught, blocks_a_door_and_detects_that_the_learner_took_another_route) {
    Walker20 pupil(school(), 2);
    pupil.live(1.0);
    const TaughtPlace lift{"lift", {14.1, 9.8, 0.0}, {}};
    const Route to_lift = school()->way(school()->base().stand_m, {lift});
    const Route shortest =
        school()->way(school()->base().stand_m, {*school()->place("Library")}, {*school()->door("Lift door")});
    ASSERT_TRUE(to_lift.reaches && shortest.reaches);
    ASSERT_TRUE(pupil.walk(to_lift.points_m)) << pupil.all();
    pupil.walk({{14.1, 11.5, 0.0}}, 5.0);
    EXPECT_TRUE(pupil.heard("Lift door is blocked")) << pupil.all();
    EXPECT_LT(pupil.headless().app().feet_m().y, 11.0);
    const Route round =
        school()->way(pupil.headless().app().feet_m(), {*school()->place("Library")}, {*school()->door("Lift door")});
    ASSERT_TRUE(pupil.walk(round.points_m)) << pupil.all();
    const double gone_m = pupil.gone_m();
    pupil.live(1.0);
    ASSERT_FALSE(pupil.run().results().empty()) << pupil.all();
    const TaskResult& lap = pupil.run().results()[0];
    EXPECT_EQ(lap.measures.at("reached"), 1.0);
    EXPECT_EQ(lap.measures.at("detour"), 1.0);
    EXPECT_GT(lap.measures.at("detour_time"), 0.0);
    // The learner walks to the lift and then along the shortest planned detour. The lap ends when the learner is a
    // metre and a half from the stop.
    constexpr double kArrived_m = 1.5;
    const double shortest_m = level_length_m(shortest.points_m) - kArrived_m;
    const double to_lift_m = level_length_m(to_lift.points_m), round_m = level_length_m(round.points_m) - kArrived_m;
    EXPECT_GT((to_lift_m + round_m) / shortest_m, 1.1) << "that was no way round";
    EXPECT_NEAR(lap.measures.at("path_ratio"), (to_lift_m + round_m) / shortest_m, 0.07);
    // The lesson measures the path between places that are a quarter metre apart. So the measured length is up to a
    // thirtieth shorter than the sum of all steps.
    EXPECT_NEAR(lap.measures.at("path_ratio"), gone_m / shortest_m, 0.035);
    pupil.run().end(pupil.headless().now_s());
    pupil.live(1.0);
    EXPECT_TRUE(pupil.run().over());
    EXPECT_NE(pupil.run().summary().find("contact"), std::string::npos) << pupil.run().summary();
}

// Returns a lesson of one session in the bundled school: pointing from the base.
std::shared_ptr<TaughtWorld> pointing_lesson() {
    LessonFile lesson = *read_lesson(kWorlds / "school.lesson.toml", {});
    TaughtStep point;
    point.kind = StepKind::Point;
    point.from = "base";
    point.to = {"Trophy case", "Drinking fountain"};
    point.pass_deg = 30.0;
    lesson.sessions = {{"Points", 0, false, {}, {point}, 1}};
    lesson.pupils.clear();
    const auto found = taught(lesson, school()->scene());
    EXPECT_TRUE(found);
    return *found;
}

double bearing_deg(const TaughtWorld& world, const char* name) {
    const Vec3 way = world.place(name)->middle_m - world.base().stand_m;
    return degrees_from_radians(std::atan2(way.x, way.y));
}

TEST(Pointing, is_correct_within_the_degrees_of_the_lesson_which_are_announced_and_measured) {
    const auto world = pointing_lesson();
    Walker20 pupil(world, 0);
    pupil.live(1.0);
    ASSERT_TRUE(pupil.heard("Face Trophy case")) << pupil.all();
    pupil.answer_facing(bearing_deg(*world, "Trophy case") + 20.0);
    EXPECT_TRUE(pupil.heard("You pointed 20 degrees too far right. Your answer counts.")) << pupil.all();
    pupil.answer_facing(bearing_deg(*world, "Drinking fountain") - 40.0);
    EXPECT_TRUE(pupil.heard("You pointed 40 degrees too far left. To count, it must be within 30 degrees."))
        << pupil.all();
    ASSERT_EQ(pupil.run().results().size(), 1U) << pupil.all();
    EXPECT_EQ(pupil.run().results()[0].measures.at("pointing_passed"), 50.0);
    EXPECT_NEAR(pupil.run().results()[0].measures.at("pointing_off"), 30.0, 0.1);
    EXPECT_TRUE(pupil.run().finished()) << "nobody is held back";
}

TEST(Pointing, in_a_lesson_without_degrees_is_reported_but_not_judged) {
    LessonFile lesson = pointing_lesson()->lesson();
    lesson.sessions[0].steps[0].pass_deg.reset();
    const auto world = *taught(lesson, school()->scene());
    Walker20 pupil(world, 0);
    pupil.live(1.0);
    pupil.answer_facing(bearing_deg(*world, "Trophy case") + 20.0);
    pupil.answer_facing(bearing_deg(*world, "Drinking fountain"));
    EXPECT_TRUE(pupil.heard("You pointed 20 degrees too far right.")) << pupil.all();
    EXPECT_FALSE(pupil.heard("count")) << pupil.all();
    ASSERT_EQ(pupil.run().results().size(), 1U) << pupil.all();
    EXPECT_FALSE(pupil.run().results()[0].measures.contains("pointing_passed"));
}

TEST(Pointing, uses_the_device_hand_if_it_moved_and_otherwise_the_heading) {
    const auto world = pointing_lesson();
    Walker20 pupil(world, 0, HandFacts{true, true, *find_device_spec("sim-t")});
    pupil.live(1.0);
    ASSERT_TRUE(pupil.heard("Face Trophy case")) << pupil.all();
    EXPECT_NEAR(pupil.headless().app().heading_rad(), 0.0, 1e-9) << "the base faces north";
    const double right_rad = radians_from_degrees(bearing_deg(*world, "Trophy case"));
    EXPECT_GT(std::abs(right_rad), radians_from_degrees(25.0)) << "facing alone is another answer";
    pupil.move_hand({0.03 * std::sin(right_rad), 0.03 * std::cos(right_rad), 0.0});
    pupil.answer();
    EXPECT_TRUE(pupil.heard("That is the right direction.")) << pupil.all();
    // The hand no longer moves, so the learner's heading is the answer.
    pupil.answer_facing(bearing_deg(*world, "Drinking fountain") + 12.0);
    EXPECT_TRUE(pupil.heard("You pointed 12 degrees too far right. Your answer counts.")) << pupil.all();
    ASSERT_EQ(pupil.run().results().size(), 1U) << pupil.all();
    EXPECT_EQ(pupil.run().results()[0].measures.at("pointing_passed"), 100.0);
    EXPECT_LT(pupil.run().results()[0].measures.at("pointing_off"), 9.0);
}

TEST(Pointing, is_judged_from_the_place_where_the_question_was_asked) {
    LessonFile lesson = pointing_lesson()->lesson();
    TaughtStep free;
    free.kind = StepKind::Free;
    lesson.sessions[0].steps.insert(lesson.sessions[0].steps.begin(), free);
    const auto world = *taught(lesson, school()->scene());
    Walker20 pupil(world, 0, HandFacts{true, true, *find_device_spec("sim-t")});
    pupil.live(1.0);
    pupil.headless().app().apply(Placed{{4.2, 8.6, 0.0}, 1.0}, pupil.headless().now_s());
    pupil.live(1.0);
    pupil.answer();
    pupil.live(1.0);
    ASSERT_TRUE(pupil.heard("Face Trophy case")) << pupil.all();
    // The hand has not moved, so the learner's heading is the answer: north, as at the base.
    pupil.answer();
    const double off_deg = std::remainder(-bearing_deg(*world, "Trophy case"), 360.0);
    EXPECT_TRUE(
        pupil.heard(fmt::format("{:.0f} degrees too far {}", std::abs(off_deg), off_deg > 0 ? "right" : "left")))
        << off_deg << "\n"
        << pupil.all();
}

TEST(Pointing, also_works_with_a_hand_that_connects_after_the_question) {
    const auto world = pointing_lesson();
    Walker20 pupil(world, 0, {}, false);
    pupil.live(1.0);
    ASSERT_TRUE(pupil.heard("Face Trophy case")) << pupil.all();
    pupil.headless().change_hand(HandFacts{true, true, *find_device_spec("sim-t")});
    pupil.live(0.2);
    const double right_rad = radians_from_degrees(bearing_deg(*world, "Trophy case"));
    pupil.move_hand({0.03 * std::sin(right_rad), 0.03 * std::cos(right_rad), 0.0});
    pupil.answer();
    EXPECT_TRUE(pupil.heard("That is the right direction.")) << pupil.all();
}

// A lesson of one session in the bundled school, in which the learner gets to know the hall.
TEST(Learning, that_ends_at_once_reports_no_progress_and_otherwise_the_progress_in_the_room) {
    LessonFile lesson = *read_lesson(kWorlds / "school.lesson.toml", {});
    TaughtStep learn;
    learn.kind = StepKind::Learn;
    learn.room = "Entrance hall";
    lesson.sessions = {{"Hall", 0, false, {}, {learn, learn}, 1}};
    lesson.pupils.clear();
    const auto world = *taught(lesson, school()->scene());
    Walker20 pupil(world, 0);
    LessonView elsewhere;
    elsewhere.rooms_known = true;
    pupil.run().tick(pupil.headless().now_s(), elsewhere);
    pupil.run().next(pupil.headless().now_s());
    pupil.live(0.5);
    // The learner trails the wall and thereby leaves the hall.
    pupil.headless().press(Command::TrailRight);
    pupil.live(8.0);
    pupil.headless().app().apply(CommandUp{Command::TrailRight}, pupil.headless().now_s());
    pupil.headless().app().apply(Placed{{4.2, 8.6, 0.0}, 0.0}, pupil.headless().now_s());
    pupil.live(0.5);
    pupil.answer();
    ASSERT_EQ(pupil.run().results().size(), 2U) << pupil.all();
    EXPECT_FALSE(pupil.run().results()[0].measures.contains("walls_percent")) << "nobody was in the room";
    EXPECT_GT(pupil.run().results()[1].measures.at("walls_percent"), 2.0);
    EXPECT_TRUE(pupil.run().results()[1].measures.contains("exits_percent"));
}

// The lesson has a base, landmarks, a route with less help in each lap, pointing and a distance. Architects designed
// the house for real use.
TEST(LessonTaught, in_a_real_building_is_walked_measured_and_finished) {
    const auto file = test::real_world("duplex-apartment.ifc");
    if (!file) GTEST_SKIP() << test::needs_real_world("duplex-apartment.ifc");
    const auto lesson = read_lesson_text(R"(handrail_lesson = 1
title = "From the door to the stove"
world = "duplex-apartment.ifc"
base = { feet = [1.5, -4.65, 0.02], heading_deg = 0, name = "Front door" }
[[landmark]]
name = "Sofa"
place_m = [4.0, -3.0, 0.02]
[[landmark]]
name = "Stove"
place_m = [7.5, -5.6, 0.01]
[[route]]
name = "to the stove"
stops = [{ name = "Sofa", place_m = [4.0, -3.0, 0.02] }, { name = "Stove", place_m = [7.5, -5.6, 0.01] }]
[[session]]
name = "House"
[[session.step]]
do = "go"
route = "to the stove"
help_percent = [100, 0]
[[session.step]]
do = "point"
from = "base"
to = ["Sofa"]
[[session.step]]
do = "distance"
from = "base"
to = ["Stove"]
)",
                                         "duplex.lesson.toml", {file->parent_path()});
    ASSERT_TRUE(lesson) << lesson.error().sentence();
    auto scene = read_world(lesson->world);
    ASSERT_TRUE(scene) << scene.error().sentence();
    const auto found = taught(*lesson, std::make_shared<const Scene>(std::move(*scene)));
    ASSERT_TRUE(found) << found.error().sentence();
    const std::shared_ptr<TaughtWorld>& house = *found;
    Walker20 pupil(house, 0);
    pupil.live(1.0);
    const Route way = house->way(house->base().stand_m, house->stops_of(house->lesson().routes[0]));
    ASSERT_TRUE(way.reaches);
    for (int lap = 0; lap < 2; ++lap) ASSERT_TRUE(pupil.walk(way.points_m)) << pupil.all();
    pupil.headless().app().apply(Steered{}, pupil.headless().now_s());
    pupil.live(1.0);
    ASSERT_TRUE(pupil.heard("Face Sofa")) << pupil.all();
    const Vec3 to_sofa = house->place("Sofa")->middle_m - pupil.headless().app().feet_m();
    pupil.answer_facing(degrees_from_radians(std::atan2(to_sofa.x, to_sofa.y)));
    ASSERT_TRUE(pupil.heard("How far is it to Stove")) << pupil.all();
    pupil.headless().app().apply(TextTyped{"9"}, pupil.headless().now_s());
    pupil.headless().tap_key("Enter");
    pupil.live(0.5);
    EXPECT_TRUE(pupil.run().finished()) << pupil.all();
    ASSERT_EQ(pupil.run().results().size(), 4U) << pupil.all();
    for (int lap = 0; lap < 2; ++lap) {
        const auto& measures = pupil.run().results()[static_cast<std::size_t>(lap)].measures;
        EXPECT_EQ(measures.at("reached"), 1.0);
        EXPECT_GT(measures.at("path_ratio"), 0.8);
        EXPECT_LT(measures.at("path_ratio"), 1.3);
    }
    EXPECT_LT(pupil.run().results()[2].measures.at("pointing_off"), 1.0);
    EXPECT_GT(pupil.run().results()[3].measures.at("distance_judged"), 0.3);
}

// The lesson has a route with one stop, as "Prepare a lesson" writes it. At the start, the stop is near the hand or the
// feet.
TEST(LessonTaught, leads_to_a_stop_that_is_near_the_hand_or_feet_from_the_start) {
    LessonFile lesson = *read_lesson(kWorlds / "school.lesson.toml", {});
    const Vec3 base_m = school()->base().stand_m;
    lesson.base_feet_m = base_m;
    lesson.landmarks = {{"Ahead", {}, {}, base_m + Vec3(0.0, 2.0, 0.0), 1}};
    lesson.routes = {{"ahead", {{"Ahead", {}, {}, base_m + Vec3(0.0, 2.0, 0.0), 3}}, 2}};
    TaughtStep learn, go;
    learn.kind = StepKind::Learn;
    learn.room = "Entrance hall";
    go.kind = StepKind::Go;
    go.route = "ahead";
    go.help_percent = {100, 0};
    lesson.sessions = {{"One", 0, false, {}, {learn, go}, 4}};
    lesson.pupils.clear();
    const auto found = taught(lesson, school()->scene());
    ASSERT_TRUE(found) << found.error().sentence();
    const std::shared_ptr<TaughtWorld>& world = *found;
    for (const bool by_hand : {true, false}) {
        Walker20 pupil(world, 0, by_hand ? HandFacts{true, true, *find_device_spec("sim-t")} : HandFacts{});
        pupil.live(1.0);
        if (by_hand) pupil.move_hand({0.0, 0.06, 0.0});
        pupil.run().next(pupil.headless().now_s());
        pupil.live(1.0);
        ASSERT_TRUE(pupil.heard("Go to Ahead")) << pupil.all();
        for (int lap = 0; lap < 2; ++lap) {
            pupil.walk({base_m + Vec3(0.0, 2.0, 0.0)}, 20.0);
            pupil.live(1.0);
        }
        EXPECT_TRUE(pupil.run().finished()) << pupil.all();

        Walker20 led(world, 0, by_hand ? HandFacts{true, true, *find_device_spec("sim-t")} : HandFacts{});
        led.live(1.0);
        led.headless().app().apply(Placed{base_m + Vec3(0.0, 1.5, 0.0), 0.0}, led.headless().now_s());
        EXPECT_EQ(carry_out_order(led.run(), "lead Ahead", led.headless().now_s()),
                  "The learner is being led to Ahead.");
        led.live(2.0);
        EXPECT_TRUE(led.heard("Ahead")) << led.all();
    }
}

TEST(WhoTeaches, gets_the_nearest_name_for_a_missing_thing) {
    Walker20 pupil(school(), 2);
    pupil.live(1.0);
    TeachingRun& run = pupil.run();
    EXPECT_EQ(carry_out_order(run, "lead Trofy case", 1.0),
              "There is no \"Trofy case\" in the lesson or its world. Did you mean \"Trophy case\"?");
    EXPECT_EQ(carry_out_order(run, "lead Lbrary", 1.0),
              "There is no \"Lbrary\" in the lesson or its world. Did you mean \"Library\"?");
    EXPECT_EQ(carry_out_order(run, "block Lift dor", 1.0),
              "No door in this world is called \"Lift dor\". Did you mean \"Lift door\"?");
    EXPECT_EQ(carry_out_order(run, "open Libary door", 1.0),
              "No door in this world is called \"Libary door\". Did you mean \"Library door\"?");
    EXPECT_EQ(carry_out_order(run, "lead Room 4", 1.0), "The learner is being led to Room 4.");
}

TEST(WhoTeaches, blocks_a_door_on_the_route_as_the_lesson_does_but_never_the_last_route) {
    LessonFile lesson = *read_lesson(kWorlds / "school.lesson.toml", {});
    lesson.sessions[2].steps[0].block.clear();
    const auto world = *taught(lesson, school()->scene());
    Walker20 pupil(world, 2);
    pupil.live(1.0);
    EXPECT_EQ(carry_out_order(pupil.run(), "block Library door", pupil.headless().now_s()),
              "With these doors blocked, nobody can complete the route \"Library\".");
    EXPECT_EQ(carry_out_order(pupil.run(), "block Lift door", pupil.headless().now_s()), "Lift door is blocked.");
    const Route round = world->way(world->base().stand_m, {*world->place("Library")}, {*world->door("Lift door")});
    ASSERT_TRUE(pupil.walk(round.points_m)) << pupil.all();
    pupil.live(1.0);
    ASSERT_FALSE(pupil.run().results().empty()) << pupil.all();
    EXPECT_EQ(pupil.run().results()[0].measures.at("detour"), 1.0);
    EXPECT_NEAR(pupil.run().results()[0].measures.at("path_ratio"), 1.0, 0.06);
}

TEST(BlockedDoor, is_avoided_if_another_route_exists_and_otherwise_stays_open) {
    LessonFile lesson = *read_lesson(kWorlds / "school.lesson.toml", {});
    lesson.base_feet_m = Vec3(-1.0, -3.0, 0.0);
    lesson.landmarks = {{"Hall", {}, "Hall", {}, 1}};
    lesson.routes = {{"in", {{"Hall", {}, "Hall", {}, 3}}, 2}};
    TaughtStep go;
    go.kind = StepKind::Go;
    go.route = "in";
    go.block = {"Front door"};
    lesson.sessions = {{"One", 0, false, {}, {go}, 4}};
    lesson.pupils.clear();
    const auto house = scene_of("house.map");
    const auto found = taught(lesson, house);
    ASSERT_TRUE(found) << found.error().sentence();
    TaughtWorld& world = **found;
    const std::vector<TaughtPlace> hall{*world.place("Hall")};
    const Route plain = world.way(world.base().stand_m, hall);
    const Route round = world.way(world.base().stand_m, hall, {*world.door("Front door")});
    ASSERT_TRUE(plain.reaches && round.reaches);
    EXPECT_GT(round.length_m, plain.length_m + 5.0);
    for (const RoutePassage& passage : round.passages) EXPECT_NE(passage.feature, *world.door("Front door"));
    for (const char* room : {"Study", "Bedroom", "Bathroom", "Guest room"}) {
        const std::string door = std::string(room) + " door";
        const Route none = world.way(world.base().stand_m, {*world.place(room)}, {*world.door(door)});
        EXPECT_FALSE(none.reaches) << room;
    }
    lesson.sessions[0].steps[0].block = {"Front door", "Garden door"};
    const auto shut_in = taught(lesson, house);
    ASSERT_FALSE(shut_in);
    EXPECT_NE(shut_in.error().sentence().find("nobody can complete the route"), std::string::npos)
        << shut_in.error().sentence();
}

TEST(LessonInItsWorld, is_refused_if_it_names_things_that_do_not_exist) {
    const LessonFile lesson = *read_lesson(kWorlds / "school.lesson.toml", {});
    const auto refused = [&](LessonFile wrong) {
        const auto found = taught(std::move(wrong), school()->scene());
        return found ? std::string("taken") : found.error().sentence();
    };
    LessonFile wrong = lesson;
    wrong.landmarks[0].thing = "Trophy cas";
    EXPECT_NE(refused(wrong).find("Trophy case"), std::string::npos) << refused(wrong);
    EXPECT_NE(refused(wrong).find("line 7"), std::string::npos) << refused(wrong);
    wrong = lesson;
    wrong.routes[0].stops[0].room = "Lower coridor";
    EXPECT_NE(refused(wrong).find("Lower corridor"), std::string::npos) << refused(wrong);
    wrong = lesson;
    wrong.sessions[2].steps[0].block = {"Lift dor"};
    EXPECT_NE(refused(wrong).find("Lift door"), std::string::npos) << refused(wrong);
    wrong = lesson;
    wrong.sessions[0].steps[1].to = {"Trophy caze"};
    EXPECT_NE(refused(wrong).find("Trophy case"), std::string::npos) << refused(wrong);
}

TEST(LessonInItsWorld, may_request_any_thing_of_the_world_except_under_the_learners_feet) {
    LessonFile lesson = *read_lesson(kWorlds / "school.lesson.toml", {});
    lesson.sessions[0].steps[1].to = {"Lift door"};  // the lift door is neither a landmark nor a stop
    const auto world = taught(lesson, school()->scene());
    ASSERT_TRUE(world) << world.error().sentence();
    ASSERT_TRUE((*world)->place("lift door"));
    EXPECT_FALSE((*world)->place("lift door")->box_m.empty());
    LessonPlace here;
    here.name = "Mat";
    here.place_m = (*world)->base().stand_m;
    lesson.landmarks.push_back(here);
    lesson.sessions[0].steps[1].to = {"Trophy case", "Mat"};
    const auto under_feet = taught(lesson, school()->scene());
    ASSERT_FALSE(under_feet);
    EXPECT_NE(under_feet.error().sentence().find("The learner is standing at \"Mat\""), std::string::npos)
        << under_feet.error().sentence();
    lesson.sessions[0].steps[1].to = {"Trophy case"};
    lesson.sessions[2].steps[2].to = {"Mat", "Trophy case"};
    EXPECT_FALSE(taught(lesson, school()->scene())) << "nobody comes to it on the route";
}

// The reader of a building adds ground around the building. That ground has no walls, so a step that teaches it must
// not require the learner to explore a percentage of its walls.
TEST(LessonInItsWorld, has_no_wall_percentage_outdoors_and_prepares_no_learning_step_there) {
    const auto file = test::project_root() / "tests/fuzz/inputs/ifc/seeds/small_house.ifc";
    const auto scene = test::world_once(file);
    LessonFile lesson = *read_lesson(kWorlds / "school.lesson.toml", {});
    lesson.base_feet_m.reset();
    lesson.landmarks.clear();
    lesson.routes.clear();
    TaughtStep learn;
    learn.kind = StepKind::Learn;
    learn.room = "Living room";
    learn.walls_percent = 90;
    lesson.sessions = {{"Walls", 0, false, {}, {learn}, 1}};
    const auto inside = taught(lesson, scene);
    EXPECT_TRUE(inside) << inside.error().sentence();
    lesson.sessions[0].steps[0].room = "ground outside";
    const auto outside = taught(lesson, scene);
    ASSERT_FALSE(outside);
    EXPECT_NE(outside.error().sentence().find("no walls of its own"), std::string::npos) << outside.error().sentence();
    lesson.sessions[0].steps[0].walls_percent = 0;
    EXPECT_TRUE(taught(lesson, scene)) << "it may be got to know without a number";
}

}  // namespace lesson_run_test
}  // namespace handrail
