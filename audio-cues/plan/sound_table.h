// Contains one table of all sounds for the cue planner, scenarios and the spoken sound dictionary. For each sound it
// contains the name, the volume and switch that apply, and the names of sounds in maps that stand for it. Pure data;
// any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audio-cues/plan/sinks.h"

namespace handrail::cues {

struct SoundInfo {
    SoundKind kind;
    // The name in scenarios, the same in every language: "wall tone". The translated names for people are in
    // settings/languages.
    std::string_view name;
    double settings::Settings::Sound::*volume;
    bool settings::Settings::Sound::*on;  // nullptr: the sound cannot be switched off
};

// Returns the table, in the order of SoundKind.
std::span<const SoundInfo> sound_table();
const SoundInfo& info(SoundKind kind);
// All sounds that a person may want to know, in the order in which they are taught. Each kind occurs once, and contact
// sounds once for every material.
struct DictionaryEntry {
    SoundKind kind;
    SoundClass material;
    std::string text;  // spoken text of the entry, for example "Wall tone: a wall is near ..."
};
std::vector<DictionaryEntry> sound_dictionary();
std::string_view material_sound_name(SoundClass material);  // Returns the name in scenarios, for example "plaster".

// Returns the sound for a map's name of a sound or of particles: "ambient_drip", "water/stream1.wav", "particle_fire".
// Only letters count, and the first word of the table that the name contains decides. A name without such a word gives
// Shimmer.
SoundKind world_sound_of(std::string_view word);

// Returns the share of a sound's loudness that remains at a distance, 0 to 1. Sounds of hand and walker keep their
// loudness up to 2 m and are halved at 6 m, because the hand may touch things far from the listener. Sounds of the
// world fall as in nature from 1 m on, and end at 30 m.
double distance_gain(SoundKind kind, double distance_m);
inline constexpr double kWorldSoundRange_m = 30.0;

}  // namespace handrail::cues
