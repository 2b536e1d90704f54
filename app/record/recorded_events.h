// What happened in a recorded session, as plain values out of the lines of its events: what a report is made of. Any
// thread.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/record/input_text.h"
#include "app/record/recording.h"

namespace handrail {

struct RecordedContact {
    double t_s = 0.0;  // since the recording began, as all times here
    std::uint32_t feature = kNoFeature.value;
    std::string thing;  // its name in the file of the world; empty: it has none
    Vec3 at_m{0.0};
};
struct RecordedVisit {
    double t_s = 0.0;
    std::uint32_t feature = kNoFeature.value;
};
// Being led to a goal, from when on, and how it ended.
struct RecordedWay {
    std::string goal;
    double from_s = 0.0;
    std::optional<double> arrived_s;  // none: it never was
};

// What was measured of a task of a lesson.
struct RecordedTask {
    double t_s = 0.0;  // its end
    std::string kind;  // "go", as lesson files have it
    std::string name;
    std::map<std::string, double> measures;
};

// What whoever taught did: a note, or an order and what came of it.
struct RecordedNote {
    double t_s = 0.0;
    std::string text;
};
// From one time to another.
struct RecordedSpan {
    double from_s = 0.0, to_s = 0.0;
};

// Of the first world that was entered.
struct RecordedEvents {
    std::string lesson;  // title; empty: none
    std::vector<RecordedTask> tasks;
    std::optional<RecordedWorld> world;
    double from_s = 0.0, to_s = 0.0;  // while it was that world
    bool more_worlds = false;         // another one was entered after it
    std::vector<RecordedContact> contacts;
    std::vector<RecordedVisit> visits;
    std::vector<RecordedWay> ways;
    std::vector<double> help_s, home_s, leaps_s;  // help asked; back to the base by its key; put elsewhere
    std::vector<RecordedNote> notes;
    std::vector<RecordedSpan> busy;   // a list was open, or somebody spoke
    std::vector<RecordedSpan> lists;  // a list was open
};
RecordedEvents events_of(const Recording& recording);

}  // namespace handrail
