#include "app/core/surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handrail {

std::optional<Vec3> nearest_free_feet(const BodyWorld& world, const Vec3& feet_m, const BodyShape& body) {
    constexpr double kStep_m = 0.1, kFarthest_m = 12.0, kHighest_m = 3.0;
    if (!world.blocked(feet_m, body)) return feet_m;
    for (double ring = kStep_m; ring <= kFarthest_m; ring += kStep_m) {
        const int around = std::max(8, static_cast<int>(2.0 * kPi * ring / kStep_m));
        for (double up = 0.0; up <= std::min(ring, kHighest_m); up += kStep_m)
            for (const double sign : {1.0, -1.0}) {
                if (up == 0.0 && sign < 0.0) continue;
                const double level = std::sqrt(ring * ring - up * up);
                for (int i = 0; i < around; ++i) {
                    const Vec3 place = feet_m + forward_of_heading(2.0 * kPi * i / around) * level + Vec3(0.0, 0.0, sign * up);
                    if (!world.blocked(place, body)) return place;
                }
            }
    }
    return std::nullopt;
}

std::optional<Seen> look(const BodyWorld& world, const Vec3& feet_m, double height_m, double bearing_rad, double range_m) {
    const Vec3 eye = feet_m + Vec3(0.0, 0.0, height_m);
    const TraceHit hit = world.trace(eye, eye + forward_of_heading(bearing_rad) * range_m, BodyShape{}, true);
    if (!hit.hit) return std::nullopt;
    return Seen{bearing_rad, hit.fraction * range_m, hit.feature, hit.end_m};
}

FreeSpace free_space(const BodyWorld& world, const Vec3& feet_m, double height_m, double heading_rad) {
    const auto span = [&](double bearing) {
        const auto one = look(world, feet_m, height_m, bearing), other = look(world, feet_m, height_m, bearing + kPi);
        return one && other ? one->distance_m + other->distance_m : 0.0;
    };
    return {span(heading_rad + kPi / 2.0), span(heading_rad)};
}

namespace {

// Where a thing in that box is looked for: its middle, its nearest point, the middles of its sides; all a little inside.
std::array<Vec3, 8> points_of(const Aabb& box, const Vec3& eye) {
    const Vec3 middle = box.centre_m(), half = 0.5 * box.size_m();
    const auto inside = [&](const Vec3& point) { return middle + (point - middle) * 0.98; };
    std::array<Vec3, 8> points{middle, inside(glm::clamp(eye, box.min_m, box.max_m))};
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) {
            Vec3 point = middle;
            point[axis] += side == 0 ? half[axis] : -half[axis];
            points[static_cast<std::size_t>(2 + 2 * axis + side)] = inside(point);
        }
    return points;
}

}  // namespace

std::vector<Seen> things_in_sight(const BodyWorld& world, const Vec3& feet_m, double height_m, std::size_t most) {
    const Scene& scene = world.scene();
    const Vec3 eye = feet_m + Vec3(0.0, 0.0, height_m);
    const auto level_m = [&](const Vec3& point) { return std::hypot(point.x - eye.x, point.y - eye.y); };
    // Nearest boxes first, so that in a large world only what is near is looked at.
    std::vector<std::pair<double, std::uint32_t>> candidates;
    for (std::uint32_t i = 0; i < scene.features.size(); ++i) {
        const Feature& feature = scene.features[i];
        const bool surface = feature.kind == FeatureKind::Wall || feature.kind == FeatureKind::Floor || feature.kind == FeatureKind::Ceiling ||
                             feature.kind == FeatureKind::Slope;
        if (feature.bounds_m.empty() || feature.kind == FeatureKind::Trigger || (surface && !feature.landmark && !feature.clue)) continue;
        const double nearest_m = level_m(glm::clamp(eye, feature.bounds_m.min_m, feature.bounds_m.max_m));
        if (nearest_m <= kSightRange_m) candidates.emplace_back(nearest_m, i);
    }
    std::sort(candidates.begin(), candidates.end());
    std::vector<Seen> found;
    for (const auto& [nearest_m, i] : candidates) {
        if (found.size() >= most && nearest_m > found[most - 1].distance_m) break;
        const Feature& feature = scene.features[i];
        const bool volume = feature.kind == FeatureKind::Liquid || feature.kind == FeatureKind::Teleport;
        for (const Vec3& point : points_of(feature.bounds_m, eye)) {
            const Vec3 way = point - eye;
            const double distance_m = glm::length(way);
            if (distance_m < 1e-6 || distance_m > kSightRange_m) continue;
            const TraceHit hit = world.trace(eye, point, BodyShape{}, true);
            if (hit.hit ? hit.feature.value != i : !volume) continue;
            const Vec3 seen_m = hit.hit ? hit.end_m : point;
            const Seen seen{std::atan2(way.x, way.y), level_m(seen_m), FeatureId{i}, seen_m};
            found.insert(std::upper_bound(found.begin(), found.end(), seen, [](const Seen& a, const Seen& b) { return a.distance_m < b.distance_m; }), seen);
            break;
        }
    }
    if (found.size() > most) found.resize(most);
    return found;
}

std::optional<Seen> nearest_ahead(const BodyWorld& world, const Vec3& feet_m, double height_m, double heading_rad, double range_m) {
    std::optional<Seen> nearest;
    for (int i = -4; i <= 4; ++i) {
        const auto seen = look(world, feet_m, height_m, heading_rad + i * kPi / 8.0, range_m);
        if (seen && (!nearest || seen->distance_m < nearest->distance_m - 1e-9)) nearest = seen;
    }
    return nearest;
}

}  // namespace handrail
