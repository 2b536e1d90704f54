// Reads a sound pack: a folder of sound files with the table pack.toml, which says which file replaces which sound of
// the program. libsndfile reads the files (WAV, FLAC, Ogg and others), at any rate and with up to eight channels. A
// file that cannot be used is reported, and the program's own sound is played. Pure data once it has been read; any
// thread. Reading takes a few milliseconds for each file. Only sound_pack.cpp includes libsndfile.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "audio-cues/plan/sinks.h"
#include "settings/toml_value.h"
#include "worlds/base/result.h"

namespace handrail::sinks {

struct SoundPack {
    static constexpr std::size_t kLargestFile_bytes = std::size_t{32} << 20;
    static constexpr double kLongest_s = 20.0;

    // Samples in mono at 48 kHz, by sound_index().
    std::map<std::size_t, std::vector<float>> sounds;
    std::vector<Error> faults;  // one sentence for each entry that is not used, with the file and what to do

    // Returns the samples that replace this sound, or nothing.
    std::span<const float> find(cues::SoundKind kind, SoundClass material) const;
};

// Reads the pack in `folder`. In the table [sounds], the key is the name of a sound in sound_table(), or the name and a
// material for a sound that depends on it, such as "contact wood". The value is a file in the folder. If pack.toml
// cannot be read, the pack is empty and has one fault.
SoundPack read_sound_pack(const std::filesystem::path& folder, const settings::TomlReader& toml = settings::toml_of);

// Returns the samples at 48 kHz. Frequencies above the limit of the lower of the two rates are removed.
std::vector<float> resampled(std::span<const float> samples, int rate_hz);

}  // namespace handrail::sinks
