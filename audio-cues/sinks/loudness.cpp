#include "audio-cues/sinks/loudness.h"

#include <algorithm>
#include <cmath>

#include "audio-cues/plan/sound_rank.h"
#include "audio-cues/plan/sound_table.h"
#include "audio-cues/sinks/synth.h"

namespace handrail::sinks {
namespace {

// A filter section with two poles and two zeros.
class Biquad {
public:
    Biquad(double b0, double b1, double b2, double a1, double a2) : b0_(b0), b1_(b1), b2_(b2), a1_(a1), a2_(a2) {}
    double operator()(double in) {
        const double out = b0_ * in + z1_;
        z1_ = b1_ * in - a1_ * out + z2_;
        z2_ = b2_ * in - a2_ * out;
        return out;
    }

private:
    double b0_, b1_, b2_, a1_, a2_;
    double z1_ = 0.0, z2_ = 0.0;
};

}  // namespace

double momentary_lufs(std::span<const float> samples) {
    constexpr std::size_t kWindow = 19200, kHop = 480;
    // The two filters of BS.1770 at 48 kHz. One models the effect of the head, the other removes frequencies too low to
    // sound loud.
    Biquad head(1.53512485958697, -2.69169618940638, 1.19839281085285, -1.69065929318241, 0.73248077421585);
    Biquad low(1.0, -2.0, 1.0, -1.99004745483398, 0.99007225036621);
    std::vector<double> energy{0.0};  // sum of the energy up to the end of each hop
    double sum = 0.0, most = 0.0;
    for (std::size_t i = 0; i < samples.size() + kWindow; ++i) {
        const double x = low(head(i < samples.size() ? static_cast<double>(samples[i]) : 0.0));
        sum += x * x;
        if ((i + 1) % kHop != 0) continue;
        energy.push_back(sum);
        const std::size_t before = energy.size() > kWindow / kHop ? energy.size() - 1 - kWindow / kHop : 0;
        most = std::max(most, sum - energy[before]);
    }
    const double mean = most / static_cast<double>(kWindow);
    return mean > 1e-12 ? -0.691 + 10.0 * std::log10(mean) : -120.0;
}

std::vector<float> levelled_sound(cues::SoundKind kind, SoundClass material) {
    return levelled_sound(kind, synthesise(kind, material));
}

std::vector<float> levelled_sound(cues::SoundKind kind, std::vector<float> samples) {
    const settings::Settings::Sound at_first;
    const double wanted_lufs =
        cues::loudness_of(cues::rank_of(kind)) - 20.0 * std::log10(at_first.*cues::info(kind).volume);
    float peak = 1e-9F;
    for (const float s : samples) peak = std::max(peak, std::abs(s));
    const double gain =
        std::min(std::pow(10.0, (wanted_lufs - momentary_lufs(samples)) / 20.0), kMostPeak / static_cast<double>(peak));
    for (float& s : samples) s = static_cast<float>(gain * static_cast<double>(s));
    return samples;
}

}  // namespace handrail::sinks
