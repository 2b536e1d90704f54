// The loop of the audio thread: 200 times a second it takes the hand's contact events and the app's requests, and lets
// CuePlanner drive the sinks. It owns the planner and both sinks from start() to stop(). The app thread owns this
// object and everything below that is marked so. step() is the whole body of the loop, so virtual time needs no thread.
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
    using ContactRing = SpscRing<servo::ContactEvent, 1024>;  // ServoLoop::EventRing
    static constexpr double kPeriod_s = 0.005;
    static constexpr double kFade_s = 0.030;  // keeps ticking for this long at the end, so that nothing clicks

    // Clock and rings must outlive this object. A ring may be null if there is no such hand; the second one is the left
    // hand's, if there are two. The clock must be the one that times contact events.
    AudioThread(std::shared_ptr<AudioSink> audio, std::shared_ptr<SpeechSink> speech, Clock& clock,
                ContactRing* contacts, const settings::Settings& settings, ContactRing* left_contacts = nullptr);
    ~AudioThread() override;
    AudioThread(const AudioThread&) = delete;
    AudioThread& operator=(const AudioThread&) = delete;

    // What one step took from the other loops.
    struct Step {
        double now_s = 0.0;
        std::uint32_t contacts = 0, left_contacts = 0;  // events taken
        std::uint32_t posts = 0;  // calls of the app since the last step: all those below that change what is heard
    };
    // For a recorder; set it before the start. Called on the audio thread. The time of a step is then a whole number of
    // microseconds.
    struct StepListener {
        std::function<void(double now_s)> begins;  // called before anything is heard in the step
        std::function<void(const Step&)> ends;
    };
    void tell_steps(StepListener listener) { step_listener_ = std::move(listener); }

    // Replaces stop() when the owner steps it: drops everything that waits to be said or played.
    void end_at_once() { stopped_ = true; }

    // App thread. stop() takes everything posted before it and waits at most finish_speech_s for the voice to finish.
    // It writes what it could not say, fades and joins. Further calls do no harm, and the destructor calls it too.
    void start();
    void stop(double finish_speech_s = 0.0);
    // AudioSink::drops_out at the last tick. App thread.
    bool sound_drops_out() const { return drops_out_.load(std::memory_order_relaxed); }

    // App thread; each holds a mutex for microseconds at most.
    void post(CueRequest request) override;
    void set_settings(const settings::Settings& settings) override;
    void enter_world(std::shared_ptr<const Scene> scene) override;
    void follow_edit(std::shared_ptr<const Scene> scene) override;
    void set_two_hands(bool two) override;
    void set_hand_stands_in(bool stands_in) override;
    void set_listener(const Listener& listener) override { listener_.publish(listener); }
    SpeechTopics take_owed() override { return {owed_.exchange(0, std::memory_order_relaxed)}; }
    std::vector<SpokenLine> take_spoken();  // what was said since the last call, oldest first
    // Something is being said or waits to be, as of the last tick.
    bool speaking() const { return speaking_.load(std::memory_order_relaxed); }
    // SpeechSink::who at the last tick; empty before the first tick.
    std::string who_speaks();

    // Runs one tick at the clock's time: called by the thread, or by the owner of virtual time.
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
    std::thread thread_;  // app thread
    std::atomic<bool> stop_asked_{false};
    std::atomic<bool> speaking_{false};
    std::atomic<std::uint32_t> owed_{0};  // bits of SpeechTopics
    double finish_speech_s_ = 0.0;        // written before stop_asked_
    bool stopped_ = false;                // app thread

    std::mutex mutex_;  // protects inbox_, outbox_ and who_
    std::string who_;
    Inbox inbox_;
    std::vector<SpokenLine> outbox_;
    LatestValue<Listener> listener_;        // app thread to audio thread
    std::array<ContactRing*, 2> contacts_;  // servo threads to audio thread, one for each hand

    // Audio thread only while it runs.
    std::shared_ptr<AudioSink> audio_;
    std::shared_ptr<SpeechSink> speech_;
    CuePlanner planner_;
    std::vector<servo::ContactEvent> events_;  // of this tick; kept to reuse its memory
    std::uint64_t published_ = 0;              // the value of planner_.spoken_in_all() up to which lines were published
    std::string told_who_;
    StepListener step_listener_;

    std::atomic<bool> drops_out_{false};  // audio thread to app thread
};

}  // namespace handrail::cues
