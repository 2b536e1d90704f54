// Chooses the voice: the first available one of several, never two at once. Text sinks always get everything; the
// braille display does unless a screen reader speaks. The audio thread owns and calls it; calls return at once.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "audio-cues/sinks/voice.h"

namespace handrail::sinks {

// A braille display, or another sink that must be silent while a screen reader speaks.
class BrailleSink : public cues::SpeechSink {
public:
    virtual void want(bool wanted) = 0;
};

// Passes each text to the best available voice.
// - While a better voice is still connecting, the first text waits for it, but no longer than that voice's
//   patience_s().
// - If a voice is lost in the middle of an utterance, the next voice announces the change and repeats the utterance. If
//   no voice is left, there is only text.
// - The setting speech.through = X passes over the voices before X. If X is missing, the next one speaks.
// For the screen reader see ReaderVoice.
class VoiceRouter final : public cues::SpeechSink {
public:
    // `voices` are in order of preference, the best first. `text` always gets everything; `braille` does too, unless a
    // screen reader speaks. `text` and `braille` may be null.
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

    // Returns the voice that speaks now, or Text if there is none.
    settings::SpeechThrough speaks() const { return active_ ? active_->through() : settings::SpeechThrough::Text; }

private:
    bool allowed(settings::SpeechThrough voice) const;
    bool waits_for_better(const Voice* best) const;
    void want_what_is_allowed();
    void hand_over_to(Voice* next);
    void report_change(const Voice* before, const Voice* after);

    std::vector<std::unique_ptr<Voice>> voices_;
    std::unique_ptr<cues::SpeechSink> text_;
    std::unique_ptr<BrailleSink> braille_;
    settings::SpeechThrough through_;
    Voice* active_ = nullptr;               // the voice that speaks now, one of voices_; null: none
    bool chosen_ = false;                   // true once a voice has been chosen for the first time
    bool choosing_again_ = false;           // the settings have changed, so a change of voice is no loss
    std::optional<double> requested_at_s_;  // time when each voice was last told whether it is requested
    double now_s_ = 0.0;
    std::optional<cues::Utterance> current_;  // utterance that the active voice received and may not have finished
    std::optional<cues::Utterance> owed_;     // utterance to be repeated as soon as a voice is available
    std::optional<std::string> news_;
};

}  // namespace handrail::sinks
