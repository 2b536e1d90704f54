// A session's sounds and the built-in voice, mixed as for headphones in virtual time. Speaking waits until espeak-ng
// has made the whole line, so two runs give the same samples. One thread, besides that of espeak-ng.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "audio-cues/sinks/espeak_speech.h"
#include "audio-cues/sinks/openal_sink.h"
#include "tests/support/names.h"

namespace handrail::test {

// A line that the session printed.
struct PrintedLine {
    Utterance utterance;
    bool voiced = true;    // false: only written
    bool stopped = false;  // a key cut it
    std::size_t begin_frame = 0;
    std::vector<std::int16_t> samples;  // as the voice made them, at voice_hz()
};

class Sounding : public SpeechSink {
public:
    Sounding();

    AudioSink& audio() { return *sink_; }
    // The next millisecond of the mix.
    void mix_ms();
    const std::vector<float>& mix() const { return mix_; }  // left and right in turn, 48 kHz
    const std::vector<PrintedLine>& lines() const { return lines_; }

    void say(const Utterance& utterance) override;
    void write(const Utterance& utterance) override;
    void stop() override;
    bool speaking() const override { return heard_->playing(); }

    // This line alone, as both ears hear it where nothing else sounds.
    static std::vector<float> alone(const PrintedLine& line);

private:
    std::vector<std::int16_t> synthesised(const Utterance& utterance);

    std::shared_ptr<VoiceChannel> made_ = std::make_shared<VoiceChannel>();   // from espeak-ng to here
    std::shared_ptr<VoiceChannel> heard_ = std::make_shared<VoiceChannel>();  // from here to the mix
    std::unique_ptr<EspeakSpeech> voice_;
    std::unique_ptr<OpenALSink> sink_;
    std::vector<PrintedLine> lines_;
    std::vector<float> mix_;
};

}  // namespace handrail::test
