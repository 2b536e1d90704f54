#include "worlds/ifc/door_trial.h"

#include <algorithm>
#include <array>

#include "worlds/geometry/clip.h"

namespace handrail::ifc {
namespace {

// Measures of the walker: half of the width, height, and the highest step up and down.
constexpr double kBodyHalf_m = 0.25, kBodyTall_m = 1.8, kBodyStep_m = 0.25, kBodyDrop_m = 1.0;
constexpr double kOnlyTouch_m = 0.01;   // an overlap of at most this depth is treated as mere contact
constexpr double kTrialPace_m = 0.1;    // distance between two successive positions at which the walker is tested
constexpr double kStandsAway_m = 0.25;  // distance from the faces of the wall at which the walk starts and ends
constexpr double kFloorAway_m = 0.6;    // distance from the faces of the wall at which there must be a floor
constexpr double kDeepestWay_m = 6.0;   // greatest thickness of a wall that a door leads through

std::vector<Aabb> boxes_of_solids(const Scene& scene) {
    std::vector<Aabb> boxes;
    boxes.reserve(scene.solids.size());
    for (const Solid& solid : scene.solids) boxes.push_back(solid.shape.bounds_m);
    return boxes;
}
std::vector<Aabb> boxes_of_triangles(const Scene& scene) {
    std::vector<Aabb> boxes;
    boxes.reserve(scene.triangles.size());
    for (const auto& triangle : scene.triangles) {
        Aabb box;
        for (const Vec3& corner : {triangle.a_m, triangle.b_m, triangle.c_m}) box.include(corner);
        boxes.push_back(box);
    }
    return boxes;
}

// Returns the range of heights of the part of a flat piece that is between four vertical planes.
std::optional<Reach> height_within(std::vector<Vec3> points, const std::array<Plane, 4>& square) {
    std::vector<Vec3> scratch;
    for (const Plane& plane : square) {
        keep_back(points, plane, 1e-9, scratch);
        if (points.size() < 3) return std::nullopt;
    }
    Reach reach{1e300, -1e300};
    for (const Vec3& p : points) reach = {std::min(reach.least, p.z), std::max(reach.most, p.z)};
    return reach;
}

}  // namespace

std::string_view key_of(DoorTrialEnd end) {
    constexpr std::array<std::string_view, 5> kWords{"", "door_trial.in_the_way", "door_trial.small", "door_trial.step",
                                                     "door_trial.no_floor"};
    return kWords[static_cast<std::size_t>(end)];
}

DoorTrials::DoorTrials(const Scene& scene)
    : scene_(scene), solids_(boxes_of_solids(scene)), triangles_(boxes_of_triangles(scene)) {}

std::vector<DoorTrials::Stretch> DoorTrials::column(const Frame& axes, double x_m, double y_m, double half_m,
                                                    const Reach& height) const {
    const Vec3 middle = axes.at({x_m, y_m, 0.0});
    const double x = glm::dot(axes.x, middle), y = glm::dot(axes.y, middle);
    const std::array<Plane, 4> square{Plane{axes.x, x + half_m}, Plane{-axes.x, -x + half_m}, Plane{axes.y, y + half_m},
                                      Plane{-axes.y, -y + half_m}};
    Aabb box;
    for (const double dx : {-half_m, half_m})
        for (const double dy : {-half_m, half_m})
            for (const double z : {height.least, height.most}) {
                const Vec3 at = axes.at({x_m + dx, y_m + dy, 0.0});
                box.include({at.x, at.y, z});
            }
    std::vector<Stretch> found;
    std::vector<std::uint32_t> near;
    solids_.find(box, near);
    for (const std::uint32_t s : near) {
        const Solid& solid = scene_.solids[s];
        if (solid.role != SolidRole::Solid) continue;
        Stretch stretch{1e300, -1e300, solid.source.line};
        for (const Polygon& face : solid.shape.faces)
            if (const std::optional<Reach> reach = height_within(face.points_m, square))
                stretch.low_m = std::min(stretch.low_m, reach->least),
                stretch.high_m = std::max(stretch.high_m, reach->most);
        if (stretch.low_m <= stretch.high_m) found.push_back(stretch);
    }
    triangles_.find(box, near);
    for (const std::uint32_t t : near) {
        const auto& triangle = scene_.triangles[t];
        const Feature* feature = scene_.find(triangle.feature);
        if (const std::optional<Reach> reach = height_within({triangle.a_m, triangle.b_m, triangle.c_m}, square))
            found.push_back({reach->least, reach->most, feature ? feature->source.line : 0});
    }
    return found;
}

DoorTrial DoorTrials::walk(const WallGap& gap, double x_m, bool back) const {
    const double level_m = gap.axes.at({x_m, 0.0, gap.least_m.z}).z;
    const double from_m = gap.least_m.y - kStandsAway_m, to_m = gap.most_m.y + kStandsAway_m;
    const Reach height{level_m - kBodyDrop_m - kBodyTall_m, level_m + kBodyTall_m + 2.0 * kBodyDrop_m};
    const int paces = std::max(1, static_cast<int>(std::ceil((to_m - from_m) / kTrialPace_m)));
    double feet_m = level_m;
    for (int i = 0; i <= paces; ++i) {
        const double part = static_cast<double>(back ? paces - i : i) / paces;
        const double y_m = from_m + part * (to_m - from_m);
        const std::vector<Stretch> here = column(gap.axes, x_m, y_m, kBodyHalf_m - kOnlyTouch_m, height);
        double floor_m = -1e300;
        for (const Stretch& one : here)
            if (one.high_m <= feet_m + kBodyStep_m + kOnlyTouch_m && one.high_m >= feet_m - kBodyDrop_m)
                floor_m = std::max(floor_m, one.high_m);
        if (floor_m == -1e300) return {DoorTrialEnd::NoFloor, {}, 0.0};
        feet_m = floor_m;
        DoorTrial met{DoorTrialEnd::Blocking, {}, 0.0};
        for (const Stretch& one : here)
            if (one.high_m > feet_m + kOnlyTouch_m && one.low_m < feet_m + kBodyTall_m - kOnlyTouch_m) {
                met.lines.push_back(one.line);
                // Measures a step only if the obstacle is lower than a lintel, so that a walker could stand on it.
                if (one.high_m < level_m + kBodyDrop_m) met.step_m = std::max(met.step_m, one.high_m - feet_m);
                else met.step_m = 1e9;
            }
        if (met.lines.empty()) continue;
        std::sort(met.lines.begin(), met.lines.end());
        met.lines.erase(std::unique(met.lines.begin(), met.lines.end()), met.lines.end());
        if (met.step_m < 2.0 * kBodyDrop_m) met.end = DoorTrialEnd::Step;
        return met;
    }
    for (const double y_m : {gap.least_m.y - kFloorAway_m, gap.most_m.y + kFloorAway_m}) {
        bool anything = false;
        for (const Stretch& one : column(gap.axes, x_m, y_m, 0.05, height))
            anything = anything || (one.high_m > level_m - kBodyDrop_m && one.low_m < level_m + kBodyTall_m);
        if (!anything) return {DoorTrialEnd::NoFloor, {}, 0.0};
    }
    return {};
}

DoorTrial DoorTrials::try_door(const WallGap& gap) const {
    const double width_m = gap.most_m.x - gap.least_m.x, height_m = gap.most_m.z - gap.least_m.z;
    if (width_m < 2.0 * (kBodyHalf_m - kOnlyTouch_m) || height_m < kBodyTall_m - kBodyStep_m ||
        gap.most_m.y - gap.least_m.y > kDeepestWay_m)
        return {DoorTrialEnd::Small, {}, 0.0};
    DoorTrial first;
    const double aside_m = std::max(0.0, 0.5 * width_m - kBodyHalf_m), middle_m = 0.5 * (gap.least_m.x + gap.most_m.x);
    for (const double aside : {0.0, -0.5, 0.5, -1.0, 1.0}) {
        DoorTrial trial;
        for (const bool back : {false, true})
            if (trial.end == DoorTrialEnd::Passed) trial = walk(gap, middle_m + aside * aside_m, back);
        if (trial.end == DoorTrialEnd::Passed) return {};
        if (aside == 0.0) first = std::move(trial);
    }
    if (first.end == DoorTrialEnd::Blocking && height_m < kBodyTall_m) first.end = DoorTrialEnd::Small;
    return first;
}

}  // namespace handrail::ifc
