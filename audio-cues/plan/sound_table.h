// What each sound is called, which volume and switch it obeys, and which names in a map mean it: one table for the cue
// planner, scenarios and the spoken sound dictionary. Pure data; any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audio-cues/plan/sinks.h"

namespace handrail {

struct SoundInfo {
    SoundKind kind;
    std::string_view name;  // as scenarios call it, in every language: "wall tone"; what people are told of it stands
                            // in settings/languages
    double Settings::Sound::*volume;
    bool Settings::Sound::*on;  // nullptr: cannot be switched off
};

// In the order of SoundKind.
std::span<const SoundInfo> sound_table();
const SoundInfo& info(SoundKind kind);
// Every sound a person may want to know, in the order it is taught: each kind once, and what the hand meets once for
// every material.
struct DictionaryEntry {
    SoundKind kind;
    SoundClass material;
    std::string text;  // fit to be spoken: "Wall tone: a wall is near ..."
};
std::vector<DictionaryEntry> sound_dictionary();
std::string_view material_sound_name(SoundClass material);  // "plaster", as scenarios call it

// What a map's word for a sound or for particles is heard as: "ambient_drip", "water/stream1.wav", "particle_fire".
// Letters alone count, the first word of the table that it holds wins; a word that says nothing is Shimmer.
SoundKind world_sound_of(std::string_view word);

// What distance leaves of a sound, 0 to 1. Sounds of hand and body keep their loudness to 2 m and lose half of it by
// three times that: the hand may touch far from the ears. Those of the world are true to nature from 1 m on, and end at
// 30 m.
double distance_gain(SoundKind kind, double distance_m);
inline constexpr double kWorldSoundRange_m = 30.0;

}  // namespace handrail
