// Opens what sounds and speaks on this machine, with every fallback: called by the composition root before other threads start.
#pragma once

#include <memory>
#include <string>

#include "audio-cues/plan/sinks.h"
#include "settings/settings.h"

namespace handrail {

struct SoundOutputs {
    std::unique_ptr<AudioSink> audio;
    std::unique_ptr<SpeechSink> speech;
    bool audible = false;     // there is a sound device
    std::string description;  // "Sound goes to Built-in Audio, for headphones."; empty where the sinks' news() says what is missing
};

// Text on `text_fd` always. With a sound device: OpenAL, and the embedded voice, or its beeps where there is none. Without a device the
// text alone, so that no line waits for a voice that nobody hears. What is missing is said by the sinks' news().
SoundOutputs open_sound_outputs(const Settings& settings, int text_fd);

}  // namespace handrail
