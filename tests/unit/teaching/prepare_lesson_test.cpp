// Tests an instructor who prepares a lesson in the program, key by key. Then the program teaches the lesson.
#include <gmock/gmock.h>

#include <cctype>

#include "app/core/session/headless_session.h"
#include "app/teaching/taught_world.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/worlds_once.h"

namespace handrail {
namespace prepare_lesson_test {

const std::filesystem::path kSchool = test::project_root() / "worlds/maps/school.map";

class Instructor {
public:
    explicit Instructor(const std::shared_ptr<const Scene>& scene)
        : headless_(Settings{}, HandFacts{}, audio_, speech_, test::with_known_rooms()) {
        headless_.app().apply(WorldEntered{make_ready(scene)}, 0.0);
        live(1.0);
    }
    void key(const std::string& name) {
        ++keys_;
        EXPECT_TRUE(headless_.tap_key(name)) << name;
        live(0.5);
    }
    void keys(const std::string& name, int times) {
        for (int i = 0; i < times; ++i) key(name);
    }
    void type(const std::string& text) {
        for (const char c : text) {
            ++keys_;
            EXPECT_TRUE(headless_.app().apply(TextTyped{std::string(1, c)}, headless_.now_s())) << text;
            live(0.2);
        }
    }
    void request(Command command) {
        headless_.app().apply(CommandDown{command}, headless_.now_s());
        headless_.app().apply(CommandUp{command}, headless_.now_s());
        live(0.2);
    }
    void line(const std::string& text) {
        EXPECT_TRUE(headless_.app().apply(LineTyped{text}, headless_.now_s())) << text;
        live(0.2);
    }
    void live(double seconds) {
        for (const double until_s = headless_.now_s() + seconds; headless_.now_s() < until_s - 1e-9;)
            headless_.advance();
    }
    int pressed() const { return keys_; }
    HeadlessSession& headless() { return headless_; }
    std::string at() { return headless_.app().dialogue().where(); }

private:
    RecordingAudio audio_;
    RecordingSpeech speech_;
    HeadlessSession headless_;
    int keys_ = 0;
};

TEST(PreparingALesson, takes_under_60_keys_and_5_minutes_in_our_school_and_gives_a_teachable_file) {
    const auto scene = test::world_once(kSchool);
    Instructor instructor(scene);
    instructor.request(Command::AskHere);
    instructor.line("Which corridor is this?");
    instructor.line("The lower one");
    // Plans a route to the lower corridor, and from there to the library.
    instructor.key("Shift+4");
    instructor.type("lower c");
    instructor.key("Enter");
    instructor.key("Shift+4");
    instructor.type("lib");
    instructor.key("Enter");
    instructor.key("Alt+F9");
    instructor.key("End");
    instructor.key("Enter");
    EXPECT_NE(instructor.at().find("Put the base here"), std::string::npos) << instructor.at();
    instructor.key("Enter");
    for (const char* landmark : {"trop", "drin", "libr"}) {
        instructor.key("Enter");
        instructor.type(landmark);
        instructor.key("Enter");
    }
    EXPECT_NE(instructor.at().find("Route"), std::string::npos) << instructor.at();
    instructor.keys("Enter", 2);
    EXPECT_NE(instructor.at().find("Save"), std::string::npos) << instructor.at();
    instructor.keys("Enter", 2);
    const auto draft = instructor.headless().app().requests().take_lesson_draft();
    ASSERT_TRUE(draft) << instructor.at();
    EXPECT_LT(instructor.pressed(), 60);
    EXPECT_LT(instructor.headless().now_s(), 300.0);
    RecordProperty("keys", instructor.pressed());
    EXPECT_EQ(draft->landmarks.size(), 3U);
    ASSERT_EQ(draft->stops.size(), 2U) << "all that were chosen one after the other";
    EXPECT_EQ(draft->stops[0].name, "Lower corridor");

    const std::string text = lesson_text(three_sessions(*draft, kSchool));
    const auto lesson = read_lesson_text(text, kSchool.parent_path() / "made.lesson.toml", {});
    ASSERT_TRUE(lesson) << lesson.error().sentence() << text;
    EXPECT_EQ(lesson->sessions.size(), 3U);
    EXPECT_THAT(lesson->sessions[2].steps, testing::Contains(testing::Truly([](const TaughtStep& step) {
                    return step.kind == StepKind::Question && step.say.text == "Which corridor is this?";
                })));
    EXPECT_EQ(lesson->landmarks[0].thing, "Trophy case");
    EXPECT_EQ(lesson->routes[0].stops.back().name, "Library");
    const auto taught = TaughtWorld::find(*lesson, scene);
    ASSERT_TRUE(taught) << taught.error().sentence() << text;
}

TEST(PreparingALesson, saves_no_lesson_without_a_landmark_or_a_route) {
    const auto scene = test::world_once(kSchool);
    Instructor instructor(scene);
    instructor.key("Alt+F9");
    instructor.key("End");
    instructor.key("Enter");
    instructor.key("End");
    instructor.key("Enter");
    EXPECT_FALSE(instructor.headless().app().requests().take_lesson_draft());
    EXPECT_FALSE(instructor.headless().app().dialogue().typing());
    // The list of choices must stay open, so that the next keys operate it and do not move the walker.
    const Vec3 stood = instructor.headless().app().feet_m();
    EXPECT_NE(instructor.at().find("Save"), std::string::npos) << instructor.at();
    instructor.key("Up");
    EXPECT_NE(instructor.at().find("Route"), std::string::npos) << instructor.at();
    instructor.key("Enter");
    EXPECT_NE(instructor.at().find("Route"), std::string::npos) << "no way was planned: " << instructor.at();
    EXPECT_EQ(instructor.headless().app().feet_m(), stood);
}

// The question must list the landmarks in the order of the route, in whatever order the instructor chose them. It must
// never include the landmark at the learner's feet.
TEST(PreparingALesson, queries_the_landmarks_in_the_order_of_the_route) {
    const auto scene = test::world_once(kSchool);
    const auto order_after = [&](const std::vector<const char*>& landmarks) {
        Instructor instructor(scene);
        instructor.key("Shift+4");
        instructor.type("lower c");
        instructor.key("Enter");
        instructor.key("Shift+4");
        instructor.type("lib");
        instructor.key("Enter");
        for (const char* key : {"Alt+F9", "End", "Enter"}) instructor.key(key);
        for (const char* landmark : landmarks) {
            instructor.key("Home");
            for (const char* key : {"Down", "Enter"}) instructor.key(key);
            instructor.type(landmark);
            instructor.key("Enter");
        }
        instructor.key("Home");
        for (const char* key : {"Down", "Down", "Enter", "Enter", "End", "Enter", "Enter"}) instructor.key(key);
        const auto draft = instructor.headless().app().requests().take_lesson_draft();
        EXPECT_TRUE(draft) << instructor.at();
        return draft ? draft->on_route : std::vector<std::string>();
    };
    const std::vector<std::string> there = order_after({"trop", "drin", "library d"});
    EXPECT_GE(there.size(), 2U);
    EXPECT_EQ(order_after({"library d", "drin", "trop"}), there);
    EXPECT_EQ(order_after({"drin", "library d", "trop"}), there);
    EXPECT_EQ(there.back(), "Library door");
}

TEST(PreparingALesson, suggests_no_landmark_that_is_under_the_base) {
    auto standing = std::make_shared<Scene>(*test::world_once(kSchool));
    const auto stands = [&](const Feature& feature) { return feature.name == "Trophy case"; };
    const auto found = std::find_if(standing->features.begin(), standing->features.end(), stands);
    ASSERT_NE(found, standing->features.end());
    const auto base =
        std::find_if(standing->starts.begin(), standing->starts.end(), [](const Start& s) { return s.base; });
    const Vec3 at = (base == standing->starts.end() ? standing->starts.front() : *base).feet_m;
    found->bounds_m = {at - Vec3(0.5, 0.5, 0.1), at + Vec3(0.5, 0.5, 0.0)};
    Instructor instructor(standing);
    for (const char* key : {"Alt+F9", "End", "Enter", "Down", "Enter"}) instructor.key(key);
    instructor.type("trop");
    EXPECT_EQ(instructor.at().find("Trophy"), std::string::npos) << instructor.at();
}

}  // namespace prepare_lesson_test
}  // namespace handrail
