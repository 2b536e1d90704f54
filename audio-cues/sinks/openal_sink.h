// Sounds at their places and a voice in the middle, through OpenAL Soft at 48 kHz, with head-related filtering for
// headphones where the device allows it. One owner: the thread that ticks it (the audio thread); only VoiceChannel is
// shared. With no sound card it plays into OpenAL's loopback device and throws the samples away at the pace of time, so
// that nothing else changes; description() and news() say so. A device that is lost while playing is replaced by the
// default one, or by loopback until one is back. Cost: about 1 % of a core; opening synthesises the sound bank
// (synth.h).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "audio-cues/plan/sinks.h"
#include "audio-cues/sinks/voice_channel.h"
#include "worlds/base/result.h"

namespace handrail {

class OpenALSink final : public AudioSink {
public:
    enum class Output {
        Device,    // the sound card, else loopback paced by tick()
        OnDemand,  // loopback; samples are made by render() only, for tests
    };
    struct Options {
        Output output = Output::Device;
        std::string device = {};  // OpenAL's name of a playback device; empty: the default one
        int periods = 2;          // of 256 samples; the first sink of a process decides for all
        bool hrtf = true;         // false: plain stereo, for loudspeakers
        // Stands in for the device's own report, so that a test can pull the plug.
        std::function<bool()> still_connected = {};
        // Told of each count of frames that the loopback device is asked for, so that a test can see them.
        std::function<void(int)> on_render = {};
    };
    // At most this many sounds besides the voice; the least important gives way, of equals the oldest, and of the
    // world's own the quietest.
    static constexpr int kMostSounds = 3;
    static constexpr double kDuckingDb = -9.0;  // sounds but alarms, while the voice speaks

    // Sets ALSOFT_CONF for the moment of opening (256 samples x 2 periods) unless the person has set it: call before
    // other threads read the environment. Fails only where OpenAL has no loopback device.
    static Result<std::unique_ptr<OpenALSink>> open(std::shared_ptr<VoiceChannel> voice, const Options& options);
    ~OpenALSink() override;

    void play(const SoundCue& cue) override;
    void set_loop(const SoundCue& cue) override;
    void set_listener(const Listener& listener) override;
    void set_sound(const Settings::Sound& settings) override;
    void set_speaking(bool speaking) override;
    void stop_all() override;  // fades within one mixing period of 5.3 ms
    void tick(double now_s) override;
    bool drops_out() const override;
    std::optional<std::string> news() override;

    // "Sound goes to Built-in Audio, for headphones."
    std::string description() const;
    bool has_device() const;     // false: on loopback
    int sounds_playing() const;  // as of the last tick, the voice not counted
    // OnDemand only: the next `frames` of the mix, left and right in turn. Valid until the next call.
    std::span<const float> render(int frames);

private:
    struct Impl;
    explicit OpenALSink(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail
