// Makes the built-in voice a choice for VoiceRouter. The voice is espeak-ng, or beeps if the data of espeak-ng is
// missing. The audio thread owns it.
#pragma once

#include <functional>
#include <memory>

#include "audio-cues/sinks/voice.h"
#include "audio-cues/sinks/voice_channel.h"

namespace handrail::sinks {

class EmbeddedVoice final : public Voice {
public:
    // `audible` returns whether the channel's sound can be heard. If it returns false, the state of the voice is Gone.
    // It is called on the audio thread.
    EmbeddedVoice(std::shared_ptr<VoiceChannel> channel, std::function<bool()> audible,
                  const settings::Settings::Speech& settings)
        : channel_(std::move(channel)), audible_(std::move(audible)), settings_(settings) {}

    settings::SpeechThrough through() const override { return settings::SpeechThrough::Embedded; }
    VoiceState state() const override { return voice_ && audible_() ? VoiceState::Ready : VoiceState::Unavailable; }
    void want(bool wanted) override;  // opens the voice when it is first requested, which takes about 3 ms

    void say(const cues::Utterance& utterance) override;
    void stop() override;
    bool speaking() const override { return voice_ && voice_->speaking(); }
    void set_speech(const settings::Settings::Speech& settings) override;
    std::optional<std::string> news() override { return voice_ ? voice_->news() : std::nullopt; }

private:
    std::shared_ptr<VoiceChannel> channel_;
    std::function<bool()> audible_;
    settings::Settings::Speech settings_;
    std::unique_ptr<cues::SpeechSink> voice_;
};

}  // namespace handrail::sinks
