// What somebody who waits for a command or a world is told: nothing within two seconds, then a sentence every few.
// Whoever works says what it is at; whoever tells asks what is due.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <thread>

#include "worlds/readers/reader.h"

namespace handrail {

// A handle on what is shared by both sides; copies are of the same work. Any thread.
class LongWork {
public:
    // Nobody waits, and nothing is told.
    LongWork() = default;
    // Somebody does. `noted`: hears at once what it is at, each time that changes, and nothing where it is done; for
    // who watches the work itself. The working thread.
    static LongWork begun(std::function<void(const std::string& what)> noted = {});

    // ---- whoever works ----
    // It is at this from now on, printed with the time so far: "Finding rooms and routes". What was begun counts on.
    void at(std::string what) const;
    // A file is being read, told by percent and by its stage, a text's key ("import.shapes"); empty: none is known yet.
    void reading(std::string_view stage = {}) const;
    void read(double fraction) const;
    // The same options, with what the reader tells of itself coming here.
    ReadOptions followed(ReadOptions options) const;
    // Over: what comes next may take its two seconds again. Nobody is telling anything when this returns.
    void done() const;

    // ---- whoever tells ----
    // Gives `say` what is due at this time, if something is. Times are of one clock; the wait begins when it is first
    // asked about.
    void tell(double now_s, const std::function<void(const std::string&)>& say) const;
    // Returns when there is work or `stop` was set by end_waiting(); true: there is work.
    bool wait_for_work(const bool& stop) const;
    // For at most that long, or until `stop` was set.
    void wait_s(double seconds, const bool& stop) const;
    void end_waiting(bool& stop) const;

private:
    struct State;
    std::shared_ptr<State> state_;
};

// Writes what is due to a stream, a line each, on a thread of its own that sleeps while there is no work. For a
// terminal; takes no signals.
class LongWorkLines {
public:
    // The stream outlives it.
    LongWorkLines(const LongWork& progress, std::ostream& to);
    ~LongWorkLines();
    LongWorkLines(const LongWorkLines&) = delete;
    LongWorkLines& operator=(const LongWorkLines&) = delete;

private:
    LongWork progress_;
    bool stop_ = false;  // guarded by what progress_ shares
    std::thread thread_;
};

}  // namespace handrail
