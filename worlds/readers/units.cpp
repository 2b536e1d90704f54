#include "worlds/readers/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/geometry/clip.h"

namespace handrail::readers {
namespace {

constexpr std::size_t kMostWarnings = 20;  // greatest number of warnings, as in ReadReport::warnings
constexpr double kInch_m = 0.0254, kFoot_m = 0.3048;

struct NamedUnit {
    std::string_view name;
    double metres;
};
constexpr std::array kUnits{NamedUnit{"mm", 0.001},   NamedUnit{"cm", 0.01},      NamedUnit{"m", 1.0},
                            NamedUnit{"in", kInch_m}, NamedUnit{"inch", kInch_m}, NamedUnit{"inches", kInch_m},
                            NamedUnit{"ft", kFoot_m}, NamedUnit{"foot", kFoot_m}, NamedUnit{"feet", kFoot_m}};

// True for OBJ, PLY and STL, which state neither units nor axes.
bool states_nothing(const Scene& scene) {
    const std::string& format = scene.report.format;
    return format == "obj" || format == "ply" || format == "stl";
}

void warn_first(Scene& scene, std::string message, std::string action) {
    Diagnostic warning;
    warning.file = scene.source_file;
    warning.message = std::move(message);
    warning.action = std::move(action);
    std::vector<Diagnostic>& warnings = scene.report.warnings;
    warnings.insert(warnings.begin(), std::move(warning));
    if (warnings.size() > kMostWarnings) warnings.pop_back();
    ++scene.report.warnings_in_all;
}

}  // namespace

std::optional<double> unit_named(std::string_view word) {
    const auto* const found =
        std::find_if(kUnits.begin(), kUnits.end(), [&](const NamedUnit& unit) { return unit.name == word; });
    if (found != kUnits.end()) return found->metres;
    double metres = 0.0;
    if (parse_finite(word, metres) && metres > 0.0) return metres;
    return std::nullopt;
}

void question_unit(Scene& scene) {
    if (scene.bounds_m.empty() || !(scene.metres_per_unit > 0.0)) return;
    const Vec3 size = scene.bounds_m.size_m();
    const double wide_m = std::max(size.x, size.y);
    if (!std::isfinite(wide_m) || wide_m <= 0.0) return;
    const bool odd_width = wide_m < kNarrowestWorld_m || wide_m > kWidestWorld_m;
    if (!odd_width && !(states_nothing(scene) && size.z > kHighestMesh_m)) return;
    const double units = wide_m / scene.metres_per_unit;
    warn_first(scene,
               phrase("reader.unit", {{"wide", wide_m},
                                      {"high", size.z},
                                      {"mm", units * 0.001},
                                      {"cm", units * 0.01},
                                      {"inch", units * kInch_m},
                                      {"feet", units * kFoot_m}}),
               phrase("reader.say_unit"));
}

void question_axes(Scene& scene) {
    constexpr double kThin = 0.6, kFlat = 0.99;
    if (scene.bounds_m.empty() || !states_nothing(scene)) return;
    const Vec3 size = scene.bounds_m.size_m();
    if (!(size.y < kThin * size.x && size.y < kThin * size.z)) return;
    Vec3 area_m2_of(0.0);
    for (const SurfacePolygon& surface : scene.surfaces)
        for (int axis = 0; axis < 3; ++axis)
            if (std::abs(surface.normal[axis]) > kFlat) area_m2_of[axis] += area_m2(surface.polygon);
    if (area_m2_of.y > area_m2_of.z && area_m2_of.y > area_m2_of.x)
        warn_first(scene, phrase("reader.on_its_side", {{"deep", size.y}, {"high", size.z}}),
                   phrase("reader.say_upright"));
}

}  // namespace handrail::readers
