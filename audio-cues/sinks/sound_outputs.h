// Opens what sounds and speaks on this machine, with every fallback: called by the composition root before other
// threads start.
#pragma once

#include <memory>
#include <string>

#include "audio-cues/plan/sinks.h"
#include "audio-cues/sinks/braille_display.h"
#include "audio-cues/sinks/reader_voice.h"
#include "settings/settings.h"

namespace handrail {

struct SoundOutputs {
    std::unique_ptr<AudioSink> audio;
    std::unique_ptr<SpeechSink> speech;
    std::string description;  // "Sound goes to Built-in Audio, for headphones."; empty where the sinks' news() says
                              // what is missing
};

// Text on `text_fd` always. The voice is the first that is there of a screen reader (`reader` leads to it; null: there
// is no window to read; `braille` likewise), speech-dispatcher and, with a sound device, the embedded voice or its
// beeps (see VoiceRouter). Without any of them it is the text alone, so that no line waits for a voice that nobody
// hears. What is missing is said by the sinks' news(). The audio sink must outlive the speech sink.
SoundOutputs open_sound_outputs(const Settings& settings, int text_fd, std::shared_ptr<ReaderChannel> reader = nullptr,
                                std::shared_ptr<BrailleLink> braille = nullptr);

}  // namespace handrail
