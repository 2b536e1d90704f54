// Runs the loop of the audio thread. 200 times a second it reads the contact events of the hands and the app's
// requests, and lets CuePlanner drive the sinks. It owns the planner and both sinks from start() to stop(). The app
// thread owns the AudioThread object and calls the functions that are marked "App thread". step() contains the whole
// body of the loop, so the owner can also step it in virtual time without a thread.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "audio-cues/plan/cue_planner.h"
#include "audio-cues/plan/ears_inbox.h"
#include "audio-cues/plan/sinks.h"
#include "settings/settings.h"
#include "worlds/base/clock.h"
#include "worlds/base/latest_value.h"
#include "worlds/base/spsc_ring.h"

namespace handrail::cues {

class AudioThread final : public EarsInbox {
public:
    using ContactRing = SpscRing<servo::ContactEvent, 1024>;  // the same type as ServoLoop::EventRing
    static constexpr double kPeriod_s = 0.005;
    // At the end, the loop keeps ticking for this long, so that the sound ends without a click.
    static constexpr double kFade_s = 0.030;

    // Clock and rings must outlive this object. A ring is null if there is no such hand. If there are two hands, the
    // second ring belongs to the left one. The clock must be the one that times the contact events.
    AudioThread(std::shared_ptr<AudioSink> audio, std::shared_ptr<SpeechSink> speech, Clock& clock,
                ContactRing* contacts, const settings::Settings& settings, ContactRing* left_contacts = nullptr);
    ~AudioThread() override;
    AudioThread(const AudioThread&) = delete;
    AudioThread& operator=(const AudioThread&) = delete;

    // The inputs that one step received from the app and the servo loops.
    struct Step {
        double now_s = 0.0;
        std::uint32_t contacts = 0, left_contacts = 0;  // number of contact events of each hand
        std::uint32_t posts = 0;  // number of the app's calls since the last step that change what is heard
    };
    // Callbacks for a recorder. Set them before the start. The audio thread calls both functions. If a listener is set,
    // the time of each step is a whole number of microseconds.
    struct StepListener {
        std::function<void(double now_s)> begins;  // called before anything sounds or is spoken in the step
        std::function<void(const Step&)> ends;
    };
    void set_step_listener(StepListener listener) { step_listener_ = std::move(listener); }

    // For an owner that steps the loop: ends it like stop(), but drops everything that is waiting to be spoken or
    // played.
    void end_at_once() { stopped_ = true; }

    // App thread. stop() handles everything that was posted before it and waits at most `finish_speech_s` for the voice
    // to finish. It then writes the lines that the voice could not speak, fades the sound out and joins the thread. It
    // may be called again, and the destructor calls it too.
    void start();
    void stop(double finish_speech_s = 0.0);
    // App thread. Returns the result of AudioSink::drops_out() in the last tick.
    bool sound_drops_out() const { return drops_out_.load(std::memory_order_relaxed); }

    // App thread. Each of these calls holds a mutex for microseconds at most.
    void post(CueRequest request) override;
    void set_settings(const settings::Settings& settings) override;
    void enter_world(std::shared_ptr<const Scene> scene) override;
    void follow_edit(std::shared_ptr<const Scene> scene) override;
    void set_two_hands(bool two) override;
    void set_hand_stands_in(bool stands_in) override;
    void set_listener(const Listener& listener) override { listener_.publish(listener); }
    SpeechTopics take_owed() override { return {owed_.exchange(0, std::memory_order_relaxed)}; }
    std::vector<SpokenLine> take_spoken();  // returns the lines spoken since the last call, oldest first
    // Returns true if, at the last tick, a line was being spoken or was waiting to be spoken.
    bool speaking() const { return speaking_.load(std::memory_order_relaxed); }
    // Returns the result of SpeechSink::who() in the last tick; empty before the first tick.
    std::string who_speaks();

    // Runs one tick at the clock's time. The loop's thread calls it, or the owner in virtual time.
    void step();

private:
    struct Inbox {
        std::vector<CueRequest> requests;
        std::optional<settings::Settings> settings;
        std::optional<std::shared_ptr<const Scene>> scene, edited;
        std::optional<bool> two_hands, hand_stands_in;
        std::uint32_t posts = 0;
    };

    void run();
    void publish();

    Clock& clock_;
    std::thread thread_;  // used by the app thread only
    std::atomic<bool> stop_requested_{false};
    std::atomic<bool> speaking_{false};
    std::atomic<std::uint32_t> owed_{0};  // bits of SpeechTopics: topics that take_owed() will return
    double finish_speech_s_ = 0.0;        // written before stop_requested_ is set
    bool stopped_ = false;                // used by the app thread only

    std::mutex mutex_;  // protects inbox_, outbox_ and who_
    std::string who_;
    Inbox inbox_;
    std::vector<SpokenLine> outbox_;
    LatestValue<Listener> listener_;        // from the app thread to the audio thread
    std::array<ContactRing*, 2> contacts_;  // from the servo thread of each hand to the audio thread

    // While the audio thread runs, only it uses the members below.
    std::shared_ptr<AudioSink> audio_;
    std::shared_ptr<SpeechSink> speech_;
    CuePlanner planner_;
    // Events of the current tick; a member so that every tick reuses the vector's memory.
    std::vector<servo::ContactEvent> events_;
    std::uint64_t published_ = 0;  // the value of planner_.spoken_in_all() at the last publication of spoken lines
    std::string reported_who_;
    StepListener step_listener_;

    std::atomic<bool> drops_out_{false};  // from the audio thread to the app thread
};

}  // namespace handrail::cues
