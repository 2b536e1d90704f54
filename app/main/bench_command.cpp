#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/core/world/entering.h"
#include "app/main/commands.h"
#include "app/main/world_files.h"
#include "haptic/servo/servo_measure.h"
#include "settings/settings.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::program {
namespace {

constexpr double kSeconds = 10.0;

std::string json_of(const servo::ServoMeasured& measured, const std::string& world) {
    const auto quantiles = [](const auto& times) {
        return nlohmann::ordered_json{{"p50_s", times.quantile_s(0.5)},
                                      {"p99_s", times.quantile_s(0.99)},
                                      {"p999_s", times.quantile_s(0.999)},
                                      {"worst_s", times.worst_s}};
    };
    const nlohmann::ordered_json json{{"world", world},
                                      {"seconds", measured.seconds},
                                      {"ticks", measured.ticks},
                                      {"overruns", measured.overruns},
                                      {"touching", measured.touching},
                                      {"period", quantiles(measured.periods)},
                                      {"tick", quantiles(measured.durations)},
                                      {"scheduling", measured.scheduling}};
    return json.dump(2) + "\n";
}

std::string text_of(const servo::ServoMeasured& measured, const std::string& world) {
    return phrase("bench.servo", {{"world", world},
                                  {"seconds", measured.seconds},
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
    readers::ReadOptions options = arguments.common.read_options(*file);
    const Result<importing::ImportedWorld> read = imported(*file, progress.followed(options));
    if (!read) return refuse(read.error());
    const core::EnteringWorld world = core::make_ready_to_touch(std::make_shared<const Scene>(read->scene));
    progress.at(phrase("progress.bench"));
    const settings::Settings settings;
    servo::ServoTuning tuning;
    tuning.touch.world_m_per_hand_m = settings.workspace.scale;
    servo::WorkspacePose pose;
    pose.origin_m = world.feet_m + Vec3(0.0, 0.0, settings.workspace.hand_height_m);
    pose.heading_rad = world.heading_rad;
    const Result<servo::ServoMeasured> measured =
        servo::measure_servo(world.sharp, pose, tuning, arguments.seconds.value_or(kSeconds));
    if (!measured) return refuse(measured.error());
    progress.done();
    const std::string name = one_line(spoken_name(*world.file));
    out << (arguments.json ? json_of(*measured, name) : text_of(*measured, name)) << std::flush;
    return 0;
}

}  // namespace handrail::program
