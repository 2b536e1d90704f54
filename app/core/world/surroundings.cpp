#include "app/core/world/surroundings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/core/world/body_heights.h"
#include "worlds/base/contract.h"

namespace handrail::core {
std::optional<Vec3> nearest_free_feet(const WalkerWorld& world, const Vec3& feet_m, const WalkerShape& body) {
    contract_pre(is_finite(feet_m));
    constexpr double kStep_m = 0.1, kFarthest_m = 12.0, kHighest_m = 3.0;
    if (!world.blocked(feet_m, body)) return feet_m;
    for (double ring = kStep_m; ring <= kFarthest_m; ring += kStep_m) {
        const int around = std::max(8, static_cast<int>(2.0 * kPi * ring / kStep_m));
        for (double up = 0.0; up <= std::min(ring, kHighest_m); up += kStep_m)
            for (const double sign : {1.0, -1.0}) {
                if (up == 0.0 && sign < 0.0) continue;
                const double level = std::sqrt(ring * ring - up * up);
                for (int i = 0; i < around; ++i) {
                    const Vec3 place =
                        feet_m + forward_of_heading(2.0 * kPi * i / around) * level + Vec3(0.0, 0.0, sign * up);
                    if (!world.blocked(place, body)) return place;
                }
            }
    }
    return std::nullopt;
}

std::optional<Seen> look(const WalkerWorld& world, const Vec3& feet_m, double height_m, double bearing_rad,
                         double range_m) {
    contract_pre(is_finite(feet_m) && std::isfinite(bearing_rad));
    contract_pre(range_m > 0.0);
    const Vec3 eye = feet_m + Vec3(0.0, 0.0, height_m);
    const TraceHit hit = world.trace(eye, eye + forward_of_heading(bearing_rad) * range_m, WalkerShape{}, true);
    if (!hit.hit) return std::nullopt;
    return Seen{bearing_rad, hit.fraction * range_m, hit.feature, hit.end_m};
}

FreeSpace free_space(const WalkerWorld& world, const Vec3& feet_m, double height_m, double heading_rad) {
    contract_pre(is_finite(feet_m) && std::isfinite(heading_rad));
    const auto span = [&](double bearing) {
        const auto one = look(world, feet_m, height_m, bearing), other = look(world, feet_m, height_m, bearing + kPi);
        return one && other ? one->distance_m + other->distance_m : 0.0;
    };
    return {span(heading_rad + kPi / 2.0), span(heading_rad)};
}

namespace {

// Returns the points of a thing in `box` at which the search tries to see the thing: its middle, its nearest point, and
// the middles of its sides. All of them are slightly inside the box.
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

// Visits a tree of boxes, the nearest first, so that only near things are examined in a large world. If a single wall
// or floor hides a whole box, the box is skipped.
std::vector<Seen> things_in_sight(const WalkerWorld& world, const Vec3& feet_m, double height_m, std::size_t most,
                                  int* rays_taken) {
    contract_pre(is_finite(feet_m) && height_m >= 0.0);
    const Scene& scene = world.scene();
    const WalkerWorld::Sights& standing = world.standing();
    const Vec3 eye = feet_m + Vec3(0.0, 0.0, height_m);
    const auto level_m = [&](const Vec3& point) { return std::hypot(point.x - eye.x, point.y - eye.y); };
    const auto nearest_m = [&](const Aabb& box) { return level_m(glm::clamp(eye, box.min_m, box.max_m)); };

    enum class What : std::uint8_t { Node, Feature };
    struct Place {
        double nearest_m;
        What what;
        std::uint32_t number;  // number of the node or feature
        Aabb around;           // box of everything that has the feature's name
        std::uint32_t hider;   // the piece that hid a part of this node or feature, or of a neighbouring one
    };
    const auto farther = [](const Place& a, const Place& b) {
        if (a.nearest_m != b.nearest_m) return a.nearest_m > b.nearest_m;
        if (a.what != b.what) return a.what > b.what;
        return a.number > b.number;
    };
    constexpr std::uint32_t kNoPiece = TraceHit{}.piece;
    std::vector<Place> open;
    const auto add = [&](const Place& place) {
        if (!(place.nearest_m <= kSightRange_m)) return;
        open.push_back(place);
        std::push_heap(open.begin(), open.end(), farther);
    };
    const auto add_feature = [&](FeatureId id, const Aabb& around, std::uint32_t hider) {
        if (const Feature* feature = scene.find(id); feature && named_when_seen(*feature))
            add({nearest_m(feature->bounds_m), What::Feature, id.value, around, hider});
    };
    if (!standing.tree.empty())
        add({nearest_m(standing.tree.nodes()[0].box), What::Node, 0, standing.tree.nodes()[0].box, kNoPiece});
    for (std::size_t i = 0; i < scene.placed.size(); ++i) {
        Aabb around = world.box_of_placed(i);
        if (const Feature* feature = scene.find(scene.placed[i].feature)) around.include(feature->bounds_m);
        add_feature(scene.placed[i].feature, around, kNoPiece);
    }

    std::vector<Seen> found;
    int rays = 0;
    const auto look_at = [&](const Vec3& point) {
        ++rays;
        return world.trace(eye, point, WalkerShape{}, true);
    };
    const auto hidden = [&](std::uint32_t piece, const Aabb& box) {
        return piece != kNoPiece && world.hides(piece, eye, box);
    };
    while (!open.empty() && rays < kMostRays) {
        std::pop_heap(open.begin(), open.end(), farther);
        Place place = open.back();
        open.pop_back();
        if (found.size() >= most && place.nearest_m > found[most - 1].distance_m) break;
        if (hidden(place.hider, place.around)) continue;
        if (place.what == What::Node) {
            const WalkerWorld::Sights& all = standing;
            const BoxIndex::Node& node = all.tree.nodes()[place.number];
            if (!BoxIndex::meets(node.box, {eye, eye})) {
                place.hider = look_at(node.box.centre_m()).piece;
                if (hidden(place.hider, node.box)) continue;
            }
            for (std::uint32_t i = node.first; i < node.first + node.items; ++i) {
                const std::uint32_t item = all.tree.items()[i];
                add_feature(all.features[item], all.boxes[item], place.hider);
            }
            for (std::uint32_t child = node.first; node.items == 0 && child < node.first + 2; ++child)
                add({nearest_m(all.tree.nodes()[child].box), What::Node, child, all.tree.nodes()[child].box,
                     place.hider});
            continue;
        }
        const Feature& feature = scene.features[place.number];
        const bool volume = feature.kind == FeatureKind::Liquid || feature.kind == FeatureKind::Teleport;
        for (const Vec3& point : points_of(feature.bounds_m, eye)) {
            const Vec3 way = point - eye;
            const double distance_m = glm::length(way);
            if (distance_m < 1e-6 || distance_m > kSightRange_m) continue;
            const TraceHit hit = look_at(point);
            if (hit.hit ? hit.feature.value != place.number : !volume) {
                if (hit.hit && hidden(hit.piece, place.around)) break;
                continue;
            }
            const Vec3 seen_m = hit.hit ? hit.end_m : point;
            const Seen seen{std::atan2(way.x, way.y), level_m(seen_m), FeatureId{place.number}, seen_m};
            found.insert(std::upper_bound(found.begin(), found.end(), seen,
                                          [](const Seen& a, const Seen& b) { return a.distance_m < b.distance_m; }),
                         seen);
            break;
        }
    }
    if (rays_taken) *rays_taken = rays;
    if (found.size() > most) found.resize(most);
    return found;
}

std::optional<Seen> nearest_ahead(const WalkerWorld& world, const Vec3& feet_m, double height_m, double heading_rad,
                                  double range_m) {
    std::optional<Seen> nearest;
    for (int i = -4; i <= 4; ++i) {
        const auto seen = look(world, feet_m, height_m, heading_rad + i * kPi / 8.0, range_m);
        if (seen && (!nearest || seen->distance_m < nearest->distance_m - 1e-9)) nearest = seen;
    }
    return nearest;
}

}  // namespace handrail::core
