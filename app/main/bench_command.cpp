#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/core/world/entering.h"
#include "app/main/commands.h"
#include "app/main/world_files.h"
#include "haptic/device/simulated_device.h"
#include "haptic/servo/servo_loop.h"
#include "settings/settings.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr double kSeconds = 10.0;
constexpr double kSweep_m = 0.035;  // the hand's amplitude, measured from the middle of its workspace
constexpr double kLookEvery_s = 0.016;

struct ServoMeasured {
    std::uint64_t ticks = 0, overruns = 0;
    double touching = 0.0;  // share of the samples at which the hand touched something
    PeriodHistogram periods;
    DurationHistogram durations;
    std::string scheduling;
};

// Measures the servo as it runs in the program: on its own thread, in real time. A simulated hand sweeps around the
// place where a person starts in this world. Returns after `seconds`.
Result<ServoMeasured> measure_servo(const EnteringWorld& world, double seconds) {
    SteadyClock clock;
    auto hand = std::make_shared<SimulatedHand>();
    ServoLoop loop(std::make_unique<SimulatedDevice>(*find_device_spec("sim-f"), hand), clock);
    if (const Result<void> opened = loop.open(); !opened) return tl::unexpected(opened.error());
    const Settings settings;
    ServoTuning tuning;
    tuning.touch.world_m_per_hand_m = settings.workspace.scale;
    loop.set_tuning(tuning);
    WorkspacePose pose;
    pose.origin_m = world.feet_m + Vec3(0.0, 0.0, settings.workspace.hand_height_m);
    pose.heading_rad = world.heading_rad;
    loop.set_pose(pose);
    loop.set_scene(world.sharp);
    const double begun_s = clock.now_s();
    loop.start();
    std::uint64_t looks = 0, touching = 0;
    // The hand turns around three axes at once, so that it meets surfaces on all sides.
    for (double at_s = 0.0; at_s < seconds; at_s = clock.now_s() - begun_s) {
        const double turn = 2.0 * kPi * at_s;
        const Vec3 at(std::sin(turn), std::sin(0.7 * turn), std::cos(0.3 * turn));
        hand->command.publish({HandMode::Follow, at * kSweep_m, 0.0, Vec3(0.0), 0});
        ++looks;
        touching += loop.tool().contacts.count > 0 ? 1 : 0;
        clock.sleep_until_s(clock.now_s() + kLookEvery_s);
    }
    loop.stop();
    const ServoReport& report = loop.report();
    return ServoMeasured{
        loop.tool().ticks,       report.overruns,  static_cast<double>(touching) / static_cast<double>(looks),
        report.counters.periods, report.durations, scheduling_sentence(report.scheduling)};
}

std::string json_of(const ServoMeasured& measured, double seconds, const std::string& world) {
    const auto quantiles = [](const auto& times) {
        return nlohmann::ordered_json{{"p50_s", times.quantile_s(0.5)},
                                      {"p99_s", times.quantile_s(0.99)},
                                      {"p999_s", times.quantile_s(0.999)},
                                      {"worst_s", times.worst_s}};
    };
    const nlohmann::ordered_json json{{"world", world},
                                      {"seconds", seconds},
                                      {"ticks", measured.ticks},
                                      {"overruns", measured.overruns},
                                      {"touching", measured.touching},
                                      {"period", quantiles(measured.periods)},
                                      {"tick", quantiles(measured.durations)},
                                      {"scheduling", measured.scheduling}};
    return json.dump(2) + "\n";
}

std::string text_of(const ServoMeasured& measured, double seconds, const std::string& world) {
    return phrase("bench.servo", {{"world", world},
                                  {"seconds", seconds},
                                  {"ticks", static_cast<double>(measured.ticks)},
                                  {"period", 1e3 * measured.periods.quantile_s(0.99)},
                                  {"longest", 1e3 * measured.periods.worst_s},
                                  {"tick", 1e6 * measured.durations.quantile_s(0.99)},
                                  {"most", 1e6 * measured.durations.worst_s}}) +
           "\n" + measured.scheduling + "\n";
}

}  // namespace

int run_bench_command(const BenchArguments& arguments, std::ostream& out, std::ostream& err, const LongWork& progress) {
    const auto refuse = [&](const Error& error) {
        progress.done();
        err << error.sentence() << '\n';
        return 1;
    };
    const Result<std::filesystem::path> file = world_given(arguments.world.value_or("house"));
    if (!file) return refuse(file.error());
    ReadOptions options = arguments.common.read_options(*file);
    const Result<ImportedWorld> read = imported(*file, progress.followed(options));
    if (!read) return refuse(read.error());
    const EnteringWorld world = make_ready_to_touch(std::make_shared<const Scene>(read->scene));
    progress.at(phrase("progress.bench"));
    const double seconds = arguments.seconds.value_or(kSeconds);
    const Result<ServoMeasured> measured = measure_servo(world, seconds);
    if (!measured) return refuse(measured.error());
    progress.done();
    const std::string name = one_line(spoken_name(*world.file));
    out << (arguments.json ? json_of(*measured, seconds, name) : text_of(*measured, seconds, name)) << std::flush;
    return 0;
}

}  // namespace handrail
