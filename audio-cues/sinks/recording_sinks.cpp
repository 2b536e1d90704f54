#include "audio-cues/sinks/recording_sinks.h"

#include <algorithm>
#include <cmath>

namespace handrail::sinks {

HeardSound RecordingAudio::heard(const cues::SoundCue& cue) const {
    // The small tolerance keeps a time at the start of a period in that period despite rounding errors.
    const double start_s = std::ceil(now_s_ / kPeriod_s - 1e-6) * kPeriod_s;
    return {cue, start_s, start_s - cue.event_time_s};
}

void RecordingAudio::play(const cues::SoundCue& cue) { sounds_.push_back(heard(cue)); }

void RecordingAudio::set_loop(const cues::SoundCue& cue) {
    const std::pair key{cue.kind, cue.source};
    const auto loop = loops_.find(key);
    const bool was_on = loop != loops_.end(), is_on = cue.loudness > 0.0;
    const auto alike = [](const cues::SoundCue& a, const cues::SoundCue& b) {
        return a.loudness == b.loudness && a.pitch == b.pitch && a.position_m == b.position_m &&
               a.material == b.material && a.muffled_db == b.muffled_db;
    };
    if (was_on != is_on || (is_on && !alike(loop->second, cue))) changes_.push_back(heard(cue));
    if (is_on) loops_.insert_or_assign(key, cue);
    else loops_.erase(key);
}

void RecordingAudio::stop_all() {
    silences_s_.push_back(now_s_);
    loops_.clear();
}

std::optional<cues::SoundCue> RecordingAudio::loop(cues::SoundKind kind, std::uint32_t source) const {
    const auto found = loops_.find({kind, source});
    return found == loops_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<cues::SoundCue> RecordingAudio::world_sounds() const {
    std::vector<cues::SoundCue> sounds;
    for (const auto& [key, cue] : loops_)
        if (cues::is_world_sound(key.first)) sounds.push_back(cue);
    return sounds;
}

void RecordingSpeech::cut() {
    if (!speaking()) return;
    lines_[*voiced_].end_s = now_s_;
    lines_[*voiced_].cut = true;
}

void RecordingSpeech::say(const cues::Utterance& utterance) {
    cut();
    double length_s = 0.0;
    if (words_per_minute_ > 0.0) {
        const auto words = 1 + std::count(utterance.text.begin(), utterance.text.end(), ' ');
        length_s = 0.1 + static_cast<double>(words) * 60.0 / words_per_minute_;
    }
    voiced_ = lines_.size();
    lines_.push_back({.utterance = utterance, .time_s = now_s_, .end_s = now_s_ + length_s});
}

void RecordingSpeech::write(const cues::Utterance& utterance) {
    lines_.push_back({.utterance = utterance, .time_s = now_s_, .end_s = now_s_, .voiced = false});
}

void RecordingSpeech::stop() {
    cut();
    stops_s_.push_back(now_s_);
}

bool RecordingSpeech::speaking() const { return voiced_ && now_s_ < lines_[*voiced_].end_s; }

}  // namespace handrail::sinks
