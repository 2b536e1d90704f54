// Runs a session of the program as app/main assembles it, without a window, devices and a sound card. The session
// includes the visited world, the lesson with its desk, the recording, and the sounds with what they and the session
// exchange. Its clock moves only on request, so minutes of a session pass in seconds. One thread runs the session. As
// in the program, a background task finds rooms.
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

// Simulates how a person sways around the intended line, by `size_m`. The sway changes within about two seconds. The
// same seed gives the same sway.
class Sway {
public:
    Sway(double size_m, std::uint64_t seed) : size_m_(size_m), draw_(seed) {}
    // Returns how far to the right of the line the person wants to be, in metres. The sitting calls this once a frame.
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

    // Starts as the command line does, with the world, lesson, learner and recording of the arguments.
    explicit Sitting(ExploreArguments arguments);
    ~Sitting();
    Sitting(const Sitting&) = delete;
    Sitting& operator=(const Sitting&) = delete;

    // Lets `seconds` of the session pass.
    void live(double seconds);
    // Waits until the background task has found rooms and routes. Returns whether the session knows them.
    bool know_rooms();
    // If `hurries` is false, each frame also lasts a real millisecond, so that background tasks can keep up with lists
    // that need their results.
    void hurry(bool hurries) { hurries_ = hurries; }

    // Presses a key, or the keys of a text, each down and up. Then waits half a second for the reaction.
    void key(const std::string& name);
    void type(const std::string& text);
    void hold(Command command, double seconds);
    int keys() const { return keys_; }

    // Walks through the places with the stick: turns, moves, and opens closed doors. Returns false if something blocks
    // the route. If the lesson places the walker elsewhere during the walk, the walk counts as complete.
    bool walk(const std::vector<Vec3>& places, Sway* sway = nullptr);
    void face(const Vec3& at);
    // Returns how far the walker was to the right of the intended lines on the last walks, in metres, sampled every
    // tenth of a second.
    const std::vector<double>& aside_m() const { return aside_m_; }

    // Waits until a line contains the words. Returns false if there was silence for `within_s`.
    bool hears(const std::string& words, double within_s = 20.0);
    std::string all() const;
    // Also teaches `run`, another lesson, in parallel with that of the arguments. Null ends the second lesson.
    void teach(TeachingRun* run) { second_run_ = run; }

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
    TeachingRun* second_run_ = nullptr;
    std::vector<SessionEvent> second_events_;
    std::vector<double> aside_m_;
    long frames_ = 0, steps_ = 0;
    double taught_s_ = -1e9, begun_s_ = 0.0;
    std::size_t heard_ = 0;
    int keys_ = 0;
    bool hurries_ = true, ended_ = false;
};

}  // namespace handrail::test
