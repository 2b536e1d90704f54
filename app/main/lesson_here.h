// The lesson of an instructor in a session with a person: begun from the command line or from the list of lessons, gone
// on with ten times a second, and the desk beside it. App thread.
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

namespace handrail {

class LessonHere {
public:
    // All outlive this object. The arguments say which lesson is to be taught and to whom.
    LessonHere(const ExploreArguments& arguments, Session& app, WorldVisits& worlds, const SessionVoice& say)
        : arguments_(arguments), app_(app), worlds_(worlds), say_(say) {}

    // Before the session's tick. speaking: somebody speaks.
    void turn(bool speaking, double now_s);
    // After it: what happened in it.
    void see(const std::vector<SessionEvent>& events);
    // The session ends: what was measured until now is kept where that is agreed.
    void end(double now_s);

private:
    void offer(double now_s);
    void begin_chosen(double now_s);
    void begin(const LessonToTeach& lesson, double now_s);
    void close(double now_s);
    void write_draft(double now_s);
    void listen_to_desk(double now_s);

    const ExploreArguments& arguments_;
    Session& app_;
    WorldVisits& worlds_;
    const SessionVoice& say_;
    int world_ = 0;  // Session::worlds_entered()
    bool began_ = false;
    std::vector<std::filesystem::path> offered_;
    BackgroundTask<Result<std::shared_ptr<TaughtWorld>>> looked_for_{on_threads(), "lesson"};
    std::optional<TeachingRun> run_;
    LessonToTeach taught_;  // while it runs
    double begun_s_ = 0.0;
    std::string begun_utc_;
    std::unique_ptr<DeskServer> desk_;
    std::vector<SessionEvent> events_;
    double turned_s_ = -1e9, told_s_ = -1e9;
};

// Reads the lessons that will be offered in a world, so that the app's thread finds them known (toml_beside_worlds).
void read_lessons_ahead(const std::filesystem::path& world, const std::stop_token& stop);
// The lesson that a command was given: a file, or by its name, "school", one of the person's own or of those that come
// with the program. Fails with what there is instead.
Result<std::filesystem::path> lesson_given(const std::filesystem::path& word);
// A lesson in its world, both read. Fails with file and line.
Result<std::shared_ptr<TaughtWorld>> read_taught_world(const std::filesystem::path& file);
// The session of that lesson, from 0, which comes next for the learner of these arguments; the first one where nothing
// is remembered. What is wrong with the file of it is added to `news`.
std::size_t next_session(const ExploreArguments& arguments, const LessonFile& lesson, std::vector<std::string>& news);
// Lessons of the person's own.
std::filesystem::path lessons_folder();

}  // namespace handrail
