// Reports progress to a person who waits for a command or a world. It reports nothing during the first two seconds,
// then a sentence every few seconds. The working thread states what it does; the reporting thread queries which
// sentence is due.
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

// A handle on the state that the working and the reporting thread share. Copies refer to the same work. Any thread may
// use it.
class LongWork {
public:
    // Makes a handle for work that nobody waits for; nothing is reported.
    LongWork() = default;
    // Makes a handle for work that somebody waits for. Calls `noted` on the working thread whenever other work begins,
    // but not when the work is done. `noted` is meant for callers that log the work.
    static LongWork begun(std::function<void(const std::string& what)> noted = {});

    // ---- the working side ----
    // Sets the name of the current work, which is reported with the time since the work began: "Finding rooms and
    // routes".
    // If other work is already under way, the time does not start again.
    void at(std::string what) const;
    // States that a file is being read, so that percent and stage are reported. `stage` is the key of a text
    // ("import.shapes"), or empty if the stage is unknown.
    void reading(std::string_view stage = {}) const;
    void read(double fraction) const;
    // Returns `options` with a change: the reader reports its progress to this object.
    readers::ReadOptions followed(readers::ReadOptions options) const;
    // Ends the current work. The next work may again go on for two seconds without a report. When this function
    // returns, no report is under way.
    void done() const;

    // ---- the reporting side ----
    // Calls `say` with the sentence that is due at this time, if any. All times must be from one clock. The two seconds
    // begin with the first call.
    void report(double now_s, const std::function<void(const std::string&)>& say) const;
    // Waits until there is work, or until end_waiting() has set `stop`. Returns true if there is work.
    bool wait_for_work(const bool& stop) const;
    // Waits for `seconds`, or until `stop` is set or the work is done.
    void wait_s(double seconds, const bool& stop) const;
    void end_waiting(bool& stop) const;

private:
    struct State;
    std::shared_ptr<State> state_;
};

// Writes each sentence that is due as a line to a stream, for a terminal. A separate thread writes the lines. The
// thread sleeps while there is no work, and receives no signals.
class LongWorkLines {
public:
    // The stream must outlive this object.
    LongWorkLines(const LongWork& progress, std::ostream& to);
    ~LongWorkLines();
    LongWorkLines(const LongWorkLines&) = delete;
    LongWorkLines& operator=(const LongWorkLines&) = delete;

private:
    LongWork progress_;
    bool stop_ = false;  // guarded by the mutex in the state that progress_ shares
    std::thread thread_;
};

}  // namespace handrail::program
