// Measures how soon the first leg of a route to a room is known, and how long the route occupies the session's thread.
// All times are of the processor, in milliseconds. Run it by hand: build/release/bin/leg_costs [ROUTES [BRUSHES... or
// worlds' files]]. It prints a row for each world: routes to rooms drawn at random, by legs; the median and the longest
// time until the first legs, the longest until all legs, and the longest tick of the session's thread.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "app/core/session/session.h"
#include "tests/support/names.h"
#include "tests/support/office_world.h"
#include "tests/support/project_root.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace {

double busy_ms() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

// Runs each task at once, and notes how long it took.
class Timed : public Executor {
public:
    std::thread run(const char* name, std::function<void()> job) const override {
        const double begun_ms = busy_ms();
        job();
        const double took_ms = busy_ms() - begun_ms;
        all_ms += took_ms;
        if (std::string_view(name) == "word-route") legs_ms.push_back(took_ms);
        return {};
    }
    mutable double all_ms = 0.0;
    mutable std::vector<double> legs_ms;
};

Result<Scene> scene_of(const std::string& world) {
    int brushes = 0;
    const auto [end, fault] = std::from_chars(world.data(), world.data() + world.size(), brushes);
    if (fault != std::errc() || end != world.data() + world.size()) return read_world(world, {});
    return read_quake_map(test::office_world(test::office_size(brushes)).map, "office.map");
}

struct Costs {
    std::vector<double> first_ms;
    double whole_ms = 0.0, session_ms = 0.0;
};

class Visit {
public:
    explicit Visit(std::shared_ptr<const Scene> scene) : app_({}, {}, SessionOptions{.executor = timed_}) {
        app_.apply(WorldEntered{make_ready(std::move(scene))}, now_s_);
        for (int i = 0; i < 60; ++i) tick();
        start_m_ = app_.feet_m();
    }
    // Goes by a route that is drawn from the list of routes.
    void go(std::mt19937& random, Costs& costs) {
        app_.apply(Placed{start_m_, 0.0}, now_s_);
        press(Command::Routes);
        choose(random);
        // Long lists begin with their kinds.
        if (app_.dialogue().is_open()) choose(random);
        for (int i = 0; i < 60; ++i) tick();
        if (timed_.legs_ms.empty()) return;
        costs.first_ms.push_back(timed_.legs_ms.front());
        double whole_ms = 0.0;
        for (const double ms : timed_.legs_ms) whole_ms += ms;
        costs.whole_ms = std::max(costs.whole_ms, whole_ms);
        costs.session_ms = std::max(costs.session_ms, session_ms_);
    }

private:
    template <class Act>
    void time(Act&& act) {
        const double begun_ms = busy_ms(), tasks_ms = timed_.all_ms;
        act();
        session_ms_ = std::max(session_ms_, busy_ms() - begun_ms - (timed_.all_ms - tasks_ms));
    }
    void tick() {
        now_s_ += 1.0 / 60.0;
        time([&] { app_.tick(now_s_, ToolState{}); });
        (void)app_.take_cues();
        (void)app_.take_events();
    }
    void press(Command command) {
        app_.apply(CommandDown{command}, now_s_);
        app_.apply(CommandUp{command}, now_s_);
    }
    void choose(std::mt19937& random) {
        const std::vector<ListItem> items = app_.dialogue().view().items;
        if (items.empty()) return;
        // The first of several entries may end the route that is followed.
        timed_.legs_ms.clear();
        session_ms_ = 0.0;
        const std::size_t first = items.size() > 3 ? 2 : 0;
        const ListItem& item = items[first + random() % (items.size() - first)];
        time([&] { app_.apply(LineTyped{item.name}, now_s_); });
    }

    Timed timed_;
    Session app_;
    double now_s_ = 0.0, session_ms_ = 0.0;
    Vec3 start_m_{0.0};
};

int print_table(int routes, const std::vector<std::string>& worlds) {
    fmt::print("| world | routes | first leg, median | first leg, most | all legs, most | session's thread, most |\n");
    fmt::print("|---|---|---|---|---|---|\n");
    for (const std::string& world : worlds) {
        Result<Scene> scene = scene_of(world);
        if (!scene) return fmt::print(stderr, "{}\n", scene.error().sentence()), 1;
        Visit visit(std::make_shared<const Scene>(std::move(*scene)));
        std::mt19937 random(1);
        Costs costs;
        for (int i = 0; i < routes; ++i) visit.go(random, costs);
        std::sort(costs.first_ms.begin(), costs.first_ms.end());
        if (costs.first_ms.empty()) costs.first_ms.push_back(0.0);
        fmt::print("| {} | {} | {:.0f} | {:.0f} | {:.0f} | {:.1f} |\n",
                   std::filesystem::path(world).filename().string(), costs.first_ms.size(),
                   costs.first_ms[costs.first_ms.size() / 2], costs.first_ms.back(), costs.whole_ms, costs.session_ms);
    }
    return 0;
}

}  // namespace
}  // namespace handrail

int main(int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const int routes = words.empty() ? 20 : std::max(1, std::atoi(words.front().c_str()));
    std::vector<std::string> worlds(words.begin() + (words.empty() ? 0 : 1), words.end());
    if (worlds.empty())
        worlds = {handrail::test::bundled_world("house.map"), handrail::test::bundled_world("school.map")};
    return handrail::print_table(routes, worlds);
}
