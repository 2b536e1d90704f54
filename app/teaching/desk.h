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

// What the words of an order do to a lesson: "next", "repeat", "more", "less", "lead NAME", "block NAME",
// "open NAME", "note TEXT", "summary", "end". The reply in one line; of an order that is none, which there are.
std::string carry_out_order(TeachingRun& run, std::string_view order, double now_s);

// $XDG_RUNTIME_DIR/handrail-desk.sock, else in a folder of the person's own below the one for temporary files.
std::filesystem::path desk_socket_path();

// For the session. App thread; never waits: who does not read is left behind.
class DeskServer {
public:
    // Fails with a sentence where there can be none, or another session has one.
    static Result<std::unique_ptr<DeskServer>> open(const std::filesystem::path& path);
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
// either ends. 0: the session ended, or the input; 1: there is none to watch.
int watch_desk(const std::filesystem::path& path, int in_descriptor, std::ostream& out, std::ostream& err);

}  // namespace handrail
