// Plays sounds at their places and a voice in the middle, through OpenAL Soft at 48 kHz, with head-related filtering
// for headphones if the device allows it. One owner: the thread that ticks it (the audio thread); only VoiceChannel is
// shared. Without a sound card it plays into OpenAL's loopback device and discards the samples at the pace of time, so
// that nothing else changes; description() and news() report this. A device that is lost while playing is replaced by
// the default one, or by loopback until one is back. Cost: about 1 % of a core; each sound of the bank (synth.h) is
// synthesised when it is first heard.
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
        Device,    // the sound card, otherwise loopback paced by tick()
        OnDemand,  // loopback; samples are made by render() only, for tests
    };
    struct Options {
        Output output = Output::Device;
        std::string device = {};        // OpenAL's name of a playback device; empty: the default one
        int periods = 2;                // of 256 samples; the first sink of a process decides for all
        bool hrtf = true;               // false: plain stereo, for loudspeakers
        std::string hrtf_set = "auto";  // part of the name of a set of filters that OpenAL Soft finds
        std::function<bool()> still_connected =
            {};  // stands in for the device's own report, so that a test can pull the plug
        std::function<void(int)> on_render =
            {};  // told of each count of frames that the loopback device is asked for, so that a test can see them
    };
    // Most sounds at once, not counting the voice. If there are more, the least important gives way; among equals the
    // oldest, and among the world's own sounds the quietest.
    static constexpr int kMostSounds = 3;
    // Of everything, so that three sounds and the voice together stay below full scale.
    static constexpr double kHeadroom = 0.5;
    static constexpr double kDuckingDb = -9.0;  // sounds but danger, while the voice speaks

    // Sets ALSOFT_CONF while opening (256 samples x 2 periods) unless the person has set it, so call it before other
    // threads read the environment. Fails only if OpenAL has no loopback device.
    static Result<std::unique_ptr<OpenALSink>> open(std::shared_ptr<VoiceChannel> voice, const Options& options);
    ~OpenALSink() override;

    void play(const cues::SoundCue& cue) override;
    void set_loop(const cues::SoundCue& cue) override;
    void set_listener(const cues::Listener& listener) override;
    void set_sound(const settings::Settings::Sound& settings) override;
    void set_speaking(bool speaking) override;
    void stop_all() override;  // fades within one mixing period of 5.3 ms
    void tick(double now_s) override;
    bool drops_out() const override;
    std::optional<std::string> news() override;

    // Such as "Sound goes to Built-in Audio, for headphones."
    std::string description() const;
    bool has_device() const;     // false: plays into loopback
    int sounds_playing() const;  // as of the last tick, without the voice
    // OnDemand only: the next `frames` of the mix, left and right alternating. Valid until the next call.
    std::span<const float> render(int frames);

private:
    struct Impl;
    explicit OpenALSink(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace handrail::sinks
