#include "app/core/wayfinding/leg_clues.h"

#include <algorithm>
#include <cmath>

#include "app/core/context/context_words.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/surroundings.h"
#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"
#include "worlds/scene/models.h"

namespace handrail::core {
namespace {

constexpr double kPassedWithin_m = 1.6;  // largest distance from the walker's centre at which the walker passes a door
constexpr double kEnds_m = 0.4;  // doors within this distance of either end of a leg are not announced as passed
constexpr int kMostPassed = 4;
constexpr double kLandmark_m = 1.5;    // largest distance from the end of the leg to a landmark
constexpr double kWallNextTo_m = 0.9;  // largest distance from the walker's centre to a wall, about an arm's length
constexpr double kWallLeast_m = 2.8;   // a shorter wall is not worth trailing
constexpr double kLookedEvery_m = 0.7;

struct Line {
    Vec3 from_m{0.0}, ahead{0.0}, right{0.0};
    double length_m = 0.0;

    double along(const Vec3& place) const { return glm::dot(place - from_m, ahead); }
    double aside(const Vec3& place) const { return glm::dot(place - from_m, right); }
};

std::string doors_clue(const DirectionsFloor& floor, const Line& line, std::uint32_t except) {
    int left = 0, right = 0;
    const std::vector<navigation::DirectionsDoor>& doors = floor.ground.doors();
    for (std::uint32_t d = 0; d < doors.size(); ++d) {
        const Vec3 at = placed_bounds(doors[d].leaves.front().own_m, doors[d].leaves.front().shut).centre_m();
        const double along_m = line.along(at), aside_m = line.aside(at);
        if (d == except || along_m < kEnds_m || along_m > line.length_m - kEnds_m ||
            std::abs(aside_m) > kPassedWithin_m || std::abs(at.z - line.from_m.z - 1.0) > kAboveOrBelow_m)
            continue;
        ++(aside_m > 0.0 ? right : left);
    }
    if (left + right == 0 || std::max(left, right) > kMostPassed) return {};
    const bool both = left > 0 && right > 0;
    if (both) return phrase("leg.passes_both", {{"left", left}, {"right", right}});
    return right > 0 ? phrase("leg.passes_right", {{"doors", right}}) : phrase("leg.passes_left", {{"doors", left}});
}

MaterialId underfoot(const SessionContext& context, const Vec3& feet_m) {
    const TraceHit hit =
        context.world.solids->trace(feet_m + Vec3(0.0, 0.0, 0.1), feet_m - Vec3(0.0, 0.0, 0.1), WalkerShape{}, true);
    return hit.hit ? hit.material : kDefaultMaterial;
}

std::string floor_clue(const SessionContext& context, const Line& line, const Vec3& to_m) {
    const Scene& scene = *context.world.scene;
    const std::string &before = scene.material(underfoot(context, line.from_m)).name,
                      &then = scene.material(underfoot(context, to_m)).name;
    const std::string spoken = spoken_material(then);
    if (before == then || before.empty() || spoken.empty()) return {};
    return phrase("leg.floor_becomes", {{"material", spoken}});
}

std::string landmark_clue(const SessionContext& context, const Line& line, const Vec3& to_m) {
    const Feature* nearest = nullptr;
    double nearest_m = kLandmark_m;
    for (const Feature& feature : context.world.scene->features) {
        if (!feature.landmark || feature.bounds_m.empty() || feature.name.empty()) continue;
        const double far_m = glm::length(nearest_place(feature.bounds_m, to_m + Vec3(0.0, 0.0, kWaist_m)) - to_m -
                                         Vec3(0.0, 0.0, kWaist_m));
        if (far_m >= nearest_m) continue;
        nearest_m = far_m;
        nearest = &feature;
    }
    if (!nearest) return {};
    const double aside_m = line.aside(nearest->bounds_m.centre_m());
    return phrase(aside_m > 0.0 ? "leg.landmark_right" : "leg.landmark_left", {{"what", spoken_name(*nearest)}});
}

// Returns the clue for a wall that is within reach along the whole leg.
std::string wall_clue(const SessionContext& context, const Line& line) {
    if (line.length_m < kWallLeast_m) return {};
    for (const double side : {1.0, -1.0}) {
        bool all = true;
        for (double at_m = 0.0; at_m <= line.length_m && all; at_m += kLookedEvery_m) {
            const Vec3 from = line.from_m + line.ahead * at_m + Vec3(0.0, 0.0, kWaist_m);
            const TraceHit hit =
                context.world.solids->trace(from, from + line.right * (side * kWallNextTo_m), WalkerShape{}, true);
            const Feature* met = hit.hit ? context.world.scene->find(hit.feature) : nullptr;
            all = met && met->kind == FeatureKind::Wall;
        }
        if (all) return phrase(side > 0.0 ? "leg.wall_right" : "leg.wall_left");
    }
    return {};
}

}  // namespace

std::string leg_clue(const SessionContext& context, const DirectionsFloor& floor, const Vec3& from_m, const Vec3& to_m,
                     int notch, std::uint32_t door) {
    Line line{from_m, forward_of_heading(navigation::notch_heading_rad(notch)),
              right_of_heading(navigation::notch_heading_rad(notch)), 0.0};
    line.length_m = line.along(to_m);
    if (line.length_m < 2.0 * kEnds_m) return {};
    if (std::string passed = doors_clue(floor, line, door); !passed.empty()) return passed;
    if (std::string changes = floor_clue(context, line, to_m); !changes.empty()) return changes;
    if (std::string landmark = landmark_clue(context, line, to_m); !landmark.empty()) return landmark;
    return wall_clue(context, line);
}

}  // namespace handrail::core
