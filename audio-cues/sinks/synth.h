// Computes every sound of the program: a material that is struck, stroked, stepped on or bumped into, a world's own
// sounds, and the earcons. Pure functions of their arguments, so the samples are the same on every machine and in every
// run. Mono, 48 kHz, peak at most 0.5. All sounds together would take about 150 ms and 23 MB, so each is made when it
// is first heard. A struck object takes at most 2 ms (see the figures that the test prints). Sources: struck objects
// are a few decaying modes and a burst of noise, after van den Doel & Pai, The sounds of physical shapes, Presence
// 7(4), 1998; stroked objects are filtered noise with grains, after van den Doel, Kry & Pai, FoleyAutomatic, SIGGRAPH
// 2001.
#pragma once

#include <span>
#include <vector>

#include "audio-cues/plan/sinks.h"

namespace handrail::sinks {

inline constexpr int kSampleRate_hz = 48000;
inline constexpr int kSoundClasses = static_cast<int>(SoundClass::Generic) + 1;

// Returns true for sounds that depend on the material. All other sounds ignore it.
bool varies_by_material(cues::SoundKind kind);
// Returns true for loops, which repeat without a seam.
bool is_loop(cues::SoundKind kind);

std::vector<float> synthesise(cues::SoundKind kind, SoundClass material);

// One tone of an earcon.
struct Note {
    double start_s = 0.0;
    double length_s = 0.1;
    double pitch_hz = 1000.0;
    double level = 1.0;  // range 0 to 1
};
std::vector<float> synthesise_notes(std::span<const Note> notes);

// Returns the index of a sound among all sounds, less than kSounds. A kind that does not depend on the material has the
// same index for all materials.
inline constexpr std::size_t kSounds = static_cast<std::size_t>(cues::kSoundKinds) * kSoundClasses;
std::size_t sound_index(cues::SoundKind kind, SoundClass material);

}  // namespace handrail::sinks
