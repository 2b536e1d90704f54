// Implements the embedded voice: espeak-ng in synchronous mode, on the only thread of the process that may use this
// library. That thread sends samples to a VoiceChannel in pieces, so a long text starts as soon as a short one. say(),
// stop() and speaking() return at once. When an utterance is cut off, the callback ends the synthesis within a
// millisecond. The library's asynchronous mode needs 200 ms for that.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "audio-cues/plan/sinks.h"
#include "audio-cues/sinks/synth.h"
#include "audio-cues/sinks/voice_channel.h"
#include "worlds/base/result.h"

namespace handrail::sinks {

// The audio thread owns and calls it.
class EspeakSpeech final : public cues::SpeechSink {
public:
    // Starts the thread and waits until the voice is ready (about 3 ms). Fails with a sentence if the library's data is
    // missing, or if another EspeakSpeech exists, because the library keeps its state in globals. For the same reason
    // the library stays loaded until the process ends. An unknown voice name gives English and a message in news().
    static Result<std::unique_ptr<EspeakSpeech>> open(std::shared_ptr<VoiceChannel> channel,
                                                      const settings::Settings::Speech& settings);
    ~EspeakSpeech() override;

    void say(const cues::Utterance& utterance) override;
    void stop() override;
    bool speaking() const override;
    std::optional<std::string> news() override;
    void set_speech(const settings::Settings::Speech& settings) override;

private:
    struct Impl;
    explicit EspeakSpeech(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

// Signals by beeps that there is text to read. Used if there is sound but no voice. Each class has its own pattern of
// tones: alarm four, answer two, name one, hint one low tone. The audio thread owns it.
class BeepSpeech final : public cues::SpeechSink {
public:
    // `news` is the reason why there is no voice. news() returns it once.
    BeepSpeech(std::shared_ptr<VoiceChannel> channel, std::string news)
        : channel_(std::move(channel)), news_(std::move(news)) {}

    void say(const cues::Utterance& utterance) override;
    void stop() override { channel_->stop(); }
    bool speaking() const override { return channel_->playing(); }
    std::optional<std::string> news() override { return std::exchange(news_, std::nullopt); }

    static std::span<const Note> pattern(cues::SpeechClass speech_class);

private:
    std::shared_ptr<VoiceChannel> channel_;
    std::optional<std::string> news_;
};

// Opens the embedded voice. If that fails, opens a BeepSpeech, whose news() says why there is no voice.
std::unique_ptr<cues::SpeechSink> open_voice(const std::shared_ptr<VoiceChannel>& channel,
                                             const settings::Settings::Speech& settings);

}  // namespace handrail::sinks
