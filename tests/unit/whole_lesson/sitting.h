// A session of the program as app/main puts it together, with everything but a window, devices and a sound card: the
// session, the ears and what they read of each other, the world that is visited, the lesson and its desk, the
// recording. Its clock moves only when told to, so somebody lives minutes in it in seconds. One thread lives it; rooms
// are looked for beside, as in the program.
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

namespace handrail::test {

// Somebody who goes to and fro a little around the line they mean to walk: a sway of that size, changing within two
// seconds, the same for the same seed.
class Sway {
public:
    Sway(double size_m, std::uint64_t seed) : size_m_(size_m), draw_(seed) {}
    // Once a frame: how far right of the line one wants to be.
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

    // As the command line would begin it: the world of the arguments, their lesson, learner and recording.
    explicit Sitting(ExploreArguments arguments);
    ~Sitting();
    Sitting(const Sitting&) = delete;
    Sitting& operator=(const Sitting&) = delete;

    // Time goes on.
    void live(double seconds);
    // Until rooms and ways are known; waits for the thread that looks for them.
    bool know_rooms();
    // Time goes no faster than the threads beside need: for lists that wait for them.
    void hurry(bool hurries) { hurries_ = hurries; }

    // By keys: each down and up, and half a second to hear what came of it.
    void key(const std::string& name);
    void type(const std::string& text);
    void hold(Command command, double seconds);
    int keys() const { return keys_; }

    // By sticks along places: turns, goes, opens what is shut. False where the way cannot be gone. A body that was put
    // elsewhere meanwhile has come to where it was to go: the lesson took it back.
    bool walk(const std::vector<Vec3>& places, Sway* sway = nullptr);
    void face(const Vec3& at);
    // How far right of the lines between its places the last walks were, one by one a tenth of a second.
    const std::vector<double>& aside_m() const { return aside_m_; }

    bool hears(const std::string& words, double within_s = 20.0);
    std::string all() const;
    // A run of its own beside the one of the lesson that is taught; null: no more.
    void teach(TeachingRun* run) { beside_ = run; }

    Session& app() { return app_; }
    double now_s() const { return clock_.now_s(); }
    // The last words are said, and the recording ends.
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
    RecordingSpeech* speech_ = nullptr;  // the ears' own
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
