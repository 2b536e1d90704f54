// Runs a scenario in the core of a page, in node, for the tests. It reads the scenario from the disk, and worlds that a
// test has packed.
#include <emscripten.h>
#include <fmt/format.h>

#include <algorithm>

#include "app/core/scenario/scenario_run.h"
#include "tests/page/packed_name.h"
#include "worlds/base/files.h"
#include "worlds/stored/stored_scene.h"

namespace handrail {
namespace {

std::string said_in(const std::string& file, const std::string& maps, const std::string& packed) {
    class Silence final : public cues::AudioSink {
        void play(const cues::SoundCue& /*cue*/) override {}
        void set_loop(const cues::SoundCue& /*cue*/) override {}
        void set_listener(const cues::Listener& /*listener*/) override {}
        void stop_all() override {}
        void tick(double /*now_s*/) override {}
    } silence;
    class Lines final : public cues::SpeechSink {
    public:
        void say(const cues::Utterance& line) override { said += fmt::format("{:.3f} {}\n", now_s_, line.text); }
        void write(const cues::Utterance& line) override { say(line); }
        void stop() override {}
        bool speaking() const override { return false; }
        void tick(double now_s) override { now_s_ = now_s; }
        std::string said;

    private:
        double now_s_ = 0.0;
    } lines;
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    const auto scenario = core::read_scenario(file, {maps, folder / "worlds"});
    if (!scenario) return scenario.error().sentence();
    const auto read = [&](const core::WorldRequest& request) -> Result<Scene> {
        return read_whole_file(std::filesystem::path(packed) / test::packed_name(request), 1U << 30)
            .and_then([](const std::string& bytes) { return stored::scene_from(bytes); });
    };
    Result<Scene> scene = read(scenario->world);
    if (!scene) return scene.error().sentence();
    const auto log =
        core::run_scenario(*scenario, std::make_shared<const Scene>(std::move(*scene)), silence, lines, {read});
    return log ? lines.said : log.error().sentence();
}

}  // namespace
}  // namespace handrail

extern "C" EMSCRIPTEN_KEEPALIVE const char* page_scenario(const char* file, const char* maps, const char* packed) {
    static std::string said;
    said = handrail::said_in(file, maps, packed);
    return said.c_str();
}
