// Every sound of the program, computed: what a material sounds like when it is struck, stroked, stepped on or run into,
// what a world's own sounds are, and the earcons. Pure functions of their arguments, so the same sound is the same
// samples on every machine and run. Mono, 48 kHz, peak at most 0.5. Cost: all of them together about 150 ms and 23 MB,
// so each is made when it is first heard; a struck thing takes at most 2 ms (see the test's printed figures). Struck
// things are a few decaying modes and a burst of noise: van den Doel & Pai, The sounds of physical shapes, Presence
// 7(4), 1998. Stroked things are filtered noise with grains: van den Doel, Kry & Pai, FoleyAutomatic, SIGGRAPH 2001.
#pragma once

#include <span>
#include <vector>

#include "audio-cues/plan/sinks.h"

namespace handrail {

inline constexpr int kSampleRate_hz = 48000;
inline constexpr int kSoundClasses = static_cast<int>(SoundClass::Generic) + 1;

// True for sounds that differ by material; the others take no notice of it.
bool varies_by_material(SoundKind kind);
// True for sounds that are made to be repeated without a seam.
bool is_loop(SoundKind kind);

std::vector<float> synthesise(SoundKind kind, SoundClass material);

// A tone of an earcon.
struct Note {
    double start_s = 0.0;
    double length_s = 0.1;
    double pitch_hz = 1000.0;
    double level = 1.0;  // 0 to 1
};
std::vector<float> synthesise_notes(std::span<const Note> notes);

// Where a sound stands among all: the same for all materials of a kind that does not vary. Less than kSounds.
inline constexpr std::size_t kSounds = static_cast<std::size_t>(kSoundKinds) * kSoundClasses;
std::size_t sound_index(SoundKind kind, SoundClass material);

}  // namespace handrail
