// What was measured in the lessons of a learner who is remembered and not recorded: results.jsonl in the learner's own
// folder, one line of JSON for each session, with its tasks and their numbers and nothing of what was said or where one
// went. A recording holds the same, and more. Any thread; writing holds a lock on the folder and is atomic.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/record/recorded_events.h"
#include "worlds/base/result.h"

namespace handrail {

struct KeptResults {
    std::string begun_utc;      // "2026-11-22T17:30:00Z"
    std::string lesson, world;  // as they are told
    double seconds = 0.0;
    std::vector<RecordedTask> tasks;
};
std::filesystem::path results_in(const std::filesystem::path& learner_folder);
// One session more.
Result<void> keep_results(const std::filesystem::path& learner_folder, const KeptResults& results);
// In the order in which they were kept. Lines that cannot be understood are faults with file and line.
std::vector<KeptResults> kept_results(const std::filesystem::path& learner_folder, std::vector<Error>& faults);
// The time of day, as recordings have it.
std::string now_utc();

}  // namespace handrail
