// Runs background tasks, either each on a named thread or at once, before run() returns. The program uses threads.
// Tests, scenarios and systems without threads run every task at once. So they execute the same code and get the same
// results at the same moments in every run.
#pragma once

#include <functional>
#include <thread>

namespace handrail {

class Executor {
public:
    virtual ~Executor() = default;
    // Runs `job`. The caller must join the returned thread; if that thread is not joinable, the job is already done.
    // `name` has at most 15 characters and is shown by `top -H`. Any thread may call this.
    virtual std::thread run(const char* name, std::function<void()> job) const = 0;
};

// on_threads() starts a new thread for each job; if the system cannot start one, the job runs at once. at_once() runs
// each job before run() returns.
const Executor& on_threads();
const Executor& at_once();

// Gives the calling thread the name that `top -H` shows. A name has at most 15 characters.
void name_this_thread(const char* name) noexcept;

}  // namespace handrail
