// A voice that may not be there yet, or not any more: what VoiceRouter chooses from. Owned and called by the audio
// thread.
#pragma once

#include <string_view>

#include "audio-cues/plan/sinks.h"
#include "settings/settings.h"

namespace handrail {

enum class VoiceState {
    Opening,  // being looked for; what is said meanwhile is lost, so nobody asks it to
    Ready,
    Gone,  // not there; it goes on looking by itself while it is wanted
};

class Voice : public SpeechSink {
public:
    virtual SpeechThrough through() const = 0;         // its name in the settings
    virtual VoiceState state() const = 0;              // as of the last tick()
    virtual void want(bool wanted) = 0;                // false: it lets go of what it holds and looks no further
    virtual double patience_s() const { return 1.0; }  // how long the first words wait for it while it is opening
};

// "the speech server", as it stands inside a sentence.
std::string voice_name(SpeechThrough through);

}  // namespace handrail
