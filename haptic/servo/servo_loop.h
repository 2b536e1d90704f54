// Runs servo_tick() on a thread that owns the device, paced by a Clock, and passes all data to and from that function.
// The servo's side never waits, allocates or frees; the app frees the scenes that the servo no longer uses. Without
// start(), the owner steps the same loop in virtual time. The sequence of ToolState values is bit-identical in both
// cases.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "haptic/device/haptic_device.h"
#include "haptic/servo/hand_recording.h"
#include "haptic/servo/servo_inbox.h"
#include "haptic/servo/servo_switches.h"
#include "haptic/servo/servo_tick.h"
#include "worlds/base/clock.h"
#include "worlds/base/latest_value.h"
#include "worlds/base/result.h"
#include "worlds/base/spsc_ring.h"

namespace handrail::servo {

enum class Scheduling : std::uint8_t { NotStarted, RealTime, Ordinary };

// Measurements of the loop, published ten times a second and once at the end.
struct ServoReport {
    ServoCounters counters;
    // Durations of ticks, including reading and writing the device, measured with the Clock.
    DurationHistogram durations;
    std::uint64_t overruns = 0;  // number of ticks that ended after the next one was due
    Scheduling scheduling = Scheduling::NotStarted;
    // True if all memory of the program is locked, so that the servo never waits for a page.
    bool memory_locked = false;
};

class ServoLoop final : public ServoInbox {
public:
    // 1024 events cover 3.4 s of sliding along three surfaces at once, so a short stall of the audio thread loses none.
    using EventRing = SpscRing<ContactEvent, 1024>;

    // Objects that outlive the loop, so that they stay when one device replaces another while the program runs. Only
    // one loop may use a ring at a time. If a pointer is null, the loop makes its own object.
    struct Links {
        const ServoSwitches* switches = nullptr;
        EventRing* events = nullptr;
        // Receives a row for each tick. With a recording, the samples are rounded before the tick. Null: no recording.
        HandRing* recording = nullptr;
    };

    // The clock must outlive the loop.
    ServoLoop(std::unique_ptr<device::HapticDevice> device, Clock& clock, double period_s = 1e-3);
    ServoLoop(std::unique_ptr<device::HapticDevice> device, Clock& clock, double period_s, const Links& links);
    ~ServoLoop() override;
    ServoLoop(const ServoLoop&) = delete;
    ServoLoop& operator=(const ServoLoop&) = delete;

    const device::DeviceSpec& device_spec() const { return device_->spec(); }

    // App thread. Call open() first; start() then starts the thread. stop() fades the force out over 75 ms, closes the
    // device and joins the thread. It may be called again, and the destructor calls it too.
    Result<void> open();
    void start();
    void stop();

    // App thread. See ServoInbox.
    void set_scene(std::shared_ptr<const render::HapticScene> scene) { set_scene(std::move(scene), engine_); }
    void set_desk(std::shared_ptr<const render::HapticScene> desk) override {
        hand_over(world_, std::move(desk), engine_);
    }
    void set_scene(std::shared_ptr<const render::HapticScene> scene, std::shared_ptr<HandBodyServo> engine) override {
        hand_over(std::move(scene), desk_, std::move(engine));
    }
    void set_tuning(const ServoTuning& tuning) override { tuning_.publish({tuning, ++given_.tuning}); }
    void set_pose(const WorkspacePose& pose) override { pose_.publish({pose, ++given_.pose}); }
    void set_bodies(const BodyFrame& bodies) override { bodies_.publish({bodies, ++given_.bodies}); }
    void set_guidance(const GuidancePath& guidance) override { guidance_.publish({guidance, ++given_.guidance}); }
    // App thread. Return the newest values, valid until the next call.
    const ToolState& tool();
    const ServoReport& report();
    // App thread. Returns the number of scenes that are kept alive because the servo may still read them.
    std::size_t scenes_kept();

    // Audio thread. Returns the ring of contact events.
    EventRing& events() { return *events_; }

    // Runs one tick at the clock's time. The loop's thread calls it, or the owner in virtual time. Returns false once a
    // stop was requested and the force has faded out.
    bool step() noexcept;
    // Makes step() fade the force out. stop() does the same and waits.
    void request_stop() { stop_requested_.store(true, std::memory_order_release); }

private:
    struct SceneHandle {
        const render::HapticScene* scene = nullptr;
        const render::HapticScene* desk = nullptr;
        HandBodyServo* engine = nullptr;
        // Number of this handle, which rises with every handle. The servo reports the number of the newest handle that
        // it has used.
        std::uint64_t number = 0;
    };
    template <class T>
    struct Given {
        T value;
        std::uint32_t number = 0;  // how many values the app has passed, including this value
    };
    struct KeptScene {
        std::uint64_t number;
        std::shared_ptr<const render::HapticScene> scene, desk;
        std::shared_ptr<HandBodyServo> engine;
    };

    void hand_over(std::shared_ptr<const render::HapticScene> scene, std::shared_ptr<const render::HapticScene> desk,
                   std::shared_ptr<HandBodyServo> engine);
    void run() noexcept;
    void close() noexcept;
    void publish_report() noexcept;
    // step() chooses the version once, so that a tick without a recording has no cost for it
    // (tests/bench/recording_cost.sh).
    template <bool kRecorded>
    bool step_as() noexcept;
    template <bool kRecorded>
    void run_as() noexcept;
    void record(double time_s, const device::DeviceSample& sample, const device::ForceCommand& command,
                std::uint32_t stops, bool focused, bool stopping) noexcept;
    void free_scenes();

    Clock& clock_;
    const double period_s_;
    std::unique_ptr<device::HapticDevice> device_;  // used by the servo thread after start()
    std::thread thread_;
    bool open_ = false;
    std::atomic<bool> stop_requested_{false};

    std::vector<KeptScene> kept_;                              // used by the app thread only
    std::shared_ptr<const render::HapticScene> world_, desk_;  // the scenes that the app passed last
    std::shared_ptr<HandBodyServo> engine_;                    // the engine that the app passed last
    std::uint64_t last_scene_ = 0;
    std::atomic<std::uint64_t> scene_in_use_{0};

    LatestValue<SceneHandle> scene_;
    LatestValue<Given<ServoTuning>> tuning_;
    LatestValue<Given<WorkspacePose>> pose_;
    LatestValue<Given<BodyFrame>> bodies_;
    LatestValue<Given<GuidancePath>> guidance_;
    ServoReads given_;  // number of values that the app has passed of each input; app thread
    LatestValue<ToolState> tool_;
    LatestValue<ServoReport> report_;
    std::unique_ptr<EventRing> own_events_;  // null if Links contains a ring
    EventRing* events_;
    std::unique_ptr<ServoSwitches> own_switches_;  // used if Links contains no switches; never set by anyone
    const ServoSwitches* switches_;
    HandRing* recording_;
    std::uint32_t recorded_as_ = 0;  // value for HandRow::servo in this loop's rows

    // Only the servo thread uses the members below.
    ServoState state_;
    ServoReport counted_;
    std::uint64_t ring_lost_ = 0;
};

// Returns "Touch runs in real time.", or a sentence about what is missing for that. Suitable for speech and print.
// Empty before the start.
std::string scheduling_sentence(Scheduling scheduling);
// Returns a sentence about what is missing if the memory could not be locked; empty if it is locked.
std::string memory_sentence(bool locked);

}  // namespace handrail::servo
