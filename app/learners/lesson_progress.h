// How far a learner has come in lessons of several sessions: lessons.toml in the learner's own folder, where the
// learner wants to be remembered. One [[lesson]] for each lesson file, with the number of the session that was taught
// to its end last; keys that nobody here knows stay. Any thread; writing holds a lock on the folder and is atomic.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "worlds/base/result.h"

namespace handrail {

struct LessonProgress {
    std::filesystem::path file;  // of the lesson: absolute, links followed
    std::size_t taught = 0;      // session, from 1
    std::string day;             // on which that was
};
// All there are. Fails with file and line where something else stands there; no file: none.
Result<std::vector<LessonProgress>> lessons_begun(const std::filesystem::path& learner_folder);
// The number of the session of that lesson which was taught last, from 1; 0: none was.
Result<std::size_t> session_taught(const std::filesystem::path& learner_folder, const std::filesystem::path& lesson);
// From now on it is that one.
Result<void> note_session_taught(const std::filesystem::path& learner_folder, const std::filesystem::path& lesson,
                                 std::size_t session);
// Of a lesson with so many sessions the one that comes next, from 0; behind the last one it is the first again.
inline std::size_t session_behind(std::size_t taught, std::size_t sessions) { return taught < sessions ? taught : 0; }
// What was remembered of lessons and of their results is forgotten.
Result<void> forget_lessons(const std::filesystem::path& learner_folder);

}  // namespace handrail
