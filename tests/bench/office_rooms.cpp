// What finding rooms, exits and ways costs in office buildings of growing size, each in a process of its own so that
// its memory is its own:
//   build/release/bin/office_rooms [brushes] [seed]        by hand, without a number: 1,000, 3,000, 10,000 and 50,000
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "app/core/world/walker.h"
#include "tests/support/office_world.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/readers/reader.h"

namespace handrail {
namespace {

double since(std::chrono::steady_clock::time_point from) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

// The most memory this process has held so far.
double peak_mb() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    return static_cast<double>(used.ru_maxrss) / 1024.0;
}

int measure(int brushes, std::uint32_t seed) {
    test::OfficeWorld office = test::office_world(test::office_size(brushes, seed));
    auto from = std::chrono::steady_clock::now();
    Result<Scene> scene = read_quake_map(office.map, "office.map");
    if (!scene) return std::fprintf(stderr, "%s\n", scene.error().message.c_str()), 1;
    office.map = {};
    const double read_s = since(from), read_mb = peak_mb();
    const BodySize body = body_size(*scene, 0.25);
    from = std::chrono::steady_clock::now();
    auto navigation = Navigation::make(*scene, walk_body(*scene, body.radius_m, body.height_m, body.step_up_m));
    if (!navigation) return std::fprintf(stderr, "%s\n", navigation.error().message.c_str()), 1;
    const double ways_s = since(from), ways_mb = peak_mb();
    from = std::chrono::steady_clock::now();
    const RoomGraph graph = make_rooms(*scene, (*navigation)->space());
    const double rooms_s = since(from), rooms_mb = peak_mb();
    // The way from the start to the farthest room.
    const Vec3 feet = scene->starts.front().feet_m;
    const auto far = std::max_element(graph.rooms.begin(), graph.rooms.end(), [&](const Room& a, const Room& b) {
        return glm::length(a.middle_m - feet) < glm::length(b.middle_m - feet);
    });
    from = std::chrono::steady_clock::now();
    const Route route = (*navigation)->plan(feet, far->middle_m);
    const double plan_s = since(from);
    const WalkSpace& space = (*navigation)->space();
    std::printf(
        "| %d | %.0f | %d | %.2f s | %.2f m | %.2f million | %.2f s | %.2f s | %.0f MB | %.0f MB | %zu | %zu | %.0f m "
        "in %.0f ms%s |\n",
        office.brushes, office.floor_m2, office.doors, read_s, space.cell_m,
        static_cast<double>(space.spans.size()) / 1e6, ways_s, rooms_s, read_mb, std::max(ways_mb, rooms_mb),
        graph.rooms.size(), graph.portals.size(), route.length_m, 1e3 * plan_s, route.reaches ? "" : ", not reached");
    return route.reaches ? 0 : 1;
}

}  // namespace
}  // namespace handrail

int main(int argc, char** argv) {
    std::printf(
        "| brushes | m2 | doors | read | cells | places to stand | ways | rooms | memory when read | memory at most | "
        "rooms found | exits | farthest way |\n");
    std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    std::fflush(stdout);
    const auto seed = argc > 2 ? static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10)) : 1U;
    for (const int brushes : {1'000, 3'000, 10'000, 50'000}) {
        if (argc > 1 && brushes != 1'000) break;
        const pid_t child = fork();
        if (child == 0) {
            const int status = handrail::measure(argc > 1 ? std::atoi(argv[1]) : brushes, seed);
            std::fflush(stdout);
            _exit(status);
        }
        int status = 0;
        if (child < 0 || waitpid(child, &status, 0) != child || status != 0) return 1;
    }
    return 0;
}
