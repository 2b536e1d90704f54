// Reports progress to a person who waits for a command or a world. It reports nothing during the first two seconds,
// then a sentence every few seconds. The thread that works says what it does; the thread that reports queries what is
// due.
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
    // Makes a handle for work that somebody waits for. `noted` is called on the working thread each time when other
    // work begins, but not when the work is done. It is for callers that log the work itself.
    static LongWork begun(std::function<void(const std::string& what)> noted = {});

    // ---- the working side ----
    // Sets the name of the current work, which is reported with the time since the work began: "Finding rooms and
    // routes".
    // If other work is already under way, the time does not start again.
    void at(std::string what) const;
    // Says that a file is being read. Percent and stage are reported. `stage` is the key of a text ("import.shapes"),
    // or empty if it is unknown.
    void reading(std::string_view stage = {}) const;
    void read(double fraction) const;
    // Returns the same options, except that the reader reports its progress to this object.
    readers::ReadOptions followed(readers::ReadOptions options) const;
    // Ends the current work. The next work may again take two seconds without a report. When this function returns, no
    // report is under way.
    void done() const;

    // ---- the reporting side ----
    // Calls `say` with the sentence that is due at this time, if any. All times must be from one clock. The two seconds
    // begin with the first call.
    void tell(double now_s, const std::function<void(const std::string&)>& say) const;
    // Waits until there is work, or until end_waiting() has set `stop`. Returns true if there is work.
    bool wait_for_work(const bool& stop) const;
    // Waits for `seconds`, or until `stop` is set or the work is done.
    void wait_s(double seconds, const bool& stop) const;
    void end_waiting(bool& stop) const;

private:
    struct State;
    std::shared_ptr<State> state_;
};

// Writes each sentence that is due as a line to a stream, for a terminal. A separate thread does that. It sleeps while
// there is no work, and receives no signals.
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
