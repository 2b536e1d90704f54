#include "audio-cues/sinks/reader_voice.h"

#include <utility>

namespace handrail::sinks {

void ReaderChannel::changed() {
    const std::lock_guard lock(call_mutex_);
    if (call_) call_();
}

void ReaderChannel::want(bool wanted) {
    {
        const std::lock_guard lock(mutex_);
        if (std::exchange(wanted_, wanted) == wanted) return;
        if (!wanted) waiting_.reset();
    }
    changed();
}

VoiceState ReaderChannel::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

void ReaderChannel::say(const cues::Utterance& utterance) {
    {
        const std::lock_guard lock(mutex_);
        if (state_ != VoiceState::Ready) return;
        if (waiting_ && waiting_->speech_class == cues::SpeechClass::Alarm &&
            utterance.speech_class != cues::SpeechClass::Alarm)
            return;
        waiting_ = utterance;
    }
    changed();
}

void ReaderChannel::stop() {
    const std::lock_guard lock(mutex_);
    waiting_.reset();
}

bool ReaderChannel::wanted() const {
    const std::lock_guard lock(mutex_);
    return wanted_;
}

void ReaderChannel::set_state(VoiceState state) {
    const std::lock_guard lock(mutex_);
    state_ = state;
    if (state != VoiceState::Ready) waiting_.reset();
}

std::optional<std::string> ReaderChannel::take() {
    const std::lock_guard lock(mutex_);
    if (!waiting_) return std::nullopt;
    std::string text = std::move(waiting_->text);
    waiting_.reset();
    return text;
}

void ReaderChannel::on_change(std::function<void()> call) {
    const std::lock_guard lock(call_mutex_);
    call_ = std::move(call);
}

void ReaderVoice::say(const cues::Utterance& utterance) {
    channel_->say(utterance);
    speaks_until_s_ = now_s_ + kStart_s + kLetter_s * static_cast<double>(utterance.text.size());
}

void ReaderVoice::stop() {
    channel_->stop();
    speaks_until_s_ = now_s_;
}

}  // namespace handrail::sinks
