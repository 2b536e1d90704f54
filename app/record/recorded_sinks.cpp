#include "app/record/recorded_sinks.h"

namespace handrail::record {

void StepNotes::begin(double at_s) {
    now_s = at_s;
    in_step = true;
    answers = 1;
    changed = false;
}

std::uint64_t StepNotes::end() {
    in_step = false;
    ++step;
    return changed ? answers : 0;
}

void RecordedVoice::say(const cues::Utterance& utterance) {
    recorder_.said(notes_->now_s, utterance, true);
    voice_->say(utterance);
}

void RecordedVoice::write(const cues::Utterance& utterance) {
    recorder_.said(notes_->now_s, utterance, false);
    voice_->write(utterance);
}

bool RecordedVoice::speaking() const {
    const bool speaks = voice_->speaking();
    if (!notes_->in_step) return speaks;
    notes_->changed = notes_->changed || speaks != notes_->last_answer;
    notes_->last_answer = speaks;
    if (notes_->answers >> 60 == 0) notes_->answers = notes_->answers << 1 | (speaks ? 1U : 0U);
    return speaks;
}

std::optional<std::string> RecordedVoice::news() {
    auto news = voice_->news();
    if (news) recorder_.sink_news(notes_->now_s, notes_->step, true, *news);
    return news;
}

std::optional<std::string> RecordedSound::news() {
    auto news = sound_->news();
    if (news) recorder_.sink_news(notes_->now_s, notes_->step, false, *news);
    return news;
}

}  // namespace handrail::record
