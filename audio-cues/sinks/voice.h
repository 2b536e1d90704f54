// A voice that may not be available yet, or no longer: the choices of VoiceRouter. Owned and called by the audio
// thread.
#pragma once

#include <string_view>

#include "audio-cues/plan/sinks.h"
#include "settings/settings.h"

namespace handrail::sinks {

enum class VoiceState {
    Opening,  // being looked for; do not say anything to it, because that would be lost
    Ready,
    Gone,  // unavailable; while it is wanted, it keeps looking automatically
};

class Voice : public cues::SpeechSink {
public:
    virtual settings::SpeechThrough through() const = 0;  // its name in the settings
    virtual VoiceState state() const = 0;                 // as of the last tick()
    virtual void want(bool wanted) = 0;                   // false: it releases what it holds and stops looking
    virtual double patience_s() const { return 1.0; }     // how long the first words wait while it is opening
};

// The voice's name inside a sentence: "the speech server".
std::string voice_name(settings::SpeechThrough through);

}  // namespace handrail::sinks
