// Reports progress to somebody who waits for a command or a world: nothing within two seconds, then a sentence every
// few seconds. The working side says what it does; the reporting side queries what is due.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <thread>

#include "worlds/readers/reader.h"

namespace handrail::program {

// A handle on the state that both sides share; copies refer to the same work. Any thread.
class LongWork {
public:
    // For work that nobody waits for; nothing is reported.
    LongWork() = default;
    // For work that somebody waits for. `noted` is called at once whenever the current work changes, and never when it
    // is done; it is for callers that follow the work itself. Called on the working thread.
    static LongWork begun(std::function<void(const std::string& what)> noted = {});

    // ---- the working side ----
    // Names the current work, which is printed with the time so far: "Finding rooms and routes". If work is already
    // under way, its time goes on.
    void at(std::string what) const;
    // A file is being read, which is reported by percent and stage. The stage is the key of a text ("import.shapes"),
    // or empty while unknown.
    void reading(std::string_view stage = {}) const;
    void read(double fraction) const;
    // The same options, but with the reader's progress reported here.
    readers::ReadOptions followed(readers::ReadOptions options) const;
    // The work is over; the next may again take two seconds in silence. When this returns, no report is under way.
    void done() const;

    // ---- the reporting side ----
    // Calls `say` with the sentence that is due at this time, if any. All times must be from one clock; the wait begins
    // with the first call.
    void tell(double now_s, const std::function<void(const std::string&)>& say) const;
    // Waits for work, or until end_waiting() has set `stop`. Returns true if there is work.
    bool wait_for_work(const bool& stop) const;
    // Waits for `seconds` at most, or until `stop` is set.
    void wait_s(double seconds, const bool& stop) const;
    void end_waiting(bool& stop) const;

private:
    struct State;
    std::shared_ptr<State> state_;
};

// Writes each due sentence as a line to a stream, for a terminal. It runs on a separate thread that sleeps while there
// is no work and takes no signals.
class LongWorkLines {
public:
    // The stream outlives it.
    LongWorkLines(const LongWork& progress, std::ostream& to);
    ~LongWorkLines();
    LongWorkLines(const LongWorkLines&) = delete;
    LongWorkLines& operator=(const LongWorkLines&) = delete;

private:
    LongWork progress_;
    bool stop_ = false;  // guarded by the mutex that progress_ shares
    std::thread thread_;
};

}  // namespace handrail::program
