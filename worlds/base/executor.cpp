#include "worlds/base/executor.h"

#include <pthread.h>

#include <memory>
#include <system_error>
#include <utility>

namespace handrail {
namespace {

class AtOnce final : public Executor {
public:
    std::thread run(const char*, std::function<void()> job) const override {
        job();
        return {};
    }
};

class OnThreads final : public Executor {
public:
    std::thread run(const char* name, std::function<void()> job) const override {
        // The job is shared, so that this thread can still run it if no other thread can be started.
        const auto shared = std::make_shared<std::function<void()>>(std::move(job));
        try {
            return std::thread([name, shared] {
                name_this_thread(name);
                (*shared)();
            });
        } catch (const std::system_error&) {
            (*shared)();
            return {};
        }
    }
};

}  // namespace

void name_this_thread(const char* name) noexcept { pthread_setname_np(pthread_self(), name); }

const Executor& at_once() {
    static const AtOnce executor;
    return executor;
}

const Executor& on_threads() {
    static const OnThreads executor;
    return executor;
}

}  // namespace handrail
