// The instructor's desk shows the state of a lesson in one line, and accepts orders. It uses a socket that only the
// same person on the same machine can open. The desk is text only and speaks nothing. Orders act only on the lesson, so
// they cannot cause forces.
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
// "note TEXT", "summary", "end". Returns one line about what happened. For an unknown order, returns the list of
// orders. Each order that is carried out becomes a note of the lesson.
std::string carry_out_order(TeachingRun& run, std::string_view order, double now_s);

// Returns the folder with all desks of the person: $XDG_RUNTIME_DIR/handrail-desks if that variable is set, otherwise a
// folder below the one for temporary files.
std::filesystem::path desk_folder();

// The session's end of the connection. App thread. This class never waits, so watchers who read slowly miss lines.
class DeskServer {
public:
    // Opens a desk for this process in `folder`. `title` is one line about the lesson and the learner, which watchers
    // receive first. Fails with a sentence.
    static Result<std::unique_ptr<DeskServer>> open(const std::filesystem::path& folder, const std::string& title);
    // Sends all watchers that the lesson has ended.
    ~DeskServer();
    DeskServer(const DeskServer&) = delete;
    DeskServer& operator=(const DeskServer&) = delete;

    // Returns the orders that have arrived since the last call, in their order.
    std::vector<std::string> take_orders();
    // Sends a line to all watchers. The last lines are also sent to watchers who connect later.
    void send(const std::string& line);

private:
    struct State;
    explicit DeskServer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

// Implements `handrail lesson watch`. Until the lesson ends, prints what the desk sends, and sends the lines from
// `in_descriptor`, the standard input, as orders. If several lessons have desks in the folder, lists them and asks for
// a number. Returns 0 if the lesson ended. Returns 1 if there is no lesson to watch, or if the instructor chose none.
int watch_desk(const std::filesystem::path& folder, int in_descriptor, std::ostream& out, std::ostream& err);

}  // namespace handrail::teaching
