// A session of the program as app/main assembles it, without window, devices and sound card. It has the session, the
// sounds and what both exchange, the visited world, the lesson with its desk, and the recording. Its clock moves only
// on request, so minutes of a session pass in seconds. One thread runs it; as in the program, a background task finds
// rooms.
#pragma once

#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "app/core/session/session_driver.h"
#include "app/main/lesson_here.h"
#include "app/main/session_recording.h"
#include "app/main/world_visits.h"
#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"

namespace handrail::test {

// A person who sways around the intended line. The sway has this size, changes within two seconds, and is the same for
// the same seed.
class Sway {
public:
    Sway(double size_m, std::uint64_t seed) : size_m_(size_m), draw_(seed) {}
    // Called once a frame: how far right of the line the person wants to be.
    double next_m();

private:
    double size_m_;
    std::mt19937_64 draw_;
    std::normal_distribution<double> normal_;
    double now_m_ = 0.0;
};

class Sitting {
public:
    static constexpr double kFrame_s = 1.0 / 60.0, kWordsPerMinute = 300.0;

    // Starts as from the command line, with the world of the arguments, their lesson, learner and recording.
    explicit Sitting(ExploreArguments arguments);
    ~Sitting();
    Sitting(const Sitting&) = delete;
    Sitting& operator=(const Sitting&) = delete;

    // Lets this much time pass.
    void live(double seconds);
    // Waits for the background task that finds rooms and routes. Returns whether they are known.
    bool know_rooms();
    // If false, each frame also takes a real millisecond, so that background tasks keep up with lists that need them.
    void hurry(bool hurries) { hurries_ = hurries; }

    // Presses keys, each down and up, then waits half a second for the reaction.
    void key(const std::string& name);
    void type(const std::string& text);
    void hold(Command command, double seconds);
    int keys() const { return keys_; }

    // Walks through the places by stick: turns, moves, opens closed doors. Returns false if the route is blocked. If
    // the lesson moves the walker meanwhile, the walk counts as arrived.
    bool walk(const std::vector<Vec3>& places, Sway* sway = nullptr);
    void face(const Vec3& at);
    // Deviation to the right of the intended lines on the last walks, sampled every tenth of a second.
    const std::vector<double>& aside_m() const { return aside_m_; }

    bool hears(const std::string& words, double within_s = 20.0);
    std::string all() const;
    // Runs another lesson in parallel with that of the arguments; null: none.
    void teach(TeachingRun* run) { beside_ = run; }

    Session& app() { return app_; }
    double now_s() const { return clock_.now_s(); }
    // Lets the last announcements finish and ends the recording.
    void end();

private:
    void frame();
    enum class Came : std::uint8_t { There, PutElsewhere, Stuck };
    Came leg(const Vec3& from, const Vec3& to, Sway* sway);

    ExploreArguments arguments_;
    Settings settings_;
    SettingsStore store_;
    VirtualClock clock_;
    std::vector<std::string> news_;
    std::unique_ptr<SessionRecording> recording_;
    RecordingSpeech* speech_ = nullptr;  // owned by sound_
    std::unique_ptr<AudioThread> sound_;
    Session app_;
    std::unique_ptr<SessionDriver> driver_;
    const SessionVoice say_;
    std::unique_ptr<WorldVisits> worlds_;
    std::unique_ptr<LessonHere> lesson_;
    TeachingRun* beside_ = nullptr;
    std::vector<SessionEvent> beside_events_;
    std::vector<double> aside_m_;
    long frames_ = 0, steps_ = 0;
    double taught_s_ = -1e9, begun_s_ = 0.0;
    std::size_t heard_ = 0;
    int keys_ = 0;
    bool hurries_ = true, ended_ = false;
};

}  // namespace handrail::test
