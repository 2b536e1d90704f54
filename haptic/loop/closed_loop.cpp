#include "haptic/loop/closed_loop.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "worlds/base/contract.h"

namespace handrail::loop {
namespace {

constexpr double kTremor_hz[3] = {8.0, 10.0, 12.0};

// Filters `signal` by one second-order section of a high-pass filter (Robert Bristow-Johnson's cookbook).
void high_pass(std::vector<double>& signal, double cut_hz, double period_s, double quality) {
    const double w = 2.0 * kPi * cut_hz * period_s, alpha = std::sin(w) / (2.0 * quality), c = std::cos(w);
    const double b0 = (1.0 + c) / 2.0, b1 = -(1.0 + c), a0 = 1.0 + alpha, a1 = -2.0 * c, a2 = 1.0 - alpha;
    double x1 = 0.0, x2 = 0.0, y1 = 0.0, y2 = 0.0;
    for (double& v : signal) {
        const double out = (b0 * v + b1 * x1 + b0 * x2 - a1 * y1 - a2 * y2) / a0;
        x2 = x1;
        x1 = v;
        y2 = y1;
        y1 = out;
        v = out;
    }
}

}  // namespace

ClosedLoop::ClosedLoop(const LoopSettings& settings, const Vec3& start_m)
    : settings_(settings), random_(settings.seed), body_{start_m, Vec3(0.0)} {
    contract_pre(settings.period_s > 0.0 && settings.delay_s >= 0.0);
    contract_pre(is_finite(start_m));
    for (double& phase : phases_) phase = 2.0 * kPi * unit();
    since_s_ = settings.period_s;
    last_.hand_m = start_m;
}

double ClosedLoop::unit() { return static_cast<double>(random_()) / 4294967296.0; }

// Draws the noise along each axis as the sum of twelve uniform numbers. That is nearly normal up to three sigma, and
// identical with every standard library.
Vec3 ClosedLoop::noise_m() {
    if (settings_.noise_m == 0.0) return Vec3(0.0);
    Vec3 sum(-6.0);
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 12; ++i) sum[axis] += unit();
    return sum * settings_.noise_m;
}

Vec3 ClosedLoop::tremor_m(double time_s) const {
    Vec3 sum(0.0);
    if (settings_.tremor_m == 0.0) return sum;
    for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < kTremors; ++k)
            sum[axis] += std::sin(2.0 * kPi * kTremor_hz[k] * time_s + phases_[axis * kTremors + k]);
    return sum * (settings_.tremor_m * std::sqrt(2.0 / kTremors));
}

LoopTick ClosedLoop::tick(const Intent& intent, const Render& render) {
    contract_pre(intent && render);
    const double begin_s = static_cast<double>(periods_) * settings_.period_s;
    last_.time_s = begin_s;
    last_.stalled = settings_.stall_every_s > 0.0 && begin_s >= settings_.stall_every_s - 1e-9 &&
                    std::fmod(begin_s + 1e-9, settings_.stall_every_s) < settings_.stall_s - 1e-9;
    if (last_.stalled) {
        since_s_ += settings_.period_s;
    } else {
        last_.measured_m = device::encoded_m(body_.position_m + noise_m(), settings_.encoder_quantum_m);
        last_.commanded_n = render(last_.measured_m, begin_s, since_s_);
        held_.give(begin_s + settings_.delay_s, last_.commanded_n);
        since_s_ = settings_.period_s;
    }
    const double step_s = settings_.period_s / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const double now_s = begin_s + i * step_s;
        const Vec3 motor_n = held_.at(now_s), before = body_.position_m;
        const HandIntent intended = intent(now_s);
        device::advance_hand(body_, settings_.hand, intended.target_m + tremor_m(now_s), motor_n + intended.push_n,
                             step_s);
        last_.work_j += glm::dot(motor_n, body_.position_m - before);
    }
    ++periods_;
    last_.hand_m = body_.position_m;
    last_.velocity_m_per_s = body_.velocity_m_per_s;
    return last_;
}

double rms_above(std::span<const double> signal, double cut_hz, double period_s) {
    contract_pre(cut_hz > 0.0 && period_s > 0.0);
    if (signal.size() < 10) return 0.0;
    std::vector<double> high(signal.begin(), signal.end());
    double mean = 0.0;
    for (const double v : high) mean += v / static_cast<double>(high.size());
    for (double& v : high) v -= mean;
    high_pass(high, cut_hz, period_s, 0.5412);
    high_pass(high, cut_hz, period_s, 1.3066);
    double sum = 0.0;
    const std::size_t settled = high.size() / 5;
    for (std::size_t i = settled; i < high.size(); ++i) sum += high[i] * high[i];
    return std::sqrt(sum / static_cast<double>(high.size() - settled));
}

double largest_step(std::span<const double> signal) {
    double largest = 0.0;
    for (std::size_t i = 1; i < signal.size(); ++i) largest = std::max(largest, std::abs(signal[i] - signal[i - 1]));
    return largest;
}

double peak_to_peak(std::span<const double> signal) {
    if (signal.empty()) return 0.0;
    const auto [low, high] = std::minmax_element(signal.begin(), signal.end());
    return *high - *low;
}

int sign_changes(std::span<const double> signal) {
    int changes = 0;
    double last = 0.0;
    for (const double v : signal) {
        if (v == 0.0) continue;
        changes += v * last < 0.0;
        last = v;
    }
    return changes;
}

double stable_stiffness_n_per_m(LoopSettings settings, const std::function<ClosedLoop::Render(double)>& wall,
                                double press_n, double seconds_s, double factor) {
    contract_pre(wall && press_n > 0.0);
    contract_pre(seconds_s > 0.0 && factor > 1.0);
    constexpr double kSoftest = 50.0, kStiffest = 60000.0, kQuiet_m = 0.3e-3;
    const HandIntent leaning{
        Vec3(settings.hand.spring_n_per_m > 0.0 ? -press_n / settings.hand.spring_n_per_m : 0.0, 0.0, 0.0),
        Vec3(settings.hand.spring_n_per_m > 0.0 ? 0.0 : -press_n, 0.0, 0.0)};
    double last_stable = 0.0;
    std::vector<double> places;
    for (double stiffness = kSoftest; stiffness < kStiffest; stiffness *= factor) {
        ClosedLoop loop(settings, Vec3(0.01, 0.0, 0.0));
        const ClosedLoop::Render render = wall(stiffness);
        const int ticks = static_cast<int>(seconds_s / settings.period_s);
        places.clear();
        bool lost = false;
        for (int i = 0; i < ticks && !lost; ++i) {
            const LoopTick tick = loop.tick([&](double) { return leaning; }, render);
            lost = !(std::abs(tick.hand_m.x) < 10.0);
            if (i > 2 * ticks / 3) places.push_back(tick.hand_m.x);
        }
        if (lost || peak_to_peak(places) > kQuiet_m) break;
        last_stable = stiffness;
    }
    return last_stable;
}

}  // namespace handrail::loop
