#include "worlds/readers/units.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {
namespace {

constexpr std::size_t kMostWarnings = 20;  // as ReadReport::warnings has it
constexpr double kInch_m = 0.0254, kFoot_m = 0.3048;

struct NamedUnit {
    std::string_view name;
    double metres;
};
constexpr std::array kUnits{NamedUnit{"mm", 0.001},   NamedUnit{"cm", 0.01},      NamedUnit{"m", 1.0},
                            NamedUnit{"in", kInch_m}, NamedUnit{"inch", kInch_m}, NamedUnit{"inches", kInch_m},
                            NamedUnit{"ft", kFoot_m}, NamedUnit{"foot", kFoot_m}, NamedUnit{"feet", kFoot_m}};

}  // namespace

std::optional<double> unit_named(std::string_view word) {
    const auto* const found =
        std::find_if(kUnits.begin(), kUnits.end(), [&](const NamedUnit& unit) { return unit.name == word; });
    if (found != kUnits.end()) return found->metres;
    double metres = 0.0;
    if (parse_finite(word, metres) && metres > 0.0) return metres;
    return std::nullopt;
}

void ask_about_unit(Scene& scene) {
    if (scene.bounds_m.empty() || !(scene.metres_per_unit > 0.0)) return;
    const Vec3 size = scene.bounds_m.size_m();
    const double wide_m = std::max(size.x, size.y);
    if (!std::isfinite(wide_m) || wide_m <= 0.0 || (wide_m >= kNarrowestWorld_m && wide_m <= kWidestWorld_m)) return;
    const double units = wide_m / scene.metres_per_unit;
    Diagnostic asked;
    asked.file = scene.source_file;
    asked.message = phrase(
        "reader.unit", {{"wide", wide_m}, {"mm", units * 0.001}, {"inch", units * kInch_m}, {"feet", units * kFoot_m}});
    asked.action = phrase("reader.say_unit");
    std::vector<Diagnostic>& warnings = scene.report.warnings;
    warnings.insert(warnings.begin(), std::move(asked));
    if (warnings.size() > kMostWarnings) warnings.pop_back();
    ++scene.report.warnings_in_all;
}

}  // namespace handrail
