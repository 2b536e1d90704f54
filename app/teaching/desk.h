// The instructor's desk: one line about how a lesson stands and orders to it, through a socket that only the same
// person on the same machine can open. Text alone: nothing here speaks. Orders reach nothing but the lesson, so no
// force.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/teaching/teaching_run.h"
#include "worlds/base/result.h"

namespace handrail {

// What the words of an order do to a lesson: "next", "repeat", "more", "less", "lead NAME", "leave", "block NAME",
// "open NAME", "note TEXT", "summary", "end". The reply says in one line what happened; of an order that is none, which
// there are. What was done is noted in the lesson.
std::string carry_out_order(TeachingRun& run, std::string_view order, double now_s);

// The folder of all desks of the person: $XDG_RUNTIME_DIR/handrail-desks, else below the folder for temporary files.
std::filesystem::path desk_folder();

// For the session. App thread; never waits: who does not read is left behind.
class DeskServer {
public:
    // A desk of this process's own in that folder. title: which lesson it is and who learns, in one line, which whoever
    // watches reads first. Fails with a sentence if there can be none.
    static Result<std::unique_ptr<DeskServer>> open(const std::filesystem::path& folder, const std::string& title);
    // Tells whoever watches that the lesson has ended.
    ~DeskServer();
    DeskServer(const DeskServer&) = delete;
    DeskServer& operator=(const DeskServer&) = delete;

    // Orders that have come since, in order: one line each.
    std::vector<std::string> take_orders();
    // To all who watch, and, the last ones, to who comes later.
    void tell(const std::string& line);

private:
    struct State;
    explicit DeskServer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

// `handrail lesson watch`: prints what is told, sends the lines of standard input (`in_descriptor`) as orders, until
// the lesson ends. If several lessons have desks in that folder, it lists them and asks for a number. 0: the lesson
// ended; 1: there is none to watch, or none was chosen.
int watch_desk(const std::filesystem::path& folder, int in_descriptor, std::ostream& out, std::ostream& err);

}  // namespace handrail
