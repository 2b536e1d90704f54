// People who type at their pace, with a voice that takes its time in virtual time: what matters is heard, whatever was
// pressed meanwhile.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "app/core/session/headless_session.h"
#include "audio-cues/plan/speakable.h"
#include "tests/support/project_root.h"
#include "tests/unit/heard/heard.h"
#include "worlds/base/language.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace typists_test {

using test::in_full;
using ::testing::IsEmpty;

constexpr double kAfterLastKey_s = 15.0;

std::shared_ptr<const Scene> world(const char* file) {
    auto scene = read_world(test::bundled_world(file));
    if (!scene) throw std::runtime_error(scene.error().sentence());
    return std::make_shared<const Scene>(std::move(*scene));
}

// Presses a key, waits, presses the next.
class Typist {
public:
    Typist(const char* file, double words_per_minute, double pause_s)
        : voice(words_per_minute), pause_s_(pause_s), session_(Settings{}, HandFacts{}, audio_, voice) {
        session_.app().apply(WorldEntered{make_ready(world(file))}, 0.0);
        wait(kAfterLastKey_s);
        entered_s = now_s();
    }
    Session& app() { return session_.app(); }
    double now_s() const { return session_.now_s(); }
    void wait(double seconds) {
        for (const double until_s = now_s() + seconds; now_s() < until_s - 1e-9;) {
            session_.advance();
            for (SessionEvent& event : app().take_events())
                if (const auto* room = std::get_if<RoomEntered>(&event.what))
                    rooms.push_back({event.time_s, room->name});
        }
    }
    void press(Command command, int times = 1) {
        for (int i = 0; i < times; ++i) {
            session_.press(command);
            app().apply(CommandUp{command}, now_s());
            wait(pause_s_);
        }
    }
    void key(const std::string& name) {
        EXPECT_TRUE(session_.tap_key(name)) << name;
        wait(pause_s_);
    }
    void line(const std::string& text) {
        EXPECT_TRUE(app().apply(LineTyped{text}, now_s())) << text;
        wait(pause_s_);
    }
    void stop() { wait(kAfterLastKey_s); }

    // Rooms whose names were not heard while the typist was there, of those left after `stay_s` or later.
    std::vector<std::string> rooms_not_heard(double stay_s) const {
        std::vector<std::string> missing;
        for (std::size_t i = 0; i < rooms.size(); ++i) {
            const double left_s = i + 1 < rooms.size() ? rooms[i + 1].time_s : now_s();
            if (rooms[i].time_s < entered_s || left_s - rooms[i].time_s < stay_s) continue;
            const std::string name = sentence_case(rooms[i].name);
            const auto& lines = voice.lines();
            const bool heard = std::any_of(lines.begin(), lines.end(), [&](const HeardSpeech& said) {
                return said.time_s >= rooms[i].time_s - 0.1 && said.time_s < left_s && in_full(said, now_s()) &&
                       said.utterance.text.find(name) != std::string::npos;
            });
            if (!heard) missing.push_back(fmt::format("{} at {:.1f} s", name, rooms[i].time_s));
        }
        return missing;
    }
    std::string all() const {
        std::string text;
        for (const HeardSpeech& said : voice.lines())
            text += fmt::format("{:7.2f} {:7.2f} {}{}\n", said.time_s, said.end_s,
                                !said.voiced ? "written: "
                                : said.cut   ? "cut: "
                                             : "",
                                said.utterance.text);
        return text;
    }

    struct Entered {
        double time_s;
        std::string name;
    };
    std::vector<Entered> rooms;
    double entered_s = 0.0;
    RecordingSpeech voice;

private:
    RecordingAudio audio_;
    double pause_s_;
    HeadlessSession session_;
};

struct Pace {
    double words_per_minute, pause_s;
};

class Paced : public ::testing::TestWithParam<Pace> {
protected:
    void SetUp() override { ASSERT_TRUE(speak_language("en")); }
};

INSTANTIATE_TEST_SUITE_P(Typists, Paced,
                         ::testing::Values(Pace{180.0, 0.5}, Pace{180.0, 2.0}, Pace{180.0, 4.0}, Pace{180.0, 6.0},
                                           Pace{120.0, 2.0}, Pace{120.0, 0.5}, Pace{350.0, 2.0}, Pace{350.0, 0.5}));

// The first start of the house is in the hall; the rest of the way is asked for leg by leg by who presses keys alone.
TEST_P(Paced, who_walks_through_the_house_hears_rooms_and_the_whole_of_a_route) {
    Typist typist("house.map", GetParam().words_per_minute, GetParam().pause_s);
    typist.press(Command::Routes);
    typist.key("Enter");
    for (int i = 0; i < 6; ++i) {
        typist.press(Command::FaceWay);
        typist.press(Command::Forward, 5);
    }
    typist.press(Command::TurnRight, 3);
    typist.press(Command::Forward, 6);
    typist.stop();
    // A stay that is shorter than two pauses and a name may end before there is a pause at all.
    const double stay_s = GetParam().pause_s < 2.0 ? kAfterLastKey_s : 2.0 * GetParam().pause_s + 3.0;
    EXPECT_THAT(typist.rooms_not_heard(stay_s), IsEmpty()) << typist.all();
    EXPECT_FALSE(typist.rooms.empty());
    EXPECT_THAT(test::unheard(typist.voice, {SpeechTopic::Place, SpeechTopic::Lesson}, typist.now_s()), IsEmpty())
        << typist.all();
    if (typist.app().guide().leads()) {
        EXPECT_THAT(test::unheard(typist.voice, {SpeechTopic::Summary, SpeechTopic::Leg}, typist.now_s()), IsEmpty())
            << typist.all();
    }
    EXPECT_THAT(test::cut_warnings(typist.voice), IsEmpty()) << typist.all();
}

TEST_P(Paced, who_asks_for_a_route_and_walks_on_at_once_hears_how_it_goes) {
    Typist typist("house.map", GetParam().words_per_minute, GetParam().pause_s);
    typist.press(Command::Routes);
    typist.key("Enter");
    typist.press(Command::TurnRight, 4);
    typist.stop();
    ASSERT_TRUE(typist.app().guide().leads());
    EXPECT_THAT(test::unheard(typist.voice, {SpeechTopic::Summary, SpeechTopic::Leg}, typist.now_s()), IsEmpty())
        << typist.all();
    EXPECT_THAT(typist.all(), ::testing::HasSubstr("steps in all"));
}

TEST_P(Paced, who_walks_on_in_the_first_minutes_hears_what_the_next_step_wants) {
    Typist typist("first_room.map", GetParam().words_per_minute, GetParam().pause_s);
    typist.app().apply(FirstMinutesBegun{"a voice", false}, typist.now_s());
    typist.key("Enter");
    typist.press(Command::Forward, 12);
    typist.press(Command::TurnLeft, 4);
    typist.press(Command::Forward, 6);
    typist.stop();
    EXPECT_THAT(test::unheard(typist.voice, {SpeechTopic::Lesson}, typist.now_s()), IsEmpty()) << typist.all();
    EXPECT_THAT(typist.all(), ::testing::HasSubstr("radiator"));
}

TEST_P(Paced, who_walks_towards_an_edge_hears_every_warning_to_its_end) {
    Typist typist("stairs_hall.map", GetParam().words_per_minute, GetParam().pause_s);
    typist.app().apply(Placed{{6.0, 0.0, 0.0}, 0.5 * kPi}, typist.now_s());
    typist.press(Command::Forward, 8);
    typist.press(Command::TurnLeft, 2);
    typist.stop();
    int warnings = 0;
    for (const HeardSpeech& said : typist.voice.lines())
        if (said.voiced && said.utterance.speech_class == SpeechClass::Warning) ++warnings;
    EXPECT_GE(warnings, 1) << typist.all();
    EXPECT_THAT(test::cut_warnings(typist.voice), IsEmpty()) << typist.all();
}

}  // namespace typists_test
}  // namespace handrail
