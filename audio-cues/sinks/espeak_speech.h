// The embedded voice: espeak-ng in synchronous mode, on the only thread of the process that may use that library.
// Samples go to a VoiceChannel in pieces, so a long text starts as soon as a short one. say(), stop() and speaking()
// return at once. The callback ends a cut synthesis within a millisecond; the library's asynchronous mode needs 200 ms.
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

// Owned and called by the audio thread.
class EspeakSpeech final : public cues::SpeechSink {
public:
    // Starts the thread and waits until the voice is ready (about 3 ms). Fails with a sentence if its data is missing,
    // or if another EspeakSpeech exists: the library keeps its state in globals. For the same reason it stays loaded
    // until the process ends. An unknown voice gives English and a message in news().
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

// Used if there is sound but no voice. A pattern of tones for each class (alarm four, answer two, name one, hint one
// low) signals that there is something to read. Owned by the audio thread.
class BeepSpeech final : public cues::SpeechSink {
public:
    // `news` is returned once: the reason why there is no voice.
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

// Opens the embedded voice, or beeps that report why there is none.
std::unique_ptr<cues::SpeechSink> open_voice(const std::shared_ptr<VoiceChannel>& channel,
                                             const settings::Settings::Speech& settings);

}  // namespace handrail::sinks
