#include "tests/bench/compare/measure.h"

#include <ctime>

#include <algorithm>
#include <cmath>

#include "tests/bench/compare/reference.h"
#include "tests/support/names.h"
#include "worlds/base/clock.h"

namespace handrail::bench {

double thread_s() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

namespace {

// Reads the processor's time-stamp counter or, on a processor without one, a clock. Reading takes some 10 ns, or 25 ns
// for the clock.
#if defined(__x86_64__)
std::uint64_t counter() { return __builtin_ia32_rdtsc(); }
#else
std::uint64_t counter() { return static_cast<std::uint64_t>(SteadyClock().now_s() * 1e9); }
#endif

double seconds_per_count() {
    static const double seconds = [] {
        const SteadyClock clock;
        const double begun_s = clock.now_s();
        const std::uint64_t begun = counter();
        while (clock.now_s() - begun_s < 0.02) {
        }
        return (clock.now_s() - begun_s) / static_cast<double>(counter() - begun);
    }();
    return seconds;
}

// Returns the time that reading the counter itself takes.
std::uint64_t counter_cost() {
    static const std::uint64_t cost = [] {
        std::uint64_t least = ~0ULL;
        for (int i = 0; i < 1000; ++i) {
            const std::uint64_t begun = counter();
            least = std::min(least, counter() - begun);
        }
        return least;
    }();
    return cost;
}

class Playing {
public:
    Playing(const Contestant& contestant, const BenchWorld& world)
        : contestant_(contestant), state_(contestant.make(world, contestant.knob_value)) {}
    ~Playing() { contestant_.drop(state_); }
    Playing(const Playing&) = delete;
    Playing& operator=(const Playing&) = delete;
    TickOutcome tick(const Vec3& goal_m) { return contestant_.tick(state_, goal_m); }

private:
    const Contestant& contestant_;
    void* state_;
};

// callgrind starts and stops counting at measured_ticks(), which it finds by its name.
[[gnu::noinline]] double measured_ticks(Playing& playing, const std::vector<Vec3>& goals_m) {
    double sum = 0.0;
    for (const Vec3& goal : goals_m) sum += playing.tick(goal).tool_m.x;
    return sum;
}

double kept = 0.0;  // the sum uses all results, so that the compiler does not remove the work

void time_it(const BenchWorld& world, const Contestant& contestant, int passes, Measured& out) {
    const std::size_t ticks = world.goals_m.size();
    double best_s = std::numeric_limits<double>::infinity();
    std::vector<std::uint64_t> least(ticks, ~0ULL);
    for (int pass = 0; pass < passes; ++pass) {
        {
            Playing playing(contestant, world);
            const double begun_s = thread_s();
            kept += measured_ticks(playing, world.goals_m);
            best_s = std::min(best_s, thread_s() - begun_s);
        }
        Playing playing(contestant, world);
        for (std::size_t i = 0; i < ticks; ++i) {
            const std::uint64_t begun = counter();
            kept += playing.tick(world.goals_m[i]).tool_m.x;
            const std::uint64_t took = counter() - begun;
            least[i] = std::min(least[i], took > counter_cost() ? took - counter_cost() : 0);
        }
    }
    std::sort(least.begin(), least.end());
    const auto at = [&](double share) {
        return static_cast<double>(
                   least[std::min(ticks - 1, static_cast<std::size_t>(share * static_cast<double>(ticks)))]) *
               seconds_per_count();
    };
    out.mean_s = best_s / static_cast<double>(ticks);
    out.p50_s = at(0.5);
    out.p999_s = at(0.999);
    out.worst_s = at(1.0);
}

}  // namespace

Truth truth_of(const BenchWorld& world, double most_work) { return {reference_walk(world, most_work)}; }

Measured measure(const BenchWorld& world, const Truth& truth, const Contestant& contestant, int passes,
                 double judging_work) {
    constexpr double kOff_m = 1e-5, kHeld_m = 0.5e-3, kStep_m = 1e-6;
    Measured out;
    out.scene = world.name;
    out.family = world.family;
    out.seed = world.seed;
    out.renderer = contestant.key;
    out.title = contestant.title;
    out.knob = contestant.knob;
    out.knob_value = contestant.knob_value;
    out.has_proxy = contestant.has_proxy && world.judged;
    const std::size_t ticks = out.ticks = world.goals_m.size();
    if (ticks == 0) return out;
    time_it(world, contestant, passes, out);

    // Runs the path once more to record the outcomes for the judge.
    std::vector<TickOutcome> outcomes;
    outcomes.reserve(ticks);
    {
        Playing playing(contestant, world);
        for (const Vec3& goal : world.goals_m) outcomes.push_back(playing.tick(goal));
    }
    const bool closed = glm::length(world.goals_m.front() - world.goals_m.back()) < 1e-9;
    double energy_j = 0.0, error2 = 0.0, rounds = 0.0, angle2 = 0.0, largest_angle = 0.0;
    std::size_t off = 0, angles = 0;
    bool was_wrong = false;
    std::vector<double> errors;
    out.referenced = truth.reference_m.size() == ticks;
    const auto stride =
        static_cast<std::size_t>(1.0 + static_cast<double>(ticks) * world.judging_work() / judging_work);
    for (std::size_t i = 0; i < ticks; ++i) {
        const Vec3& goal = world.goals_m[i];
        const Vec3 pull = outcomes[i].tool_m - goal;
        rounds += outcomes[i].rounds;
        out.most_rounds = std::max(out.most_rounds, outcomes[i].rounds);
        if (i > 0) {
            const Vec3 step = goal - world.goals_m[i - 1], last = outcomes[i - 1].tool_m - world.goals_m[i - 1];
            const double change = glm::length(pull - last);
            out.largest_jump_n = std::max(out.largest_jump_n, kStiffness_n_per_m * change);
            if (glm::length(step) > kStep_m) out.largest_gain = std::max(out.largest_gain, change / glm::length(step));
            energy_j += 0.5 * kStiffness_n_per_m * glm::dot(pull + last, step);
        }
        if (out.referenced) {
            const Vec3 wanted = truth.reference_m[i] - goal;
            const double error = glm::length(outcomes[i].tool_m - truth.reference_m[i]);
            errors.push_back(error);
            error2 += error * error;
            off += error > kOff_m;
            const bool wrong = glm::length(wanted) > kHeld_m && glm::dot(pull, wanted) <= 0.0;
            out.wrong_holds += wrong && !was_wrong;
            was_wrong = wrong;
        }
        if (const double far = glm::length(goal); world.sphere_radius_m > 0.0 &&
                                                  world.sphere_radius_m + world.radius_m - far > kHeld_m &&
                                                  glm::length(pull) > 0.0) {
            const double angle = std::atan2(glm::length(glm::cross(pull, goal)), glm::dot(pull, goal));
            angle2 += angle * angle;
            largest_angle = std::max(largest_angle, angle);
            ++angles;
        }
        if (out.has_proxy && i % stride == 0)
            out.penetration_m =
                std::max(out.penetration_m, static_cast<double>(static_cast<long double>(world.radius_m) -
                                                                world.judge.distance(outcomes[i].tool_m, 0.02L)));
    }
    out.mean_rounds = rounds / static_cast<double>(ticks);
    if (closed) out.given_j = energy_j;
    if (out.referenced) {
        out.error_rms_m = std::sqrt(error2 / static_cast<double>(ticks));
        out.off_share = static_cast<double>(off) / static_cast<double>(ticks);
        std::sort(errors.begin(), errors.end());
        out.error_p99_m = errors[errors.size() * 99 / 100];
        out.error_max_m = errors.back();
    }
    if (angles > 0) {
        out.direction_error_rms_rad = std::sqrt(angle2 / static_cast<double>(angles));
        out.direction_error_max_rad = largest_angle;
    }
    return out;
}

double counted_ticks(const BenchWorld& world, const Contestant& contestant) {
    Playing playing(contestant, world);
    return measured_ticks(playing, world.goals_m);
}

}  // namespace handrail::bench
