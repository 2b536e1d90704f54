#include "tests/bench/compare/bench.h"

#include <fmt/chrono.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <utility>

#include "tests/support/names.h"
#include "tests/support/worst_cases.h"
#include "worlds/base/clock.h"
#include "worlds/base/text.h"

namespace handrail::bench {
namespace {

// Option that selects the worst places, in which only Handrail's own renderer runs.
constexpr const char* kWorst = "worst";
// Option that selects the moving objects. They are no comparison of renderers either.
constexpr const char* kBodies = "bodies";

// A scene that is built only when it is measured and freed afterwards, so that scenes of a million triangles do not
// stay in memory.
struct Planned {
    std::string name;
    std::string family;
    std::function<Result<BenchWorld>()> make;
};

std::vector<Planned> plan(const BenchOptions& options, std::vector<std::string>& left_out) {
    std::vector<Planned> all;
    const int seeds = options.quick ? 0 : options.seeds;
    for (int seed = 0; seed <= seeds; ++seed) {
        auto cases = std::make_shared<std::vector<BenchWorld>>(hard_case_worlds(static_cast<std::uint32_t>(seed)));
        for (std::size_t i = 0; i < cases->size(); ++i)
            all.push_back({(*cases)[i].name, (*cases)[i].family,
                           [cases, i]() -> Result<BenchWorld> { return std::move((*cases)[i]); }});
    }
    const auto add = [&](const std::string& family, int seed, std::function<Result<BenchWorld>()> make) {
        all.push_back({seed == 0 ? family : fmt::format("{}, seed {}", family, seed), family, std::move(make)});
    };
    for (const int frequency : options.quick ? std::vector<int>{7, 22} : std::vector<int>{7, 22, 71, 224})
        for (int seed = 0; seed <= (options.quick ? 0 : std::min(seeds, 1)); ++seed)
            add(fmt::format("sphere of {} triangles", 20 * frequency * frequency), seed,
                [=, quick = options.quick]() -> Result<BenchWorld> {
                    return sphere_world(frequency, quick ? 1000 : 6000, static_cast<std::uint32_t>(seed));
                });
    for (const int sectors : options.quick ? std::vector<int>{200} : std::vector<int>{200, 500, 1000, 2000})
        add(fmt::format("pole of a sphere, {} triangles", sectors), 0,
            [=, quick = options.quick]() -> Result<BenchWorld> { return pole_world(sectors, quick ? 1000 : 4000); });
    for (const double within_m : options.quick ? std::vector<double>{} : std::vector<double>{1e-3, 1.5e-3, 2e-3, 3e-3})
        for (int seed = 0; seed <= std::min(seeds, 1); ++seed)
            add(fmt::format("simplified sphere of 9680 triangles, within {:g} mm", within_m * 1e3), seed,
                [=]() -> Result<BenchWorld> {
                    return sphere_world(22, 6000, static_cast<std::uint32_t>(seed), within_m);
                });
    for (const std::filesystem::path& map : options.maps)
        for (int seed = 0; seed <= (options.quick ? 0 : std::min(seeds, 1)); ++seed)
            add("map " + map.stem().string(), seed, [=, quick = options.quick] {
                return map_world(map, quick ? 4000 : 10000, static_cast<std::uint32_t>(seed));
            });
    if (!options.only.empty()) {
        const std::string wanted = lower_ascii(options.only);
        std::erase_if(all, [&](const Planned& p) {
            return lower_ascii(p.name).find(wanted) == std::string::npos &&
                   lower_ascii(p.family).find(wanted) == std::string::npos;
        });
        if (all.empty() && wanted != kWorst && wanted != kBodies)
            left_out.push_back(fmt::format("No scene is named like \"{}\".", options.only));
    }
    return all;
}

std::string machine() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "a processor that does not tell its name";
}

}  // namespace

BenchReport run_bench(const BenchOptions& options) {
    const SteadyClock clock;
    const double begun_s = clock.now_s();
    BenchReport report;
    report.quick = options.quick;
    report.machine = machine();
    report.day = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
    const auto at = [&](const std::string& scene) {
        if (options.progress) options.progress(scene);
    };
    for (const Planned& planned : plan(options, report.left_out)) {
        at(planned.name);
        const Result<BenchWorld> made = planned.make();
        if (!made) {
            report.left_out.push_back(planned.name + " is left out: " + made.error().sentence());
            continue;
        }
        const BenchWorld& world = *made;
        const Truth truth = truth_of(world, options.quick ? 2e7 : 2e10);
        report.scenes.push_back({world.name, world.family, world.scene->obstacles.size(), world.goals_m.size(),
                                 world.build_s, world.bytes_per_obstacle, !truth.reference_m.empty(),
                                 world.simplify_bound_m, world.simplify_measured_m});
        // For the curves of the knobs, the original scenes and one random variant of each family are enough. A quick
        // run includes only the main renderers.
        for (const Contestant& contestant :
             options.quick || world.seed > 1 ? main_contestants() : knobbed_contestants()) {
            if (contestant.key == "handrail_uncapped" && !world.hard_case) continue;
            report.results.push_back(
                measure(world, truth, contestant, options.quick ? 1 : 4, options.quick ? 1e6 : 1e8));
        }
        if (world.hard_case && (options.quick || world.seed > 1))
            report.results.push_back(
                measure(world, truth, handrail_uncapped(), options.quick ? 1 : 4, options.quick ? 1e6 : 1e8));
    }
    if (options.only.empty() || lower_ascii(options.only) == kWorst)
        for (int number = 0; number < test::kWorstCases; ++number) {
            // A quick run includes only worst case 1, which is built fastest.
            if (options.quick && number != 1) continue;
            at(fmt::format("hard case {} of {}", number + 1, test::kWorstCases));
            report.worst.push_back(run_worst_case(number, options.quick ? 200 : 2000, options.quick ? 1 : 3));
        }
    if (options.only.empty() || lower_ascii(options.only) == kBodies) {
        at("things that move");
        report.bodies = run_bodies();
    }
    if (options.only.empty()) {
        at("stable walls");
        for (const std::string& wall :
             options.quick
                 ? std::vector<std::string>{"flat wall"}
                 : std::vector<std::string>{"flat wall", "three objects that overlap", "groove of 20 degrees"})
            for (const Contestant& contestant : main_contestants())
                report.stability.push_back(stable_stiffness(contestant, wall, options.quick ? 1.5 : 1.1));
        const double seconds = options.quick ? std::min(options.servo_s, 1.0) : options.servo_s;
        if (seconds > 0.0) {
            at("the servo thread");
            if (auto measured = run_servo_thread(seconds)) report.servo = std::move(*measured);
            else report.left_out.push_back("The servo thread is left out: " + measured.error().sentence());
        }
    }
    report.took_s = clock.now_s() - begun_s;
    return report;
}

std::vector<std::string> scene_names(const BenchOptions& options) {
    std::vector<std::string> names, left_out;
    for (const Planned& planned : plan(options, left_out)) names.push_back(planned.name);
    if (options.only.empty() || lower_ascii(options.only) == kWorst) names.emplace_back(kWorst);
    if (options.only.empty() || lower_ascii(options.only) == kBodies) names.emplace_back(kBodies);
    return names;
}

Result<double> count_once(const BenchOptions& options, const std::string& renderer, std::size_t& ticks) {
    const std::vector<Contestant> all = knobbed_contestants();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Contestant& c) { return c.key == renderer; });
    if (found == all.end()) return fail(fmt::format("There is no renderer named \"{}\".", renderer));
    std::vector<std::string> left_out;
    const std::vector<Planned> planned = plan(options, left_out);
    if (planned.empty()) return fail(left_out.empty() ? "There is no scene." : left_out.front());
    const Result<BenchWorld> world = planned.front().make();
    if (!world) return tl::unexpected(world.error());
    ticks = world->goals_m.size();
    return counted_ticks(*world, *found);
}

}  // namespace handrail::bench
