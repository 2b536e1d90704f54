#include "audio-cues/sinks/openal_sink.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>
#include <AL/efx.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

#include "audio-cues/plan/second_cue.h"
#include "audio-cues/plan/sound_table.h"
#include "audio-cues/sinks/dropout_watch.h"
#include "audio-cues/sinks/synth.h"
#include "worlds/base/language.h"

namespace handrail {
namespace {

constexpr std::size_t kOneShots = 8;     // more than may sound, so that displaced ones can fade
constexpr double kFadeOut_s = 0.020;     // a silenced source is stopped this much later; the mixer's ramp takes 5.3 ms of it
constexpr double kLoopFade_s = 0.030;    // loops come and go over this
constexpr std::size_t kOwnLoops = 3;     // the wall tone, and sliding of each hand
constexpr std::size_t kWorldVoices = 6;  // those that are heard, and as many that fade
constexpr double kWorldFade_s = 0.25;    // the world's sounds are ground, not figure: they come and go slowly
constexpr double kRoomFor_s = 1.5;       // one that gave way comes back when there was room for this long, or each footstep would pump it
constexpr double kMuffle_db_per_s = 120.0;
constexpr double kPulseLow = 0.25;                   // what is left of a pulsing loop between its swells
constexpr double kRoomChange = 1.08, kRoom_s = 0.5;  // the reverberation follows a change of this factor, so often
constexpr double kEffectLonger_s = 0.045;            // OpenAL Soft 1.19.1 reverberates this much longer than it is told, measured from 0.3 to 4 s
constexpr double kDuckDown_s = 0.040, kDuckUp_s = 0.250;
constexpr double kConnectionPoll_s = 0.5, kReopen_s = 5.0;
constexpr int kMostPacedFrames = kSampleRate_hz / 4;
constexpr int kPacedBlock = 1024;

// Settings that OpenAL Soft takes from a file only, and only once in a process. Shorter periods drop out on a loaded machine, the default of
// 3 x 1024 is late by 44 ms. Measured with the null device: 256 x 2 is late by 6.3 ms, 256 x 3 by 11.7.
std::string configuration(int periods) { return fmt::format("period_size = 256\nperiods = {}\n", periods); }

void ignore_alsa_message(const char* /*file*/, int /*line*/, const char* /*function*/, int /*error*/, const char* /*format*/, ...) {}

// Gives OpenAL the configuration above while it starts, in a file that exists only in memory.
class OpenALEnvironment {
public:
    explicit OpenALEnvironment(int periods) {
        // OpenAL and ALSA both print to standard error when there is no sound card; the sink says so in words instead.
        ::setenv("ALSOFT_LOGLEVEL", "0", 0);
        if (void* alsa = ::dlopen("libasound.so.2", RTLD_NOW | RTLD_LOCAL)) {
            using SetHandler = int (*)(decltype(&ignore_alsa_message));
            if (void* set_handler = ::dlsym(alsa, "snd_lib_error_set_handler")) reinterpret_cast<SetHandler>(set_handler)(&ignore_alsa_message);
        }  // stays loaded: OpenAL uses it too
        if (std::getenv("ALSOFT_CONF") != nullptr) return;
        file_ = ::memfd_create("openal.conf", MFD_CLOEXEC);
        if (file_ < 0) return;
        const std::string text = configuration(periods);
        if (::write(file_, text.data(), text.size()) == static_cast<ssize_t>(text.size()))
            ::setenv("ALSOFT_CONF", fmt::format("/proc/self/fd/{}", file_).c_str(), 1);
    }
    ~OpenALEnvironment() {
        if (file_ < 0) return;
        ::unsetenv("ALSOFT_CONF");
        ::close(file_);
    }
    OpenALEnvironment(const OpenALEnvironment&) = delete;
    OpenALEnvironment& operator=(const OpenALEnvironment&) = delete;

private:
    int file_ = -1;
};

// An extension's function; the context or device it was asked of must be there.
template <class Function>
Function alc_function(ALCdevice* device, const char* name) {
    return reinterpret_cast<Function>(alcGetProcAddress(device, name));
}

int importance(SoundKind kind) {
    if (is_world_sound(kind)) return -1;
    switch (kind) {
        case SoundKind::WallTone:
            return 0;
        case SoundKind::Slide:
            return 1;
        case SoundKind::Footstep:
            return 2;
        case SoundKind::Splash:
        case SoundKind::DoorMoves:
        case SoundKind::DoorShuts:
        case SoundKind::Bump:
        case SoundKind::Contact:
            return 3;
        case SoundKind::Alarm:
            return 5;
        default:
            return 4;  // earcons answer a key
    }
}

// A source of OpenAL and what it plays.
struct Voice {
    ALuint source = 0;
    bool active = false;
    bool leaving = false;  // a loop that goes down to level 0 and then ends
    bool ending = false;   // fading, to be stopped at stop_at_s
    double stop_at_s = 0.0;
    SoundCue cue;
    double level = 1.0;           // fade, 0 to 1
    bool audible = true;          // false: too many sounds at once
    double may_sound_at_s = 0.0;  // one that gave way waits until then
    double muffled_db = 0.0;      // as it sounds; follows cue.muffled_db
    double filtered_db = -1.0;    // as the filter has it
    ALuint filter = 0;
    double pulse = 0.0;       // phase of its swells, 0 to 1
    std::uint64_t order = 0;  // larger is newer
};

// A source of OpenAL for the voice: utterances alternate between two, so that a cut one can fade.
struct Speaker {
    ALuint source = 0;
    VoiceChannel::Ticket ticket = 0;
    bool active = false;
    bool ended = false;  // all samples are queued
    bool ending = false;
    double stop_at_s = 0.0;
    double gain = 1.0;
};

}  // namespace

struct OpenALSink::Impl {
    Options options;
    std::shared_ptr<VoiceChannel> channel;
    SoundBank bank;

    ALCdevice* device = nullptr;
    ALCcontext* context = nullptr;
    bool loopback = false;
    LPALCRENDERSAMPLESSOFT render_samples = nullptr;
    LPALGENFILTERS gen_filters = nullptr;
    LPALDELETEFILTERS delete_filters = nullptr;
    LPALFILTERI filter_i = nullptr;
    LPALFILTERF filter_f = nullptr;
    LPALEFFECTF effect_f = nullptr;
    LPALAUXILIARYEFFECTSLOTI slot_i = nullptr;
    LPALAUXILIARYEFFECTSLOTF slot_f = nullptr;
    ALuint effect = 0, slot = 0;  // of the room; 0 where there is no such extension
    double room_s = 0.0;          // reverberation as the effect has it
    double next_room_s = 0.0;     // when it may follow again
    double slot_gain = 0.0;
    bool hush_room = false;       // after stop_all, until something sounds
    std::vector<ALuint> buffers;  // as SoundBank::index
    std::array<Voice, kOneShots> one_shots{};
    std::array<Voice, kOwnLoops + kWorldVoices> loops{};  // WallTone, Slide of each hand, then those of the world
    std::array<Speaker, 2> speakers{};
    std::size_t speaker = 0;  // the one in use

    Listener listener;
    Settings::Sound sound;  // what set_sound said
    bool others_speak = false;
    double now_s = 0.0;
    bool has_time = false;
    double duck = 1.0;
    std::uint64_t order = 0;
    double next_poll_s = 0.0, next_reopen_s = 0.0;
    bool lost = false;  // has no device, and looks for one
    bool never_had = false;
    DropoutWatch dropouts;
    LPALCGETINTEGER64VSOFT get_clock = nullptr;  // the device's own clock, where it has one
    bool drops_out = false;
    double rendered_until_s = 0.0;
    std::vector<float> mix;
    std::optional<std::string> news;

    ~Impl() { close(); }

    // 1. Devices

    Result<void> open() {
        if (options.output == Output::Device && open_playback()) return {};
        return open_loopback();
    }

    bool open_playback() {
        device = alcOpenDevice(options.device.empty() ? nullptr : options.device.c_str());
        if (device == nullptr) return false;
        loopback = false;
        if (make_context({ALC_FREQUENCY, kSampleRate_hz})) return true;
        close();
        return false;
    }

    Result<void> open_loopback() {
        const auto open_device = alc_function<LPALCLOOPBACKOPENDEVICESOFT>(nullptr, "alcLoopbackOpenDeviceSOFT");
        render_samples = alc_function<LPALCRENDERSAMPLESSOFT>(nullptr, "alcRenderSamplesSOFT");
        if (open_device != nullptr && render_samples != nullptr) device = open_device(nullptr);
        if (device == nullptr) return fail(phrase("sound_output.no_loopback"));
        loopback = true;
        rendered_until_s = now_s;
        if (make_context({ALC_FORMAT_CHANNELS_SOFT, ALC_STEREO_SOFT, ALC_FORMAT_TYPE_SOFT, ALC_FLOAT_SOFT, ALC_FREQUENCY, kSampleRate_hz})) return {};
        close();
        return fail(phrase("sound_output.no_48_khz"));
    }

    bool make_context(std::vector<ALCint> attributes) {
        attributes.insert(attributes.end(), {ALC_HRTF_SOFT, options.hrtf ? ALC_TRUE : ALC_FALSE});
        // Without a name the first data set wins, and that one would set the device to 44.1 kHz.
        if (options.hrtf)
            if (const auto id = hrtf_named("default-48000")) attributes.insert(attributes.end(), {ALC_HRTF_ID_SOFT, *id});
        attributes.push_back(0);
        context = alcCreateContext(device, attributes.data());
        if (context == nullptr || alcMakeContextCurrent(context) == ALC_FALSE) return false;
        return make_sources();
    }

    std::optional<ALCint> hrtf_named(std::string_view name) const {
        const auto name_of = alc_function<LPALCGETSTRINGISOFT>(device, "alcGetStringiSOFT");
        if (name_of == nullptr || alcIsExtensionPresent(device, "ALC_SOFT_HRTF") == ALC_FALSE) return std::nullopt;
        ALCint count = 0;
        alcGetIntegerv(device, ALC_NUM_HRTF_SPECIFIERS_SOFT, 1, &count);
        for (ALCint i = 0; i < count; ++i) {
            const ALCchar* found = name_of(device, ALC_HRTF_SPECIFIER_SOFT, i);
            if (found != nullptr && std::string_view(found).find(name) != std::string_view::npos) return i;
        }
        return std::nullopt;
    }

    bool make_sources() {
        alGetError();
        buffers.assign(SoundBank::size(), 0);
        for (int k = 0; k < kSoundKinds; ++k) {
            for (int m = 0; m < kSoundClasses; ++m) {
                const auto kind = static_cast<SoundKind>(k);
                const auto material = static_cast<SoundClass>(m);
                ALuint& buffer = buffers[SoundBank::index(kind, material)];
                if (buffer != 0) continue;
                const auto samples = bank.sound(kind, material);
                alGenBuffers(1, &buffer);
                alBufferData(buffer, AL_FORMAT_MONO_FLOAT32, samples.data(), static_cast<ALsizei>(samples.size_bytes()), kSampleRate_hz);
            }
        }
        get_clock = nullptr;
        if (alcIsExtensionPresent(device, "ALC_SOFT_device_clock") == ALC_TRUE)
            get_clock = alc_function<LPALCGETINTEGER64VSOFT>(device, "alcGetInteger64vSOFT");
        dropouts.reset();
        alDistanceModel(AL_NONE);  // distance_gain() has its own say
        const bool filters = load_filters();
        if (filters) make_room();
        const auto generate = [&](Voice& voice, ALint looping) {
            voice = Voice{};
            alGenSources(1, &voice.source);
            alSourcei(voice.source, AL_LOOPING, looping);
            if (!filters) return;
            gen_filters(1, &voice.filter);
            filter_i(voice.filter, AL_FILTER_TYPE, AL_FILTER_LOWPASS);
        };
        for (Voice& voice : one_shots) generate(voice, AL_FALSE);
        for (Voice& voice : loops) generate(voice, AL_TRUE);
        const ALint best_resampler = alGetInteger(AL_NUM_RESAMPLERS_SOFT) - 1;
        for (Speaker& s : speakers) {
            s = Speaker{};
            alGenSources(1, &s.source);
            alSource3f(s.source, AL_POSITION, 0.0F, 0.0F, -1.0F);
            if (best_resampler >= 0) alSourcei(s.source, AL_SOURCE_RESAMPLER_SOFT, best_resampler);
        }
        return alGetError() == AL_NO_ERROR;
    }

    void close() {
        if (context != nullptr) {
            for (Speaker& s : speakers) drop_speech(s);
            const auto discard = [&](Voice& voice) {
                alDeleteSources(1, &voice.source);
                if (voice.filter != 0) delete_filters(1, &voice.filter);
            };
            for (Voice& voice : one_shots) discard(voice);
            for (Voice& voice : loops) discard(voice);
            for (Speaker& s : speakers) alDeleteSources(1, &s.source);
            drop_room();
            for (ALuint& buffer : buffers)
                if (buffer != 0) alDeleteBuffers(1, &buffer);
            buffers.clear();
            alcMakeContextCurrent(nullptr);
            alcDestroyContext(context);
            context = nullptr;
        }
        if (device != nullptr) alcCloseDevice(device);
        device = nullptr;
    }

    std::string device_name() const {
        const bool all = alcIsExtensionPresent(device, "ALC_ENUMERATE_ALL_EXT") == ALC_TRUE;
        const ALCchar* name = alcGetString(device, all ? ALC_ALL_DEVICES_SPECIFIER : ALC_DEVICE_SPECIFIER);
        return name != nullptr ? std::string(name) : phrase("sound_output.unnamed");
    }

    bool hrtf_active() const {
        ALCint active = ALC_FALSE;
        alcGetIntegerv(device, ALC_HRTF_SOFT, 1, &active);
        return active == ALC_TRUE;
    }

    bool connected() const {
        if (options.still_connected) return options.still_connected();
        if (alcIsExtensionPresent(device, "ALC_EXT_disconnect") == ALC_FALSE) return true;
        ALCint answer = ALC_TRUE;
        alcGetIntegerv(device, ALC_CONNECTED, 1, &answer);
        return answer == ALC_TRUE;
    }

    // Loops go on after the change; one-shots and what was being said are lost with their device.
    void change_device() {
        const auto before = loops;
        const VoiceChannel::Ticket spoken = speakers[speaker].ticket;
        close();
        if (!open()) return;  // tick() tries again
        for (std::size_t i = 0; i < loops.size(); ++i)
            if (before[i].active && !before[i].ending) start(loops[i], before[i].cue, 0.0);
        channel->finished(spoken);
        speakers[speaker].ticket = spoken;
    }

    // Looks without letting go of the loopback device, which would have to be filled anew.
    bool device_is_there() const {
        ALCdevice* found = alcOpenDevice(options.device.empty() ? nullptr : options.device.c_str());
        if (found != nullptr) alcCloseDevice(found);
        return found != nullptr;
    }

    void watch_dropouts() {
        if (loopback || get_clock == nullptr) return;
        ALCint64SOFT clock_ns = 0;
        get_clock(device, ALC_DEVICE_CLOCK_SOFT, 1, &clock_ns);
        drops_out = dropouts.tick(now_s, static_cast<double>(clock_ns) * 1e-9);
    }

    void watch_device() {
        if (options.output == Output::OnDemand || now_s < next_poll_s) return;
        next_poll_s = now_s + kConnectionPoll_s;
        if (device != nullptr && !loopback && !connected()) {
            change_device();
            lost = device == nullptr || loopback;
            next_reopen_s = now_s + kReopen_s;
            news = lost ? phrase("sound_output.lost") : phrase("sound_output.lost_other", {{"device", device_name()}});
        } else if (lost && now_s >= next_reopen_s) {
            next_reopen_s = now_s + kReopen_s;
            if (!device_is_there()) return;
            change_device();
            lost = device == nullptr || loopback;
            if (!lost)
                news = never_had ? phrase("sound_output.here_now", {{"device", device_name()}}) : phrase("sound_output.back", {{"device", device_name()}});
        }
    }

    // 2. Sounds

    ALuint buffer_of(const SoundCue& cue) const { return buffers[SoundBank::index(cue.kind, cue.material)]; }

    // Filters are an extension; without it what is behind walls is quieter alone.
    bool load_filters() {
        if (alcIsExtensionPresent(device, "ALC_EXT_EFX") == ALC_FALSE) return false;
        gen_filters = reinterpret_cast<LPALGENFILTERS>(alGetProcAddress("alGenFilters"));
        delete_filters = reinterpret_cast<LPALDELETEFILTERS>(alGetProcAddress("alDeleteFilters"));
        filter_i = reinterpret_cast<LPALFILTERI>(alGetProcAddress("alFilteri"));
        filter_f = reinterpret_cast<LPALFILTERF>(alGetProcAddress("alFilterf"));
        return gen_filters != nullptr && delete_filters != nullptr && filter_i != nullptr && filter_f != nullptr;
    }

    // Doors and walls: the loss itself is part of the gain, high tones lose twice as much and more. A filter is copied when it is
    // attached, so it has to be attached anew.
    static bool muffle(Voice& voice, const Impl& impl) {
        if (voice.filter == 0 || voice.filtered_db == voice.muffled_db || (voice.filtered_db < 0.0 && voice.muffled_db == 0.0)) return false;
        voice.filtered_db = voice.muffled_db;
        impl.filter_f(voice.filter, AL_LOWPASS_GAINHF, static_cast<float>(std::pow(10.0, -voice.muffled_db / 20.0)));
        alSourcei(voice.source, AL_DIRECT_FILTER, static_cast<ALint>(voice.filter));
        return true;
    }

    // The effect of a room, if OpenAL has it. Its own shares of early and late sound stay as they are: a plain room.
    void make_room() {
        effect = slot = 0;
        const auto gen_effects = reinterpret_cast<LPALGENEFFECTS>(alGetProcAddress("alGenEffects"));
        const auto effect_i = reinterpret_cast<LPALEFFECTI>(alGetProcAddress("alEffecti"));
        const auto gen_slots = reinterpret_cast<LPALGENAUXILIARYEFFECTSLOTS>(alGetProcAddress("alGenAuxiliaryEffectSlots"));
        effect_f = reinterpret_cast<LPALEFFECTF>(alGetProcAddress("alEffectf"));
        slot_i = reinterpret_cast<LPALAUXILIARYEFFECTSLOTI>(alGetProcAddress("alAuxiliaryEffectSloti"));
        slot_f = reinterpret_cast<LPALAUXILIARYEFFECTSLOTF>(alGetProcAddress("alAuxiliaryEffectSlotf"));
        if (gen_effects == nullptr || effect_i == nullptr || gen_slots == nullptr || effect_f == nullptr || slot_i == nullptr || slot_f == nullptr) return;
        gen_effects(1, &effect);
        effect_i(effect, AL_EFFECT_TYPE, AL_EFFECT_EAXREVERB);
        effect_i(effect, AL_EAXREVERB_DECAY_HFLIMIT, AL_FALSE);
        effect_f(effect, AL_EAXREVERB_DECAY_HFRATIO, 1.0F);
        effect_f(effect, AL_EAXREVERB_GAIN, 1.0F);
        gen_slots(1, &slot);
        slot_f(slot, AL_EFFECTSLOT_GAIN, 0.0F);
        room_s = slot_gain = 0.0;
        if (alGetError() == AL_NO_ERROR) return;
        drop_room();
    }

    void drop_room() {
        if (slot != 0) reinterpret_cast<LPALDELETEAUXILIARYEFFECTSLOTS>(alGetProcAddress("alDeleteAuxiliaryEffectSlots"))(1, &slot);
        if (effect != 0) reinterpret_cast<LPALDELETEEFFECTS>(alGetProcAddress("alDeleteEffects"))(1, &effect);
        effect = slot = 0;
        alGetError();
    }

    // Places and levels a source as the ears stand now. OpenAL's listener stays at its origin: x right, y up, z backward of the head.
    void apply(Voice& voice) const {
        Vec3 head_m{0.0, 0.0, -1.0};
        double near = 1.0;
        if (!is_earcon(voice.cue.kind)) {
            const Vec3 offset_m = voice.cue.position_m - listener.ears_m;
            near = distance_gain(voice.cue.kind, glm::length(offset_m));
            const double side = sound.swap_sides ? -1.0 : 1.0;
            head_m = {side * glm::dot(offset_m, right_of_heading(listener.heading_rad)), offset_m.z,
                      -glm::dot(offset_m, forward_of_heading(listener.heading_rad))};
        }
        SecondCue second;
        if (is_world_sound(voice.cue.kind)) second = second_cue({head_m.x, -head_m.z, head_m.y}, now_s, sound.behind, sound.height);
        if (sound.mono) head_m = {0.0, 0.0, -1.0};
        const double ducked = voice.cue.kind == SoundKind::Alarm ? 1.0 : duck;
        const double swell = voice.cue.pulses_per_s > 0.0 && voice.pulse >= 0.5 ? kPulseLow : 1.0;
        const double gain =
            voice.ending ? 0.0 : voice.cue.loudness * voice.level * ducked * near * swell * second.gain * std::pow(10.0, -voice.muffled_db / 20.0);
        if (muffle(voice, *this)) send_to_room(voice);
        alSource3f(voice.source, AL_POSITION, static_cast<float>(head_m.x), static_cast<float>(head_m.y), static_cast<float>(head_m.z));
        alSourcef(voice.source, AL_GAIN, static_cast<float>(gain));
        alSourcef(voice.source, AL_PITCH, static_cast<float>(std::clamp(voice.cue.pitch * second.pitch, 0.25, 4.0)));
    }

    // What sounds in the room sounds through it: signals and the tone of walls are no part of it.
    static bool is_in_room(SoundKind kind) { return !is_earcon(kind) && kind != SoundKind::WallTone && kind != SoundKind::Bell; }

    void send_to_room(const Voice& voice) const {
        if (slot == 0) return;
        const bool in_room = is_in_room(voice.cue.kind);
        alSource3i(voice.source, AL_AUXILIARY_SEND_FILTER, in_room ? static_cast<ALint>(slot) : AL_EFFECTSLOT_NULL, 0,
                   in_room && voice.filtered_db > 0.0 ? static_cast<ALint>(voice.filter) : AL_FILTER_NULL);
    }

    // The reverberation of the room around, weak, and silent at once when all sound is to stop.
    void update_room() {
        if (slot == 0) return;
        const double wanted_s = std::clamp(listener.reverberation_s, 0.0, 8.0);
        const double gain = wanted_s <= 0.0 || hush_room ? 0.0 : sound.reverberation;
        if (gain != slot_gain) slot_f(slot, AL_EFFECTSLOT_GAIN, static_cast<float>(slot_gain = gain));
        const bool changed = wanted_s > room_s * kRoomChange || wanted_s * kRoomChange < room_s;
        if (gain <= 0.0 || !changed || now_s < next_room_s) return;
        room_s = wanted_s;
        next_room_s = now_s + kRoom_s;
        effect_f(effect, AL_EAXREVERB_DECAY_TIME, static_cast<float>(std::max(room_s - kEffectLonger_s, 0.1)));
        slot_i(slot, AL_EFFECTSLOT_EFFECT, static_cast<ALint>(effect));
    }

    void start(Voice& voice, const SoundCue& cue, double level) {
        alSourceStop(voice.source);
        alSourcei(voice.source, AL_BUFFER, static_cast<ALint>(buffer_of(cue)));
        voice = Voice{.source = voice.source,
                      .active = true,
                      .cue = cue,
                      .level = level,
                      .muffled_db = cue.muffled_db,
                      .filtered_db = voice.filtered_db,
                      .filter = voice.filter,
                      .order = ++order};
        hush_room = false;
        apply(voice);
        send_to_room(voice);
        alSourcePlay(voice.source);
    }

    // Silent from the next mixing period on, over its length; stopped when that has surely passed. Those of the world fade first.
    void end(Voice& voice, bool at_once = true) {
        if (!voice.active || voice.ending) return;
        if (!at_once && is_world_sound(voice.cue.kind)) {
            voice.leaving = true;
            return;
        }
        voice.ending = true;
        voice.stop_at_s = now_s + kFadeOut_s;
        apply(voice);
    }

    Voice& free_one_shot() {
        const auto cost = [](const Voice& v) { return std::tuple(v.active, !v.ending, v.active ? importance(v.cue.kind) : 0, v.order); };
        return *std::min_element(one_shots.begin(), one_shots.end(), [&](const Voice& a, const Voice& b) { return cost(a) < cost(b); });
    }

    // The voice that plays this loop, or where it may begin; nullptr where there is no room for one more, or nothing to end.
    Voice* loop_of(const SoundCue& cue) {
        if (!is_world_sound(cue.kind)) return &loops[cue.kind == SoundKind::Slide ? 1 + std::min(cue.source, 1U) : 0];
        const std::span<Voice> world = std::span(loops).subspan(kOwnLoops);
        const auto same = std::find_if(world.begin(), world.end(),
                                       [&](const Voice& v) { return v.active && !v.ending && v.cue.kind == cue.kind && v.cue.source == cue.source; });
        if (same != world.end()) return &*same;
        if (cue.loudness <= 0.0) return nullptr;
        const auto free = std::find_if(world.begin(), world.end(), [](const Voice& v) { return !v.active; });
        return free != world.end() ? &*free : nullptr;
    }

    // How loud it is at the ears, but for its own samples.
    double strength(const Voice& voice) const {
        return voice.cue.loudness * distance_gain(voice.cue.kind, glm::length(voice.cue.position_m - listener.ears_m)) *
               std::pow(10.0, -voice.cue.muffled_db / 20.0);
    }

    std::vector<Voice*> competing() {
        std::vector<Voice*> all;
        const auto add = [&](Voice& voice) {
            if (voice.active && !voice.ending && !voice.leaving && voice.cue.loudness > 0.0) all.push_back(&voice);
        };
        for (Voice& voice : one_shots) add(voice);
        for (Voice& voice : loops) add(voice);
        return all;
    }

    // At most kMostSounds are heard: a one-shot that is one too many ends, a loop is mute until there is room again.
    void limit() {
        std::vector<Voice*> all = competing();
        const auto rank = [&](const Voice* v) { return std::tuple(importance(v->cue.kind), is_world_sound(v->cue.kind) ? strength(*v) : 0.0, v->order); };
        std::sort(all.begin(), all.end(), [&](const Voice* a, const Voice* b) { return rank(a) > rank(b); });
        for (std::size_t i = 0; i < all.size(); ++i) {
            Voice& voice = *all[i];
            const bool room = i < static_cast<std::size_t>(kMostSounds);
            if (!room) voice.may_sound_at_s = now_s + (is_world_sound(voice.cue.kind) ? kRoomFor_s : 0.0);
            voice.audible = room && now_s >= voice.may_sound_at_s;
            if (!room && !is_loop(voice.cue.kind)) end(voice);
        }
    }

    void update_sounds(double dt_s) {
        const double wanted = channel->playing() || others_speak ? std::pow(10.0, kDuckingDb / 20.0) : 1.0;
        duck += std::clamp(wanted - duck, -dt_s / kDuckDown_s, dt_s / kDuckUp_s);
        for (Voice& voice : one_shots) {
            if (!voice.active) continue;
            ALint state = 0;
            alGetSourcei(voice.source, AL_SOURCE_STATE, &state);
            if (state != AL_PLAYING || (voice.ending && now_s >= voice.stop_at_s)) {
                alSourceStop(voice.source);
                voice.active = false;
            }
        }
        limit();
        update_room();
        for (Voice& voice : loops) {
            if (!voice.active) continue;
            voice.pulse += dt_s * voice.cue.pulses_per_s;
            voice.pulse -= std::floor(voice.pulse);
            const double step = dt_s / (is_world_sound(voice.cue.kind) ? kWorldFade_s : kLoopFade_s);
            voice.level += std::clamp((voice.audible && !voice.leaving ? 1.0 : 0.0) - voice.level, -step, step);
            const double muffle_step = dt_s * kMuffle_db_per_s;
            voice.muffled_db += std::clamp(voice.cue.muffled_db - voice.muffled_db, -muffle_step, muffle_step);
            if (voice.leaving && voice.level == 0.0) end(voice);
            if (voice.ending && now_s >= voice.stop_at_s) {
                alSourceStop(voice.source);
                voice.active = false;
            }
        }
        for (Voice& voice : one_shots)
            if (voice.active) apply(voice);
        for (Voice& voice : loops)
            if (voice.active) apply(voice);
    }

    // 3. The voice

    static void delete_played(const Speaker& s) {
        ALint played = 0;
        alGetSourcei(s.source, AL_BUFFERS_PROCESSED, &played);
        std::vector<ALuint> done(static_cast<std::size_t>(std::max(played, 0)));
        if (done.empty()) return;
        alSourceUnqueueBuffers(s.source, played, done.data());
        alDeleteBuffers(played, done.data());
    }

    static void drop_speech(Speaker& s) {
        alSourceStop(s.source);  // now all of its buffers count as played
        delete_played(s);
        alSourcei(s.source, AL_BUFFER, 0);
        s.active = s.ended = s.ending = false;
    }

    void update_speech() {
        const VoiceChannel::Update update = channel->take();
        if (update.ticket != speakers[speaker].ticket) {
            Speaker& cut = speakers[speaker];
            if (cut.active) {
                cut.ending = true;
                cut.stop_at_s = now_s + kFadeOut_s;
                alSourcef(cut.source, AL_GAIN, 0.0F);
            }
            speaker = 1 - speaker;
            drop_speech(speakers[speaker]);
            speakers[speaker].ticket = update.ticket;
            speakers[speaker].gain = update.gain;
        }
        Speaker& s = speakers[speaker];
        s.ended = update.ended;
        if (!update.samples.empty()) {
            delete_played(s);  // a source that ran dry would begin again with them
            ALuint buffer = 0;
            alGenBuffers(1, &buffer);
            alBufferData(buffer, AL_FORMAT_MONO16, update.samples.data(), static_cast<ALsizei>(update.samples.size() * sizeof(std::int16_t)), update.rate_hz);
            alSourceQueueBuffers(s.source, 1, &buffer);
            alSourcef(s.source, AL_GAIN, static_cast<float>(s.gain));
            ALint state = 0;
            alGetSourcei(s.source, AL_SOURCE_STATE, &state);
            if (state != AL_PLAYING) alSourcePlay(s.source);  // the first piece, or the voice was slower than its own speech
            s.active = true;
        }
        if (s.ended) {
            ALint state = 0;
            if (s.active) alGetSourcei(s.source, AL_SOURCE_STATE, &state);
            if (state != AL_PLAYING) {
                if (s.active) drop_speech(s);
                s.ended = true;
                channel->finished(s.ticket);
            }
        }
        Speaker& other = speakers[1 - speaker];
        if (other.ending && now_s >= other.stop_at_s) drop_speech(other);
    }

    // 4. Samples without a device

    void render_to(float* stereo, int frames) const { render_samples(device, stereo, frames); }

    void discard_elapsed() {
        double due = (now_s - rendered_until_s) * kSampleRate_hz;
        if (due > kMostPacedFrames) {  // the thread was held up; what nobody hears need not be made up for
            rendered_until_s = now_s - static_cast<double>(kMostPacedFrames) / kSampleRate_hz;
            due = kMostPacedFrames;
        }
        mix.resize(2 * kPacedBlock);
        for (int left = static_cast<int>(due); left > 0; left -= kPacedBlock) {
            const int frames = std::min(left, kPacedBlock);
            render_to(mix.data(), frames);
            rendered_until_s += static_cast<double>(frames) / kSampleRate_hz;
        }
    }
};

OpenALSink::OpenALSink(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
OpenALSink::~OpenALSink() = default;

Result<std::unique_ptr<OpenALSink>> OpenALSink::open(std::shared_ptr<VoiceChannel> voice, const Options& options) {
    const OpenALEnvironment environment(options.periods);
    auto impl = std::make_unique<Impl>();
    impl->options = options;
    impl->channel = std::move(voice);
    if (auto opened = impl->open(); !opened) return tl::unexpected(opened.error());
    if (options.output == Output::Device && impl->loopback) {
        impl->news = phrase("sound_output.none_found");
        impl->lost = true;  // one may be plugged in later
        impl->never_had = true;
    }
    return std::unique_ptr<OpenALSink>(new OpenALSink(std::move(impl)));
}

void OpenALSink::play(const SoundCue& cue) {
    if (impl_->device == nullptr) return;
    impl_->start(impl_->free_one_shot(), cue, 1.0);
    impl_->limit();
}

void OpenALSink::set_loop(const SoundCue& cue) {
    if (impl_->device == nullptr || !is_loop(cue.kind)) return;
    Voice* loop = impl_->loop_of(cue);
    if (loop == nullptr) return;
    if (cue.loudness <= 0.0) return impl_->end(*loop, false);
    if (!loop->active || loop->ending || impl_->buffer_of(loop->cue) != impl_->buffer_of(cue)) return impl_->start(*loop, cue, 0.0);
    loop->cue = cue;
    loop->leaving = false;
}

void OpenALSink::set_sound(const Settings::Sound& settings) { impl_->sound = settings; }

void OpenALSink::set_speaking(bool speaking) { impl_->others_speak = speaking; }

void OpenALSink::set_listener(const Listener& listener) { impl_->listener = listener; }

void OpenALSink::stop_all() {
    impl_->hush_room = true;
    for (Voice& voice : impl_->one_shots) impl_->end(voice);
    for (Voice& voice : impl_->loops) impl_->end(voice);
}

void OpenALSink::tick(double now_s) {
    Impl& s = *impl_;
    if (!s.has_time) s.rendered_until_s = now_s;
    const double dt_s = s.has_time ? std::max(0.0, now_s - s.now_s) : 0.0;
    s.has_time = true;
    s.now_s = now_s;
    s.watch_device();
    if (s.device == nullptr) return;
    s.watch_dropouts();
    s.update_speech();
    s.update_sounds(dt_s);
    if (s.loopback && s.options.output == Output::Device) s.discard_elapsed();
}

bool OpenALSink::drops_out() const { return impl_->drops_out; }

std::optional<std::string> OpenALSink::news() { return std::exchange(impl_->news, std::nullopt); }

std::string OpenALSink::description() const {
    if (!has_device()) return impl_->options.output == Output::OnDemand ? phrase("sound_output.on_demand") : phrase("sound_output.none");
    const std::string device = impl_->device_name();
    return impl_->hrtf_active() ? phrase("sound_output.headphones", {{"device", device}}) : phrase("sound_output.stereo", {{"device", device}});
}

bool OpenALSink::has_device() const { return impl_->device != nullptr && !impl_->loopback; }

int OpenALSink::sounds_playing() const {
    return static_cast<int>(
        std::count_if(impl_->one_shots.begin(), impl_->one_shots.end(), [](const Voice& v) { return v.active && !v.ending; }) +
        std::count_if(impl_->loops.begin(), impl_->loops.end(), [](const Voice& v) { return v.active && !v.ending && !v.leaving && v.audible; }));
}

std::span<const float> OpenALSink::render(int frames) {
    impl_->mix.resize(2 * static_cast<std::size_t>(frames));
    impl_->render_to(impl_->mix.data(), frames);
    return impl_->mix;
}

}  // namespace handrail
