#include "audio-cues/sinks/voice_router.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "audio-cues/plan/speakable.h"
#include "worlds/base/language.h"

namespace handrail::sinks {

std::string voice_name(settings::SpeechThrough through) {
    switch (through) {
        case settings::SpeechThrough::ScreenReader:
            return phrase("voice.screen_reader");
        case settings::SpeechThrough::SpeechDispatcher:
            return phrase("voice.speech_server");
        case settings::SpeechThrough::Embedded:
            return phrase("voice.built_in");
        case settings::SpeechThrough::Auto:
        case settings::SpeechThrough::Text:
            break;
    }
    return phrase("voice.text");
}

VoiceRouter::VoiceRouter(std::vector<std::unique_ptr<Voice>> voices, std::unique_ptr<cues::SpeechSink> text,
                         std::unique_ptr<BrailleSink> braille, const settings::Settings::Speech& settings)
    : voices_(std::move(voices)), text_(std::move(text)), braille_(std::move(braille)), through_(settings.through) {
    want_what_is_allowed();
}

// Returns true if the settings allow `voice`. The enumerators are in the order of the voices, so one comparison is
// enough.
bool VoiceRouter::allowed(settings::SpeechThrough voice) const { return voice >= through_; }

void VoiceRouter::want_what_is_allowed() {
    for (const auto& voice : voices_) voice->want(allowed(voice->through()));
    requested_at_s_.reset();
}

bool VoiceRouter::waits_for_better(const Voice* best) const {
    const double waited_s = requested_at_s_ ? now_s_ - *requested_at_s_ : 0.0;
    for (const auto& voice : voices_) {
        if (voice.get() == best) return false;
        if (allowed(voice->through()) && voice->state() == VoiceState::Opening && waited_s < voice->patience_s())
            return true;
    }
    return false;
}

void VoiceRouter::say(const cues::Utterance& utterance) {
    if (text_) text_->say(utterance);
    if (braille_) braille_->say(utterance);
    owed_.reset();
    if (active_) {
        active_->say(utterance);
        current_ = utterance;
    } else if (!chosen_) {
        owed_ = utterance;
    }
}

void VoiceRouter::write(const cues::Utterance& utterance) {
    if (text_) text_->write(utterance);
    if (braille_) braille_->write(utterance);
}

void VoiceRouter::stop() {
    if (text_) text_->stop();
    if (braille_) braille_->stop();
    if (active_) active_->stop();
    current_.reset();
    owed_.reset();
}

bool VoiceRouter::speaking() const { return owed_ || (active_ && active_->speaking()); }

void VoiceRouter::tick(double now_s) {
    now_s_ = now_s;
    if (!requested_at_s_) requested_at_s_ = now_s;
    if (text_) text_->tick(now_s);
    if (braille_) braille_->tick(now_s);
    for (const auto& voice : voices_) voice->tick(now_s);

    if (current_ && active_ && active_->state() == VoiceState::Ready && !active_->speaking()) current_.reset();
    const auto first_ready = std::find_if(voices_.begin(), voices_.end(), [&](const auto& voice) {
        return allowed(voice->through()) && voice->state() == VoiceState::Ready;
    });
    Voice* best = first_ready == voices_.end() ? nullptr : first_ready->get();
    if (best != active_ && !waits_for_better(best)) hand_over_to(best);
    else if (!chosen_ && !best && !waits_for_better(nullptr)) hand_over_to(nullptr);

    // An utterance that a lost voice left unfinished is repeated after the announcement of the change, which the
    // planner sends as an alarm.
    if (owed_ && active_ && !news_ && !active_->speaking()) {
        current_ = std::exchange(owed_, std::nullopt);
        active_->say(*current_);
    }
}

void VoiceRouter::hand_over_to(Voice* next) {
    Voice* before = std::exchange(active_, next);
    if (before && before->state() == VoiceState::Ready) before->stop();
    if (current_) owed_ = std::exchange(current_, std::nullopt);
    if (!next) owed_.reset();
    if (braille_) braille_->want(!next || next->through() != settings::SpeechThrough::ScreenReader);
    report_change(before, next);
    chosen_ = true;
    choosing_again_ = false;
}

void VoiceRouter::report_change(const Voice* before, const Voice* after) {
    const std::string voice = after ? voice_name(after->through()) : std::string();
    const bool lost = before && before->state() != VoiceState::Ready && !choosing_again_;
    if (lost) {
        const std::string gone = voice_name(before->through());
        news_ = cues::sentence_case(after ? phrase("voice.gone", {{"gone", gone}, {"voice", voice}})
                                          : phrase("voice.gone_only_text", {{"gone", gone}}));
    } else if (chosen_) {
        news_ =
            after ? cues::sentence_case(phrase("voice.speaks_now", {{"voice", voice}})) : phrase("voice.only_text_now");
    } else if (through_ != settings::SpeechThrough::Auto && through_ != settings::SpeechThrough::Text &&
               (!after || after->through() != through_)) {
        // The person chose the voice `through_` by name. Without an announcement they would think that Handrail is
        // broken.
        const std::string wanted = voice_name(through_);
        news_ = cues::sentence_case(after ? phrase("voice.not_reached", {{"wanted", wanted}, {"voice", voice}})
                                          : phrase("voice.not_reached_only_text", {{"wanted", wanted}}));
    }
}

std::string VoiceRouter::who() const {
    if (!chosen_) return {};
    return active_ ? voice_name(active_->through()) : phrase("voice.text_alone");
}

void VoiceRouter::set_speech(const settings::Settings::Speech& settings) {
    for (const auto& voice : voices_) voice->set_speech(settings);
    if (braille_) braille_->set_speech(settings);
    if (std::exchange(through_, settings.through) == settings.through) return;
    choosing_again_ = true;
    want_what_is_allowed();
}

std::optional<std::string> VoiceRouter::news() {
    if (news_) return std::exchange(news_, std::nullopt);
    for (const auto& voice : voices_)
        if (voice.get() == active_)
            if (auto sentence = voice->news()) return sentence;
    return braille_ ? braille_->news() : std::nullopt;
}

}  // namespace handrail::sinks
