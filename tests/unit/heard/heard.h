// Which lines a person has heard of a voice that takes its time: judged by what a recording sink kept, never by what
// was printed.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"

namespace handrail::test {

inline constexpr double kAfterLastKey_s = 15.0;  // then what was heard is judged

// It was spoken and nothing cut it.
inline bool in_full(const HeardSpeech& line, double now_s) { return line.voiced && !line.cut && line.end_s <= now_s; }

// The last lines about these topics, if they were cut or only written; one that is still being said is heard. The line
// that tells the topic anew counts, so an empty result means that all that still holds was heard.
inline std::vector<std::string> unheard(const RecordingSpeech& voice, const std::vector<SpeechTopic>& topics) {
    std::vector<std::string> missing;
    for (const SpeechTopic topic : topics) {
        const HeardSpeech* last = nullptr;
        for (const HeardSpeech& line : voice.lines())
            if (line.utterance.topic == topic) last = &line;
        if (last && (!last->voiced || last->cut)) missing.push_back(last->utterance.text);
    }
    return missing;
}

// Every line with its times, for whoever reads of a failure.
inline std::string told(const RecordingSpeech& voice) {
    std::string text;
    for (const HeardSpeech& said : voice.lines())
        text += fmt::format("{:7.2f} {:7.2f} {}{}\n", said.time_s, said.end_s,
                            !said.voiced ? "written: "
                            : said.cut   ? "cut: "
                                         : "",
                            said.utterance.text);
    return text;
}

// Warnings that something cut.
inline std::vector<std::string> cut_warnings(const RecordingSpeech& voice) {
    std::vector<std::string> cut;
    for (const HeardSpeech& line : voice.lines())
        if (line.voiced && line.cut && line.utterance.speech_class == SpeechClass::Warning)
            cut.push_back(line.utterance.text);
    return cut;
}

}  // namespace handrail::test
