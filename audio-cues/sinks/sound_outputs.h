// Opens the sound and speech outputs of this machine, with all fallbacks. The start-up code of the program calls it
// before other threads start.
#pragma once

#include <memory>
#include <string>

#include "audio-cues/plan/sinks.h"
#include "audio-cues/sinks/braille_display.h"
#include "audio-cues/sinks/reader_voice.h"
#include "settings/settings.h"

namespace handrail::sinks {

struct SoundOutputs {
    std::unique_ptr<cues::AudioSink> audio;
    std::unique_ptr<cues::SpeechSink> speech;
    // For example "Sound goes to Built-in Audio, for headphones."; empty if the sinks' news() reports what is missing.
    std::string description;
};

// Opens both sinks. The audio sink must outlive the speech sink.
// - Text always goes to `text_fd`.
// - The voice is the first available of a screen reader, speech-dispatcher and, with a sound device, the embedded voice
//   or its beeps (see VoiceRouter). If there is none, there is only text, so that no line waits for a voice that nobody
//   hears.
// - reader: channel to the screen reader; null: there is no window to read.
// - braille: link to the braille display; null: there is no window.
// The sinks' news() reports what is missing.
SoundOutputs open_sound_outputs(const settings::Settings& settings, int text_fd,
                                std::shared_ptr<ReaderChannel> reader = nullptr,
                                std::shared_ptr<BrailleLink> braille = nullptr);

}  // namespace handrail::sinks
