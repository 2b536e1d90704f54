// Measures the cost of finding rooms, exits and routes in office buildings of growing size. Each building runs in a
// separate process, so that its memory can be measured:
//   build/release/bin/office_rooms [brushes] [seed]        by hand; without a number: 1,000, 3,000, 10,000 and 50,000
//   build/release/bin/office_rooms WORLD...                measures worlds from files instead
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>

#include "app/core/world/walker.h"
#include "tests/support/names.h"
#include "tests/support/office_world.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace {

double since(std::chrono::steady_clock::time_point from) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

// Returns the peak memory of this process in MB.
double peak_mb() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return static_cast<double>(used.ru_maxrss) / 1024.0;
}

// Costs and results of finding routes and rooms in one world.
struct Found {
    double ways_s = 0.0, rooms_s = 0.0, most_mb = 0.0, cell_m = 0.0, farthest_m = 0.0, plan_s = 0.0;
    std::size_t places = 0, rooms = 0, exits = 0;
    bool reaches = false;
};

std::optional<Found> find(const Scene& scene) {
    Found found;
    const WalkerSize body = walker_size(scene, 0.25);
    auto from = std::chrono::steady_clock::now();
    auto navigation = Navigation::make(scene, walker_measures(scene, body.radius_m, body.height_m, body.step_up_m));
    if (!navigation) return std::fprintf(stderr, "%s\n", navigation.error().message.c_str()), std::nullopt;
    found.ways_s = since(from);
    const WalkSpace& space = (*navigation)->space();
    from = std::chrono::steady_clock::now();
    const RoomGraph graph = make_rooms(scene, space);
    found.rooms_s = since(from);
    found.most_mb = peak_mb();
    found.cell_m = space.cell_m;
    found.places = space.spans.size();
    found.rooms = graph.rooms.size();
    found.exits = graph.portals.size();
    // Plans the route from the start to the farthest room.
    const Vec3 feet = scene.starts.front().feet_m;
    const auto far = std::max_element(graph.rooms.begin(), graph.rooms.end(), [&](const Room& a, const Room& b) {
        return glm::length(a.middle_m - feet) < glm::length(b.middle_m - feet);
    });
    if (far == graph.rooms.end()) return found;
    from = std::chrono::steady_clock::now();
    const Route route = (*navigation)->plan(feet, far->middle_m);
    found.plan_s = since(from);
    found.farthest_m = route.length_m;
    found.reaches = route.reaches;
    return found;
}

int measure(int brushes, std::uint32_t seed) {
    test::OfficeWorld office = test::office_world(test::office_size(brushes, seed));
    const auto from = std::chrono::steady_clock::now();
    Result<Scene> scene = read_quake_map(office.map, "office.map");
    if (!scene) return std::fprintf(stderr, "%s\n", scene.error().message.c_str()), 1;
    office.map = {};
    const double read_s = since(from), read_mb = peak_mb();
    const std::optional<Found> found = find(*scene);
    if (!found) return 1;
    std::printf(
        "| %d | %.0f | %d | %.2f s | %.2f m | %.2f million | %.2f s | %.2f s | %.0f MB | %.0f MB | %zu | %zu | %.0f m "
        "in %.0f ms%s |\n",
        office.brushes, office.floor_m2, office.doors, read_s, found->cell_m, static_cast<double>(found->places) / 1e6,
        found->ways_s, found->rooms_s, read_mb, found->most_mb, found->rooms, found->exits, found->farthest_m,
        1e3 * found->plan_s, found->reaches ? "" : ", not reached");
    return found->reaches ? 0 : 1;
}

// Measures a world from a file. If its farthest room cannot be reached on foot, that is a result and not a failure.
int measure_file(const char* file) {
    Result<Scene> scene = read_world(file);
    if (!scene) return std::fprintf(stderr, "%s\n", scene.error().sentence().c_str()), 1;
    const std::optional<Found> found = find(*scene);
    if (!found) return 1;
    std::printf("| %s | %zu | %.2f m | %.0f ms | %.0f ms | %.0f MB | %zu | %zu | %.0f m in %.1f ms%s |\n",
                std::filesystem::path(file).stem().c_str(), found->places, found->cell_m, 1e3 * found->ways_s,
                1e3 * found->rooms_s, found->most_mb, found->rooms, found->exits, found->farthest_m,
                1e3 * found->plan_s, found->reaches ? "" : ", short of it");
    return 0;
}

// Runs `work` in a separate process. Returns false if that failed.
bool apart(const std::function<int()>& work) {
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        const int status = work();
        std::fflush(stdout);
        _exit(status);
    }
    int status = 0;
    return child >= 0 && waitpid(child, &status, 0) == child && status == 0;
}

}  // namespace
}  // namespace handrail

int main(int argc, char** argv) {
    if (argc > 1 && std::atoi(argv[1]) == 0) {
        std::printf(
            "| World | Places to stand | Cell | Columns and mesh | Rooms | Memory at most | Rooms found | Exits | "
            "Farthest way |\n|---|---|---|---|---|---|---|---|---|\n");
        for (int i = 1; i < argc; ++i)
            if (!handrail::apart([&] { return handrail::measure_file(argv[i]); })) return 1;
        return 0;
    }
    std::printf(
        "| brushes | m2 | doors | read | cells | places to stand | ways | rooms | memory when read | memory at most | "
        "rooms found | exits | farthest way |\n");
    std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    const auto seed = argc > 2 ? static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)) : 1U;
    for (const int brushes : {1'000, 3'000, 10'000, 50'000}) {
        if (argc > 1 && brushes != 1'000) break;
        const int wanted = argc > 1 ? std::atoi(argv[1]) : brushes;
        if (!handrail::apart([&] { return handrail::measure(wanted, seed); })) return 1;
    }
    return 0;
}
