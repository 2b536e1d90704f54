// The results of lessons of a learner who is remembered but not recorded, in results.jsonl in the learner's own folder.
// Each session is one line of JSON with its tasks and measures, but without anything that was said and without
// positions. A recording contains the same and more. Any thread; writing locks the folder and is atomic.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/record/recorded_events.h"
#include "worlds/base/result.h"

namespace handrail::learners {

struct KeptResults {
    std::string begun_utc;      // "2026-11-22T17:30:00Z"
    std::string lesson, world;  // names as they are announced
    double seconds = 0.0;
    std::vector<record::RecordedTask> tasks;
};
std::filesystem::path results_in(const std::filesystem::path& learner_folder);
// Adds one session.
Result<void> keep_results(const std::filesystem::path& learner_folder, const KeptResults& results);
// The sessions in the order in which they were added. Lines that cannot be read are reported as faults with file and
// line.
std::vector<KeptResults> kept_results(const std::filesystem::path& learner_folder, std::vector<Error>& faults);
// The current time, in the format of recordings.
std::string now_utc();

}  // namespace handrail::learners
