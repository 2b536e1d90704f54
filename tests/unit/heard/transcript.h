// What a person hears of a mix: each line is searched for in it by the voice's own rendering of that line.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/support/names.h"
#include "tests/unit/heard/sounding.h"

namespace handrail::test {

struct Transcribed {
    std::string text;
    SpeechClass speech_class = SpeechClass::Answer;
    SpeechTopic topic = SpeechTopic::None;
    bool voiced = true, stopped = false;
    double printed_s = 0.0;
    std::optional<double> heard_s;  // where it begins in the mix; none: it was not found
    double share = 0.0;             // of its pieces with voice in them that are in the mix
    bool in_full = false;           // 90 % of the pieces and the last one

    // Danger, places, routes and lessons, and answers that the person did not cut with the next key. What is only
    // written was said a moment before, or is out of date.
    bool matters() const {
        if (!voiced || speech_class > SpeechClass::Guidance || topic == SpeechTopic::Heading) return false;
        return topic != SpeechTopic::None || speech_class <= SpeechClass::Warning || !stopped;
    }
};

std::vector<Transcribed> transcribe(const Sounding& sounding);

// Of the lines that matter: how many there are, and those that were never heard in full. A line that is told again,
// because it was cut, counts once.
struct Judged {
    int matter = 0;
    std::vector<std::string> missing;
    double share() const { return 1.0 - static_cast<double>(missing.size()) / matter; }
};
Judged judge(const std::vector<Transcribed>& lines);

// A line of text for each, with the times at which it was printed and heard.
std::string text_of(const std::vector<Transcribed>& lines);

}  // namespace handrail::test
