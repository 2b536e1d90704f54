// Gives the same typed lines to two programs, which must announce the same. One is the real program with its threads in
// real time. The other is the session on a virtual clock that scenarios and tests use.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "app/core/session/headless_session.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "worlds/base/typist.h"
#include "worlds/readers/reader.h"

namespace handrail::test {
namespace typed_commands_test {

const std::vector<std::string> kThirty{
    "where",    "forward 3",  "left 2",    "exits",       "around",    "describe kitchen",
    "overview", "right 4",    "forward 5", "trail-left",  "lost",      "heading",
    "back 2",   "find piano", "forward 1", "use",         "mark",      "Clock",
    "storeys",  "escape",     "help",      "hello",       "turn left", "trail-right 2",
    "home",     "routes",     "study",     "rest-of-way", "forward 4", "where"};

std::string joined(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) all += line + "\n";
    return all;
}

// Removes the lines before the first sentence about the world.
std::vector<std::string> from_greeting(std::vector<std::string> said) {
    const auto greeting =
        std::find_if(said.begin(), said.end(), [](const std::string& line) { return line.starts_with("House with"); });
    said.erase(said.begin(), greeting);
    return said;
}

std::vector<std::string> said_by_program() {
    ProgramCall call;
    call.program = built_program("handrail");
    call.arguments = {"--no-window", "--device", "none", "house"};
    for (const std::string& line : kThirty) call.input += line + "\n";
    const ProgramRun run = run_program(call);
    EXPECT_EQ(run.exit_status, 0) << run.err;
    std::vector<std::string> said;
    std::istringstream out(run.out);
    for (std::string line; std::getline(out, line);)
        if (line.starts_with("say: ")) said.push_back(line.substr(5));
    return from_greeting(std::move(said));
}

std::vector<std::string> said_in_virtual_time() {
    speak_to(ActsBy::Lines);
    auto world = read_world(bundled_world("house.map"));
    EXPECT_TRUE(world);
    RecordingAudio audio;
    RecordingSpeech speech;
    HeadlessSession session(Settings{}, HandFacts{}, audio, speech);
    session.app().apply(WorldEntered{make_ready(std::make_shared<const Scene>(std::move(*world)))}, 0.0);
    for (const std::string& line : kThirty) session.type(line);
    for (double quiet_s = 0.0; quiet_s < 1.0 && session.now_s() < 600.0; quiet_s += 1e-3) {
        session.advance();
        if (!session.lines().done() || !session.app().idle()) quiet_s = 0.0;
    }
    speak_to(ActsBy::WindowKeys);
    std::vector<std::string> said;
    for (const HeardSpeech& line : speech.lines()) said.push_back(line.utterance.text);
    return from_greeting(std::move(said));
}

TEST(TypedCommands, get_the_same_answers_in_real_and_in_virtual_time) {
    const std::vector<std::string> virtual_time = said_in_virtual_time();
    EXPECT_GT(virtual_time.size(), kThirty.size());
    EXPECT_EQ(joined(said_by_program()), joined(virtual_time));
}

}  // namespace typed_commands_test
}  // namespace handrail::test
