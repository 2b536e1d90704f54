#include "worlds/readers/map_soft.h"

#include <array>

#include "worlds/base/text.h"

namespace handrail::readers {
namespace {

constexpr double kLeastStiffness = 0.02, kMostStiffness = 0.6;
constexpr double kShortestRecoveryS = 0.02, kLongestRecoveryS = 60.0;
constexpr double kLeastYieldN = 0.1, kMostYieldN = 4.0;
constexpr double kMostOfThickness = 0.9;  // greatest share of a brush's thickness that may be soft; the rest stays hard
// A face faces a direction if the cosine of the angle between its normal and the direction is above this (45 degrees).
constexpr double kFacesThatWay = 0.7;

struct SideRow {
    std::string_view name;
    Vec3 direction;
};
const std::array kSides{SideRow{"top", {0, 0, 1}},    SideRow{"bottom", {0, 0, -1}}, SideRow{"north", {0, 1, 0}},
                        SideRow{"south", {0, -1, 0}}, SideRow{"east", {1, 0, 0}},    SideRow{"west", {-1, 0, 0}}};

}  // namespace

std::optional<SoftOptions> soft_options_of(const MapEntity& entity, double metres_per_unit, Diagnostics& diagnostics) {
    const MapKey* soft = entity.find("soft");
    if (!soft) return std::nullopt;
    const std::string kind = lower_ascii(trimmed(soft->value).substr(0, 32));
    SoftOptions options;
    options.place = soft->place;
    if (kind != "elastic" && kind != "plastic") {
        diagnostics.warn(soft->place, "map.then_hard", "map.soft_kind", {{"value", excerpt(soft->value)}});
        return std::nullopt;
    }
    options.face.plastic = kind == "plastic";
    const MapKeys keys(diagnostics, metres_per_unit);
    if (const MapKey* depth = entity.find("soft_depth")) {
        options.depth_place = depth->place;
        double value = 1.0;
        if (parse_finite(trimmed(depth->value), value) && value <= 0.0) {
            diagnostics.warn(depth->place, "map.then_hard", "map.soft_no_depth");
            return std::nullopt;
        }
        options.face.depth_m =
            keys.number_of(entity, "soft_depth", 0.0, kFarthestM, "map.range_length").value_or(0.0) * metres_per_unit;
    }
    options.face.stiffness_fraction =
        keys.number_of(entity, "soft_stiffness", kLeastStiffness, kMostStiffness, "map.range")
            .value_or(options.face.stiffness_fraction);
    options.face.recovery_s =
        keys.number_of(entity, "soft_recovery", kShortestRecoveryS, kLongestRecoveryS, "map.range_seconds")
            .value_or(options.face.recovery_s);
    options.face.yield_n = keys.number_of(entity, "soft_yield", kLeastYieldN, kMostYieldN, "map.range_newtons")
                               .value_or(options.face.yield_n);
    if (const MapKey* side = entity.find("soft_side")) {
        const std::string value = lower_ascii(trimmed(side->value).substr(0, 32));
        const auto found =
            std::find_if(kSides.begin(), kSides.end(), [&](const SideRow& row) { return row.name == value; });
        if (found != kSides.end()) {
            options.side = found->direction;
        } else {
            std::vector<std::string> names;
            for (const SideRow& row : kSides) names.emplace_back(row.name);
            diagnostics.warn(side->place, "map.then_top", "map.soft_side",
                             {{"value", excerpt(side->value)}, {"nearest", nearest_name(value, names)}});
        }
    }
    return options;
}

std::optional<SoftFace> soft_face_of(const SoftOptions& options, const ConvexSolid& shape, const std::string& name,
                                     Diagnostics& diagnostics) {
    const std::string what = name.empty() ? phrase("map.this_thing") : name;
    SoftFace soft = options.face;
    double best = kFacesThatWay;
    bool found = false;
    for (std::size_t i = 0; i < shape.planes.size(); ++i)
        if (const double along = glm::dot(shape.planes[i].normal, options.side); along > best) {
            best = along;
            soft.face = static_cast<std::uint32_t>(i);
            found = true;
        }
    if (!found) {
        diagnostics.warn(options.place, "map.then_hard", "map.soft_no_face", {{"name", what}});
        return std::nullopt;
    }
    double lowest = 0.0;  // signed distance from the face to the corner farthest below it
    for (const Polygon& face : shape.faces)
        for (const Vec3& corner : face.points_m)
            lowest = std::min(lowest, signed_distance(shape.planes[soft.face], corner));
    const double most = kMostOfThickness * -lowest;
    if (soft.depth_m <= 0.0) soft.depth_m = 0.5 * -lowest;
    if (soft.depth_m > most) {
        diagnostics.warn(options.depth_place, "map.then_nine_tenths", "map.soft_too_deep", {{"name", what}});
        soft.depth_m = most;
    }
    return soft;
}

}  // namespace handrail::readers
