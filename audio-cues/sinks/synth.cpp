#include "audio-cues/sinks/synth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "worlds/base/contract.h"
#include "worlds/base/vec.h"

namespace handrail::sinks {
namespace {

constexpr double kRate = kSampleRate_hz;
constexpr double kPeak = 0.5;

std::size_t samples_of(double seconds) { return static_cast<std::size_t>(std::lround(seconds * kRate)); }

// Kind of object, which determines the ratios of its modes to the lowest one.
enum class Body { Bar, Plate, Block };
constexpr std::array<std::array<double, 6>, 3> kModeRatios{{
    {1.0, 2.756, 5.404, 8.933, 13.34,
     18.64},  // a free bar (Fletcher & Rossing, The physics of musical instruments, 1998)
    // A plate: dense, inharmonic modes, with ratios near those of a round membrane.
    {1.0, 1.594, 2.136, 2.296, 2.653, 2.918},
    {1.0, 1.38, 1.71, 2.03, 2.44, 2.87},  // a compact solid, with modes close together
}};

// The sound of a material. The values were chosen by ear with the literature as a guide. Then they were spread so that
// any two materials differ in brightness or ringing time by a third or more (test:
// any_two_materials_differ_when_struck). Listening tests with people are still missing.
struct Timbre {
    Body body;
    double lowest_hz;     // frequency of the lowest mode of the struck object
    double ring_s;        // time in which the lowest mode falls by 60 dB
    double damping;       // how much faster each higher mode decays than the one below it
    double noise;         // share of the noise burst in the sound, 0 to 1
    double noise_hz;      // upper frequency limit of the noise burst
    double noise_s;       // time in which the noise burst falls by 60 dB
    double stroke_hz;     // centre frequency of the noise when the surface is stroked
    double grains_per_s;  // number of bumps per second while the surface is stroked; 0: smooth
};

constexpr std::array<Timbre, kSoundClasses> kTimbres{{
    /* Plaster  */ {Body::Plate, 260.0, 0.12, 0.5, 0.45, 2200.0, 0.05, 1400.0, 30.0},
    /* Wood     */ {Body::Bar, 430.0, 0.22, 0.9, 0.20, 3000.0, 0.03, 900.0, 45.0},
    /* Brick    */ {Body::Block, 730.0, 0.085, 0.4, 0.75, 4300.0, 0.075, 2350.0, 160.0},
    /* Concrete */ {Body::Block, 370.0, 0.045, 0.4, 0.60, 3200.0, 0.035, 1850.0, 90.0},
    /* Tile     */ {Body::Plate, 2300.0, 0.16, 0.5, 0.30, 9000.0, 0.02, 4200.0, 8.0},
    /* Carpet   */ {Body::Block, 95.0, 0.05, 0.6, 0.85, 480.0, 0.19, 450.0, 0.0},
    /* Metal    */ {Body::Bar, 880.0, 1.10, 0.25, 0.10, 9000.0, 0.02, 3500.0, 4.0},
    /* Glass    */ {Body::Plate, 3100.0, 0.50, 0.3, 0.10, 12000.0, 0.01, 5600.0, 0.0},
    /* Stone    */ {Body::Block, 1700.0, 0.07, 0.4, 0.40, 8500.0, 0.025, 3100.0, 60.0},
    /* Rubber   */ {Body::Block, 130.0, 0.14, 0.8, 0.08, 900.0, 0.02, 300.0, 14.0},
    /* Grass    */ {Body::Block, 300.0, 0.02, 0.5, 0.98, 9500.0, 0.24, 5000.0, 220.0},
    /* Water    */ {Body::Bar, 560.0, 0.30, 1.5, 0.35, 1800.0, 0.14, 700.0, 25.0},
    /* Plastic  */ {Body::Plate, 1500.0, 0.16, 0.6, 0.15, 6000.0, 0.015, 2200.0, 0.0},
    /* Cloth    */ {Body::Block, 160.0, 0.03, 0.6, 0.95, 700.0, 0.34, 650.0, 0.0},
    /* Sand     */ {Body::Block, 900.0, 0.01, 0.5, 0.99, 14000.0, 0.13, 6200.0, 400.0},
    /* Earth    */ {Body::Block, 120.0, 0.05, 0.6, 0.5, 600.0, 0.03, 560.0, 60.0},
    /* Ice      */ {Body::Plate, 4200.0, 0.90, 0.3, 0.12, 12000.0, 0.02, 6600.0, 30.0},
    /* Grille   */ {Body::Bar, 480.0, 1.70, 0.25, 0.12, 7000.0, 0.02, 2650.0, 12.0},
    /* Generic  */ {Body::Plate, 720.0, 0.14, 0.6, 0.35, 4800.0, 0.03, 1600.0, 0.0},
}};

const Timbre& timbre_of(SoundClass material) { return kTimbres[static_cast<std::size_t>(material)]; }

// White noise, -1 to 1. The C++ standard fixes the generator's sequence, so every run sounds the same.
class Noise {
public:
    explicit Noise(unsigned seed) : engine_(seed + 1U) {}
    double operator()() { return 2.0 * uniform() - 1.0; }
    double uniform() {
        return static_cast<double>(engine_() - std::minstd_rand::min()) /
               static_cast<double>(std::minstd_rand::max() - 1U);
    }

private:
    std::minstd_rand engine_;
};

unsigned seed_of(cues::SoundKind kind, SoundClass material) {
    return static_cast<unsigned>(kind) * 64U + static_cast<unsigned>(material);
}

// A two-pole band pass with a peak of 1 (state variable filter, Chamberlin 1985). It is stable for a centre frequency
// below a sixth of the sample rate.
class BandPass {
public:
    BandPass(double centre_hz, double q)
        : f_(2.0 * std::sin(kPi * std::min(centre_hz, kRate / 7.0) / kRate)), damping_(1.0 / q) {}
    double operator()(double in) {
        low_ += f_ * band_;
        const double high = in - low_ - damping_ * band_;
        band_ += f_ * high;
        return damping_ * band_;
    }

private:
    double f_, damping_;
    double low_ = 0.0, band_ = 0.0;
};

class LowPass {
public:
    explicit LowPass(double edge_hz) : a_(1.0 - std::exp(-2.0 * kPi * edge_hz / kRate)) {}
    double operator()(double in) { return y_ += a_ * (in - y_); }

private:
    double a_;
    double y_ = 0.0;
};

// Returns the factor per sample with which a sound falls by 60 dB in `ring_s`.
double decay_per_sample(double ring_s) { return std::pow(10.0, -3.0 / (ring_s * kRate)); }

// Adds a decaying tone, computed by a recursion with two multiplications per sample.
void add_mode(std::vector<float>& out, std::size_t from, double hz, double ring_s, double level) {
    if (hz > 0.45 * kRate) return;
    const double decay = decay_per_sample(ring_s), w = 2.0 * kPi * hz / kRate;
    const double a = 2.0 * decay * std::cos(w), b = decay * decay;
    double y1 = level * decay * std::sin(w), y2 = 0.0;
    const std::size_t end = std::min(out.size(), from + samples_of(ring_s));
    for (std::size_t i = from; i < end; ++i) {
        out[i] += static_cast<float>(y1);
        const double y = a * y1 - b * y2;
        y2 = y1;
        y1 = y;
    }
}

void add_noise_burst(std::vector<float>& out, std::size_t from, double edge_hz, double ring_s, double level,
                     Noise& noise) {
    LowPass soft(edge_hz), softer(edge_hz);
    const double decay = decay_per_sample(ring_s);
    // White noise through a low frequency limit is weak. The factor below makes bursts of all limits about equally
    // strong.
    const double evened = level * std::sqrt(0.5 * kRate / edge_hz);
    double envelope = evened;
    const std::size_t end = std::min(out.size(), from + samples_of(ring_s));
    for (std::size_t i = from; i < end; ++i, envelope *= decay)
        out[i] += static_cast<float>(envelope * softer(soft(noise())));
}

// Adds the sound of a blow on an object. `deeper` lowers the pitch and prolongs the ringing, as for a larger part of
// the object.
void add_impact(std::vector<float>& out, std::size_t from, const Timbre& timbre, double deeper, double level,
                Noise& noise) {
    const auto& ratios = kModeRatios[static_cast<std::size_t>(timbre.body)];
    for (std::size_t k = 0; k < ratios.size(); ++k) {
        const double rank = static_cast<double>(k);
        add_mode(out, from, timbre.lowest_hz * ratios[k] / deeper,
                 timbre.ring_s * deeper / (1.0 + timbre.damping * rank),
                 level * (1.0 - timbre.noise) / (1.0 + 0.7 * rank));
    }
    add_noise_burst(out, from, timbre.noise_hz / deeper, timbre.noise_s * deeper, level * timbre.noise, noise);
}

// Scales the sound to its peak, fades it in within half a millisecond and ends it without a click.
void finish(std::vector<float>& out, double peak) {
    float highest = 1e-9F;
    for (const float s : out) highest = std::max(highest, std::abs(s));
    const double gain = peak / static_cast<double>(highest);
    const std::size_t attack = std::min(out.size(), samples_of(0.0005)),
                      release = std::min(out.size(), samples_of(0.01));
    for (std::size_t i = 0; i < out.size(); ++i) {
        double g = gain;
        if (i < attack) g *= static_cast<double>(i + 1) / static_cast<double>(attack);
        const std::size_t left = out.size() - 1 - i;
        if (left < release) g *= static_cast<double>(left) / static_cast<double>(release);
        out[i] = static_cast<float>(g * static_cast<double>(out[i]));
    }
}

double longest_ring_s(const Timbre& timbre) { return std::max(timbre.ring_s, timbre.noise_s); }

std::vector<float> contact(SoundClass material, Noise& noise) {
    const Timbre& timbre = timbre_of(material);
    std::vector<float> out(samples_of(longest_ring_s(timbre) + 0.02));
    add_impact(out, 0, timbre, 1.0, 1.0, noise);
    finish(out, kPeak);
    return out;
}

// A footstep: the heel, and 90 ms later the ball of the foot. On soft ground the shoe itself is heard, on loose ground
// the grains.
std::vector<float> footstep(SoundClass material, Noise& noise) {
    const Timbre& timbre = timbre_of(material);
    const double ring_s = std::min(longest_ring_s(timbre) * 1.4, 0.35);
    std::vector<float> out(samples_of(0.09 + ring_s + 0.08));
    add_impact(out, 0, timbre, 1.4, 1.0, noise);
    add_impact(out, samples_of(0.09), timbre, 1.2, 0.5, noise);
    add_mode(out, 0, 85.0, 0.09, 0.2);  // the dull sound of the body's weight on the heel
    finish(out, kPeak);
    return out;
}

// A bump: the dull sound of the body's weight, and the sound of the wall that a shoulder strikes.
std::vector<float> bump(SoundClass material, Noise& noise) {
    const Timbre& timbre = timbre_of(material);
    std::vector<float> out(samples_of(std::max(0.25, std::min(0.6, longest_ring_s(timbre) * 1.8)) + 0.02));
    add_mode(out, 0, 68.0, 0.24, 1.0);
    add_mode(out, 0, 112.0, 0.16, 0.5);
    add_impact(out, 0, timbre, 1.8, 0.6, noise);
    finish(out, kPeak);
    return out;
}

// Makes a longer signal repeat without a seam after `length` samples. The surplus is cross-faded into the start at
// equal power.
void close_loop(std::vector<float>& out, std::size_t length) {
    const std::size_t surplus = out.size() - length;
    for (std::size_t i = 0; i < surplus; ++i) {
        const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(surplus) * 0.5 * kPi;
        out[i] = static_cast<float>(std::sin(t) * static_cast<double>(out[i]) +
                                    std::cos(t) * static_cast<double>(out[length + i]));
    }
    out.resize(length);
}

void scale_to_peak(std::vector<float>& out, double peak) {
    float highest = 1e-9F;
    for (const float s : out) highest = std::max(highest, std::abs(s));
    for (float& s : out) s *= static_cast<float>(peak) / highest;
}

std::vector<float> slide(SoundClass material, Noise& noise) {
    const Timbre& timbre = timbre_of(material);
    const std::size_t length = samples_of(1.0);
    std::vector<float> out(length + samples_of(0.1));
    BandPass band(timbre.stroke_hz, 0.8);
    const double grain_chance = timbre.grains_per_s / kRate, grain_decay = decay_per_sample(0.02);
    double grain = timbre.grains_per_s > 0.0 ? 0.0 : 1.0;
    for (float& s : out) {
        if (noise.uniform() < grain_chance) grain = 0.5 + 0.5 * noise.uniform();
        s = static_cast<float>(band(noise()) * (0.3 + 0.7 * grain));
        if (timbre.grains_per_s > 0.0) grain *= grain_decay;
    }
    close_loop(out, length);
    scale_to_peak(out, 0.6 * kPeak);
    return out;
}

// The wall tone: a soft hum with breathy noise. The hum makes it sound like one object. The noise lets the ears locate
// it, because they need energy above 1.5 kHz for that.
std::vector<float> wall_tone(Noise& noise) {
    const std::size_t length = samples_of(1.0);
    std::vector<float> out(length + samples_of(0.1));
    BandPass breath(2200.0, 0.7);
    for (float& s : out) s = static_cast<float>(0.9 * breath(noise()));
    close_loop(out, length);
    // Each harmonic has whole periods in one second, so that the hum has no seam.
    for (int harmonic = 1; harmonic <= 6; ++harmonic) {
        const double w = 2.0 * kPi * 180.0 * harmonic / kRate;
        for (std::size_t i = 0; i < length; ++i)
            out[i] += static_cast<float>(0.5 / harmonic * std::sin(w * static_cast<double>(i)));
    }
    scale_to_peak(out, 0.6 * kPeak);
    return out;
}

// Adds a bubble that rings with rising pitch (van den Doel, Physically based models for liquid sounds, ACM TAP 2(4),
// 2005). The part beyond the end of the loop is added at the start of the loop.
void add_bubble(std::vector<float>& out, std::size_t from, double hz, double ring_s, double level) {
    double phase = 0.0, envelope = level;
    const double decay = decay_per_sample(ring_s);
    const std::size_t length = samples_of(ring_s), attack = samples_of(0.0005);
    for (std::size_t i = 0; i < length; ++i, envelope *= decay) {
        phase += 2.0 * kPi * hz * (1.0 + 0.4 * static_cast<double>(i) / static_cast<double>(length)) / kRate;
        const double rise = std::min(1.0, static_cast<double>(i) / static_cast<double>(attack));
        out[(from + i) % out.size()] += static_cast<float>(rise * envelope * std::sin(phase));
    }
}

std::vector<float> splash(Noise& noise) {
    std::vector<float> out(samples_of(0.7));
    add_noise_burst(out, 0, 3500.0, 0.45, 0.5, noise);
    for (int bubble = 0; bubble < 14; ++bubble) {
        const auto from = static_cast<std::size_t>((0.02 + 0.45 * noise.uniform()) * kRate);
        const double hz = 500.0 + 1400.0 * noise.uniform(), ring_s = 0.04 + 0.08 * noise.uniform();
        add_bubble(out, from, hz, ring_s, 0.15 + 0.25 * noise.uniform());
    }
    finish(out, kPeak);
    return out;
}

// A door that starts to move: a latch, then a creaking hinge, which sticks and slips at a rate that rises with the
// leaf's speed.
std::vector<float> door_moves(Noise& noise) {
    std::vector<float> out(samples_of(0.6));
    add_noise_burst(out, 0, 2600.0, 0.02, 0.5, noise);
    for (double at_s = 0.08, every_s = 0.022; at_s < 0.5; at_s += every_s, every_s *= 0.97) {
        add_mode(out, samples_of(at_s), 420.0 + 500.0 * at_s, 0.05, 0.30);
        add_mode(out, samples_of(at_s), 1130.0 + 900.0 * at_s, 0.03, 0.18);
    }
    finish(out, kPeak);
    return out;
}

// A door that shuts: the leaf hits its frame, then the latch clicks.
std::vector<float> door_shuts(Noise& noise) {
    std::vector<float> out(samples_of(0.45));
    add_noise_burst(out, 0, 700.0, 0.06, 0.5, noise);
    add_mode(out, 0, 95.0, 0.16, 1.0);
    add_mode(out, 0, 210.0, 0.09, 0.5);
    add_noise_burst(out, samples_of(0.05), 3200.0, 0.012, 0.5, noise);
    finish(out, kPeak);
    return out;
}

// A small hand bell, struck twice. Its sound is bright, because the ears locate bright sounds well.
std::vector<float> bell() {
    std::vector<float> out(samples_of(1.0));
    for (const double from_s : {0.0, 0.22})
        for (std::size_t mode = 0; mode < 5; ++mode) {
            // The partials of a bell: hum, prime, tierce, quint and nominal (Fletcher & Rossing, chapter 21).
            constexpr std::array kPartials{0.5, 1.0, 1.2, 1.5, 2.0}, kLevels{0.3, 0.6, 0.7, 0.4, 1.0};
            add_mode(out, samples_of(from_s), 1450.0 * kPartials[mode], 0.7 / kPartials[mode], kLevels[mode]);
        }
    finish(out, kPeak);
    return out;
}

// A tone that falls by three octaves, faster and faster, and then a dull landing.
std::vector<float> falls() {
    constexpr double kFalls_s = 0.6, kFrom_hz = 1200.0, kOctaves = 3.0;
    std::vector<float> out(samples_of(kFalls_s + 0.25));
    double phase = 0.0;
    for (std::size_t i = 0; i < samples_of(kFalls_s); ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(samples_of(kFalls_s));
        phase += 2.0 * kPi * kFrom_hz * std::exp2(-kOctaves * part * part) / kRate;
        out[i] += static_cast<float>(std::sin(phase) *
                                     std::min(1.0, static_cast<double>(i) / static_cast<double>(samples_of(0.002))) *
                                     (1.0 - 0.6 * part));
    }
    add_mode(out, samples_of(kFalls_s), 90.0, 0.2, 1.0);
    finish(out, kPeak);
    return out;
}

// Sounds of places along a route. They differ in rhythm first, then in pitch, as earcons do. Each sounds at a place, so
// it contains breathy noise that lets the ears locate it.
std::vector<float> waymark(cues::SoundKind kind, Noise& noise) {
    struct Strike {
        double at_s, hz, ring_s;
    };
    const auto struck = [&](std::initializer_list<Strike> strikes, double breath) {
        double end_s = 0.0;
        for (const Strike& one : strikes) end_s = std::max(end_s, one.at_s + one.ring_s);
        std::vector<float> out(samples_of(end_s + 0.02));
        for (const Strike& one : strikes) {
            add_mode(out, samples_of(one.at_s), one.hz, one.ring_s, 0.8);
            add_mode(out, samples_of(one.at_s), 2.76 * one.hz, 0.5 * one.ring_s, 0.3);
            add_noise_burst(out, samples_of(one.at_s), 4000.0, 0.03, breath, noise);
        }
        finish(out, kPeak);
        return out;
    };
    switch (kind) {
        case cues::SoundKind::Corner:
            return struck({{0.0, 880.0, 0.12}, {0.13, 1319.0, 0.25}}, 0.15);
        case cues::SoundKind::Opening:
            return struck({{0.0, 300.0, 0.25}, {0.05, 450.0, 0.25}, {0.10, 675.0, 0.3}}, 0.5);
        case cues::SoundKind::DropNear:
            return struck({{0.0, 1900.0, 0.1}, {0.035, 1250.0, 0.12}, {0.08, 1900.0, 0.12}}, 0.2);
        case cues::SoundKind::StairsUp:
            return struck({{0.0, 523.0, 0.1}, {0.09, 659.0, 0.1}, {0.18, 784.0, 0.1}, {0.27, 1047.0, 0.25}}, 0.2);
        case cues::SoundKind::StairsDown:
            return struck({{0.0, 1047.0, 0.1}, {0.09, 784.0, 0.1}, {0.18, 659.0, 0.1}, {0.27, 523.0, 0.25}}, 0.2);
        case cues::SoundKind::Knock:  // Knock: a hollow board
            return struck({{0.0, 130.0, 0.16}, {0.09, 110.0, 0.22}}, 0.3);
        case cues::SoundKind::Border:  // Border: one low thud
            return struck({{0.0, 70.0, 0.3}}, 0.1);
        default:  // DoorNear: knuckles knock twice on wood
            return struck({{0.0, 240.0, 0.07}, {0.12, 240.0, 0.09}}, 0.4);
    }
}

// The world's own sounds are loops of whole seconds. Every steady tone in them thus has whole periods and no seam.

// Adds steady harmonics of a lowest tone. Each is weaker than the one below it by the factor `slope`.
void add_harmonics(std::vector<float>& out, double hz, int count, double level, double slope) {
    for (int k = 1; k <= count; ++k, level *= slope) {
        // Computes the sine by a recursion with two multiplications a sample. Over four seconds it drifts by less than
        // a float resolves.
        const double w = 2.0 * kPi * hz * k / kRate, twice_cos = 2.0 * std::cos(w);
        double y = 0.0, before = -level * std::sin(w);
        for (float& s : out) {
            s += static_cast<float>(y);
            const double next = twice_cos * y - before;
            before = y;
            y = next;
        }
    }
}

// Adds noise around a pitch that may change. `shape(t)` returns centre frequency in Hz and level, with t from 0 to 1
// over the loop.
template <class Shape>
void add_air(std::vector<float>& out, Noise& noise, double q, Shape shape) {
    std::vector<float> air(out.size() + samples_of(0.2));
    // Samples for which the filter stays the same; it is updated a hundred times a second.
    constexpr std::size_t kHold = 480;
    double low = 0.0, band = 0.0, f = 0.0, level = 0.0;
    for (std::size_t i = 0; i < air.size(); ++i) {
        if (i % kHold == 0) {
            const auto [hz, gain] = shape(static_cast<double>(i % out.size()) / static_cast<double>(out.size()));
            f = 2.0 * std::sin(kPi * std::min(hz, kRate / 7.0) / kRate);
            level = gain;
        }
        low += f * band;
        band += f * (noise() - low - band / q);
        air[i] = static_cast<float>(level * band / q);
    }
    close_loop(air, out.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += air[i];
}

// Adds a tone that swells, glides and ends, such as a chirp, a croak or a note.
void add_call(std::vector<float>& out, double start_s, double length_s, double from_hz, double to_hz, double level) {
    const std::size_t from = samples_of(start_s), length = samples_of(length_s);
    double phase = 0.0;
    for (std::size_t i = 0; i < length; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(length);
        phase += 2.0 * kPi * (from_hz + (to_hz - from_hz) * t) / kRate;
        const double swell = std::sin(kPi * t);
        out[(from + i) % out.size()] +=
            static_cast<float>(level * swell * swell * (std::sin(phase) + 0.3 * std::sin(2.0 * phase)));
    }
}

// Adds a decaying tone. The part beyond the end of the loop is added at the start of the loop.
void add_ring(std::vector<float>& out, double start_s, double hz, double ring_s, double level) {
    std::vector<float> ring(samples_of(ring_s));
    add_mode(ring, 0, hz, ring_s, level);
    const std::size_t attack = samples_of(0.0005), from = samples_of(start_s);
    for (std::size_t i = 0; i < ring.size(); ++i)
        out[(from + i) % out.size()] +=
            ring[i] * static_cast<float>(std::min(1.0, static_cast<double>(i) / static_cast<double>(attack)));
}

std::vector<float> world_loop(cues::SoundKind kind, Noise& noise) {
    const auto steady = [](double hz, double level) { return [=](double) { return std::pair(hz, level); }; };
    const auto between = [&](double low, double high) { return low + (high - low) * noise.uniform(); };
    std::vector<float> out(samples_of(4.0));
    const double length_s = 4.0;
    switch (kind) {
        case cues::SoundKind::Hum:
            add_harmonics(out, 120.0, 4, 0.5, 0.45);
            add_air(out, noise, 0.7, steady(900.0, 0.35));
            break;
        case cues::SoundKind::Buzz:
            add_harmonics(out, 100.0, 40, 0.12, 0.97);
            for (std::size_t i = 0; i < out.size(); ++i)  // the level flickers eight times a second
                out[i] *= static_cast<float>(0.75 + 0.25 * std::sin(2.0 * kPi * 8.0 * static_cast<double>(i) / kRate));
            break;
        case cues::SoundKind::Drone:
            add_harmonics(out, 55.0, 6, 0.5, 0.6);
            // This tone and the one above beat: their lowest harmonics once in two seconds, their fourth harmonics
            // twice a second.
            add_harmonics(out, 55.5, 6, 0.5, 0.6);
            add_air(out, noise, 0.8, steady(320.0, 0.5));
            break;
        case cues::SoundKind::Drip:
            for (const double at_s : {0.1, 0.95, 1.3, 2.4, 3.15}) {
                const double hz = between(900.0, 1500.0);
                add_bubble(out, samples_of(at_s), hz, 0.12, between(0.6, 1.0));
            }
            break;
        case cues::SoundKind::Wind:
            add_air(out, noise, 3.0, [](double t) {
                return std::pair(420.0 + 180.0 * std::sin(2.0 * kPi * t),
                                 0.7 + 0.3 * std::sin(2.0 * kPi * (2.0 * t + 0.3)));
            });
            break;
        case cues::SoundKind::Swamp:
            for (int k = 0; k < 24; ++k) add_call(out, k / 6.0, 0.06, 4300.0, 4400.0, 0.35);
            for (const double at_s : {0.5, 0.72, 2.6}) add_call(out, at_s, 0.18, 180.0, 120.0, 1.0);
            for (int k = 0; k < 8; ++k) {
                const double hz = between(250.0, 500.0);
                add_bubble(out, samples_of(between(0.0, length_s)), hz, 0.15, 0.4);
            }
            break;
        case cues::SoundKind::Thunder:
            add_air(out, noise, 0.7, [](double t) {
                return std::pair(
                    90.0,
                    t < 0.5 ? (0.3 + 0.7 * std::sin(40.0 * t) * std::sin(40.0 * t)) * std::sin(2.0 * kPi * t) : 0.0);
            });
            break;
        case cues::SoundKind::Stream:
            add_air(out, noise, 0.6, steady(1800.0, 0.25));
            for (int k = 0; k < 260; ++k) {
                const double hz = between(450.0, 2200.0), ring_s = between(0.02, 0.09), level = between(0.05, 0.4);
                add_bubble(out, samples_of(between(0.0, length_s)), hz, ring_s, level);
            }
            break;
        case cues::SoundKind::Fire:
            add_air(out, noise, 0.7,
                    [](double t) { return std::pair(260.0, 0.5 + 0.2 * std::sin(2.0 * kPi * 5.0 * t)); });
            for (int k = 0; k < 70; ++k) {
                const double at_s = between(0.0, length_s - 0.05), edge_hz = between(2500.0, 8000.0),
                             ring_s = between(0.004, 0.02);
                add_noise_burst(out, samples_of(at_s), edge_hz, ring_s, between(0.05, 0.5), noise);
            }
            break;
        case cues::SoundKind::Clock:
            for (int k = 0; k < 4; ++k) {
                const double hz = k % 2 == 0 ? 2600.0 : 2050.0;
                add_ring(out, k + 0.1, hz, 0.045, 1.0);
                add_ring(out, k + 0.1, 1.73 * hz, 0.03, 0.6);
            }
            break;
        case cues::SoundKind::Fan:
            add_air(out, noise, 0.6, [](double) { return std::pair(700.0, 0.6); });
            // The level falls and rises twenty times a second, whenever a blade of the fan passes.
            for (std::size_t i = 0; i < out.size(); ++i)
                out[i] *= static_cast<float>(0.7 + 0.3 * std::sin(2.0 * kPi * 20.0 * static_cast<double>(i) / kRate));
            break;
        case cues::SoundKind::Rain:
            add_air(out, noise, 0.5, steady(5200.0, 0.25));
            for (int k = 0; k < 500; ++k) {
                const double at_s = between(0.0, length_s), hz = between(2500.0, 7000.0),
                             ring_s = between(0.004, 0.012);
                add_ring(out, at_s, hz, ring_s, between(0.05, 0.4));
            }
            break;
        case cues::SoundKind::Birds:
            for (int song = 0; song < 4; ++song)
                for (int k = 0; k < 3 + song % 2; ++k) {
                    const double from_hz = between(2600.0, 3400.0), to_hz = between(3600.0, 4800.0);
                    add_call(out, song + 0.1 + 0.17 * k, 0.09, from_hz, to_hz, between(0.5, 1.0));
                }
            break;
        case cues::SoundKind::Tolling:
            // The partials of a bell: hum, prime, tierce, quint and nominal (Fletcher & Rossing, chapter 21).
            for (const auto& [ratio, level] : {std::pair(0.5, 0.5), std::pair(1.0, 0.8), std::pair(1.2, 0.7),
                                               std::pair(1.5, 0.4), std::pair(2.0, 1.0)})
                add_ring(out, 0.0, 392.0 * ratio, 3.6 / std::sqrt(ratio), level);
            break;
        case cues::SoundKind::Music:
            for (int k = 0; k < 8; ++k) {
                constexpr std::array kTune{262.0, 330.0, 392.0, 523.0, 392.0, 330.0, 294.0, 392.0};
                for (int h = 1; h <= 4; ++h)
                    add_ring(out, 0.5 * k, kTune[static_cast<std::size_t>(k)] * h, 0.9 / h, 0.8 / (h * h));
            }
            break;
        case cues::SoundKind::HiddenClock:
            // A hidden clock: it ticks five times a second, with a little brass bell and, twice in its four seconds, a
            // cuckoo. A clock of a world is different: it ticks once a second and has no call.
            for (int k = 0; k < 20; ++k) {
                add_ring(out, 0.2 * k, 4100.0, 0.03, k % 5 == 0 ? 1.0 : 0.7);
                add_ring(out, 0.2 * k, 1.41 * 4100.0, 0.02, 0.4);
            }
            for (const double at_s : {0.9, 2.9}) {
                add_ring(out, at_s, 740.0, 0.16, 1.0);
                add_ring(out, at_s + 0.3, 587.0, 0.24, 1.0);
            }
            break;
        default:  // Shimmer, and any other kind: many short tones
            for (int k = 0; k < 40; ++k) {
                const double at_s = between(0.0, length_s),
                             hz = 1200.0 * std::pow(2.0, std::floor(between(0.0, 8.0)) / 4.0);
                add_ring(out, at_s, hz, 0.35, between(0.2, 0.7));
            }
            break;
    }
    scale_to_peak(out, 0.8 * kPeak);
    return out;
}

// The ears locate a beacon by its breathy noise from 3 to 8 kHz, because the head shades the far ear at these
// frequencies. The noise has the rhythm of the beacon's pitch and most of its energy, because the head hardly shades
// the tone. A beacon behind the person has no such noise and sounds dull.
std::vector<float> beacon(cues::SoundKind kind, Noise& noise) {
    constexpr double kPitch_hz = 659.0, kBreath = 4.5;
    if (kind == cues::SoundKind::BeaconBehind) return synthesise_notes(std::array{Note{0.0, 0.12, 277.0, 1.0}});
    const bool ahead = kind == cues::SoundKind::BeaconAhead;
    std::vector<float> out =
        ahead ? synthesise_notes(std::array{Note{0.0, 0.09, kPitch_hz, 0.54}, Note{0.0, 0.12, 2.0 * kPitch_hz, 0.54},
                                            Note{0.02, 0.14, 3.0 * kPitch_hz, 0.36}})
              : synthesise_notes(std::array{Note{0.0, 0.09, kPitch_hz, 1.0}});
    BandPass band(5200.0, 0.9), narrower(5200.0, 0.9);
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double t = static_cast<double>(i), left = static_cast<double>(out.size() - 1 - i);
        const double edge = 0.006 * kRate;
        const double envelope = std::min({1.0, t / edge, left / edge});
        const double rhythm = 0.5 + 0.5 * std::sin(2.0 * kPi * kPitch_hz * t / kRate);
        out[i] += static_cast<float>(kBreath * envelope * rhythm * narrower(band(noise())));
    }
    finish(out, kPeak);
    return out;
}

// Earcons differ in rhythm first and in pitch second, so that people with a mild hearing loss can distinguish them.
std::vector<float> earcon(cues::SoundKind kind) {
    switch (kind) {
        case cues::SoundKind::Denied:
            return synthesise_notes(std::array{Note{0.0, 0.07, 196.0, 1.0}, Note{0.11, 0.11, 165.0, 1.0}});
        case cues::SoundKind::ForcesOn:
            return synthesise_notes(std::array{Note{0.0, 0.08, 523.0, 0.8}, Note{0.08, 0.16, 784.0, 1.0}});
        case cues::SoundKind::ForcesOff:
            return synthesise_notes(std::array{Note{0.0, 0.08, 784.0, 1.0}, Note{0.08, 0.16, 523.0, 0.8}});
        case cues::SoundKind::TurnTick:
            return synthesise_notes(std::array{Note{0.0, 0.03, 1300.0, 0.7}});
        case cues::SoundKind::FrameSwitch:
            return synthesise_notes(
                std::array{Note{0.0, 0.06, 600.0, 0.8}, Note{0.06, 0.06, 900.0, 1.0}, Note{0.12, 0.1, 600.0, 0.8}});
        case cues::SoundKind::Arrived:
            return synthesise_notes(
                std::array{Note{0.0, 0.06, 784.0, 0.8}, Note{0.09, 0.06, 988.0, 0.9}, Note{0.18, 0.2, 1175.0, 1.0}});
        case cues::SoundKind::Rim:
            return synthesise_notes(
                std::array{Note{0.0, 0.02, 330.0, 1.0}, Note{0.035, 0.02, 440.0, 1.0}, Note{0.07, 0.05, 550.0, 0.9}});
        case cues::SoundKind::RimBack:
            return synthesise_notes(std::array{Note{0.0, 0.02, 550.0, 0.8}, Note{0.035, 0.04, 330.0, 0.8}});
        case cues::SoundKind::Grab:
            return synthesise_notes(std::array{Note{0.0, 0.025, 220.0, 1.0}, Note{0.03, 0.07, 294.0, 1.0}});
        case cues::SoundKind::LetGo:
            return synthesise_notes(std::array{Note{0.0, 0.07, 294.0, 0.8}, Note{0.09, 0.03, 220.0, 0.8}});
        case cues::SoundKind::Click:
            return synthesise_notes(std::array{Note{0.0, 0.012, 1800.0, 1.0}, Note{0.03, 0.02, 900.0, 0.8}});
        case cues::SoundKind::GuideStart:
            return synthesise_notes(
                std::array{Note{0.0, 0.09, 392.0, 0.8}, Note{0.1, 0.09, 494.0, 0.9}, Note{0.2, 0.22, 587.0, 1.0}});
        case cues::SoundKind::GuideStop:
            return synthesise_notes(std::array{Note{0.0, 0.09, 587.0, 1.0}, Note{0.1, 0.2, 392.0, 0.9}});
        case cues::SoundKind::Warmer:
            return synthesise_notes(std::array{Note{0.0, 0.035, 880.0, 0.9}});
        case cues::SoundKind::Colder:
            return synthesise_notes(std::array{Note{0.0, 0.07, 311.0, 0.9}});
        // Marks, landmarks and clues have different numbers of notes.
        case cues::SoundKind::Mark:
            return synthesise_notes(std::array{Note{0.0, 0.14, 740.0, 0.9}});
        case cues::SoundKind::Landmark:
            return synthesise_notes(
                std::array{Note{0.0, 0.07, 494.0, 0.8}, Note{0.09, 0.07, 622.0, 0.9}, Note{0.18, 0.16, 494.0, 0.8}});
        case cues::SoundKind::Clue:
            return synthesise_notes(std::array{Note{0.0, 0.03, 988.0, 0.7}, Note{0.06, 0.03, 831.0, 0.7}});
        case cues::SoundKind::Alarm:
            return synthesise_notes(std::array{Note{0.0, 0.11, 1047.0, 1.0}, Note{0.13, 0.11, 740.0, 1.0},
                                               Note{0.26, 0.11, 1047.0, 1.0}, Note{0.39, 0.16, 740.0, 1.0}});
        default:
            return synthesise_notes(std::array{Note{0.0, 0.1, 1000.0, 0.8}});
    }
}

}  // namespace

bool varies_by_material(cues::SoundKind kind) {
    return kind == cues::SoundKind::Contact || kind == cues::SoundKind::Slide || kind == cues::SoundKind::Footstep ||
           kind == cues::SoundKind::Bump;
}

bool is_loop(cues::SoundKind kind) {
    return kind == cues::SoundKind::Slide || kind == cues::SoundKind::WallTone || cues::is_world_sound(kind);
}

std::vector<float> synthesise(cues::SoundKind kind, SoundClass material) {
    Noise noise(seed_of(kind, varies_by_material(kind) ? material : SoundClass::Generic));
    switch (kind) {
        case cues::SoundKind::Contact:
            return contact(material, noise);
        case cues::SoundKind::Slide:
            return slide(material, noise);
        case cues::SoundKind::Footstep:
            return footstep(material, noise);
        case cues::SoundKind::Bump:
            return bump(material, noise);
        case cues::SoundKind::WallTone:
            return wall_tone(noise);
        case cues::SoundKind::Splash:
            return splash(noise);
        case cues::SoundKind::DoorMoves:
            return door_moves(noise);
        case cues::SoundKind::DoorShuts:
            return door_shuts(noise);
        case cues::SoundKind::Bell:
            return bell();
        case cues::SoundKind::Corner:
        case cues::SoundKind::Opening:
        case cues::SoundKind::DropNear:
        case cues::SoundKind::StairsUp:
        case cues::SoundKind::StairsDown:
        case cues::SoundKind::DoorNear:
        case cues::SoundKind::Knock:
        case cues::SoundKind::Border:
            return waymark(kind, noise);
        case cues::SoundKind::Falls:
            return falls();
        case cues::SoundKind::Beacon:
        case cues::SoundKind::BeaconAhead:
        case cues::SoundKind::BeaconBehind:
            return beacon(kind, noise);
        default:
            return cues::is_world_sound(kind) ? world_loop(kind, noise) : earcon(kind);
    }
}

std::vector<float> synthesise_notes(std::span<const Note> notes) {
    double end_s = 0.0;
    for (const Note& note : notes) {
        contract_pre(note.start_s >= 0.0 && note.length_s > 0.0 && note.level >= 0.0 && note.level <= 1.0);
        end_s = std::max(end_s, note.start_s + note.length_s);
    }
    std::vector<float> out(samples_of(end_s) + 1);
    for (const Note& note : notes) {
        const std::size_t from = samples_of(note.start_s), length = samples_of(note.length_s);
        const double edge = std::min(0.25 * note.length_s, 0.006) * kRate;
        for (std::size_t i = 0; i < length && from + i < out.size(); ++i) {
            const double t = static_cast<double>(i), left = static_cast<double>(length - i),
                         w = 2.0 * kPi * note.pitch_hz / kRate;
            const double envelope = note.level * std::min({1.0, t / edge, left / edge});
            out[from + i] += static_cast<float>(
                kPeak * envelope *
                (0.75 * std::sin(w * t) + 0.2 * std::sin(2.0 * w * t) + 0.05 * std::sin(3.0 * w * t)));
        }
    }
    return out;
}

std::size_t sound_index(cues::SoundKind kind, SoundClass material) {
    const auto column = varies_by_material(kind) ? static_cast<std::size_t>(material) : 0U;
    return static_cast<std::size_t>(kind) * kSoundClasses + column;
}

}  // namespace handrail::sinks
