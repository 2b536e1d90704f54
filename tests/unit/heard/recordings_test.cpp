// Makes three recordings as a person with headphones would hear them: the first minutes, a walk through five doors with
// a beacon, and a labyrinth. Transcribes each recording by searching it for the voice's own rendering of each line. To
// save the recordings with a list of how much of each line was heard, run:
//   HANDRAIL_WRITE_RECORDINGS=FOLDER build/release/bin/unit_heard --gtest_filter='Recordings.*'
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>

#include "tests/support/heard_legs.h"
#include "tests/support/loudness_meter.h"
#include "tests/support/names.h"
#include "tests/support/scale.h"
#include "tests/unit/heard/recorded.h"
#include "tests/unit/heard/transcript.h"
#include "worlds/base/language.h"

namespace handrail {
namespace recordings_test {

using test::Recorded;

void put(std::ofstream& file, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) file.put(static_cast<char>(value >> (8 * i) & 0xFFU));
}

// Writes a WAV file with 16 bits, two channels and 48 kHz.
void write_wav(const std::filesystem::path& path, const std::vector<float>& both) {
    std::ofstream file(path, std::ios::binary);
    const auto size = static_cast<std::uint32_t>(2 * both.size());
    file << "RIFF";
    put(file, 36 + size, 4);
    file << "WAVEfmt ";
    for (const auto& [value, bytes] :
         {std::pair{16U, 4}, {1U, 2}, {2U, 2}, {48000U, 4}, {192000U, 4}, {4U, 2}, {16U, 2}})
        put(file, value, bytes);
    file << "data";
    put(file, size, 4);
    for (const float s : both)
        put(file, static_cast<std::uint16_t>(std::lround(32767.0F * std::clamp(s, -1.0F, 1.0F))), 2);
    ASSERT_TRUE(file.flush().good()) << path;
}

// Checks that the person heard at least 95 % of the important lines in full, and each text of `must` and each name of a
// room. Checks that the mix stays 3 dB below full scale. `least` is the least number of important lines.
void judge(const Recorded& recorded, const std::string& name, int least, std::vector<test::MustHear> must = {}) {
    // A person who stays in a room for a shorter time may leave it before the voice has had any time to speak.
    constexpr double kStay_s = 7.0;
    const std::vector<test::Transcribed> lines = test::transcribe(recorded);
    const std::string transcript = test::text_of(lines);
    const test::Judged judged = test::judge(lines);
    const test::Measured all = test::measured(recorded.mix(), 2);
    std::cout << fmt::format(
        "    {}: {:.0f} s, {} lines, {} of them matter, {:.0f} % heard in full; true peak {:.1f} dB\n", name,
        static_cast<double>(recorded.mix().size()) / 96000.0, lines.size(), judged.matter, 100.0 * judged.share(),
        all.true_peak_db);
    if (const char* folder = std::getenv("HANDRAIL_WRITE_RECORDINGS"); folder && *folder) {
        write_wav(std::filesystem::path(folder) / (name + ".wav"), recorded.mix());
        std::ofstream(std::filesystem::path(folder) / (name + ".txt")) << transcript;
    }
    EXPECT_GE(judged.matter, least) << transcript;
    EXPECT_GE(judged.share(), 0.95) << transcript << ::testing::PrintToString(judged.missing);
    EXPECT_LT(all.true_peak_db, -3.0);
    for (const auto& more : {recorded.rooms_to_hear(kStay_s), recorded.summaries, recorded.arrivals})
        must.insert(must.end(), more.begin(), more.end());
    EXPECT_THAT(test::never_heard(must, test::spoken(lines)), ::testing::IsEmpty()) << transcript;
}

// Requires that the person hears each of these texts, at whatever time.
std::vector<test::MustHear> texts(const std::vector<std::string>& all) {
    std::vector<test::MustHear> must;
    for (const std::string& text : all) must.push_back({0.0, 1e9, text});
    return must;
}

class Recordings : public ::testing::Test {
protected:
    void SetUp() override {
        if (test::kSanitizerScale < 1.0) GTEST_SKIP() << "minutes of sound take too long to mix under a sanitizer";
        ASSERT_TRUE(speak_language("en"));
    }
    Recorded recorded;
};

TEST_F(Recordings, of_the_first_minutes) {
    recorded.enter("first_room.map");
    recorded.app().apply(FirstMinutesBegun{"its own voice", false}, recorded.now_s());
    recorded.listen();
    recorded.key("Enter");
    recorded.listen();
    // Presses the key `times` times without waiting for the announcements, and then listens until the voice is silent.
    const auto go = [&](Command command, int times) {
        recorded.press(command, times);
        recorded.listen();
    };
    go(Command::Forward, 9);
    go(Command::TurnLeft, 4);
    go(Command::Forward, 4);
    go(Command::TurnRight, 8);
    go(Command::Forward, 9);
    for (const char* key : {"Home", "Down", "Up", "Enter"}) {
        recorded.key(key);
        recorded.listen();
    }
    go(Command::WhereAmI, 1);
    recorded.finish();
    judge(recorded, "first_minutes", 15,
          texts({"Press Up to walk one step at a time", "There is a radiator", "Well done", "Now go the other way",
                 "Corner.", "press Home", "You are back at the door", "What to do next", "Saved."}));
}

// Follows the legs of a route, as the person hears them, until there are no more.
void follow_legs(Recorded& recorded) {
    const test::LegForm form = test::english_legs();
    const auto last_leg = [&](std::size_t from) {
        for (std::size_t i = recorded.lines().size(); i > from; --i)
            if (const auto leg = test::understood(recorded.lines()[i - 1].utterance.text, form)) return leg;
        return std::optional<test::HeardLeg>{};
    };
    std::size_t from = recorded.lines().size();
    recorded.press(Command::RepeatLeg);
    for (int legs = 0; legs < 12; ++legs) {
        recorded.listen();
        const auto leg = last_leg(from);
        if (!leg) return;
        recorded.press(leg->turn_notches > 0 ? Command::TurnRight : Command::TurnLeft, std::abs(leg->turn_notches));
        recorded.press(Command::Forward, leg->steps + (leg->until == test::HeardLeg::Until::Counted ? 0 : 1));
        if (leg->use) recorded.press(Command::Use);
        from = recorded.lines().size();
        recorded.press(Command::NextLeg);
    }
}

// Turns to the beacon and walks towards it, until it falls silent.
void follow_beacon(Recorded& recorded) {
    constexpr double kNotch_rad = kPi / 8.0;
    for (int steps = 0; steps < 20 && recorded.app().guide().beacon().on(); ++steps) {
        const auto& sounds = recorded.sounds();
        const auto beat =
            std::find_if(sounds.rbegin(), sounds.rend(), [](const auto& sound) { return is_beacon(sound.cue.kind); });
        if (beat == sounds.rend()) return;
        const Vec3 to = beat->cue.position_m - beat->listener.ears_m;
        const double right_rad = std::remainder(std::atan2(to.x, to.y) - beat->listener.heading_rad, 2.0 * kPi);
        const int notches = static_cast<int>(std::lround(right_rad / kNotch_rad));
        recorded.press(notches > 0 ? Command::TurnRight : Command::TurnLeft, std::abs(notches));
        recorded.press(Command::Forward);
    }
    recorded.listen();
}

TEST_F(Recordings, of_a_walk_through_five_doors_with_a_beacon) {
    recorded.enter("house.map");
    recorded.press(Command::Exits);  // so that the session knows the rooms from now on
    recorded.listen();
    for (const auto& [room, thing] : {std::pair{"Living room", "Sofa"},
                                      {"Study", "Desk"},
                                      {"Bathroom", "Bath tub"},
                                      {"Utility room", "Washing machine"},
                                      {"Garden", "Apple tree"}}) {
        recorded.type(fmt::format("find {}", thing));
        recorded.key("Enter");  // selects the beacon
        recorded.listen();
        recorded.type(fmt::format("routes {}", room));
        follow_legs(recorded);
        follow_beacon(recorded);
    }
    recorded.finish();
    const std::set<std::string> doors(recorded.doors.begin(), recorded.doors.end());
    EXPECT_GE(doors.size(), 5U) << ::testing::PrintToString(recorded.doors);
    EXPECT_EQ(recorded.summaries.size(), 5U);
    EXPECT_EQ(recorded.arrivals.size(), 10U) << "in each room, and at each thing";
    const test::HeardBeacon beacon = test::heard_beacon(recorded);
    std::cout << fmt::format("    {} doors, {} passages, {} rooms, {} of {} sounds of the beacon heard\n", doors.size(),
                             recorded.doors.size(), recorded.rooms.size(), beacon.heard, beacon.played);
    EXPECT_GE(beacon.played, 50);
    EXPECT_GE(beacon.heard, 0.9 * beacon.played) << "steps and turns may cover some";
    judge(recorded, "five_doors", 40);
}

TEST_F(Recordings, of_a_labyrinth) {
    recorded.enter("labyrinth1.map");
    for (const Command command :
         {Command::Labyrinth, Command::Use, Command::TurnRight, Command::TurnRight, Command::TurnRight,
          Command::TurnRight, Command::TurnRight, Command::Forward, Command::Forward, Command::Forward}) {
        recorded.press(command);
        recorded.listen();
    }
    recorded.finish();
    judge(recorded, "labyrinth", 7, texts({"The goal is", "Ball held", "Ball moved", "Finished in"}));
}

}  // namespace recordings_test
}  // namespace handrail
