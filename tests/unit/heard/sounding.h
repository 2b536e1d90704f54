// Mixes a session's sounds and the built-in voice as for headphones, in virtual time. Before a line is played, the
// class waits until espeak-ng has rendered the whole line, so two runs give the same samples. The class uses one
// thread, and espeak-ng uses another.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "audio-cues/sinks/espeak_speech.h"
#include "audio-cues/sinks/openal_sink.h"
#include "tests/support/names.h"

namespace handrail::test {

// A line that the session printed, and how the voice rendered it.
struct PrintedLine {
    Utterance utterance;
    bool voiced = true;    // false: the session wrote the line but did not speak it
    bool stopped = false;  // a key cut the line
    std::size_t begin_frame = 0;
    std::vector<std::int16_t> samples = {};  // the line as the voice rendered it, at the voice's sample rate
};

// A single sound that the session played.
struct PlayedSound {
    SoundCue cue;
    Listener listener;
    std::size_t begin_frame = 0;
};

class Sounding : public SpeechSink {
public:
    explicit Sounding(const Settings& settings = {});

    AudioSink& audio() { return ears_; }
    // Adds the next millisecond to the mix.
    void mix_ms();
    const std::vector<float>& mix() const { return mix_; }  // left and right samples in turn, 48 kHz
    const std::vector<PrintedLine>& lines() const { return lines_; }
    const std::vector<PlayedSound>& sounds() const { return ears_.sounds; }
    // Returns true if the voice was silent in the mix between two frames.
    bool voice_silent(std::size_t from_frame, std::size_t until_frame) const;

    void say(const Utterance& utterance) override;
    void write(const Utterance& utterance) override;
    void stop() override;
    bool speaking() const override { return heard_->playing(); }

    // Returns `line` alone, for both ears, without any other sound.
    static std::vector<float> alone(const PrintedLine& line);

private:
    // Passes all sounds on to the mix, and stores the single sounds.
    class Ears : public AudioSink {
    public:
        explicit Ears(const Sounding& mix) : mix_(mix) {}
        void play(const SoundCue& cue) override;
        void set_loop(const SoundCue& cue) override { mix_.sink_->set_loop(cue); }
        void set_listener(const Listener& listener) override;
        void set_sound(const Settings::Sound& settings) override { mix_.sink_->set_sound(settings); }
        void set_speaking(bool speaking) override { mix_.sink_->set_speaking(speaking); }
        void stop_all() override { mix_.sink_->stop_all(); }
        void tick(double now_s) override { mix_.sink_->tick(now_s); }
        std::optional<std::string> news() override { return mix_.sink_->news(); }

        std::vector<PlayedSound> sounds;

    private:
        const Sounding& mix_;
        Listener listener_;
    };

    std::vector<std::int16_t> synthesised(const Utterance& utterance);

    // Carries samples from espeak-ng to this class.
    std::shared_ptr<VoiceChannel> made_ = std::make_shared<VoiceChannel>();
    // Carries samples from this class to the mix.
    std::shared_ptr<VoiceChannel> heard_ = std::make_shared<VoiceChannel>();
    std::unique_ptr<EspeakSpeech> voice_;
    std::unique_ptr<OpenALSink> sink_;
    std::vector<PrintedLine> lines_;
    Ears ears_{*this};
    std::vector<float> mix_;
    std::vector<bool> speaks_;  // for each millisecond of the mix: true if the voice was speaking
};

// Renders single sounds as a listener hears them without anything else.
class SoundAlone {
public:
    SoundAlone();
    // Returns the first 0.1 s of the sound, for both ears.
    std::vector<float> render(const PlayedSound& sound);

private:
    std::unique_ptr<OpenALSink> sink_;
    double now_s_ = 0.0;
};

}  // namespace handrail::test
