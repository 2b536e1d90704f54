// The part of SpokenRoute about obstacles that have just stopped the walker on the route. Use it on the app thread
// only.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "app/core/wayfinding/leaf_ahead.h"
#include "app/core/wayfinding/spoken_route.h"

namespace handrail::core {
namespace {

constexpr double kStoppedHere_m = 0.25;  // a walker farther from a stop has left it
// If an open leaf has stopped the walker more often than this, shutting it does not help: it touches the walker.
constexpr int kShutTries = 2;

}  // namespace

void SpokenRoute::note_stop(FeatureId by) {
    directions_.note_stop(by);
    // Keeps the places aside that were announced after stops near here, because they did not help.
    constexpr double kNear_m = 3.0;
    const Vec3& feet_m = context_.avatar.feet_m();
    const int times = stopped_ && stopped_->by == by ? stopped_->times + 1 : 1;
    std::vector<Vec3> tried_m;
    if (stopped_ && glm::length(stopped_->at_m - feet_m) < kNear_m) {
        tried_m = std::move(stopped_->tried_m);
        if (stopped_->aside_m) tried_m.push_back(*stopped_->aside_m);
    }
    stopped_ = Stop{by, feet_m, context_.avatar.heading_rad, times, std::move(tried_m), {}, false};
}

void SpokenRoute::leave_stop() {
    if (stopped_ && glm::length(stopped_->at_m - context_.avatar.feet_m()) > kStoppedHere_m) stopped_->left = true;
}

// Returns true if something has just stopped the walker here, on the way to `to_m`.
bool SpokenRoute::stopped_towards(const Vec3& to_m) const {
    constexpr double kThatWay_rad = 0.8;
    const Vec3 way = to_m - context_.avatar.feet_m();
    return stopped_ && !stopped_->left && glm::length(stopped_->at_m - context_.avatar.feet_m()) < kStoppedHere_m &&
           std::abs(wrap_angle(std::atan2(way.x, way.y) - stopped_->heading_rad)) < kThatWay_rad;
}

// If anything but a door has just stopped the walker here on the way to `to_m`, returns a place one step aside from
// which the walker comes closest to `to_m`. The plan passes the obstacle by less than the width of a cell, or the
// spoken direction, which is rounded, does not pass it. So the same direction would stop the walker again. A place that
// was announced after an earlier stop near here is not announced again, since the walker came back from it.
std::optional<Vec3> SpokenRoute::place_aside(const Vec3& to_m) const {
    // In directions nearer to the obstacle or more straight back, the walker would meet the obstacle again.
    constexpr int kLeast_notches = 3, kMost_notches = 6;
    constexpr double kLeast_m = 0.1, kSame_m = 0.2;
    if (!stopped_towards(to_m)) return std::nullopt;
    const Feature* const met = context_.world.scene->find(stopped_->by);
    const std::shared_ptr<const DirectionsFloor> floor = ground_.floor();
    const bool door = met && met->kind == FeatureKind::Door;
    if ((door && !(is_open_leaf(stopped_->by) && stopped_->times > kShutTries)) || !floor) return std::nullopt;
    const navigation::BlindGround& ground = floor->ground;
    const navigation::BlindWalker here = ground.body_at(context_.avatar.feet_m());
    if (here.span == navigation::kNothing) return std::nullopt;
    const navigation::DoorsOpen open = ground_.open_now(*floor);
    std::optional<Vec3> best;
    double best_m = std::numeric_limits<double>::infinity();
    for (int notches = -kMost_notches; notches <= kMost_notches; ++notches) {
        if (std::abs(notches) < kLeast_notches) continue;
        navigation::BlindWalker body = here;
        ground.walk(body, stopped_->heading_rad + navigation::notch_heading_rad(notches), floor->step_m,
                    navigation::PaceEnd::Steps, open);
        const Vec3 aside_m = ground.feet_m(body), way = to_m - aside_m;
        ground.walk(body, std::atan2(way.x, way.y), std::hypot(way.x, way.y), navigation::PaceEnd::Steps, open);
        // Of places that are equally good, the one with the most room is best.
        const double left_m = glm::length(to_m - ground.feet_m(body)) -
                              static_cast<double>(ground.space().spans[ground.body_at(aside_m).span].clearance_m);
        const bool tried = std::any_of(stopped_->tried_m.begin(), stopped_->tried_m.end(), [&](const Vec3& earlier_m) {
            return glm::length(aside_m - earlier_m) < kSame_m;
        });
        if (tried || left_m >= best_m || glm::length(aside_m - context_.avatar.feet_m()) < kLeast_m) continue;
        best_m = left_m;
        best = aside_m;
    }
    return best;
}

bool SpokenRoute::is_open_leaf(FeatureId by) const {
    const int mover = mover_of(context_.world, by);
    const Feature* const met = context_.world.scene->find(by);
    return mover >= 0 && met && met->kind == FeatureKind::Door &&
           context_.world.scene->movers[static_cast<std::size_t>(mover)].by_hand &&
           !shut(context_.world, static_cast<std::uint32_t>(mover));
}

// Returns the door whose leaf blocks the straight line to `to_m`, or whose leaf has just stopped the walker here. A
// leaf that meets only a shoulder also blocks, even if the plan passes that leaf. The text is empty if there is no such
// leaf, or if shutting it has not helped.
std::string SpokenRoute::leaf_on_route(const Vec3& to_m) const {
    if (stopped_towards(to_m) && stopped_->times > kShutTries) return {};
    std::string leaf = leaf_name(context_, leaf_ahead(context_, std::array{context_.avatar.feet_m(), to_m}));
    if (!leaf.empty() || !stopped_towards(to_m)) return leaf;
    return leaf_name(context_, is_open_leaf(stopped_->by) ? stopped_->by : kNoFeature);
}

}  // namespace handrail::core
