// Judges how steadily the servo loop runs, only from measured periods. Plain state, servo thread only; no clock, no
// allocation.
#pragma once

#include <array>
#include <cstdint>

namespace handrail::servo {

// Detects a loop that is too slow to render a stable wall. A single long gap is not enough: each period adds at most 10
// ms, so at least two in a row are needed.
struct RateWatch {
    static constexpr double kPatienceS = 0.020;
    static constexpr double kMostPerPeriodS = 0.010;

    double counted_s = 0.0;  // sum of the slow periods in a row
    double elapsed_s = 0.0;  // real time since the first of these periods began
};

// Adds one measured period. Returns true once all periods of the last 20 ms were longer than 1 / min_rate_hz. The check
// is disabled if min_rate_hz <= 0.
bool too_slow(RateWatch& watch, double period_s, double min_rate_hz) noexcept;

// Histogram of measured times. Bucket i counts times up to Edges[i] and above the previous edge; the last bucket counts
// all longer times.
template <const std::array<double, 11>& Edges>
struct TimeHistogram {
    std::array<std::uint64_t, Edges.size() + 1> counts{};
    double worst_s = 0.0;

    void add(double time_s) noexcept {
        std::size_t bucket = 0;
        while (bucket < Edges.size() && time_s > Edges[bucket]) ++bucket;
        ++counts[bucket];
        if (time_s > worst_s) worst_s = time_s;
    }
    std::uint64_t total() const noexcept {
        std::uint64_t sum = 0;
        for (const std::uint64_t count : counts) sum += count;
        return sum;
    }
    // Returns the upper edge of the bucket that contains the quantile `share` (0 to 1). In the last bucket it is
    // worst_s; for an empty histogram it is 0.
    double quantile_s(double share) const noexcept {
        const double wanted = static_cast<double>(total()) * share;
        std::uint64_t seen = 0;
        for (std::size_t i = 0; i < Edges.size(); ++i) {
            seen += counts[i];
            if (seen > 0 && static_cast<double>(seen) >= wanted) return Edges[i];
        }
        return worst_s;
    }
};

inline constexpr std::array<double, 11> kPeriodEdgesS{0.0005, 0.0009, 0.0011, 0.00125, 0.0015, 0.002,
                                                      0.003,  0.005,  0.010,  0.025,   0.100};
inline constexpr std::array<double, 11> kDurationEdgesS{2e-6,   5e-6,   10e-6, 20e-6, 50e-6, 100e-6,
                                                        200e-6, 500e-6, 1e-3,  2e-3,  5e-3};
using PeriodHistogram = TimeHistogram<kPeriodEdgesS>;      // times from one tick to the next
using DurationHistogram = TimeHistogram<kDurationEdgesS>;  // times spent in a tick

}  // namespace handrail::servo
