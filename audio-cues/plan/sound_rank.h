// Ranks sounds by importance. More important sounds are louder. If too many sound at once, the least important one
// ends. Pure data; any thread.
#pragma once

#include <cstdint>
#include <string_view>

#include "audio-cues/plan/sinks.h"

namespace handrail::cues {

// In order of importance, the most important first.
enum class SoundRank : std::uint8_t { Danger, Blocked, Route, Landmark, Step, Background };
inline constexpr int kSoundRanks = static_cast<int>(SoundRank::Background) + 1;

SoundRank rank_of(SoundKind kind);
std::string_view rank_name(SoundRank rank);  // for example "danger", for the table of sounds

// Returns the momentary loudness of the loudest part of a sound, at the volumes of a new settings file and before the
// filters for the ears.
double loudness_of(SoundRank rank);  // in LUFS

}  // namespace handrail::cues
