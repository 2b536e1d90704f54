// Runs a session without servo and speech, together with the person who uses it: what they press and type, and what the
// session would say. Tests use it to check what the session does and says.
#pragma once

#include <fmt/ranges.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/core/session/session.h"
#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/worlds_once.h"
#include "worlds/readers/reader.h"

namespace handrail::test {

inline std::shared_ptr<const Scene> world_in(const std::filesystem::path& file) {
    auto scene = read_world(file);
    EXPECT_TRUE(scene) << file;
    return scene ? std::make_shared<const Scene>(std::move(*scene)) : std::make_shared<const Scene>();
}

inline std::shared_ptr<const Scene> our_world(const char* file) {
    return world_once(test::project_root() / "worlds" / "maps" / file);
}

struct AppSession {
    explicit AppSession(const Settings& settings = {}, const HandFacts& hand = {}, const SessionOptions& options = {})
        : app(settings, hand, with_known_rooms(options)) {}
    void run(double seconds) {
        for (const double until = now + seconds; now < until - 1e-9;) {
            now += 1.0 / 60.0;
            app.tick(now, tool);
            listen();
        }
    }
    void listen() {
        for (CueRequest& cue : app.take_cues()) {
            if (cue.kind == CueRequestKind::Say || cue.kind == CueRequestKind::Demonstrate) said.push_back(cue.text);
            if (cue.kind == CueRequestKind::Play) sounds.push_back(cue.sound);
            if (cue.kind == CueRequestKind::WorldSound) world_sounds.push_back(cue);
            if (cue.kind == CueRequestKind::Bump) bumped.push_back(cue.feature);
        }
    }
    // Gives a command and returns the last sentence that the session said. Waits if a route is still being planned.
    std::string request(Command command) {
        app.apply(CommandDown{command}, now);
        app.apply(CommandUp{command}, now);
        listen();
        for (int i = 0; i < 600 && !said.empty() && said.back() == phrase("leg.looks"); ++i) run(1.0 / 60.0);
        return said.empty() ? std::string() : said.back();
    }
    void hold(Command command, double seconds) {
        app.apply(CommandDown{command}, now);
        run(seconds);
        app.apply(CommandUp{command}, now);
    }
    // Presses and releases the key of a command, and then waits for `then_s`.
    void tap(Command command, double then_s = 0.1) {
        hold(command, 0.05);
        run(then_s);
    }
    // Walks straight on for this many seconds, then waits until the walker stands.
    void walk(double seconds) {
        hold(Command::Forward, seconds);
        run(0.2);
    }
    // Sends a line to the open list or question, as a terminal does.
    std::string line(const std::string& text) {
        EXPECT_TRUE(app.apply(LineTyped{text}, now)) << text;
        listen();
        return said.empty() ? std::string() : said.back();
    }
    // Returns everything that the session has said since the last call, on one line.
    std::string news() {
        listen();
        return fmt::format("{}", fmt::join(std::exchange(said, {}), " | "));
    }
    bool heard(const std::string& part) const {
        return std::any_of(said.begin(), said.end(),
                           [&](const std::string& s) { return s.find(part) != std::string::npos; });
    }
    int count(SoundKind kind) const { return static_cast<int>(std::count(sounds.begin(), sounds.end(), kind)); }
    Session app;
    ToolState tool;
    double now = 0.0;
    std::vector<std::string> said;
    std::vector<SoundKind> sounds;
    std::vector<CueRequest> world_sounds;  // sounds of the world as the cue planner received them, the newest last
    std::vector<FeatureId> bumped;         // features that the walker bumped into
};

}  // namespace handrail::test
