// Stores how far a learner has come in lessons with several sessions. The file is lessons.toml in the learner's own
// folder; it exists only if the learner agreed to be remembered. The file has one [[lesson]] for each lesson, with the
// number of the last completed session. Rewriting the file keeps its unknown keys. Any thread; writing locks the folder
// and is atomic.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::learners {

struct LessonProgress {
    std::filesystem::path file;  // the lesson file: absolute path, links resolved
    std::size_t taught = 0;      // number of the last completed session, from 1
    std::string day;             // day on which that session was completed
};
// Returns the progress in all lessons; empty if there is no file. Fails with file and line if the contents are invalid.
Result<std::vector<LessonProgress>> lessons_begun(const std::filesystem::path& learner_folder);
// Returns the number of the last completed session of the lesson, counted from 1; 0 if there is none.
Result<std::size_t> session_taught(const std::filesystem::path& learner_folder, const std::filesystem::path& lesson);
// Stores the number of the last completed session.
Result<void> note_session_taught(const std::filesystem::path& learner_folder, const std::filesystem::path& lesson,
                                 std::size_t session);
// Returns the index, from 0, of the session that follows the first `taught` ones in a lesson with `sessions` sessions.
// After the last session, returns 0, so the lesson starts again.
inline std::size_t session_behind(std::size_t taught, std::size_t sessions) { return taught < sessions ? taught : 0; }
// Deletes the learner's progress in lessons and the results of lessons.
Result<void> forget_lessons(const std::filesystem::path& learner_folder);

}  // namespace handrail::learners
