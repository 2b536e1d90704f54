// Measures how long each command occupies the app thread. The result is the longest time of the command and of the
// ticks after it, in milliseconds of that thread's processor time. Run it by hand: build/release/bin/command_costs
// [BRUSHES... or worlds' files]. It prints the table of docs/results/commands.md.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <map>
#include <string>
#include <thread>
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

template <class Act>
double timed(Act&& act) {
    const double begun_ms = busy_ms();
    act();
    return busy_ms() - begun_ms;
}

Result<Scene> scene_of(const std::string& world) {
    int brushes = 0;
    const auto [end, fault] = std::from_chars(world.data(), world.data() + world.size(), brushes);
    if (fault != std::errc() || end != world.data() + world.size()) return read_world(world, {});
    return read_quake_map(test::office_world(test::office_size(brushes)).map, "office.map");
}

// Runs each command in one world and measures its milliseconds.
class Visit {
public:
    explicit Visit(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) { begin(); }
    double of(Command command) {
        double worst_ms = timed([&] {
            app_->apply(CommandDown{command}, now_s_);
            app_->apply(CommandUp{command}, now_s_);
        });
        for (int i = 0; i < 30; ++i) worst_ms = std::max(worst_ms, tick());
        for (int i = 0; i < 5 && app_->dialogue().is_open(); ++i) app_->apply(KeyTapped{"Escape"}, now_s_);
        // An open desk or list would receive the next command, so a new session begins.
        if (app_->dialogue().is_open() || app_->at_desk()) begin();
        (void)app_->take_cues();
        settle();
        return worst_ms;
    }

private:
    void begin() {
        HandFacts hand;
        hand.present = hand.simulated = true;
        hand.spec = *find_device_spec("sim-t");
        app_.emplace(Settings{}, hand, SessionOptions{.executor = on_threads()});
        app_->apply(WorldEntered{make_ready_to_touch(scene_)}, now_s_);
        settle();
    }
    double tick() {
        now_s_ += 1.0 / 60.0;
        const double took_ms = timed([&] { app_->tick(now_s_, ToolState{}); });
        (void)app_->take_cues();
        (void)app_->take_events();
        return took_ms;
    }
    void settle() {
        for (int i = 0; i < 120'000 && app_->works_in_background(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            tick();
        }
        for (int i = 0; i < 30; ++i) tick();
    }

    std::shared_ptr<const Scene> scene_;
    double now_s_ = 0.0;
    std::optional<Session> app_;
};

int print_table(const std::vector<std::string>& worlds) {
    std::map<std::string, std::vector<double>> rows;
    std::string head = "| command |", line = "|---|";
    for (const std::string& world : worlds) {
        Result<Scene> scene = scene_of(world);
        if (!scene) return fmt::print(stderr, "{}\n", scene.error().sentence()), 1;
        Visit visit(std::make_shared<const Scene>(std::move(*scene)));
        for (const CommandInfo& command : command_table())
            if (command.command != Command::Leave) rows[std::string(command.word)].push_back(visit.of(command.command));
        head += fmt::format(" {} |", std::filesystem::path(world).filename().string());
        line += "---|";
    }
    fmt::print("{}\n{}\n", head, line);
    for (const auto& [word, times_ms] : rows) {
        fmt::print("| {} |", word);
        for (const double time_ms : times_ms) fmt::print(" {:.1f} |", time_ms);
        fmt::print("\n");
    }
    return 0;
}

}  // namespace
}  // namespace handrail

int main(int argc, char** argv) {
    std::vector<std::string> worlds(argv + 1, argv + argc);
    if (worlds.empty())
        worlds = {handrail::test::bundled_world("house.map"), handrail::test::bundled_world("school.map")};
    return handrail::print_table(worlds);
}
