// Runs one background task at a time. The owner begins the task and polls for its result each tick. The task is
// cancelled if the owner begins a newer one or destroys this object. Call every function on the owner's thread. The
// executor decides on which thread the work runs. Objects that the work captures are freed on that thread too, so
// freeing large objects costs the owner nothing.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "worlds/base/arrivals.h"
#include "worlds/base/executor.h"

namespace handrail {

template <class Result>
class BackgroundTask {
public:
    // The work must check `stop` often. Its result is dropped if it returns after a stop request.
    using Work = std::function<Result(const std::stop_token& stop)>;

    // The executor and the arrivals must outlive this object. For `name` see Executor::run. `arrivals` decides in which
    // tick take() returns the result; if it is null, take() returns the result as soon as it is done.
    BackgroundTask(const Executor& executor, const char* name, Arrivals* arrivals = nullptr)
        : executor_(executor), name_(name), arrivals_(arrivals) {}
    ~BackgroundTask() {
        give_up();
        if (worker_.joinable()) worker_.join();
    }
    BackgroundTask(const BackgroundTask&) = delete;
    BackgroundTask& operator=(const BackgroundTask&) = delete;

    // Cancels any earlier task and begins this one.
    void begin(Work work) {
        give_up();
        next_ = std::move(work);
        go_on();
    }
    void give_up() {
        if (run_) run_->stop.request_stop();
        next_ = nullptr;
    }
    // True if the task begun last is done. take() then returns its result, or nothing if memory ran out.
    bool ready() const { return !next_ && run_ && run_->done.load(std::memory_order_acquire); }
    // True if a task is waiting to start or is running, or if it is done but take() has not yet returned its result.
    // False for a cancelled task.
    bool busy() const { return next_ || (run_ && !run_->stop.stop_requested()); }
    // Returns the result of the task begun last, once that task is done. If the task ran out of memory, take() never
    // returns a result.
    std::optional<Result> take() {
        std::optional<Result> made;
        Arrivals::there(
            arrivals_, [&] { return (made = take_done()).has_value(); },
            [&] {
                while (run_ && !made) {
                    run_->done.wait(false, std::memory_order_acquire);
                    made = take_done();
                }
            });
        return made;
    }

private:
    std::optional<Result> take_done() {
        if (!run_ || !run_->done.load(std::memory_order_acquire)) return std::nullopt;
        if (worker_.joinable()) worker_.join();
        std::shared_ptr<Run> run = std::move(run_);
        std::optional<Result> made;
        if (!run->stop.stop_requested()) made = std::move(run->made);
        go_on(std::move(run));
        return made;
    }
    struct Run {
        std::stop_source stop;
        std::atomic<bool> done{false};
        std::optional<Result> made;
    };
    // Starts the waiting task, if there is one and no other is running. `before` is the last run with its dropped
    // result; the thread of the next run frees it.
    void go_on(std::shared_ptr<Run> before = nullptr) {
        if (!next_) return;
        if (run_ && run_->done.load(std::memory_order_acquire)) {
            if (worker_.joinable()) worker_.join();
            before = std::move(run_);
        }
        if (run_) return;
        run_ = std::make_shared<Run>();
        worker_ = executor_.run(
            name_, [run = run_.get(), work = std::exchange(next_, nullptr), before = std::move(before)]() mutable {
                before.reset();
                try {
                    run->made = work(run->stop.get_token());
                } catch (const std::bad_alloc&) {
                    run->made.reset();
                }
                if (run->stop.stop_requested()) run->made.reset();
                work = nullptr;
                run->done.store(true, std::memory_order_release);
                run->done.notify_all();
            });
    }

    const Executor& executor_;
    const char* name_;
    Arrivals* arrivals_;
    Work next_;
    std::shared_ptr<Run> run_;
    std::thread worker_;
};

}  // namespace handrail
