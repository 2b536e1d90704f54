#include "haptic/servo/servo_loop.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <algorithm>

#include "worlds/base/executor.h"
#include "worlds/base/language.h"

namespace handrail::servo {
namespace {

// Above the priority of audio threads (usually 20 to 60), below the kernel's own 99.
constexpr int kRealTimePriority = 70;
constexpr std::uint64_t kReportEveryTicks = 100;

Scheduling request_real_time() noexcept {
    sched_param scheduling{};
    scheduling.sched_priority = kRealTimePriority;
    return pthread_setschedparam(pthread_self(), SCHED_FIFO, &scheduling) == 0 ? Scheduling::RealTime
                                                                               : Scheduling::Ordinary;
}

// Locks the memory of the whole process until the process ends. Pages are locked when they are first used, so memory
// use does not grow. Does nothing under a memory limit, because every allocation would fail once the limit is reached.
bool lock_memory() noexcept {
    rlimit limit{};
    if (getrlimit(RLIMIT_MEMLOCK, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY) return false;
    return mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
}

}  // namespace

std::string memory_sentence(bool locked) { return locked ? "" : phrase("device.memory_not_locked"); }

std::string scheduling_sentence(Scheduling scheduling) {
    switch (scheduling) {
        case Scheduling::NotStarted:
            return "";
        case Scheduling::RealTime:
            return phrase("device.real_time");
        case Scheduling::Ordinary:
            return phrase("device.ordinary_time", {{"priority", kRealTimePriority}});
    }
    return "";
}

ServoLoop::ServoLoop(std::unique_ptr<device::HapticDevice> device, Clock& clock, double period_s)
    : ServoLoop(std::move(device), clock, period_s, Links{}) {}

ServoLoop::ServoLoop(std::unique_ptr<device::HapticDevice> device, Clock& clock, double period_s, const Links& links)
    : clock_(clock),
      period_s_(period_s),
      device_(std::move(device)),
      own_events_(links.events ? nullptr : std::make_unique<EventRing>()),
      events_(links.events ? links.events : own_events_.get()),
      own_switches_(links.switches ? nullptr : std::make_unique<ServoSwitches>()),
      switches_(links.switches ? links.switches : own_switches_.get()),
      recording_(links.recording),
      recorded_as_(links.recording ? ++links.recording->servos : 0),
      state_(device_->spec()) {}

ServoLoop::~ServoLoop() { stop(); }

Result<void> ServoLoop::open() {
    if (open_) return {};
    Result<void> opened = device_->open();
    open_ = opened.has_value();
    return opened;
}

void ServoLoop::start() {
    if (!open_ || thread_.joinable()) return;
    stop_requested_.store(false, std::memory_order_release);
    thread_ = std::thread([this] {
        name_this_thread("servo");
        run();
    });
}

void ServoLoop::stop() {
    request_stop();
    if (thread_.joinable()) {
        thread_.join();
    } else if (open_) {
        close();
    }
    open_ = false;
    free_scenes();
}

void ServoLoop::close() noexcept {
    device_->write({});
    device_->close();
    publish_report();
}

void ServoLoop::publish_report() noexcept {
    counted_.counters = state_.counters();
    counted_.counters.lost_events += ring_lost_;
    report_.publish(counted_);
}

void ServoLoop::hand_over(std::shared_ptr<const render::HapticScene> scene,
                          std::shared_ptr<const render::HapticScene> desk, std::shared_ptr<HandBodyServo> engine) {
    free_scenes();
    world_ = std::move(scene);
    desk_ = std::move(desk);
    engine_ = std::move(engine);
    const SceneHandle handle{world_.get(), desk_.get(), engine_.get(), ++last_scene_};
    kept_.push_back({handle.number, world_, desk_, engine_});
    scene_.publish(handle);
}

void ServoLoop::free_scenes() {
    const std::uint64_t in_use = scene_in_use_.load(std::memory_order_acquire);
    std::erase_if(kept_, [in_use](const KeptScene& kept) { return kept.number < in_use; });
}

std::size_t ServoLoop::scenes_kept() {
    free_scenes();
    return kept_.size();
}

const ToolState& ServoLoop::tool() {
    free_scenes();
    tool_.refresh();
    return tool_.read();
}

const ServoReport& ServoLoop::report() {
    report_.refresh();
    return report_.read();
}

bool ServoLoop::step() noexcept { return recording_ ? step_as<true>() : step_as<false>(); }

template <bool kRecorded>
bool ServoLoop::step_as() noexcept {
    double start_s = clock_.now_s();
    if constexpr (kRecorded) start_s = in_whole_microseconds(start_s);
    scene_.refresh();
    tuning_.refresh();
    pose_.refresh();
    bodies_.refresh();
    guidance_.refresh();
    const bool stopping = stop_requested_.load(std::memory_order_acquire);
    // The switches are read once, so that the recording contains the values that the tick used.
    const std::uint32_t stops = switches_->stops.load(std::memory_order_acquire);
    const bool focused = switches_->focused.load(std::memory_order_acquire);
    ServoTuning tuning = with_switches(tuning_.read().value, stops, focused);
    if (stopping) tuning.forces_on = false;
    const SceneHandle scene = scene_.read();

    device::DeviceSample sample = device_->read(start_s);
    if constexpr (kRecorded) round_to_whole_steps(sample);
    const device::ForceCommand command = servo_tick(state_, {.scene = scene.scene,
                                                             .tuning = tuning,
                                                             .pose = pose_.read().value,
                                                             .sample = sample,
                                                             .now_s = start_s,
                                                             .bodies = &bodies_.read().value,
                                                             .desk = scene.desk,
                                                             .guidance = &guidance_.read().value,
                                                             .engine = scene.engine});
    device_->write(command);
    if constexpr (kRecorded) record(start_s, sample, command, stops, focused, stopping);

    // From this statement on, the servo does not read any older scene.
    scene_in_use_.store(scene.number, std::memory_order_release);
    for (const ContactEvent& event : state_.events())
        if (!events_->push(event)) ++ring_lost_;
    tool_.publish(state_.tool());
    counted_.durations.add(clock_.now_s() - start_s);
    if (state_.tool().ticks % kReportEveryTicks == 0) publish_report();
    return !(stopping && state_.tool().force_gain == 0.0);
}

void ServoLoop::record(double time_s, const device::DeviceSample& sample, const device::ForceCommand& command,
                       std::uint32_t stops, bool focused, bool stopping) noexcept {
    const SceneHandle& scene = scene_.read();
    const ServoReads reads{static_cast<std::uint32_t>(scene.number),
                           tuning_.read().number,
                           pose_.read().number,
                           bodies_.read().number,
                           guidance_.read().number,
                           stops,
                           focused,
                           stopping};
    EngineReads bodies;
    if (scene.engine) {
        render::HandChannel& channel = scene.engine->channel();
        bodies = {channel.engine, channel.frame.read().number, scene.engine->take_refused()};
    }
    recording_->push({time_s, sample, command.force_n, state_.tool().touched(), recorded_as_, reads, bodies});
}

void ServoLoop::run() noexcept {
    counted_.scheduling = request_real_time();
    counted_.memory_locked = lock_memory();
    if (recording_) run_as<true>();
    else run_as<false>();
    close();
}

template <bool kRecorded>
void ServoLoop::run_as() noexcept {
    double next_s = clock_.now_s();
    while (step_as<kRecorded>()) {
        next_s += period_s_;
        const double now_s = clock_.now_s();
        if (now_s >= next_s) {
            // The tick is late. Missed ticks are not computed later; the schedule continues from now.
            ++counted_.overruns;
            next_s = now_s + period_s_;
        }
        clock_.sleep_until_s(next_s);
    }
}

}  // namespace handrail::servo
