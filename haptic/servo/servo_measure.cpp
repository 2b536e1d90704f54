#include "haptic/servo/servo_measure.h"

#include <cmath>
#include <utility>

#include "haptic/device/simulated_device.h"
#include "haptic/servo/servo_loop.h"
#include "worlds/base/contract.h"

namespace handrail::servo {
namespace {

constexpr double kSweep_m = 0.035;
constexpr double kSampleEvery_s = 0.016;

}  // namespace

Result<ServoMeasured> measure_servo(std::shared_ptr<const render::HapticScene> scene, const WorkspacePose& pose,
                                    const ServoTuning& tuning, double seconds) {
    contract_pre(scene != nullptr);
    contract_pre(seconds > 0.0);
    SteadyClock clock;
    auto hand = std::make_shared<device::SimulatedHand>();
    ServoLoop loop(std::make_unique<device::SimulatedDevice>(*device::find_device_spec("sim-f"), hand), clock);
    if (const Result<void> opened = loop.open(); !opened) return tl::unexpected(opened.error());
    loop.set_tuning(tuning);
    loop.set_pose(pose);
    loop.set_scene(std::move(scene));
    const double begun_s = clock.now_s();
    loop.start();
    std::uint64_t samples = 0, touching = 0;
    // The hand moves with three frequencies without a common multiple, so that it touches objects on all sides.
    for (double at_s = 0.0; at_s < seconds; at_s = clock.now_s() - begun_s) {
        const double turn = 2.0 * kPi * at_s;
        const Vec3 at(std::sin(turn), std::sin(0.7 * turn), std::cos(0.3 * turn));
        hand->command.publish({device::HandMode::Follow, at * kSweep_m, 0.0, Vec3(0.0), 0});
        ++samples;
        touching += loop.tool().contacts.count > 0 ? 1 : 0;
        clock.sleep_until_s(clock.now_s() + kSampleEvery_s);
    }
    loop.stop();
    const ServoReport& report = loop.report();
    return ServoMeasured{seconds,
                         loop.tool().ticks,
                         report.overruns,
                         static_cast<double>(touching) / static_cast<double>(samples),
                         report.counters.periods,
                         report.durations,
                         scheduling_sentence(report.scheduling)};
}

}  // namespace handrail::servo
