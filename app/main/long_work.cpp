#include "app/main/long_work.h"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

#include "worlds/base/clock.h"
#include "worlds/base/executor.h"
#include "worlds/base/language.h"
#include "worlds/base/patience.h"

namespace handrail::program {

struct LongWork::State {
    std::mutex mutex;  // locked while a sentence is reported, so that no sentence is reported after done() has returned
    std::condition_variable changed;
    bool under_way = false, reads = false;
    std::string what;  // the current work in words; while a file is read, the stage of reading, which may be empty
    int percent = 0;
    std::optional<Patience> patience;  // decides when a sentence is due; created by the first call of report()
    std::function<void(const std::string&)> noted;

    std::string words(double now_s) const {
        if (!reads)
            return phrase("program.so_far", {{"what", what}, {"seconds", std::lround(patience->waited_s(now_s))}});
        if (what.empty()) return phrase("program.loading", {{"percent", percent}});
        return phrase("program.loading_at", {{"percent", percent}, {"stage", what}});
    }
};

LongWork LongWork::begun(std::function<void(const std::string&)> noted) {
    LongWork progress;
    progress.state_ = std::make_shared<State>();
    progress.state_->noted = std::move(noted);
    return progress;
}

void LongWork::at(std::string what) const {
    if (!state_) return;
    if (state_->noted) state_->noted(what);
    const std::lock_guard lock(state_->mutex);
    state_->what = std::move(what);
    state_->reads = false;
    state_->under_way = true;
    state_->changed.notify_all();
}

void LongWork::reading(std::string_view stage) const {
    if (!state_) return;
    std::string what = stage.empty() ? std::string() : phrase(stage);
    if (state_->noted) state_->noted(what.empty() ? phrase("import.file") : what);
    const std::lock_guard lock(state_->mutex);
    state_->what = std::move(what);
    if (!std::exchange(state_->reads, true)) state_->percent = 0;
    state_->under_way = true;
    state_->changed.notify_all();
}

void LongWork::read(double fraction) const {
    if (!state_) return;
    const std::lock_guard lock(state_->mutex);
    state_->percent = static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0));
}

readers::ReadOptions LongWork::followed(readers::ReadOptions options) const {
    if (!state_) return options;
    reading();
    options.progress = [to = *this](double fraction) { to.read(fraction); };
    options.stage = [to = *this](std::string_view stage) { to.reading(stage); };
    return options;
}

void LongWork::done() const {
    if (!state_) return;
    if (state_->noted) state_->noted({});
    const std::lock_guard lock(state_->mutex);
    state_->under_way = state_->reads = false;
    state_->patience.reset();
    state_->changed.notify_all();
}

void LongWork::report(double now_s, const std::function<void(const std::string&)>& say) const {
    if (!state_) return;
    const std::lock_guard lock(state_->mutex);
    if (!state_->under_way) return;
    if (!state_->patience) state_->patience.emplace(now_s);
    if (state_->patience->due(now_s)) say(state_->words(now_s));
}

bool LongWork::wait_for_work(const bool& stop) const {
    if (!state_) return false;
    std::unique_lock lock(state_->mutex);
    state_->changed.wait(lock, [&] { return stop || state_->under_way; });
    return !stop;
}

void LongWork::wait_s(double seconds, const bool& stop) const {
    if (!state_) return;
    std::unique_lock lock(state_->mutex);
    state_->changed.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return stop || !state_->under_way; });
}

void LongWork::end_waiting(bool& stop) const {
    if (!state_) return;
    const std::lock_guard lock(state_->mutex);
    stop = true;
    state_->changed.notify_all();
}

LongWorkLines::LongWorkLines(const LongWork& progress, std::ostream& to) : progress_(progress) {
    constexpr double kLook_s = 0.25;
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);  // the new thread inherits this signal mask, which blocks all signals
    thread_ = std::thread([this, &to] {
        name_this_thread("progress");
        const SteadyClock clock;
        while (progress_.wait_for_work(stop_)) {
            progress_.report(clock.now_s(), [&to](const std::string& words) { to << words + "\n" << std::flush; });
            progress_.wait_s(kLook_s, stop_);
        }
    });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

LongWorkLines::~LongWorkLines() {
    progress_.end_waiting(stop_);
    thread_.join();
}

}  // namespace handrail::program
