// How far a learner has come in lessons with several sessions. Kept in lessons.toml in the learner's own folder, if the
// learner wants to be remembered. One [[lesson]] for each lesson file, with the number of the last session that was
// completed; unknown keys stay. Any thread; writing locks the folder and is atomic.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::learners {

struct LessonProgress {
    std::filesystem::path file;  // of the lesson: absolute, links resolved
    std::size_t taught = 0;      // number of the last completed session, from 1
    std::string day;             // day of that session
};
// The progress in all lessons; empty if there is no file. Fails with file and line if the contents are invalid.
Result<std::vector<LessonProgress>> lessons_begun(const std::filesystem::path& learner_folder);
// The number of the last completed session of that lesson, from 1; 0 if there is none.
Result<std::size_t> session_taught(const std::filesystem::path& learner_folder, const std::filesystem::path& lesson);
// Sets the last completed session.
Result<void> note_session_taught(const std::filesystem::path& learner_folder, const std::filesystem::path& lesson,
                                 std::size_t session);
// The index of the next session, from 0, in a lesson with that many sessions. After the last one it starts again with
// the first.
inline std::size_t session_behind(std::size_t taught, std::size_t sessions) { return taught < sessions ? taught : 0; }
// Forgets the progress in lessons and their results.
Result<void> forget_lessons(const std::filesystem::path& learner_folder);

}  // namespace handrail::learners
