// Runs background tasks: each on a named thread, or at once before the call returns. The program uses threads. Tests,
// scenarios and systems without threads run every task at once, so the same code gives the same results at the same
// moments in every run.
#pragma once

#include <functional>
#include <thread>

namespace handrail {

class Executor {
public:
    virtual ~Executor() = default;
    // Runs `job`. The caller must join the returned thread; if it is not joinable, the job is already done. name: at
    // most 15 characters, shown by `top -H`. Any thread.
    virtual std::thread run(const char* name, std::function<void()> job) const = 0;
};

// A new thread for each job. If the system has no thread left, the job runs at once.
const Executor& on_threads();
const Executor& at_once();

// Gives the calling thread the name that `top -H` shows; at most 15 characters.
void name_this_thread(const char* name) noexcept;

}  // namespace handrail
