// The lesson of an instructor in a session with a person: begun from the command line or from the list of lessons, gone
// on with ten times a second, and the desk beside it. App thread.
#pragma once

#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/session/session.h"
#include "app/main/commands.h"
#include "app/main/session_voice.h"
#include "app/teaching/desk.h"
#include "app/teaching/lesson_check.h"

namespace handrail {

class LessonHere {
public:
    // All outlive this object.
    // learner: whose session it is, for lessons chosen in it; empty: nobody's by name.
    LessonHere(const std::optional<LessonToTeach>& wanted, const std::string& learner, Session& app,
               const SessionVoice& say)
        : wanted_(wanted), learner_(learner), app_(app), say_(say) {}

    // Before the session's tick. world: the file one is in.
    void turn(const std::filesystem::path& world, double now_s);
    // After it: what happened in it.
    void see(const std::vector<SessionEvent>& events);

private:
    void offer(const std::filesystem::path& world, double now_s);
    void begin_chosen(double now_s);
    void begin(const LessonToTeach& lesson);
    void write_draft(const std::filesystem::path& world, double now_s);
    void listen_to_desk(double now_s);

    const std::optional<LessonToTeach>& wanted_;
    const std::string& learner_;
    Session& app_;
    const SessionVoice& say_;
    int world_ = 0;  // Session::worlds_entered()
    bool began_ = false;
    std::vector<std::filesystem::path> offered_;
    std::future<Result<std::shared_ptr<TaughtWorld>>> looked_for_;
    std::optional<TeachingRun> run_;
    std::unique_ptr<DeskServer> desk_;
    std::vector<SessionEvent> events_;
    double turned_s_ = -1e9, told_s_ = -1e9;
};

// A lesson in its world, both read. Fails with file and line.
Result<std::shared_ptr<TaughtWorld>> read_taught_world(const std::filesystem::path& file);
// Lessons of the person's own.
std::filesystem::path lessons_folder();

}  // namespace handrail
