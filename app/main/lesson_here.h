// Runs an instructor's lesson in a session with a person, and the desk from which the instructor follows the lesson.
// The lesson begins from the command line or from the list of lessons. The lesson advances ten times a second. App
// thread.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/core/session/session.h"
#include "app/main/commands.h"
#include "app/main/session_voice.h"
#include "app/main/world_visits.h"
#include "app/teaching/desk.h"
#include "app/teaching/lesson_check.h"
#include "worlds/base/background_task.h"

namespace handrail::program {

class LessonHere {
public:
    // All arguments must outlive this object. `arguments` contains which lesson is taught, and to whom.
    LessonHere(const ExploreArguments& arguments, core::Session& app, WorldVisits& worlds, const SessionVoice& say)
        : arguments_(arguments), app_(app), worlds_(worlds), say_(say) {}

    // Call before the session's tick. `speaking`: the voice is speaking a sentence.
    void turn(bool speaking, double now_s);
    // Call after the tick, with the events of that tick.
    void see(const std::vector<core::SessionEvent>& events);
    // Call when the session ends. Stores what was measured so far, if the learner has agreed to that.
    void end(double now_s);

private:
    void offer(double now_s);
    void begin_chosen(double now_s);
    void begin(const LessonToTeach& lesson, double now_s);
    void close(double now_s);
    void write_draft(double now_s);
    void listen_to_desk(double now_s);

    const ExploreArguments& arguments_;
    core::Session& app_;
    WorldVisits& worlds_;
    const SessionVoice& say_;
    int world_ = 0;  // Session::worlds_entered() at the last call of turn()
    bool began_ = false;
    std::vector<std::filesystem::path> offered_;
    BackgroundTask<Result<std::shared_ptr<teaching::TaughtWorld>>> looked_for_{on_threads(), "lesson"};
    std::optional<teaching::TeachingRun> run_;
    LessonToTeach taught_;  // the lesson that runs; set only while run_ is set
    double begun_s_ = 0.0;
    std::string begun_utc_;
    std::unique_ptr<teaching::DeskServer> desk_;
    std::vector<core::SessionEvent> events_;
    double turned_s_ = -1e9, summary_sent_s_ = -1e9;
};

// Reads the lessons that will be offered in a world. The results are stored in the cache of toml_next_to_worlds, so the
// app thread later gets them without waiting.
void read_lessons_ahead(const std::filesystem::path& world, const std::stop_token& stop);
// Finds the lesson that a command names. `word` is a file, or a name such as "school": one of the person's own lessons,
// or a lesson that is shipped with the program. Fails with a list of the existing names.
Result<std::filesystem::path> lesson_given(const std::filesystem::path& word);
// Reads a lesson and its world. Fails with file and line. `rooms_kept` is as for TaughtWorld::find.
Result<std::shared_ptr<teaching::TaughtWorld>> read_taught_world(const std::filesystem::path& file,
                                                                 core::RoomsKept* rooms_kept = nullptr);
// Returns which session of the lesson, counted from 0, comes next for the learner in `arguments`. If nothing is
// remembered, returns 0. Adds faults in the file with the learner's progress to `news`.
std::size_t next_session(const ExploreArguments& arguments, const teaching::LessonFile& lesson,
                         std::vector<std::string>& news);
// Returns the folder of the person's own lessons.
std::filesystem::path lessons_folder();

}  // namespace handrail::program
