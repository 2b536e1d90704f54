// Plays sounds at their places and a voice in the middle, through OpenAL Soft at 48 kHz. Sounds have head-related
// filtering for headphones if the device permits it. One owner: the thread that ticks it (the audio thread); only
// VoiceChannel is shared with other threads. Without a sound card, the sink plays into OpenAL's loopback device and
// discards the samples as fast as a sound card would play them. All other functions stay the same; description() and
// news() report the missing card. If a device is lost while playing, the default device replaces it, or loopback until
// there is a device again. Cost: about 1 % of a core. Each sound of the bank (synth.h) is synthesised when it is first
// heard.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "audio-cues/plan/sinks.h"
#include "audio-cues/sinks/voice_channel.h"
#include "worlds/base/result.h"

namespace handrail::sinks {

class OpenALSink final : public cues::AudioSink {
public:
    enum class Output {
        Device,    // the sound card, or without one the loopback device, paced by tick()
        OnDemand,  // the loopback device, from which only render() takes samples; for tests
    };
    struct Options {
        Output output = Output::Device;
        std::string device = {};  // OpenAL's name of a playback device; empty: the default device
        int periods = 2;          // number of periods of 256 samples; the first sink of a process determines it for all
        bool hrtf = true;         // use head-related filters; false: plain stereo, for loudspeakers
        // Part of the name of a set of head-related filters that OpenAL Soft finds, or "auto".
        std::string hrtf_set = "auto";
        std::string pack = "none";  // folder of a sound pack (sound_pack.h), or "none"
        std::function<bool()> still_connected =
            {};  // Replaces the device's own report of whether it is connected, so that a test can simulate unplugging.
        std::function<void(int)> on_render =
            {};  // Receives the number of frames of each request to the loopback device, for tests.
    };
    // Greatest number of sounds at once, without the voice. If there are more, the least important one ends. Among
    // equally important sounds the oldest ends, and among the world's own sounds the quietest.
    static constexpr int kMostSounds = 3;
    // Factor on all sounds, so that three sounds and the voice together stay below full scale.
    static constexpr double kHeadroom = 0.5;
    static constexpr double kDuckingDb = -9.0;  // level of all sounds except danger while the voice speaks

    // Opens the sink. During the call, the environment variable ALSOFT_CONF is set (256 samples x 2 periods) unless the
    // person has set it. Call open() before other threads read the environment. Fails only if OpenAL has no loopback
    // device.
    static Result<std::unique_ptr<OpenALSink>> open(std::shared_ptr<VoiceChannel> voice, const Options& options);
    ~OpenALSink() override;

    void play(const cues::SoundCue& cue) override;
    void set_loop(const cues::SoundCue& cue) override;
    void set_listener(const cues::Listener& listener) override;
    void set_sound(const settings::Settings::Sound& settings) override;
    void set_speaking(bool speaking) override;
    void stop_all() override;  // fades all sounds out within one mixing period of 5.3 ms
    void tick(double now_s) override;
    bool drops_out() const override;
    std::optional<std::string> news() override;

    // Returns for example "Sound goes to Built-in Audio, for headphones."
    std::string description() const;
    bool has_device() const;     // false: the sink plays into the loopback device
    int sounds_playing() const;  // number of sounds as of the last tick, without the voice
    // OnDemand only. Renders the next `frames` frames of the mix, with left and right alternating. Valid until the next
    // call.
    std::span<const float> render(int frames);

private:
    struct Impl;
    explicit OpenALSink(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail::sinks
