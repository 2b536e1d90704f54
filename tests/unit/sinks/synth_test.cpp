#include "audio-cues/sinks/synth.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <complex>

#include "tests/support/names.h"
#include "worlds/base/vec.h"

namespace handrail {
namespace synth_test {

// The properties by which a listener distinguishes sounds. Each is computed from its definition.
struct Character {
    double centroid_hz = 0.0;  // centre of mass of the power spectrum between 60 Hz and 16 kHz
    double decay_s = 0.0;      // time until 99 % of the sound's energy has passed
};

double band_power(std::span<const float> x, double hz) {
    const std::complex<double> turn = std::polar(1.0, -2.0 * kPi * hz / kSampleRate_hz);
    std::complex<double> phase = 1.0, sum = 0.0;
    for (const float s : x) {
        sum += static_cast<double>(s) * phase;
        phase *= turn;
    }
    return std::norm(sum);
}

Character character_of(std::span<const float> x) {
    Character c;
    double weighted = 0.0, power = 0.0;
    for (double hz = 60.0; hz < 16000.0; hz *= 1.02) {
        // The bands have a constant frequency ratio, so their width is proportional to their frequency.
        const double p = band_power(x, hz) * hz;
        weighted += p * std::log(hz);
        power += p;
    }
    c.centroid_hz = std::exp(weighted / power);
    double energy = 0.0, part = 0.0;
    for (const float s : x) energy += static_cast<double>(s) * static_cast<double>(s);
    for (std::size_t i = 0; i < x.size(); ++i) {
        part += static_cast<double>(x[i]) * static_cast<double>(x[i]);
        if (part < 0.99 * energy) c.decay_s = static_cast<double>(i + 1) / kSampleRate_hz;
    }
    return c;
}

double ratio(double a, double b) { return std::max(a, b) / std::min(a, b); }

void expect_all_pairs_differ(SoundKind kind, double least) {
    std::vector<Character> all;
    for (int m = 0; m < kSoundClasses; ++m) {
        all.push_back(character_of(synthesise(kind, static_cast<SoundClass>(m))));
        std::cout << "    material " << m << ": centroid " << std::lround(all.back().centroid_hz) << " Hz, ring "
                  << std::lround(1e3 * all.back().decay_s) << " ms\n";
    }
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            EXPECT_GE(std::max(ratio(all[a].centroid_hz, all[b].centroid_hz), ratio(all[a].decay_s, all[b].decay_s)),
                      least)
                << a << " and " << b;
}

TEST(Synth, any_two_materials_differ_when_struck) { expect_all_pairs_differ(SoundKind::Contact, 1.33); }
TEST(Synth, any_two_materials_differ_when_stepped_on) { expect_all_pairs_differ(SoundKind::Footstep, 1.15); }

TEST(Synth, any_two_materials_differ_when_stroked) {
    // Loops do not ring, so their decay is meaningless. Besides brightness, they differ in roughness: how much the
    // loudness varies between successive intervals of 10 ms.
    struct Stroke {
        double centroid_hz, roughness;
    };
    std::vector<Stroke> all;
    for (int m = 0; m < kSoundClasses; ++m) {
        const std::vector<float> x = synthesise(SoundKind::Slide, static_cast<SoundClass>(m));
        std::vector<double> levels;
        for (std::size_t i = 0; i + 480 <= x.size(); i += 480) {
            double e = 0.0;
            for (std::size_t j = i; j < i + 480; ++j) e += static_cast<double>(x[j]) * static_cast<double>(x[j]);
            levels.push_back(std::sqrt(e / 480.0));
        }
        double mean = 0.0, spread = 0.0;
        for (const double l : levels) mean += l / static_cast<double>(levels.size());
        for (const double l : levels) spread += (l - mean) * (l - mean) / static_cast<double>(levels.size());
        all.push_back({character_of(std::span(x).first(12000)).centroid_hz, std::sqrt(spread) / mean});
        std::cout << "    material " << m << ": centroid " << std::lround(all.back().centroid_hz) << " Hz, roughness "
                  << all.back().roughness << '\n';
    }
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            EXPECT_GE(
                std::max(ratio(all[a].centroid_hz, all[b].centroid_hz), ratio(all[a].roughness, all[b].roughness)), 1.2)
                << a << " and " << b;
}

class EverySound : public ::testing::TestWithParam<int> {};

TEST_P(EverySound, is_finite_in_range_and_identical_each_time) {
    const auto kind = static_cast<SoundKind>(GetParam());
    for (int m = 0; m < kSoundClasses; ++m) {
        const std::vector<float> x = synthesise(kind, static_cast<SoundClass>(m));
        float peak = 0.0F;
        for (const float s : x) {
            ASSERT_TRUE(std::isfinite(s));
            peak = std::max(peak, std::abs(s));
        }
        EXPECT_LE(peak, 0.5F + 1e-6F);
        EXPECT_GE(peak, 0.2F);
        EXPECT_EQ(x, synthesise(kind, static_cast<SoundClass>(m)));
        if (!varies_by_material(kind)) break;
    }
}

TEST_P(EverySound, is_loud_within_3_ms_and_starts_and_ends_without_a_click) {
    const auto kind = static_cast<SoundKind>(GetParam());
    const std::vector<float> x = synthesise(kind, SoundClass::Plaster);
    if (is_loop(kind)) {
        // At the seam between the loop's end and its beginning, the step must be no larger than the steps inside the
        // loop.
        float largest = 0.0F;
        for (std::size_t i = 1; i < x.size(); ++i) largest = std::max(largest, std::abs(x[i] - x[i - 1]));
        EXPECT_LE(std::abs(x.front() - x.back()), largest);
        return;
    }
    EXPECT_LE(std::abs(x.front()), 0.05F);
    EXPECT_LE(std::abs(x.back()), 0.005F);
    float early = 0.0F;
    for (std::size_t i = 0; i < 144; ++i) early = std::max(early, std::abs(x[i]));
    EXPECT_GE(early, 0.05F);
}

INSTANTIATE_TEST_SUITE_P(Synth, EverySound, ::testing::Range(0, kSoundKinds));

TEST(Synth, every_sound_has_a_unique_cache_slot) {
    using Clock = std::chrono::steady_clock;
    std::size_t samples = 0, places = 0;
    double spent_ms = 0.0, longest_ms = 0.0, longest_struck_ms = 0.0;
    std::vector<bool> taken(kSounds, false);
    for (int k = 0; k < kSoundKinds; ++k)
        for (int m = 0; m < kSoundClasses; ++m) {
            const auto kind = static_cast<SoundKind>(k);
            const auto material = static_cast<SoundClass>(m);
            const std::size_t index = sound_index(kind, material);
            ASSERT_LT(index, kSounds);
            if (!varies_by_material(kind)) {
                ASSERT_EQ(index, sound_index(kind, SoundClass::Generic));
                if (m > 0) continue;
            }
            ASSERT_FALSE(taken[index]);
            taken[index] = true;
            ++places;
            const auto before = Clock::now();
            samples += synthesise(kind, material).size();
            const double took_ms = std::chrono::duration<double, std::milli>(Clock::now() - before).count();
            spent_ms += took_ms;
            longest_ms = std::max(longest_ms, took_ms);
            if (kind == SoundKind::Contact) longest_struck_ms = std::max(longest_struck_ms, took_ms);
        }
    std::cout << "    all " << places << " sounds: " << std::lround(spent_ms) << " ms, "
              << samples * sizeof(float) / 1000 << " kB; the longest " << longest_ms << " ms, of what is struck "
              << longest_struck_ms << " ms\n";
}

}  // namespace synth_test
}  // namespace handrail
