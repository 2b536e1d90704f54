// Extracts the events of a recorded session from the lines of the recording, as plain values for reports. Any thread.
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
    double t_s = 0.0;  // time since the recording began, like all times in this file
    std::uint32_t feature = kNoFeature.value;
    std::string thing;  // name in the world's file; empty if there is none
    Vec3 at_m{0.0};
};
struct RecordedVisit {
    double t_s = 0.0;
    std::uint32_t feature = kNoFeature.value;
};
// Guidance to a goal: when the guidance began, and when the walker arrived.
struct RecordedRoute {
    std::string goal;
    double from_s = 0.0;
    std::optional<double> arrived_s;  // nothing: the walker never arrived
};

// The measures of one task of a lesson.
struct RecordedTask {
    double t_s = 0.0;  // end of the task
    std::string kind;  // kind of task as in lesson files, such as "go"
    std::string name;
    std::map<std::string, double> measures;
};

// What the instructor did: a note, or an order with its result.
struct RecordedNote {
    double t_s = 0.0;
    std::string text;
};
// A span of time.
struct RecordedSpan {
    double from_s = 0.0, to_s = 0.0;
};

// The events in the first world that the person entered.
struct RecordedEvents {
    std::string lesson;  // title of the lesson; empty: no lesson
    std::vector<RecordedTask> tasks;
    std::optional<RecordedWorld> world;
    double from_s = 0.0, to_s = 0.0;  // when the person entered the first world and left it
    bool more_worlds = false;         // the person entered another world later
    std::vector<RecordedContact> contacts;
    std::vector<RecordedVisit> visits;
    std::vector<RecordedRoute> ways;
    // Times at which the person requested help, used the key that leads back to the base, or was moved to another place
    // without walking.
    std::vector<double> help_s, home_s, leaps_s;
    std::vector<RecordedNote> notes;
    std::vector<RecordedSpan> busy;   // times when a list was open or the voice was speaking
    std::vector<RecordedSpan> lists;  // times when a list was open
};
RecordedEvents events_of(const Recording& recording);

}  // namespace handrail::record
