// The loop of the ears: 200 times a second it takes what the hand met and what the app asks for, and lets CuePlanner
// drive the sinks. It owns the planner and both sinks from start() to stop(); the app thread owns this object and
// everything marked so below. step() is the whole body of the loop, so the owner of virtual time needs no thread.
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

namespace handrail {

class AudioThread final : public EarsInbox {
public:
    using ContactRing = SpscRing<ContactEvent, 1024>;  // ServoLoop::EventRing
    static constexpr double kPeriod_s = 0.005;
    static constexpr double kFade_s = 0.030;  // ticks on for this long at the end, so that nothing clicks

    // Clock and rings outlive this object; a ring may be null where there is no hand, the second is the left hand's
    // where there are two. The clock is the one that times contact events.
    AudioThread(std::shared_ptr<AudioSink> audio, std::shared_ptr<SpeechSink> speech, Clock& clock,
                ContactRing* contacts, const Settings& settings, ContactRing* left_contacts = nullptr);
    ~AudioThread() override;
    AudioThread(const AudioThread&) = delete;
    AudioThread& operator=(const AudioThread&) = delete;

    // What one step read of the other loops.
    struct Step {
        double now_s = 0.0;
        std::uint32_t contacts = 0, left_contacts = 0;  // taken
        std::uint32_t posts = 0;  // calls of the app since the step before: all below that change what is heard
    };
    // For who records, before the start; on the thread of the ears. The time of a step is in whole microseconds then.
    struct StepListener {
        std::function<void(double now_s)> begins;  // before anything is heard in it
        std::function<void(const Step&)> ends;
    };
    void tell_steps(StepListener listener) { step_listener_ = std::move(listener); }

    // In place of stop(), for who steps it: whatever waits to be said or played is dropped.
    void end_at_once() { stopped_ = true; }

    // App thread. stop() takes everything posted before it, waits at most that long for the voice to finish, writes
    // what it could not say, fades and joins; more often does no harm, and the destructor does it too.
    void start();
    void stop(double finish_speech_s = 0.0);
    // As AudioSink::drops_out, at the last tick. App thread.
    bool sound_drops_out() const { return drops_out_.load(std::memory_order_relaxed); }

    // App thread; each holds a mutex for microseconds at most.
    void post(CueRequest request) override;
    void set_settings(const Settings& settings) override;
    void enter_world(std::shared_ptr<const Scene> scene) override;
    void follow_edit(std::shared_ptr<const Scene> scene) override;
    void set_two_hands(bool two) override;
    void set_hand_stands_in(bool stands_in) override;
    void set_listener(const Listener& listener) override { listener_.publish(listener); }
    std::vector<SpokenLine> take_spoken();  // what was said since the last call, oldest first
    // Something is being said or waits to be, as of the last tick.
    bool speaking() const { return speaking_.load(std::memory_order_relaxed); }
    // As SpeechSink::who, at the last tick; empty before the first.
    std::string who_speaks();

    // One tick at the clock's time: the thread's body, or for the owner of virtual time.
    void step();

private:
    struct Inbox {
        std::vector<CueRequest> requests;
        std::optional<Settings> settings;
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
    double finish_speech_s_ = 0.0;  // written before stop_asked_
    bool stopped_ = false;          // app thread

    std::mutex mutex_;  // guards inbox_, outbox_ and who_
    std::string who_;
    Inbox inbox_;
    std::vector<SpokenLine> outbox_;
    LatestValue<Listener> listener_;        // app thread to audio thread
    std::array<ContactRing*, 2> contacts_;  // servo threads to audio thread, one for each hand

    // Audio thread only while it runs.
    std::shared_ptr<AudioSink> audio_;
    std::shared_ptr<SpeechSink> speech_;
    CuePlanner planner_;
    std::vector<ContactEvent> events_;  // of this tick; kept for its memory
    std::uint64_t published_ = 0;       // of planner_.spoken_in_all()
    std::string told_who_;
    StepListener step_listener_;

    std::atomic<bool> drops_out_{false};  // audio thread to app thread
};

}  // namespace handrail
