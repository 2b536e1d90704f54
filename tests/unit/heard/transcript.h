// Finds out what a person hears in a mix. The functions search the mix for each line, using the voice's own rendering
// of that line.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/support/names.h"
#include "tests/unit/heard/heard.h"
#include "tests/unit/heard/sounding.h"

namespace handrail::test {

struct Transcribed {
    std::string text;
    SpeechClass speech_class = SpeechClass::Answer;
    SpeechTopic topic = SpeechTopic::None;
    bool voiced = true, stopped = false;
    double printed_s = 0.0;
    std::optional<double> heard_s = {};  // time at which the line begins in the mix; empty: not found
    double share = 0.0;                  // share of the line's voiced pieces that are heard in the mix
    bool in_full = false;                // all pieces but 10 %, or but one, are heard, including the last one

    // Returns whether the line is important. Important are lines about danger, places, routes and lessons, and answers
    // that the person did not cut with the next key. Lines that were only written are unimportant, because they were
    // announced a moment before or are out of date.
    bool matters() const {
        if (!voiced || speech_class > SpeechClass::Guidance || topic == SpeechTopic::Heading) return false;
        return topic != SpeechTopic::None || speech_class <= SpeechClass::Warning || !stopped;
    }
};

std::vector<Transcribed> transcribe(const Sounding& sounding);

// Returns the lines as the person heard them.
std::vector<Spoken> spoken(const std::vector<Transcribed>& lines);

// How many sounds of the beacon are in the mix. Counts only those that began while the voice was silent, because the
// voice covers the others.
struct HeardBeacon {
    int played = 0, heard = 0;
};
HeardBeacon heard_beacon(const Sounding& sounding);

// The number of important lines, and the texts of those that were never heard in full. If the session announced a line
// again because it was cut, the line counts once.
struct Judged {
    int matter = 0;
    std::vector<std::string> missing;
    double share() const { return 1.0 - static_cast<double>(missing.size()) / matter; }
};
Judged judge(const std::vector<Transcribed>& lines);

// Returns one line of text for each line, with the times at which the session printed it and the person heard it.
std::string text_of(const std::vector<Transcribed>& lines);

}  // namespace handrail::test
