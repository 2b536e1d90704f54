// How important a sound is: the more important, the louder it is made, and of too many at once the least important
// gives way. Pure data; any thread.
#pragma once

#include <cstdint>
#include <string_view>

#include "audio-cues/plan/sinks.h"

namespace handrail::cues {

// The most important first.
enum class SoundRank : std::uint8_t { Danger, Blocked, Route, Landmark, Step, Background };
inline constexpr int kSoundRanks = static_cast<int>(SoundRank::Background) + 1;

SoundRank rank_of(SoundKind kind);
std::string_view rank_name(SoundRank rank);  // "danger", for the table of sounds

// Momentary loudness of the loudest part at the volumes of a new settings file, before filters for the ears.
double loudness_of(SoundRank rank);  // LUFS

}  // namespace handrail::cues
