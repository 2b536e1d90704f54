// How loud a sound is heard, after ITU-R BS.1770-5, and making each sound as loud as its rank wants it. Pure functions;
// any thread. Measuring costs about two multiplications of six numbers a sample.
#pragma once

#include <span>
#include <vector>

#include "audio-cues/plan/sinks.h"

namespace handrail::sinks {

// The loudest 400 ms of one channel at 48 kHz, in LUFS; what lies before and after it is silence. -120 of silence.
double momentary_lufs(std::span<const float> samples);

// As synthesise(), and as loud as the sound's rank wants at the volume of a new settings file. A sound that is too
// short for that ends quieter, so that no sample is above kMostPeak.
std::vector<float> levelled_sound(cues::SoundKind kind, SoundClass material);
inline constexpr double kMostPeak = 1.2;

}  // namespace handrail::sinks
