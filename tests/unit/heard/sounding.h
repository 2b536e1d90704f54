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
    std::vector<std::int16_t> samples;  // the line as the voice rendered it, at the voice's sample rate
};

class Sounding : public SpeechSink {
public:
    Sounding();

    AudioSink& audio() { return *sink_; }
    // Adds the next millisecond to the mix.
    void mix_ms();
    const std::vector<float>& mix() const { return mix_; }  // left and right samples in turn, 48 kHz
    const std::vector<PrintedLine>& lines() const { return lines_; }

    void say(const Utterance& utterance) override;
    void write(const Utterance& utterance) override;
    void stop() override;
    bool speaking() const override { return heard_->playing(); }

    // Returns `line` alone, for both ears, without any other sound.
    static std::vector<float> alone(const PrintedLine& line);

private:
    std::vector<std::int16_t> synthesised(const Utterance& utterance);

    // Carries samples from espeak-ng to this class.
    std::shared_ptr<VoiceChannel> made_ = std::make_shared<VoiceChannel>();
    // Carries samples from this class to the mix.
    std::shared_ptr<VoiceChannel> heard_ = std::make_shared<VoiceChannel>();
    std::unique_ptr<EspeakSpeech> voice_;
    std::unique_ptr<OpenALSink> sink_;
    std::vector<PrintedLine> lines_;
    std::vector<float> mix_;
};

}  // namespace handrail::test
