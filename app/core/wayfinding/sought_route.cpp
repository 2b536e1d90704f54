#include "app/core/wayfinding/sought_route.h"

#include <algorithm>
#include <cmath>

#include "worlds/navigation/route_place.h"

namespace handrail::core {
namespace {

constexpr double kJump_m = 2.0;  // if the person moves further than this in one update, they were placed elsewhere

double turn_between(const Vec3& before, const Vec3& after) {
    const double lengths = glm::length(before) * glm::length(after);
    return lengths > 0.0 ? std::acos(std::clamp(glm::dot(before, after) / lengths, -1.0, 1.0)) : 0.0;
}

}  // namespace

void SoughtRoute::plan(std::vector<Vec3> points_m, const std::vector<navigation::RoutePassage>& passages, double tail_m,
                       const Vec3& at_m, double now_s) {
    const bool goes_on = known();
    const double announced_before_m = goes_on ? announced_m() : 0.0;
    points_m_ = std::move(points_m);
    planned_s_ = now_s;
    seen_ = true;
    tried_ = true;
    turnings_m_.clear();
    length_m_ = 0.0;
    for (std::size_t i = 0; i + 1 < points_m_.size(); ++i) {
        length_m_ += glm::length(points_m_[i + 1] - points_m_[i]);
        if (i + 2 == points_m_.size() ||
            turn_between(points_m_[i + 1] - points_m_[i], points_m_[i + 2] - points_m_[i + 1]) >= kLeastTurn_rad)
            turnings_m_.push_back(length_m_);
    }
    for (const navigation::RoutePassage& passage : passages)
        if (passage.at_m < length_m_) turnings_m_.push_back(passage.at_m);
    std::sort(turnings_m_.begin(), turnings_m_.end());
    tail_m_ = tail_m;
    eased_m_ = 0.0;
    along_m_ = 0.0;
    at_m_ = at_m;
    if (!known()) return;
    off_m_ = glm::length(at_m - points_m_.front());
    if (goes_on) eased_m_ = announced_before_m - left_m();
}

void SoughtRoute::no_route(double now_s) { plan({}, {}, 0.0, Vec3(0.0), now_s); }

bool SoughtRoute::wants_plan(bool changed, double now_s) const {
    if (!tried_) return true;
    return now_s - planned_s_ >= kAgain_s && (changed || (known() && off_m_ > (seen_ ? kFar_m : kLeft_m)));
}

void SoughtRoute::follow(const Vec3& at_m, double height_counts, const std::function<bool(const Vec3&)>& sees) {
    if (!known()) return;
    const navigation::RoutePlace place =
        navigation::near_on_path(points_m_, at_m, along_m_, height_counts,
                                 [&](const Vec3& on_route_m) { return seen_ = !sees || sees(on_route_m); });
    const double went_m = glm::length(at_m - at_m_);
    along_m_ = place.along_m;
    off_m_ = place.distance_m;
    at_m_ = at_m;
    // The correction shrinks no faster than the person moves. So a person who approaches the thing never hears that the
    // distance grows.
    if (went_m > kJump_m) eased_m_ = 0.0;
    else eased_m_ = std::copysign(std::max(0.0, std::abs(eased_m_) - kEasing * went_m), eased_m_);
}

Vec3 SoughtRoute::next_turning_m() const {
    for (const double turning_m : turnings_m_)
        if (turning_m > along_m_ + kPassed_m) return navigation::place_along(points_m_, turning_m);
    return points_m_.back();
}

Vec3 SoughtRoute::ahead_m(double by_m) const { return navigation::place_along(points_m_, along_m_ + by_m); }

}  // namespace handrail::core
