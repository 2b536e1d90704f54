// An instructor's lesson in a session with a person, and the desk from which the instructor follows it. It begins from
// the command line or from the list of lessons, and advances ten times a second. App thread.
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
    // All of these outlive this object. The arguments say which lesson is taught, and to whom.
    LessonHere(const ExploreArguments& arguments, core::Session& app, WorldVisits& worlds, const SessionVoice& say)
        : arguments_(arguments), app_(app), worlds_(worlds), say_(say) {}

    // Call before the session's tick. `speaking`: a sentence is being spoken.
    void turn(bool speaking, double now_s);
    // Call after the tick, with what happened in it.
    void see(const std::vector<core::SessionEvent>& events);
    // Call when the session ends. Keeps what was measured until now, if the learner has agreed to that.
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
    int world_ = 0;  // the last Session::worlds_entered() that was seen
    bool began_ = false;
    std::vector<std::filesystem::path> offered_;
    BackgroundTask<Result<std::shared_ptr<teaching::TaughtWorld>>> looked_for_{on_threads(), "lesson"};
    std::optional<teaching::TeachingRun> run_;
    LessonToTeach taught_;  // set while a lesson runs
    double begun_s_ = 0.0;
    std::string begun_utc_;
    std::unique_ptr<teaching::DeskServer> desk_;
    std::vector<core::SessionEvent> events_;
    double turned_s_ = -1e9, told_s_ = -1e9;
};

// Reads the lessons that will be offered in a world, so that toml_beside_worlds already has them when the app thread
// asks.
void read_lessons_ahead(const std::filesystem::path& world, const std::stop_token& stop);
// Finds the lesson that a command names: a file, or a name such as "school". A name is that of one of the person's own
// lessons or of a lesson that comes with the program. Fails with a list of what exists.
Result<std::filesystem::path> lesson_given(const std::filesystem::path& word);
// A lesson in its world, both read. Fails with file and line. rooms_kept: as of TaughtWorld::find.
Result<std::shared_ptr<teaching::TaughtWorld>> read_taught_world(const std::filesystem::path& file,
                                                                 core::RoomsKept* rooms_kept = nullptr);
// The session of that lesson, from 0, which comes next for the learner of these arguments; the first one where nothing
// is remembered. What is wrong with the file of it is added to `news`.
std::size_t next_session(const ExploreArguments& arguments, const teaching::LessonFile& lesson,
                         std::vector<std::string>& news);
// The folder of the person's own lessons.
std::filesystem::path lessons_folder();

}  // namespace handrail::program
