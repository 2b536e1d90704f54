// Plays the first minute of a session from its scenario, and compares it with README.md, which shows that minute. If
// HANDRAIL_WRITE_TRANSCRIPTS is set, writes the page instead.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>

#include "app/core/scenario/scenario_run.h"
#include "audio-cues/plan/sound_table.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace first_contact_test {

const std::filesystem::path kRoot = test::project_root();

// Describes a person's action in words; empty while the person listens.
std::string deed_of(const ScenarioStep& step) {
    const auto key = [](Command command) {
        const std::string keys(info(command).key);
        return keys.substr(0, keys.find(' '));
    };
    if (const auto* tap = std::get_if<TapCommand>(&step)) return "press " + key(tap->command);
    if (const auto* hold = std::get_if<HoldCommand>(&step))
        return fmt::format("hold {} for {} seconds", key(hold->command), hold->for_s);
    return {};
}

// Returns the name of a sound, such as "footstep on tile" or "wall tone".
std::string name_of(const SoundCue& cue) {
    const std::string name(info(cue.kind).name);
    return cue.material == SoundClass::Generic ? name : name + " on " + std::string(material_sound_name(cue.material));
}

// Describes an action and what happens until the next one, for example: "0:23 You hold Up for 3 seconds. Heard:
// footstep on wood, twice; knock. Said: North wall."
std::string paragraph(const std::string& deed, double from_s, double to_s, const RecordingAudio& audio,
                      const RecordingSpeech& speech, std::set<SoundKind>& going_on) {
    std::vector<std::pair<std::string, int>> heard;
    const auto hear = [&](const std::string& name) {
        for (auto& [known, times] : heard)
            if (known == name) return void(++times);
        heard.emplace_back(name, 1);
    };
    std::set<SoundKind> loops;
    for (const HeardSound& sound : audio.sounds())
        if (sound.time_s >= from_s && sound.time_s < to_s) hear(name_of(sound.cue));
    // A lasting sound is named only when it begins.
    for (const HeardSound& sound : audio.loop_changes())
        if (sound.time_s >= from_s && sound.time_s < to_s && sound.cue.loudness > 0.0 &&
            loops.insert(sound.cue.kind).second && !going_on.contains(sound.cue.kind))
            hear(name_of(sound.cue));
    going_on = loops;
    const int from = static_cast<int>(std::lround(from_s));
    std::string text = fmt::format("- {}:{:02} {}.", from / 60, from % 60, deed);
    for (std::size_t i = 0; i < heard.size(); ++i)
        text += fmt::format("{}{}{}", i == 0 ? " Heard: " : ", ", heard[i].first,
                            heard[i].second == 1 ? "" : fmt::format(" {} times", heard[i].second));
    if (!heard.empty()) text += '.';
    std::string said;
    for (const HeardSpeech& line : speech.lines())
        if (line.time_s >= from_s && line.time_s < to_s)
            said += " " + line.utterance.text + (line.utterance.text.ends_with('.') ? "" : ".");
    return text + (said.empty() ? "" : " Said:" + said) + "\n";
}

std::string played() {
    const auto scenario =
        read_scenario(kRoot / "tests" / "scenarios" / "first_contact.toml", {kRoot / "worlds" / "maps"});
    EXPECT_TRUE(scenario) << scenario.error().sentence();
    auto world = read_world(kRoot / "worlds" / "maps" / "house.map");
    EXPECT_TRUE(world) << world.error().sentence();
    RecordingAudio audio;
    RecordingSpeech speech;
    const auto log =
        run_scenario(*scenario, std::make_shared<const Scene>(std::move(*world)), audio, speech, {read_requested});
    EXPECT_TRUE(log) << log.error().sentence();
    EXPECT_NEAR(log->end_s, 60.0, 1.0) << "a minute";
    struct Deed {
        std::string words, last;
        double from_s = 0.0;
    };
    std::vector<Deed> deeds;
    for (const ScenarioAction& action : scenario->actions) {
        const std::string deed = deed_of(action.step);
        if (action.name.empty()) {
            // Two equal actions in a row become one with "twice". A step without an action continues the previous
            // action.
            if (!deed.empty() && deed == deeds.back().last) deeds.back().words += " twice";
            else EXPECT_TRUE(deed.empty()) << deed << " needs a name";
            continue;
        }
        const double from_s = log->action_times.at(action.name).first;
        deeds.push_back({deed.empty() ? "You enter with `./run house`" : "You " + deed, deed, from_s});
    }
    std::string text;
    std::set<SoundKind> going_on;
    for (std::size_t i = 0; i < deeds.size(); ++i)
        text += paragraph(deeds[i].words, deeds[i].from_s, i + 1 < deeds.size() ? deeds[i + 1].from_s : 1e9, audio,
                          speech, going_on);
    return text;
}

TEST(Readme, shows_a_first_minute_that_matches_the_program) {
    const std::string begin = "a test holds it against that. -->\n", end = "<!-- end -->";
    std::string readme = test::content_of(kRoot / "README.md");
    const std::size_t from = readme.find(begin), to = readme.find(end);
    ASSERT_TRUE(from != std::string::npos && to != std::string::npos && from < to);
    const std::string shown = readme.substr(from + begin.size(), to - from - begin.size()), now = played();
    if (const char* write = std::getenv("HANDRAIL_WRITE_TRANSCRIPTS"); write && *write) {
        std::ofstream(kRoot / "README.md") << readme.replace(from + begin.size(), shown.size(), now);
        GTEST_SKIP() << "written to README.md";
    }
    EXPECT_EQ(shown, now) << "HANDRAIL_WRITE_TRANSCRIPTS=1 writes it anew; read what has changed";
}

TEST(Readme, is_short) {
    const std::string readme = test::content_of(kRoot / "README.md");
    EXPECT_LE(std::count(readme.begin(), readme.end(), '\n'), 130);
}

}  // namespace first_contact_test
}  // namespace handrail
