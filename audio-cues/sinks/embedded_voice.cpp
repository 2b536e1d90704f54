#include "audio-cues/sinks/embedded_voice.h"

#include "audio-cues/sinks/espeak_speech.h"

namespace handrail::sinks {

void EmbeddedVoice::want(bool wanted) {
    if (wanted && !voice_) voice_ = open_voice(channel_, settings_);
    else if (!wanted) voice_.reset();
}

void EmbeddedVoice::say(const cues::Utterance& utterance) {
    if (voice_) voice_->say(utterance);
}

void EmbeddedVoice::stop() {
    if (voice_) voice_->stop();
}

void EmbeddedVoice::set_speech(const settings::Settings::Speech& settings) {
    settings_ = settings;
    if (voice_) voice_->set_speech(settings);
}

}  // namespace handrail::sinks
