// Stores the lesson results of a learner who agreed to be remembered but not recorded. The results are in results.jsonl
// in the learner's own folder, with one line of JSON for each session. A line contains tasks and measures, but no
// positions and nothing that was said. A recording would contain all of this. Any thread; writing locks the folder and
// is atomic.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/record/recorded_events.h"
#include "worlds/base/result.h"

namespace handrail::learners {

struct KeptResults {
    std::string begun_utc;      // beginning of the session, such as "2026-11-22T17:30:00Z"
    std::string lesson, world;  // names of the lesson and of its world, as the program announces them
    double seconds = 0.0;
    std::vector<record::RecordedTask> tasks;
};
std::filesystem::path results_in(const std::filesystem::path& learner_folder);
// Adds the results of one session.
Result<void> keep_results(const std::filesystem::path& learner_folder, const KeptResults& results);
// Returns the sessions in the order in which they were added. Adds a fault with file and line for each line that cannot
// be read.
std::vector<KeptResults> kept_results(const std::filesystem::path& learner_folder, std::vector<Error>& faults);
// Returns the current time in the format of recordings.
std::string now_utc();

}  // namespace handrail::learners
