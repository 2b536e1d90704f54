// Measures samples at 48 kHz with libebur128. Programs that include this header must link PkgConfig::EBUR128.
#pragma once

#include <ebur128.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

#include "tests/support/names.h"

namespace handrail::test {

struct Measured {
    double lufs = -120.0;  // loudness of the loudest 400 ms
    double true_peak_db = -120.0;
};

// Measures the samples, which alternate between the channels. If they are shorter than 400 ms, they are measured with
// silence around them.
inline Measured measured(std::span<const float> frames, unsigned channels) {
    ebur128_state* state = ebur128_init(channels, 48000, EBUR128_MODE_M | EBUR128_MODE_TRUE_PEAK);
    if (state == nullptr) throw std::runtime_error("libebur128 gives no state");
    Measured all;
    std::vector<float> padded(frames.begin(), frames.end());
    padded.resize(padded.size() + 19200 * channels);
    constexpr std::size_t kPiece = 480;
    for (std::size_t at = 0; at < padded.size() / channels; at += kPiece) {
        const std::size_t count = std::min(kPiece, padded.size() / channels - at);
        ebur128_add_frames_float(state, padded.data() + at * channels, count);
        double lufs = -120.0;
        if (ebur128_loudness_momentary(state, &lufs) == EBUR128_SUCCESS) all.lufs = std::max(all.lufs, lufs);
    }
    double highest = 1e-9;
    for (unsigned channel = 0; channel < channels; ++channel) {
        double peak = 0.0;
        ebur128_true_peak(state, channel, &peak);
        highest = std::max(highest, peak);
    }
    all.true_peak_db = 20.0 * std::log10(highest);
    ebur128_destroy(&state);
    return all;
}

}  // namespace handrail::test
