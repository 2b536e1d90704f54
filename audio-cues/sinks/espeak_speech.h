// The embedded voice: espeak-ng, synchronous, on the one thread in the process that may touch that library. Samples go to a
// VoiceChannel in pieces, so that a long text starts as soon as a short one. say(), stop() and speaking() return at once; the
// callback ends a cut synthesis within a millisecond (its asynchronous mode needs 200 ms).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "audio-cues/plan/sinks.h"
#include "audio-cues/sinks/synth.h"
#include "audio-cues/sinks/voice_channel.h"
#include "worlds/base/result.h"

namespace handrail {

struct VoiceSettings {
    int rate_wpm = 175;        // 80 to 450
    std::string voice = "en";  // espeak-ng voice name or language
};

// Owned and called by the audio thread; set_voice by any.
class EspeakSpeech final : public SpeechSink {
public:
    // Starts the thread and waits until the voice is ready (about 3 ms). Fails with a sentence when its data is missing, or when there
    // is another EspeakSpeech: the library keeps its state in globals, and for the same reason stays loaded until the process ends. An unknown voice gives
    // English and news().
    static Result<std::unique_ptr<EspeakSpeech>> open(std::shared_ptr<VoiceChannel> channel, const VoiceSettings& settings);
    ~EspeakSpeech() override;

    void say(const Utterance& utterance) override;
    void stop() override;
    bool speaking() const override;
    std::optional<std::string> news() override;
    void set_voice(const VoiceSettings& settings);  // from the next utterance on

private:
    struct Impl;
    explicit EspeakSpeech(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

// Where there is sound but no voice: a pattern of tones per class (alarm four, answer two, name one, hint one low) tells that there is
// something to read. Owned by the audio thread.
class BeepSpeech final : public SpeechSink {
public:
    explicit BeepSpeech(std::shared_ptr<VoiceChannel> channel) : channel_(std::move(channel)) {}

    void say(const Utterance& utterance) override;
    void stop() override { channel_->stop(); }
    bool speaking() const override { return channel_->playing(); }

    static std::span<const Note> pattern(SpeechClass speech_class);

private:
    std::shared_ptr<VoiceChannel> channel_;
};

}  // namespace handrail
