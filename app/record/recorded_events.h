// The events of a recorded session as plain values, taken from its lines. Reports are made from them. Any thread.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/record/input_text.h"
#include "app/record/recording.h"

namespace handrail::record {

struct RecordedContact {
    double t_s = 0.0;  // since the recording began, like all times here
    std::uint32_t feature = kNoFeature.value;
    std::string thing;  // name in the world's file; empty: none
    Vec3 at_m{0.0};
};
struct RecordedVisit {
    double t_s = 0.0;
    std::uint32_t feature = kNoFeature.value;
};
// Guidance to a goal: when it began, and when the walker arrived.
struct RecordedRoute {
    std::string goal;
    double from_s = 0.0;
    std::optional<double> arrived_s;  // nothing: the walker never arrived
};

// The measures of one task of a lesson.
struct RecordedTask {
    double t_s = 0.0;  // end of the task
    std::string kind;  // as in lesson files, such as "go"
    std::string name;
    std::map<std::string, double> measures;
};

// What the instructor did: a note, or an order and its result.
struct RecordedNote {
    double t_s = 0.0;
    std::string text;
};
// A time span.
struct RecordedSpan {
    double from_s = 0.0, to_s = 0.0;
};

// The events in the first world that was entered.
struct RecordedEvents {
    std::string lesson;  // title; empty: no lesson
    std::vector<RecordedTask> tasks;
    std::optional<RecordedWorld> world;
    double from_s = 0.0, to_s = 0.0;  // time in that world
    bool more_worlds = false;         // another world was entered later
    std::vector<RecordedContact> contacts;
    std::vector<RecordedVisit> visits;
    std::vector<RecordedRoute> ways;
    // Help requested; back to the base by its key; put somewhere else.
    std::vector<double> help_s, home_s, leaps_s;
    std::vector<RecordedNote> notes;
    std::vector<RecordedSpan> busy;   // a list was open, or the voice was speaking
    std::vector<RecordedSpan> lists;  // a list was open
};
RecordedEvents events_of(const Recording& recording);

}  // namespace handrail::record
