// Measures the cost of a first and a second start with a world, step by step, in seconds of processor time:
//   build/release/bin/start_costs WORLD...
// A second start takes the scene, the walkable area and the rooms from the cache. The haptic scene and the mesh are
// built again each time. A background task writes the cache when everything is ready.
#include <fmt/format.h>

#include <cstdio>
#include <ctime>
#include <functional>

#include "app/import/kept_scene.h"
#include "haptic/compile/compile_haptic.h"
#include "tests/support/names.h"
#include "worlds/navigation/nav_mesh.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/readers/reader.h"
#include "worlds/stored/stored_navigation.h"
#include "worlds/stored/stored_scene.h"

namespace {

using namespace handrail;

double cpu_s(const std::function<void()>& work) {
    const auto now = [] {
        timespec t{};
        ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    };
    const double before = now();
    work();
    return now() - before;
}

int measure(const char* file) {
    Result<Scene> scene = fail("");
    const double read_s = cpu_s([&] { scene = read_world(file); });
    if (!scene) return std::fprintf(stderr, "%s\n", scene.error().sentence().c_str()), 1;
    const std::string kept = kept_scene({}, stored::stored(*scene));
    bool whole = false;
    // A .map is always read again, so for a .map the cache contains no scene.
    const bool scene_is_kept = std::filesystem::path(file).extension() != ".map";
    const double kept_s = cpu_s([&] {
        const auto again = scene_in(kept, [](const std::vector<NeighbourFile>&) { return true; });
        whole = again && *again;
    });
    if (!whole) return std::fprintf(stderr, "%s cannot be kept\n", file), 1;
    const double touch_s = cpu_s([&] { (void)compile_haptic(*scene, exploring(0.0, 1)); });
    Result<WalkSpace> space = fail("");
    std::string ways;
    const double columns_s = cpu_s([&] { space = make_walk_space(*scene, {}); });
    if (!space) return std::fprintf(stderr, "%s\n", space.error().sentence().c_str()), 1;
    const double mesh_s = cpu_s([&] { (void)NavMesh::make(*space); });
    RoomGraph graph;
    const double rooms_s = cpu_s([&] { graph = make_rooms(*scene, *space); });
    const double keeping_s = cpu_s([&] { ways = stored_navigation(*space, graph); });
    bool whole_navigation = false;
    const double kept_ways_s =
        cpu_s([&] { whole_navigation = navigation_from(unpacked_navigation(ways), {}, *scene).has_value(); });
    if (!whole_navigation) return std::fprintf(stderr, "the ways of %s cannot be kept\n", file), 1;
    const double rest_s = touch_s + mesh_s;
    std::printf(
        "| %s | %.2f s | %.3f s, %.1f MB | %.3f s | %.2f s | %.2f s | %.2f s | %.2f s | %.2f s, %.1f MB | %.2f s | "
        "%.2f s |\n",
        std::filesystem::path(file).filename().c_str(), read_s, kept_s, 1e-6 * static_cast<double>(kept.size()),
        touch_s, mesh_s, columns_s, rooms_s, keeping_s, kept_ways_s, 1e-6 * static_cast<double>(ways.size()),
        read_s + rest_s + columns_s + rooms_s, (scene_is_kept ? kept_s : read_s) + rest_s + kept_ways_s);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    std::printf(
        "| World | read | from what was kept | for touch | mesh for ways | where one can stand | rooms | keeping both "
        "| "
        "both from what was kept | a first start | a second |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (int i = 1; i < argc; ++i)
        if (const int status = measure(argv[i]); status != 0) return status;
    return 0;
}
