// Measures how loud people hear a sound, after ITU-R BS.1770-5, and gives each sound the loudness of its rank. Pure
// functions; any thread. Measuring costs about two multiplications of six numbers a sample.
#pragma once

#include <span>
#include <vector>

#include "audio-cues/plan/sinks.h"

namespace handrail::sinks {

// Returns the loudness of the loudest 400 ms of one channel at 48 kHz, in LUFS. Before and after the samples there is
// silence. Silence itself gives -120.
double momentary_lufs(std::span<const float> samples);

// Returns the samples of synthesise() with the loudness of the sound's rank, at the volume of a new settings file. A
// sound that is too short for that loudness stays quieter, so that no sample exceeds kMostPeak.
std::vector<float> levelled_sound(cues::SoundKind kind, SoundClass material);
// Returns other samples for the same sound, such as those of a sound pack, with the same loudness.
std::vector<float> levelled_sound(cues::SoundKind kind, std::vector<float> samples);
inline constexpr double kMostPeak = 1.2;

}  // namespace handrail::sinks
