// Measures a session in office buildings of growing size: when the person can hear, touch and find routes, and the
// longest time for which the app thread is busy. During that measurement the person walks, opens doors, makes queries
// and changes the scale. Run it by hand: build/release/bin/session_ticks [BRUSHES...], or with worlds' files.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <thread>

#include "app/core/session/session.h"
#include "tests/support/names.h"
#include "tests/support/office_world.h"
#include "worlds/base/clock.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace {

const SteadyClock kClock;

// Returns the processor time of the calling thread. It excludes the work of other threads, which may share a core with
// the calling thread.
double busy_ms() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

class Visit {
public:
    explicit Visit(const std::string& world) : world_(world) {}

    bool run() {
        begun_s_ = kClock.now_s();
        Result<Scene> read = made();
        if (!read) {
            fmt::print(stderr, "{}\n", read.error().sentence());
            return false;
        }
        const double read_s = since_begin();
        EnteringWorld ready = make_ready_to_touch(std::make_shared<const Scene>(std::move(*read)));
        const double ready_s = since_begin();
        const std::size_t solids = ready.file->solids.size();
        HandFacts hand;
        hand.present = hand.simulated = true;
        hand.spec = *find_device_spec("sim-t");
        Session app(Settings{}, hand, {.executor = on_threads()});
        const double enter_ms = timed([&] { app.apply(WorldEntered{std::move(ready)}, now_s_); });
        const double touch_s = since_begin();
        until_made(app);
        const double rounded_s = since_begin();
        double query_ms = 0.0, scale_ms = 0.0, door_ms = 0.0;
        const auto act = [&](Command command, double& worst) {
            worst = std::max(worst, timed([&] {
                                 app.apply(CommandDown{command}, now_s_);
                                 app.apply(CommandUp{command}, now_s_);
                             }));
            until_made(app);
        };
        for (const Command request : {Command::WhereAmI, Command::AroundMe, Command::AheadOfMe, Command::LookNext})
            act(request, query_ms);
        for (const Command scale : {Command::ScaleBuilding, Command::ScaleFloor, Command::ScaleRoom,
                                    Command::ScaleDetail, Command::ScaleFloor})
            act(scale, scale_ms);
        const double walk_ms = worst_tick_;
        // Walks along the corridor and opens every door within reach.
        worst_tick_ = 0.0;
        for (int step = 0; step < 60; ++step) {
            app.apply(CommandDown{Command::Forward}, now_s_);
            app.apply(CommandUp{Command::Forward}, now_s_);
            if (step % 6 == 5) act(Command::Use, door_ms);
            ticks(app, 30);
        }
        until_made(app);
        const double doors_ms = worst_tick_;
        fmt::print(
            "| {} | {:.2f} s | {:.2f} s | {:.0f} ms | {:.2f} s | {:.1f} s | {:.1f} ms | {:.1f} ms | {:.1f} ms | {:.1f} "
            "ms |\n",
            solids, read_s, ready_s, enter_ms, touch_s, rounded_s, query_ms, std::max(scale_ms, door_ms), walk_ms,
            doors_ms);
        return true;
    }

private:
    Result<Scene> made() {
        int brushes = 0;
        const auto [end, fault] = std::from_chars(world_.data(), world_.data() + world_.size(), brushes);
        if (fault != std::errc() || end != world_.data() + world_.size()) return read_world(world_, {});
        const std::string map = test::office_world(test::office_size(brushes)).map;
        begun_s_ = kClock.now_s();
        return read_quake_map(map, "office.map");
    }
    double since_begin() const { return kClock.now_s() - begun_s_; }
    template <class Act>
    static double timed(Act&& act) {
        const double begun_ms = busy_ms();
        act();
        return busy_ms() - begun_ms;
    }
    void ticks(Session& app, int count) {
        for (int i = 0; i < count; ++i) {
            now_s_ += 1.0 / 60.0;
            worst_tick_ = std::max(worst_tick_, timed([&] { app.tick(now_s_, ToolState{}); }));
            (void)app.take_cues();
        }
    }
    void until_made(Session& app) {
        ticks(app, 3);
        for (int i = 0; i < 60000 && app.works_in_background(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            ticks(app, 1);
        }
        ticks(app, 60);
    }

    std::string world_;
    double begun_s_ = 0.0, now_s_ = 0.0, worst_tick_ = 0.0;
};

}  // namespace
}  // namespace handrail

int main(int argc, char** argv) {
    std::vector<std::string> worlds(argv + 1, argv + argc);
    if (worlds.empty()) worlds = {"1000", "3000", "10000", "50000"};
    fmt::print(
        "| solids | read | ready | entering | felt sharp | felt rounded | a question | a change of scale, a door's key "
        "| worst tick | with doors |\n");
    fmt::print("|---|---|---|---|---|---|---|---|---|---|\n");
    for (const std::string& world : worlds)
        if (!handrail::Visit(world).run()) return 1;
}
