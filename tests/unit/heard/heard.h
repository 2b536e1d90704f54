// Finds out which lines a person has heard in full. The functions examine what a recording sink spoke in realistic
// time, not what the session printed.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "audio-cues/sinks/recording_sinks.h"
#include "tests/support/names.h"

namespace handrail::test {

inline constexpr double kAfterLastKey_s = 15.0;  // time after the last key, after which the tests judge what was heard

// Returns whether the voice spoke the line to its end without an interruption.
inline bool in_full(const HeardSpeech& line, double now_s) { return line.voiced && !line.cut && line.end_s <= now_s; }

// Returns the last line about each topic if that line was cut or only written. A line that is still being spoken counts
// as heard. Earlier lines about a topic do not matter, because the last line replaces them. So an empty result means
// that the person heard everything that is still valid.
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

// A line as a voice spoke it.
struct Spoken {
    double time_s = 0.0;
    std::string text;
    bool in_full = false;
    SpeechTopic topic = SpeechTopic::None;
};

// A text that the person must hear in full between two times. What must be heard follows from the session's events, not
// from its lines. So a line that the session never says is missing, too.
struct MustHear {
    double from_s = 0.0, until_s = 0.0;
    std::string text;
    // If it is not None, only a line about this topic counts: "Study door is shut" does not name the room.
    SpeechTopic topic = SpeechTopic::None;
};

// Returns the texts that no line contained, or only a line that was not heard in full.
inline std::vector<std::string> never_heard(const std::vector<MustHear>& all, const std::vector<Spoken>& lines) {
    std::vector<std::string> missing;
    for (const MustHear& must : all) {
        const bool heard = std::any_of(lines.begin(), lines.end(), [&](const Spoken& line) {
            return line.in_full && (must.topic == SpeechTopic::None || line.topic == must.topic) &&
                   line.time_s >= must.from_s && line.time_s < must.until_s &&
                   line.text.find(must.text) != std::string::npos;
        });
        if (!heard) missing.push_back(fmt::format("{} at {:.1f} s", must.text, must.from_s));
    }
    return missing;
}

// Returns every line with its times, for a person who analyses a failure.
inline std::string said_by(const RecordingSpeech& voice) {
    std::string text;
    for (const HeardSpeech& said : voice.lines())
        text += fmt::format("{:7.2f} {:7.2f} {}{}\n", said.time_s, said.end_s,
                            !said.voiced ? "written: "
                            : said.cut   ? "cut: "
                                         : "",
                            said.utterance.text);
    return text;
}

// Returns the warnings that something cut.
inline std::vector<std::string> cut_warnings(const RecordingSpeech& voice) {
    std::vector<std::string> cut;
    for (const HeardSpeech& line : voice.lines())
        if (line.voiced && line.cut && line.utterance.speech_class == SpeechClass::Warning)
            cut.push_back(line.utterance.text);
    return cut;
}

}  // namespace handrail::test
