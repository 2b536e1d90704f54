// Defines the interface of a voice that may not be available yet, or no longer. VoiceRouter chooses among several
// voices. The audio thread owns and calls it.
#pragma once

#include <string_view>

#include "audio-cues/plan/sinks.h"
#include "settings/settings.h"

namespace handrail::sinks {

enum class VoiceState {
    Opening,  // the voice is still connecting; a text given to it now would be lost
    Ready,
    Unavailable,  // the voice is unavailable; while it is requested, it tries again automatically
};

class Voice : public cues::SpeechSink {
public:
    virtual settings::SpeechThrough through() const = 0;  // returns the voice's name in the settings
    virtual VoiceState state() const = 0;                 // state as of the last tick()
    // Requests the voice; if false, the voice releases its resources and stops trying.
    virtual void want(bool wanted) = 0;
    virtual double patience_s() const { return 1.0; }  // how long the first text waits while the voice is connecting
};

// Returns the voice's name as part of a sentence: "the speech server".
std::string voice_name(settings::SpeechThrough through);

}  // namespace handrail::sinks
