// Drives servo_tick: a thread with the device in its hands, paced by a Clock, and every hand-over to and from it.
// Nothing on the servo's side waits, allocates or frees; a scene it has let go is freed by the app. Without start() the
// same loop is stepped by hand in virtual time, and both ways give the same stream of ToolState to the bit.
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

namespace handrail {

enum class Scheduling : std::uint8_t { NotStarted, RealTime, Ordinary };

// Published ten times a second and once at the end.
struct ServoReport {
    ServoCounters counters;
    DurationHistogram durations;  // of a tick with reading and writing the device, by the Clock
    std::uint64_t overruns = 0;   // ticks after which the next one was already due
    Scheduling scheduling = Scheduling::NotStarted;
    bool memory_locked = false;  // no page of the program can be away when the servo needs it
};

class ServoLoop final : public ServoInbox {
public:
    // 1024 events are 3.4 s of three surfaces slid along at once, so a stalled ear loses none of a short stall.
    using EventRing = SpscRing<ContactEvent, 1024>;

    // What others hold so that it outlives a device that is replaced by another while the program runs. Each outlives
    // the loop; a ring belongs to one loop at a time. Null: the loop has its own.
    struct Links {
        const ServoSwitches* switches = nullptr;
        EventRing* events = nullptr;
        HandRing* recording = nullptr;  // gets each tick; the samples are rounded for it. Null: nothing is kept
    };

    // The clock outlives the loop.
    ServoLoop(std::unique_ptr<HapticDevice> device, Clock& clock, double period_s = 1e-3);
    ServoLoop(std::unique_ptr<HapticDevice> device, Clock& clock, double period_s, const Links& links);
    ~ServoLoop() override;
    ServoLoop(const ServoLoop&) = delete;
    ServoLoop& operator=(const ServoLoop&) = delete;

    const DeviceSpec& device_spec() const { return device_->spec(); }

    // App thread. open() comes first; start() makes the thread. stop() takes the force away over 75 ms, closes the
    // device and joins; more often does no harm, and the destructor does it too.
    Result<void> open();
    void start();
    void stop();

    // App thread: see ServoInbox.
    void set_scene(std::shared_ptr<const HapticScene> scene) { set_scene(std::move(scene), engine_); }
    void set_desk(std::shared_ptr<const HapticScene> desk) override { hand_over(world_, std::move(desk), engine_); }
    void set_scene(std::shared_ptr<const HapticScene> scene, std::shared_ptr<HandEngine> engine) override {
        hand_over(std::move(scene), desk_, std::move(engine));
    }
    void set_tuning(const ServoTuning& tuning) override { tuning_.publish({tuning, ++given_.tuning}); }
    void set_pose(const WorkspacePose& pose) override { pose_.publish({pose, ++given_.pose}); }
    void set_bodies(const BodyFrame& bodies) override { bodies_.publish({bodies, ++given_.bodies}); }
    void set_guidance(const GuidancePath& guidance) override { guidance_.publish({guidance, ++given_.guidance}); }
    // App thread: the newest of each, valid until the next call.
    const ToolState& tool();
    const ServoReport& report();
    // App thread: how many scenes are kept because the servo may still read them.
    std::size_t scenes_kept();

    // Ears' thread.
    EventRing& events() { return *events_; }

    // One tick at the clock's time: the thread's body, or for the owner of virtual time. False when stop was asked for
    // and the force is gone.
    bool step() noexcept;
    // Lets step() bring the force down; stop() does the same and waits.
    void ask_to_stop() { stop_asked_.store(true, std::memory_order_release); }

private:
    struct SceneHandle {
        const HapticScene* scene = nullptr;
        const HapticScene* desk = nullptr;
        HandEngine* engine = nullptr;
        std::uint64_t number = 0;  // rising; the servo says up to which it has come
    };
    template <class T>
    struct Given {
        T value;
        std::uint32_t number = 0;  // how many came before it, and itself
    };
    struct KeptScene {
        std::uint64_t number;
        std::shared_ptr<const HapticScene> scene, desk;
        std::shared_ptr<HandEngine> engine;
    };

    void hand_over(std::shared_ptr<const HapticScene> scene, std::shared_ptr<const HapticScene> desk,
                   std::shared_ptr<HandEngine> engine);
    void run() noexcept;
    void close() noexcept;
    void publish_report() noexcept;
    // Chosen once, so that a tick which nobody records pays nothing for it (tests/bench/recording_cost.sh).
    template <bool kRecorded>
    bool step_as() noexcept;
    template <bool kRecorded>
    void run_as() noexcept;
    void record(double time_s, const DeviceSample& sample, const ForceCommand& command, std::uint32_t stops,
                bool focused, bool stopping) noexcept;
    void free_scenes();

    Clock& clock_;
    const double period_s_;
    std::unique_ptr<HapticDevice> device_;  // servo thread after start()
    std::thread thread_;
    bool open_ = false;
    std::atomic<bool> stop_asked_{false};

    std::vector<KeptScene> kept_;                      // app thread only
    std::shared_ptr<const HapticScene> world_, desk_;  // as handed over last
    std::shared_ptr<HandEngine> engine_;               // likewise
    std::uint64_t last_scene_ = 0;
    std::atomic<std::uint64_t> scene_in_use_{0};

    LatestValue<SceneHandle> scene_;
    LatestValue<Given<ServoTuning>> tuning_;
    LatestValue<Given<WorkspacePose>> pose_;
    LatestValue<Given<BodyFrame>> bodies_;
    LatestValue<Given<GuidancePath>> guidance_;
    ServoReads given_;  // app thread
    LatestValue<ToolState> tool_;
    LatestValue<ServoReport> report_;
    std::unique_ptr<EventRing> own_events_;  // null when it was given one
    EventRing* events_;
    std::unique_ptr<ServoSwitches> own_switches_;  // nobody sets these
    const ServoSwitches* switches_;
    HandRing* recording_;
    std::uint32_t recorded_as_ = 0;  // HandRow::servo

    // Servo thread only.
    ServoState state_;
    ServoReport counted_;
    std::uint64_t ring_lost_ = 0;
};

// "Touch runs in real time." or what is missing for it, fit to be spoken or printed; empty before the start.
std::string scheduling_sentence(Scheduling scheduling);
// What is missing where the memory may not be locked; empty where it is.
std::string memory_sentence(bool locked);

}  // namespace handrail
