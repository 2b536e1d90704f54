// Chooses the voice: the first available one of several, never two. Text always gets everything, and braille does
// unless a screen reader speaks. Owned and called by the audio thread; calls return at once.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "audio-cues/sinks/voice.h"

namespace handrail::sinks {

// A braille display, or another sink that must be silent while a screen reader has the words.
class BrailleSink : public cues::SpeechSink {
public:
    virtual void want(bool wanted) = 0;
};

// While a better voice is still opening, the first words wait for it, at most its patience_s(); then the best available
// voice says them. If a voice is lost in the middle of an utterance, the next voice announces the change and repeats
// the utterance. If no voice is left, there is only text. With speech.through = X the voices before X are passed over;
// if X is missing, the next one speaks. For the screen reader see ReaderVoice.
class VoiceRouter final : public cues::SpeechSink {
public:
    // `voices`: the best first. `text` always gets everything; `braille` does too, unless a screen reader speaks.
    // Either may be null.
    VoiceRouter(std::vector<std::unique_ptr<Voice>> voices, std::unique_ptr<cues::SpeechSink> text,
                std::unique_ptr<BrailleSink> braille, const settings::Settings::Speech& settings);

    void say(const cues::Utterance& utterance) override;
    void write(const cues::Utterance& utterance) override;
    void stop() override;
    bool speaking() const override;
    void tick(double now_s) override;
    void set_speech(const settings::Settings::Speech& settings) override;
    std::optional<std::string> news() override;

    std::string who() const override;

    // The voice that speaks now; Text: none.
    settings::SpeechThrough speaks() const { return active_ ? active_->through() : settings::SpeechThrough::Text; }

private:
    bool allowed(settings::SpeechThrough voice) const;
    bool waits_for_better(const Voice* best) const;
    void want_what_is_allowed();
    void hand_over_to(Voice* next);
    void tell_change(const Voice* before, const Voice* after);

    std::vector<std::unique_ptr<Voice>> voices_;
    std::unique_ptr<cues::SpeechSink> text_;
    std::unique_ptr<BrailleSink> braille_;
    settings::SpeechThrough through_;
    Voice* active_ = nullptr;           // points into voices_
    bool chosen_ = false;               // a first choice was made
    bool choosing_again_ = false;       // the settings changed, so a change of voice is not a loss
    std::optional<double> asked_at_s_;  // when the wishes were last passed to the voices
    double now_s_ = 0.0;
    std::optional<cues::Utterance> current_;  // given to the active voice and possibly not finished
    std::optional<cues::Utterance> owed_;     // to be said as soon as a voice is free for it
    std::optional<std::string> news_;
};

}  // namespace handrail::sinks
