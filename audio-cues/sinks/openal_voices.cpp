#include "audio-cues/sinks/openal_voices.h"

#include <AL/alext.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "audio-cues/plan/second_cue.h"
#include "audio-cues/plan/sound_rank.h"
#include "audio-cues/plan/sound_table.h"
#include "audio-cues/sinks/loudness.h"

namespace handrail::sinks {
namespace {

constexpr double kLoopFade_s = 0.030;  // fade time of loops
constexpr double kWorldFade_s = 0.25;  // fade time of the world's sounds; slow, because they are background
// A world's sound that was muted because too many sounds played returns only after there has been room for this long.
// Otherwise each footstep would interrupt it.
constexpr double kRoomFor_s = 1.5;
constexpr double kMuffle_db_per_s = 120.0;
constexpr double kPulseLow = 0.25;  // level of a pulsing loop between its swells, as a share of full level
constexpr double kDuckDown_s = 0.040, kDuckUp_s = 0.250;

int importance(cues::SoundKind kind) {
    if (cues::is_world_sound(kind)) return -1;
    switch (kind) {
        case cues::SoundKind::WallTone:
            return 0;
        case cues::SoundKind::Slide:
            return 1;
        case cues::SoundKind::Footstep:
            return 2;
        case cues::SoundKind::Splash:
        case cues::SoundKind::DoorMoves:
        case cues::SoundKind::DoorShuts:
        case cues::SoundKind::Bump:
        case cues::SoundKind::Contact:
            return 3;
        default:
            // The other kinds that are not dangers are sounds of places, and earcons that answer a key.
            return cues::rank_of(kind) == cues::SoundRank::Danger ? 5 : 4;
    }
}

// Returns true for sounds inside the room, which get its reverberation. Earcons and the wall tone do not.
bool is_in_room(cues::SoundKind kind) {
    return !cues::is_earcon(kind) && kind != cues::SoundKind::WallTone && kind != cues::SoundKind::Bell;
}

}  // namespace

// ---- buffers, filters and sources ----

// Returns the buffer of a sound. It is created when the sound is first heard; OpenAL then keeps the samples.
ALuint OpenALVoices::buffer_of(const cues::SoundCue& cue) {
    ALuint& buffer = buffers_[sound_index(cue.kind, cue.material)];
    if (buffer == 0) {
        const std::span<const float> own = pack_.find(cue.kind, cue.material);
        const std::vector<float> samples = own.empty()
                                               ? levelled_sound(cue.kind, cue.material)
                                               : levelled_sound(cue.kind, std::vector<float>(own.begin(), own.end()));
        alGenBuffers(1, &buffer);
        alBufferData(buffer, AL_FORMAT_MONO_FLOAT32, samples.data(),
                     static_cast<ALsizei>(samples.size() * sizeof(float)), kSampleRate_hz);
    }
    return buffer;
}

// Filters are an OpenAL extension. Without it, sounds behind walls only get quieter.
bool OpenALVoices::load_filters(ALCdevice* device) {
    if (alcIsExtensionPresent(device, "ALC_EXT_EFX") == ALC_FALSE) return false;
    gen_filters_ = reinterpret_cast<LPALGENFILTERS>(alGetProcAddress("alGenFilters"));
    delete_filters_ = reinterpret_cast<LPALDELETEFILTERS>(alGetProcAddress("alDeleteFilters"));
    filter_i_ = reinterpret_cast<LPALFILTERI>(alGetProcAddress("alFilteri"));
    filter_f_ = reinterpret_cast<LPALFILTERF>(alGetProcAddress("alFilterf"));
    return gen_filters_ != nullptr && delete_filters_ != nullptr && filter_i_ != nullptr && filter_f_ != nullptr;
}

void OpenALVoices::make_sources(bool filters) {
    const auto generate = [&](SinkVoice& voice, ALint looping) {
        voice = SinkVoice{};
        alGenSources(1, &voice.source);
        alSourcei(voice.source, AL_LOOPING, looping);
        if (!filters) return;
        gen_filters_(1, &voice.filter);
        filter_i_(voice.filter, AL_FILTER_TYPE, AL_FILTER_LOWPASS);
    };
    for (SinkVoice& voice : one_shots_) generate(voice, AL_FALSE);
    for (SinkVoice& voice : loops_) generate(voice, AL_TRUE);
}

void OpenALVoices::drop_sources() {
    const auto discard = [&](SinkVoice& voice) {
        alDeleteSources(1, &voice.source);
        if (voice.filter != 0) delete_filters_(1, &voice.filter);
    };
    for (SinkVoice& voice : one_shots_) discard(voice);
    for (SinkVoice& voice : loops_) discard(voice);
}

void OpenALVoices::drop_buffers() {
    for (ALuint& buffer : buffers_)
        if (buffer != 0) alDeleteBuffers(1, &buffer);
    buffers_.fill(0);
}

// ---- the sound of one voice ----

// Muffles a sound behind doors and walls. The loss is part of the gain, and high tones lose at least twice as much.
// OpenAL copies a filter when it is attached, so a changed filter must be attached again.
bool OpenALVoices::muffle(SinkVoice& voice) const {
    if (voice.filter == 0 || voice.filtered_db == voice.muffled_db ||
        (voice.filtered_db < 0.0 && voice.muffled_db == 0.0))
        return false;
    voice.filtered_db = voice.muffled_db;
    filter_f_(voice.filter, AL_LOWPASS_GAINHF, static_cast<float>(std::pow(10.0, -voice.muffled_db / 20.0)));
    alSourcei(voice.source, AL_DIRECT_FILTER, static_cast<ALint>(voice.filter));
    return true;
}

// Sets position and level of a source for the listener's present position. OpenAL's own listener stays at the origin: x
// right, y up, z backwards from the head.
void OpenALVoices::apply(SinkVoice& voice) const {
    Vec3 head_m{0.0, 0.0, -1.0};
    double near = 1.0;
    if (!cues::is_earcon(voice.cue.kind)) {
        const Vec3 offset_m = voice.cue.position_m - hearing_.listener.ears_m;
        near = cues::distance_gain(voice.cue.kind, glm::length(offset_m));
        const double side = hearing_.sound.swap_sides ? -1.0 : 1.0;
        head_m = {side * glm::dot(offset_m, right_of_heading(hearing_.listener.heading_rad)), offset_m.z,
                  -glm::dot(offset_m, forward_of_heading(hearing_.listener.heading_rad))};
    }
    cues::SecondCue second;
    if (cues::is_world_sound(voice.cue.kind))
        second = cues::second_cue({head_m.x, -head_m.z, head_m.y}, hearing_.now_s, hearing_.sound.behind,
                                  hearing_.sound.height);
    if (hearing_.sound.mono) head_m = {0.0, 0.0, -1.0};
    const double ducked = cues::rank_of(voice.cue.kind) == cues::SoundRank::Danger ? 1.0 : duck_;
    const double swell = voice.cue.pulses_per_s > 0.0 && voice.pulse >= 0.5 ? kPulseLow : 1.0;
    const double gain = voice.ending ? 0.0
                                     : voice.cue.loudness * voice.level * ducked * near * swell * second.gain *
                                           std::pow(10.0, -voice.muffled_db / 20.0);
    if (muffle(voice)) send_to_room(voice);
    alSource3f(voice.source, AL_POSITION, static_cast<float>(head_m.x), static_cast<float>(head_m.y),
               static_cast<float>(head_m.z));
    alSourcef(voice.source, AL_GAIN, static_cast<float>(gain));
    alSourcef(voice.source, AL_PITCH, static_cast<float>(std::clamp(voice.cue.pitch * second.pitch, 0.25, 4.0)));
}

void OpenALVoices::send_to_room(const SinkVoice& voice) const {
    room_.send(voice.source, is_in_room(voice.cue.kind), voice.filtered_db > 0.0 ? voice.filter : 0);
}

void OpenALVoices::start(SinkVoice& voice, const cues::SoundCue& cue, double level) {
    alSourceStop(voice.source);
    alSourcei(voice.source, AL_BUFFER, static_cast<ALint>(buffer_of(cue)));
    voice = SinkVoice{.source = voice.source,
                      .active = true,
                      .cue = cue,
                      .level = level,
                      .muffled_db = cue.muffled_db,
                      .filtered_db = voice.filtered_db,
                      .filter = voice.filter,
                      .order = ++order_};
    room_.sound_again();
    apply(voice);
    send_to_room(voice);
    alSourcePlay(voice.source);
}

// Silences a voice over the next mixing period, and stops it when that period has certainly passed. The world's sounds
// fade out before.
void OpenALVoices::end(SinkVoice& voice, bool at_once) {
    if (!voice.active || voice.ending) return;
    if (!at_once && cues::is_world_sound(voice.cue.kind)) {
        voice.leaving = true;
        return;
    }
    voice.ending = true;
    voice.stop_at_s = hearing_.now_s + kFadeOut_s;
    apply(voice);
}

SinkVoice& OpenALVoices::free_one_shot() {
    const auto cost = [](const SinkVoice& v) {
        return std::tuple(v.active, !v.ending, v.active ? importance(v.cue.kind) : 0, v.order);
    };
    return *std::min_element(one_shots_.begin(), one_shots_.end(),
                             [&](const SinkVoice& a, const SinkVoice& b) { return cost(a) < cost(b); });
}

// Returns the voice that plays this loop, or a free one for it. Returns nullptr if there is no room for a new loop, or
// if the loop to end does not play.
SinkVoice* OpenALVoices::loop_of(const cues::SoundCue& cue) {
    if (!cues::is_world_sound(cue.kind))
        return &loops_[cue.kind == cues::SoundKind::Slide ? 1 + std::min(cue.source, 1U) : 0];
    const std::span<SinkVoice> world = std::span(loops_).subspan(kOwnLoops);
    const auto same = std::find_if(world.begin(), world.end(), [&](const SinkVoice& v) {
        return v.active && !v.ending && v.cue.kind == cue.kind && v.cue.source == cue.source;
    });
    if (same != world.end()) return &*same;
    if (cue.loudness <= 0.0) return nullptr;
    const auto free = std::find_if(world.begin(), world.end(), [](const SinkVoice& v) { return !v.active; });
    return free != world.end() ? &*free : nullptr;
}

// Returns the loudness of a voice for the listener, without the level of its samples.
double OpenALVoices::strength(const SinkVoice& voice) const {
    return voice.cue.loudness *
           cues::distance_gain(voice.cue.kind, glm::length(voice.cue.position_m - hearing_.listener.ears_m)) *
           std::pow(10.0, -voice.cue.muffled_db / 20.0);
}

std::vector<SinkVoice*> OpenALVoices::competing() {
    std::vector<SinkVoice*> all;
    const auto add = [&](SinkVoice& voice) {
        if (voice.active && !voice.ending && !voice.leaving && voice.cue.loudness > 0.0) all.push_back(&voice);
    };
    for (SinkVoice& voice : one_shots_) add(voice);
    for (SinkVoice& voice : loops_) add(voice);
    return all;
}

// Limits how many sounds are heard. One-shots beyond the limit end; loops beyond it are muted until there is room
// again.
void OpenALVoices::limit() {
    std::vector<SinkVoice*> all = competing();
    const auto rank = [&](const SinkVoice* v) {
        return std::tuple(importance(v->cue.kind), cues::is_world_sound(v->cue.kind) ? strength(*v) : 0.0, v->order);
    };
    std::sort(all.begin(), all.end(), [&](const SinkVoice* a, const SinkVoice* b) { return rank(a) > rank(b); });
    for (std::size_t i = 0; i < all.size(); ++i) {
        SinkVoice& voice = *all[i];
        const bool room = i < static_cast<std::size_t>(most_);
        if (!room) voice.may_sound_at_s = hearing_.now_s + (cues::is_world_sound(voice.cue.kind) ? kRoomFor_s : 0.0);
        voice.audible = room && hearing_.now_s >= voice.may_sound_at_s;
        if (!room && !is_loop(voice.cue.kind)) end(voice);
    }
}

// ---- requests ----

void OpenALVoices::play(const cues::SoundCue& cue) {
    start(free_one_shot(), cue, 1.0);
    limit();
}

void OpenALVoices::set_loop(const cues::SoundCue& cue) {
    SinkVoice* loop = loop_of(cue);
    if (loop == nullptr) return;
    if (cue.loudness <= 0.0) return end(*loop, false);
    const bool same = sound_index(loop->cue.kind, loop->cue.material) == sound_index(cue.kind, cue.material);
    if (!loop->active || loop->ending || !same) return start(*loop, cue, 0.0);
    loop->cue = cue;
    loop->leaving = false;
}

void OpenALVoices::stop_all() {
    room_.hush();
    for (SinkVoice& voice : one_shots_) end(voice);
    for (SinkVoice& voice : loops_) end(voice);
}

void OpenALVoices::go_on(const Loops& before) {
    for (std::size_t i = 0; i < loops_.size(); ++i)
        if (before[i].active && !before[i].ending) start(loops_[i], before[i].cue, 0.0);
}

int OpenALVoices::playing() const {
    return static_cast<int>(
        std::count_if(one_shots_.begin(), one_shots_.end(), [](const SinkVoice& v) { return v.active && !v.ending; }) +
        std::count_if(loops_.begin(), loops_.end(),
                      [](const SinkVoice& v) { return v.active && !v.ending && !v.leaving && v.audible; }));
}

void OpenALVoices::stop_ended_one_shots() {
    for (SinkVoice& voice : one_shots_) {
        if (!voice.active) continue;
        ALint state = 0;
        alGetSourcei(voice.source, AL_SOURCE_STATE, &state);
        if (state != AL_PLAYING || (voice.ending && hearing_.now_s >= voice.stop_at_s)) {
            alSourceStop(voice.source);
            voice.active = false;
        }
    }
}

void OpenALVoices::update_loop(SinkVoice& voice, double dt_s) {
    voice.pulse += dt_s * voice.cue.pulses_per_s;
    voice.pulse -= std::floor(voice.pulse);
    const double step = dt_s / (cues::is_world_sound(voice.cue.kind) ? kWorldFade_s : kLoopFade_s);
    voice.level += std::clamp((voice.audible && !voice.leaving ? 1.0 : 0.0) - voice.level, -step, step);
    const double muffle_step = dt_s * kMuffle_db_per_s;
    voice.muffled_db += std::clamp(voice.cue.muffled_db - voice.muffled_db, -muffle_step, muffle_step);
    if (voice.leaving && voice.level == 0.0) end(voice);
    if (voice.ending && hearing_.now_s >= voice.stop_at_s) {
        alSourceStop(voice.source);
        voice.active = false;
    }
}

void OpenALVoices::update(double dt_s, bool spoken_over, double ducking_db) {
    const double wanted = spoken_over ? std::pow(10.0, ducking_db / 20.0) : 1.0;
    duck_ += std::clamp(wanted - duck_, -dt_s / kDuckDown_s, dt_s / kDuckUp_s);
    stop_ended_one_shots();
    limit();
    room_.update(hearing_.now_s, hearing_.listener.reverberation_s, hearing_.sound.reverberation);
    for (SinkVoice& voice : loops_)
        if (voice.active) update_loop(voice, dt_s);
    for (SinkVoice& voice : one_shots_)
        if (voice.active) apply(voice);
    for (SinkVoice& voice : loops_)
        if (voice.active) apply(voice);
}

}  // namespace handrail::sinks
