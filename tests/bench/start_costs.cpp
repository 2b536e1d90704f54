// What a first and a second start with a world cost, step by step, in seconds of the processor:
//   build/release/bin/start_costs WORLD...
// A second start takes the scene from what was kept of it; all else is made anew each time.
#include <fmt/format.h>

#include <cstdio>
#include <ctime>
#include <functional>

#include "app/import/kept_scene.h"
#include "haptic/compile/compile_haptic.h"
#include "worlds/navigation/nav_mesh.h"
#include "worlds/navigation/navigation.h"
#include "worlds/navigation/rooms.h"
#include "worlds/readers/reader.h"
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
    const std::string kept = kept_file({}, stored(*scene));
    bool whole = false;
    const double kept_s = cpu_s([&] {
        const auto again = scene_in(kept, [](const KeptFrom&) { return true; });
        whole = again && *again;
    });
    if (!whole) return std::fprintf(stderr, "%s cannot be kept\n", file), 1;
    const double touch_s = cpu_s([&] { (void)compile_haptic(*scene, exploring(0.0, 1)); });
    Result<WalkSpace> space = fail("");
    const double columns_s = cpu_s([&] { space = make_walk_space(*scene, {}); });
    if (!space) return std::fprintf(stderr, "%s\n", space.error().sentence().c_str()), 1;
    const double mesh_s = cpu_s([&] { (void)NavMesh::make(*space); });
    const double rooms_s = cpu_s([&] { (void)make_rooms(*scene, *space); });
    const double rest_s = touch_s + columns_s + mesh_s + rooms_s;
    std::printf("| %s | %.2f s | %.3f s, %.1f MB | %.3f s | %.2f s | %.2f s | %.2f s | %.2f s | %.2f s |\n",
                std::filesystem::path(file).filename().c_str(), read_s, kept_s, 1e-6 * static_cast<double>(kept.size()),
                touch_s, columns_s, mesh_s, rooms_s, read_s + rest_s, kept_s + rest_s);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    std::printf(
        "| World | read | from what was kept | for touch | where one can stand | mesh for ways | rooms | a first start "
        "| "
        "a second |\n|---|---|---|---|---|---|---|---|---|\n");
    for (int i = 1; i < argc; ++i)
        if (const int status = measure(argv[i]); status != 0) return status;
    return 0;
}
