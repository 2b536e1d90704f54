// The instructor's desk: shows the state of a lesson in one line and accepts orders, through a socket that only the
// same person on the same machine can open. It uses text only and speaks nothing. Orders reach only the lesson, so they
// cannot cause forces.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/teaching/teaching_run.h"
#include "worlds/base/result.h"

namespace handrail::teaching {

// Carries out an order on a lesson: "next", "repeat", "more", "less", "lead NAME", "leave", "block NAME", "open NAME",
// "note TEXT", "summary", "end". Returns one line about what happened; for an unknown order, the list of orders. What
// was done is noted in the lesson.
std::string carry_out_order(TeachingRun& run, std::string_view order, double now_s);

// The folder with all desks of the person: $XDG_RUNTIME_DIR/handrail-desks, otherwise below the folder for temporary
// files.
std::filesystem::path desk_folder();

// The session's end of the desk. App thread; never waits, so slow readers miss lines.
class DeskServer {
public:
    // Opens a desk for this process in that folder. `title`: one line about the lesson and the learner, which watchers
    // read first. Fails with a sentence if it is not possible.
    static Result<std::unique_ptr<DeskServer>> open(const std::filesystem::path& folder, const std::string& title);
    // Tells all watchers that the lesson has ended.
    ~DeskServer();
    DeskServer(const DeskServer&) = delete;
    DeskServer& operator=(const DeskServer&) = delete;

    // Orders that have arrived since the last call, in order: one line each.
    std::vector<std::string> take_orders();
    // Sends a line to all watchers. The last lines are also sent to watchers who connect later.
    void tell(const std::string& line);

private:
    struct State;
    explicit DeskServer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

// Implements `handrail lesson watch`: prints what the desk sends, and sends the lines of standard input
// (`in_descriptor`) as orders, until the lesson ends. If several lessons have desks in that folder, it lists them and
// asks for a number. Returns 0 if the lesson ended, 1 if there is none to watch or none was chosen.
int watch_desk(const std::filesystem::path& folder, int in_descriptor, std::ostream& out, std::ostream& err);

}  // namespace handrail::teaching
