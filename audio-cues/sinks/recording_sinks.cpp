#include "audio-cues/sinks/recording_sinks.h"

#include <algorithm>
#include <cmath>

namespace handrail {

HeardSound RecordingAudio::heard(const SoundCue& cue) const {
    // The small allowance keeps a time that is a period's start, but for rounding, in that period.
    const double start_s = std::ceil(now_s_ / kPeriod_s - 1e-6) * kPeriod_s;
    return {cue, start_s, start_s - cue.event_time_s};
}

void RecordingAudio::play(const SoundCue& cue) { sounds_.push_back(heard(cue)); }

void RecordingAudio::set_loop(const SoundCue& cue) {
    std::optional<SoundCue>& loop = loops_[static_cast<std::size_t>(cue.kind)];
    const bool was_on = loop.has_value(), is_on = cue.loudness > 0.0;
    const bool same =
        was_on == is_on &&
        (!is_on || (loop->loudness == cue.loudness && loop->pitch == cue.pitch && loop->position_m == cue.position_m && loop->material == cue.material));
    if (!same) changes_.push_back(heard(cue));
    if (is_on) loop = cue;
    else loop.reset();
}

void RecordingAudio::stop_all() {
    silences_s_.push_back(now_s_);
    for (auto& loop : loops_) loop.reset();
}

std::optional<SoundCue> RecordingAudio::loop(SoundKind kind) const { return loops_[static_cast<std::size_t>(kind)]; }

void RecordingSpeech::cut() {
    if (!speaking()) return;
    lines_[*voiced_].end_s = now_s_;
    lines_[*voiced_].cut = true;
}

void RecordingSpeech::say(const Utterance& utterance) {
    cut();
    double length_s = 0.0;
    if (words_per_minute_ > 0.0) {
        const auto words = 1 + std::count(utterance.text.begin(), utterance.text.end(), ' ');
        length_s = 0.1 + static_cast<double>(words) * 60.0 / words_per_minute_;
    }
    voiced_ = lines_.size();
    lines_.push_back({.utterance = utterance, .time_s = now_s_, .end_s = now_s_ + length_s});
}

void RecordingSpeech::write(const Utterance& utterance) { lines_.push_back({.utterance = utterance, .time_s = now_s_, .end_s = now_s_, .voiced = false}); }

void RecordingSpeech::stop() {
    cut();
    stops_s_.push_back(now_s_);
}

bool RecordingSpeech::speaking() const { return voiced_ && now_s_ < lines_[*voiced_].end_s; }

}  // namespace handrail
