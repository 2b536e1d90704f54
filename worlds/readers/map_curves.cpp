#include "worlds/readers/map_curves.h"

#include <algorithm>

#include "worlds/base/language.h"

namespace handrail::readers {
namespace {

// Converts to millimetres for messages. Values below a millionth of a millimetre become 0.
double in_millimetres(double m) { return m < 1e-9 ? 0.0 : 1e3 * m; }

}  // namespace

void MapCurves::bend(Scene& scene, double chord_m, const std::stop_token& stop) {
    if (bent_.empty()) return;
    constexpr std::size_t kMostTriangles = 400'000;
    for (int round = 0; round < 40; ++round, chord_m *= 2.0) {
        std::size_t all = 0;
        for (const MapCurve& bent : bent_) all += stop.stop_requested() ? 0 : triangles_of_patch(bent.grid, chord_m);
        if (all <= kMostTriangles) break;
    }
    double error_m = 0.0;
    for (const MapCurve& bent : bent_) {
        if (stop.stop_requested()) return;
        const PatchMesh made = tessellate(bent.grid, chord_m);
        error_m = std::max(error_m, made.error_m);
        Feature& feature = scene.features[bent.feature.value];
        for (const Corners& t : made.mesh.triangles) {
            const Vec3 &a = made.mesh.points_m[t[0]], &b = made.mesh.points_m[t[1]], &c = made.mesh.points_m[t[2]];
            scene.triangles.push_back({a, b, c, bent.feature, bent.material, bent.side});
            feature.area_m2 += 0.5 * glm::length(glm::cross(b - a, c - a));
            for (const Vec3& p : {a, b, c}) {
                feature.bounds_m.include(p);
                scene.bounds_m.include(p);
            }
        }
    }
    scene.report.patches = static_cast<int>(bent_.size());
    scene.report.simplified.push_back(phrase("map.curves_cut", {{"n", bent_.size()},
                                                                {"triangles", scene.triangles.size()},
                                                                {"error", in_millimetres(error_m)},
                                                                {"bound", in_millimetres(chord_m)}}));
}

}  // namespace handrail::readers
