#include "audio-cues/sinks/sound_pack.h"

#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "audio-cues/plan/sound_table.h"
#include "audio-cues/sinks/synth.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/base/vec.h"

namespace handrail::sinks {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestTable_bytes = std::size_t{1} << 20;
constexpr int kMostChannels = 8, kLeastRate_hz = 4000, kMostRate_hz = 384000;

// The bytes of a sound file, as libsndfile reads them.
struct Bytes {
    std::string all;
    sf_count_t at = 0;
};

SF_VIRTUAL_IO reading_from_bytes() {
    SF_VIRTUAL_IO io{};
    io.get_filelen = [](void* user) { return static_cast<sf_count_t>(static_cast<Bytes*>(user)->all.size()); };
    io.tell = [](void* user) { return static_cast<Bytes*>(user)->at; };
    io.seek = [](sf_count_t offset, int whence, void* user) {
        auto& bytes = *static_cast<Bytes*>(user);
        const auto size = static_cast<sf_count_t>(bytes.all.size());
        const sf_count_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? bytes.at : size;
        return bytes.at = std::clamp<sf_count_t>(from + offset, 0, size);
    };
    io.read = [](void* to, sf_count_t count, void* user) {
        auto& bytes = *static_cast<Bytes*>(user);
        const auto left = static_cast<sf_count_t>(bytes.all.size()) - bytes.at;
        count = std::clamp<sf_count_t>(count, 0, left);
        std::copy_n(bytes.all.begin() + bytes.at, count, static_cast<char*>(to));
        bytes.at += count;
        return count;
    };
    io.write = [](const void*, sf_count_t, void*) -> sf_count_t { return 0; };
    return io;
}

// Returns the sound file in mono at 48 kHz.
Result<std::vector<float>> read_sound(const fs::path& file) {
    auto read = read_whole_file(file, SoundPack::kLargestFile_bytes);
    if (!read) return tl::unexpected(read.error());
    Bytes bytes{std::move(*read)};
    SF_VIRTUAL_IO io = reading_from_bytes();
    SF_INFO info{};
    const std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> sound(sf_open_virtual(&io, SFM_READ, &info, &bytes), sf_close);
    if (!sound) return fail(phrase("sound_pack.no_sound"));
    if (info.channels < 1 || info.channels > kMostChannels)
        return fail(phrase("sound_pack.channels", {{"channels", info.channels}, {"most", kMostChannels}}));
    if (info.samplerate < kLeastRate_hz || info.samplerate > kMostRate_hz)
        return fail(
            phrase("sound_pack.rate", {{"rate", info.samplerate}, {"least", kLeastRate_hz}, {"most", kMostRate_hz}}));
    if (info.frames < 1) return fail(phrase("sound_pack.silent"));
    if (static_cast<double>(info.frames) > SoundPack::kLongest_s * info.samplerate)
        return fail(phrase("sound_pack.long", {{"most", SoundPack::kLongest_s}}));
    const auto channels = static_cast<std::size_t>(info.channels), frames = static_cast<std::size_t>(info.frames);
    std::vector<float> all(channels * frames);
    all.resize(channels *
               static_cast<std::size_t>(std::max<sf_count_t>(0, sf_readf_float(sound.get(), all.data(), info.frames))));
    std::vector<float> mono(all.size() / channels);
    bool silent = true;
    for (std::size_t i = 0; i < mono.size(); ++i) {
        for (std::size_t c = 0; c < channels; ++c) mono[i] += all[i * channels + c] / static_cast<float>(channels);
        if (!std::isfinite(mono[i])) return fail(phrase("sound_pack.no_sound"));
        silent = silent && std::abs(mono[i]) < 1e-5F;
    }
    if (silent) return fail(phrase("sound_pack.silent"));
    return resampled(mono, info.samplerate);
}

// The sounds that an entry of the table replaces; empty: its name is unknown.
std::vector<std::size_t> sounds_called(const std::string& name) {
    std::vector<std::size_t> sounds;
    for (const cues::SoundInfo& info : cues::sound_table())
        for (int material = 0; material < kSoundClasses; ++material) {
            const auto as = static_cast<SoundClass>(material);
            const std::string own = std::string(info.name) + " " + std::string(cues::material_sound_name(as));
            if (name == info.name || (varies_by_material(info.kind) && name == own))
                sounds.push_back(sound_index(info.kind, as));
        }
    return sounds;
}

std::string nearest_sound(const std::string& name) {
    std::vector<std::string> names;
    for (const cues::SoundInfo& info : cues::sound_table()) names.emplace_back(info.name);
    return nearest_name(name, names);
}

}  // namespace

std::span<const float> SoundPack::find(cues::SoundKind kind, SoundClass material) const {
    const auto found = sounds.find(sound_index(kind, material));
    return found == sounds.end() ? std::span<const float>() : std::span<const float>(found->second);
}

std::vector<float> resampled(std::span<const float> samples, int rate_hz) {
    if (rate_hz == kSampleRate_hz) return {samples.begin(), samples.end()};
    constexpr int kLobes = 16;
    const double step = static_cast<double>(rate_hz) / kSampleRate_hz;  // input samples for each output sample
    const double cutoff = std::min(1.0, 1.0 / step), reach = kLobes / cutoff;
    std::vector<float> out(static_cast<std::size_t>(std::ceil(static_cast<double>(samples.size()) / step)));
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double at = static_cast<double>(i) * step;
        const auto first = static_cast<std::int64_t>(std::ceil(at - reach)),
                   last = static_cast<std::int64_t>(std::floor(at + reach));
        double sum = 0.0;
        for (std::int64_t k = std::max<std::int64_t>(0, first);
             k <= std::min(last, static_cast<std::int64_t>(samples.size()) - 1); ++k) {
            const double x = at - static_cast<double>(k), y = kPi * cutoff * x;
            const double sinc = std::abs(y) < 1e-9 ? 1.0 : std::sin(y) / y;
            sum += static_cast<double>(samples[static_cast<std::size_t>(k)]) * cutoff * sinc *
                   (0.5 + 0.5 * std::cos(kPi * x / reach));
        }
        out[i] = static_cast<float>(sum);
    }
    return out;
}

SoundPack read_sound_pack(const fs::path& folder, const settings::TomlReader& toml) {
    SoundPack pack;
    const std::string table_name = (folder / "pack.toml").string();
    const auto refuse = [&](std::string message, const std::string& file, int line = 0) {
        pack.faults.push_back(Error{file, line, 0, std::move(message)});
    };
    const auto text = read_whole_file(folder / "pack.toml", kLargestTable_bytes);
    if (!text) return refuse(phrase("sound_pack.no_table"), table_name), pack;
    const auto root = toml(*text);
    if (!root) return refuse(phrase("sound_pack.bad_table"), table_name, root.error().line), pack;
    const settings::TomlValue* sounds = root->find("sounds");
    if (!sounds || !sounds->table()) return refuse(phrase("sound_pack.no_sounds"), table_name), pack;
    for (const settings::TomlMember& member : *sounds->table()) {
        const std::vector<std::size_t> replaced = sounds_called(member.key);
        const std::string* file = member.value.text();
        if (replaced.empty()) {
            refuse(
                phrase("sound_pack.unknown", {{"name", one_line(member.key)}, {"nearest", nearest_sound(member.key)}}),
                table_name, member.value.line);
            continue;
        }
        // A pack that somebody else made must not name files elsewhere.
        if (!file || file->empty() || fs::path(*file).has_parent_path()) {
            refuse(phrase("sound_pack.no_file", {{"name", one_line(member.key)}}), table_name, member.value.line);
            continue;
        }
        auto samples = read_sound(folder / *file);
        if (!samples) {
            refuse(phrase("sound_pack.unusable", {{"reason", samples.error().message}}), (folder / *file).string());
            continue;
        }
        for (const std::size_t sound : replaced) pack.sounds[sound] = *samples;
    }
    return pack;
}

}  // namespace handrail::sinks
