#include "audio-cues/sinks/openal_sink.h"

#include <algorithm>
#include <utility>

#include "audio-cues/plan/sound_table.h"
#include "audio-cues/sinks/dropout_watch.h"
#include "audio-cues/sinks/loopback_mix.h"
#include "audio-cues/sinks/openal_device.h"
#include "audio-cues/sinks/openal_room.h"
#include "audio-cues/sinks/openal_speech.h"
#include "audio-cues/sinks/openal_voices.h"
#include "audio-cues/sinks/synth.h"
#include "worlds/base/language.h"

namespace handrail::sinks {
namespace {

constexpr double kConnectionPoll_s = 0.5, kReopen_s = 5.0;

bool leads_by_sound(cues::SoundKind kind) {
    return cues::is_beacon(kind) || kind == cues::SoundKind::Bell || kind == cues::SoundKind::Warmer;
}

}  // namespace

// The state of the sink. Impl chooses the device and notices when the device is lost or found again. Its members
// `voices`, `speech` and `room` make the sound.
struct OpenALSink::Impl {
    Impl(const Options& requested, std::shared_ptr<VoiceChannel> channel)
        : options(requested),
          device(requested.device, requested.hrtf, requested.hrtf_set),
          pack(requested.pack == "none" ? SoundPack{} : read_sound_pack(requested.pack)),
          voices(hearing, room, pack, kMostSounds),
          speech(std::move(channel)),
          mix(device, requested.on_render) {}
    ~Impl() { close(); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    Options options;
    Listening hearing;
    OpenALDevice device;
    OpenALRoom room;
    SoundPack pack;
    OpenALVoices voices;
    OpenALSpeech speech;
    LoopbackMix mix;
    DropoutWatch dropouts;

    bool others_speak = false;
    bool has_time = false;
    double next_poll_s = 0.0, next_reopen_s = 0.0;
    bool lost = false;  // there is no playback device, and the sink searches for one
    bool never_had = false;
    bool drops_out = false;
    std::optional<std::string> news;
    // The message that there is no sound. It is kept until the person needs sound to find their way.
    std::optional<std::string> unreported;

    Result<void> open() {
        if (options.output == Output::Device && open_playback()) return {};
        return open_loopback();
    }

    bool open_playback() {
        if (device.open_playback() && make_sources()) return true;
        close();
        return false;
    }

    Result<void> open_loopback() {
        mix.restart(hearing.now_s);
        auto opened = device.open_loopback();
        if (opened && !make_sources()) opened = fail(phrase("sound_output.no_48_khz"));
        if (!opened) close();
        return opened;
    }

    bool make_sources() {
        alGetError();
        dropouts.reset();
        alListenerf(AL_GAIN, static_cast<float>(kHeadroom));
        alDistanceModel(AL_NONE);  // off, because distance_gain() computes the effect of distance instead
        const bool filters = voices.load_filters(device.handle());
        if (filters) room.make();
        voices.make_sources(filters);
        speech.make();
        return alGetError() == AL_NO_ERROR;
    }

    void close() {
        if (device.has_context()) {
            speech.stop();
            voices.drop_sources();
            speech.drop();
            room.drop();
            voices.drop_buffers();
        }
        device.close();
    }

    // Changes the device. Loops continue afterwards; one-shots and the current utterance are lost with the old device.
    void change_device() {
        const auto before = voices.loops();
        const VoiceChannel::Ticket spoken = speech.ticket();
        close();
        if (!open()) return;  // if it fails, tick() tries again
        voices.go_on(before);
        speech.give_up(spoken);
    }

    void watch_dropouts() {
        if (device.is_loopback()) return;
        if (const auto clock_s = device.clock_s()) drops_out = dropouts.tick(hearing.now_s, *clock_s);
    }

    bool connected() const { return options.still_connected ? options.still_connected() : device.connected(); }

    void watch_device() {
        const double now_s = hearing.now_s;
        if (options.output == Output::OnDemand || now_s < next_poll_s) return;
        next_poll_s = now_s + kConnectionPoll_s;
        if (device.is_open() && !device.is_loopback() && !connected()) {
            change_device();
            lost = !device.is_open() || device.is_loopback();
            next_reopen_s = now_s + kReopen_s;
            news = lost ? phrase("sound_output.lost") : phrase("sound_output.lost_other", {{"device", device.name()}});
        } else if (lost && now_s >= next_reopen_s) {
            next_reopen_s = now_s + kReopen_s;
            if (!device.playback_is_there()) return;
            change_device();
            lost = !device.is_open() || device.is_loopback();
            if (!lost) unreported.reset();
            if (!lost)
                news = never_had ? phrase("sound_output.here_now", {{"device", device.name()}})
                                 : phrase("sound_output.back", {{"device", device.name()}});
        }
    }
};

OpenALSink::OpenALSink(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
OpenALSink::~OpenALSink() = default;

Result<std::unique_ptr<OpenALSink>> OpenALSink::open(std::shared_ptr<VoiceChannel> voice, const Options& options) {
    const OpenALEnvironment environment(options.periods);
    auto impl = std::make_unique<Impl>(options, std::move(voice));
    if (auto opened = impl->open(); !opened) return tl::unexpected(opened.error());
    if (options.output == Output::Device && impl->device.is_loopback()) {
        impl->unreported = phrase("sound_output.none_found");
        impl->lost = true;  // lets tick() search for a sound card, which may be plugged in later
        impl->never_had = true;
    }
    if (!impl->device.has_wanted_hrtf())
        impl->news = phrase("sound_output.no_such_hrtf", {{"wanted", options.hrtf_set}});
    if (const std::vector<Error>& faults = impl->pack.faults; !faults.empty())
        impl->news = phrase("sound_pack.faults", {{"fault", faults.front().sentence()}, {"more", faults.size() - 1}});
    return std::unique_ptr<OpenALSink>(new OpenALSink(std::move(impl)));
}

void OpenALSink::play(const cues::SoundCue& cue) {
    // The person needs sound only to follow a sound, so the sink announces missing sound only when such a sound is due.
    if (leads_by_sound(cue.kind) && impl_->unreported) impl_->news = std::exchange(impl_->unreported, std::nullopt);
    if (impl_->device.is_open()) impl_->voices.play(cue);
}

void OpenALSink::set_loop(const cues::SoundCue& cue) {
    if (impl_->device.is_open() && is_loop(cue.kind)) impl_->voices.set_loop(cue);
}

void OpenALSink::set_sound(const settings::Settings::Sound& settings) { impl_->hearing.sound = settings; }

void OpenALSink::set_speaking(bool speaking) { impl_->others_speak = speaking; }

void OpenALSink::set_listener(const cues::Listener& listener) { impl_->hearing.listener = listener; }

void OpenALSink::stop_all() { impl_->voices.stop_all(); }

void OpenALSink::tick(double now_s) {
    Impl& s = *impl_;
    if (!s.has_time) s.mix.begin_at(now_s);
    const double dt_s = s.has_time ? std::max(0.0, now_s - s.hearing.now_s) : 0.0;
    s.has_time = true;
    s.hearing.now_s = now_s;
    s.watch_device();
    if (!s.device.is_open()) return;
    s.watch_dropouts();
    s.speech.update(now_s, s.hearing.sound);
    s.voices.update(dt_s, s.speech.playing() || s.others_speak, kDuckingDb);
    if (s.device.is_loopback() && s.options.output == Output::Device) s.mix.discard_elapsed(now_s);
}

bool OpenALSink::drops_out() const { return impl_->drops_out; }

std::optional<std::string> OpenALSink::news() { return std::exchange(impl_->news, std::nullopt); }

std::string OpenALSink::description() const {
    if (!has_device())
        return impl_->options.output == Output::OnDemand ? phrase("sound_output.on_demand")
                                                         : phrase("sound_output.none");
    const OpenALDevice& device = impl_->device;
    return device.hrtf_active() ? phrase("sound_output.headphones", {{"device", device.name()}})
                                : phrase("sound_output.stereo", {{"device", device.name()}});
}

bool OpenALSink::has_device() const { return impl_->device.is_open() && !impl_->device.is_loopback(); }

int OpenALSink::sounds_playing() const { return impl_->voices.playing(); }

std::span<const float> OpenALSink::render(int frames) { return impl_->mix.render(frames); }

}  // namespace handrail::sinks
