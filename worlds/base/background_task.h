// One background task at a time: begun, queried each tick, and given up when something newer is wanted or its owner
// goes. Every function on the owner's thread; the executor says where the work runs. What the work keeps is also freed
// there, so large things cost the owner nothing.
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
    // Looks at `stop` often; what it returns after that counts for nothing.
    using Work = std::function<Result(const std::stop_token& stop)>;

    // The executor outlives this object. name: as Executor::run has it.
    BackgroundTask(const Executor& executor, const char* name) : executor_(executor), name_(name) {}
    ~BackgroundTask() {
        give_up();
        if (worker_.joinable()) worker_.join();
    }
    BackgroundTask(const BackgroundTask&) = delete;
    BackgroundTask& operator=(const BackgroundTask&) = delete;

    // In place of whatever was begun before.
    void begin(Work work) {
        give_up();
        next_ = std::move(work);
        go_on();
    }
    void give_up() {
        if (run_) run_->stop.request_stop();
        next_ = nullptr;
    }
    // What was begun last is done: take() gives it, or nothing where memory did not suffice.
    bool ready() const { return !next_ && run_ && run_->done.load(std::memory_order_acquire); }
    // Something is on its way that will be there to take.
    bool busy() const { return next_ || (run_ && !run_->stop.stop_requested()); }
    // What was begun last, once it is done; where memory did not suffice for it, never.
    std::optional<Result> take() {
        std::optional<Result> made;
        Arrivals::there([&] { return (made = take_done()).has_value(); },
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
    // `before`: what was made in vain by the last one goes with the next.
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
    Work next_;
    std::shared_ptr<Run> run_;
    std::thread worker_;
};

}  // namespace handrail
