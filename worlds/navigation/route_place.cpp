#include "worlds/navigation/route_place.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "worlds/base/contract.h"

namespace handrail::navigation {

namespace {

// Calls `visit` with the nearest place on each leg, in order.
template <class Visit>
void visit_legs(std::span<const Vec3> points_m, const Vec3& from_m, Visit visit) {
    double before_m = 0.0;
    for (std::size_t leg = 0; leg + 1 < points_m.size(); ++leg) {
        const Vec3 way = points_m[leg + 1] - points_m[leg];
        const double length2 = glm::dot(way, way);
        const double part = length2 > 0.0 ? std::clamp(glm::dot(from_m - points_m[leg], way) / length2, 0.0, 1.0) : 0.0;
        const Vec3 place = points_m[leg] + way * part;
        const double length_m = std::sqrt(length2);
        visit(RoutePlace{place, glm::length(from_m - place), before_m + part * length_m, leg});
        before_m += length_m;
    }
}

}  // namespace

RoutePlace nearest_on_path(std::span<const Vec3> points_m, const Vec3& from_m) {
    contract_pre(!points_m.empty());
    RoutePlace nearest{points_m[0], glm::length(from_m - points_m[0]), 0.0, 0};
    visit_legs(points_m, from_m, [&](const RoutePlace& place) {
        if (place.distance_m < nearest.distance_m) nearest = place;
    });
    return nearest;
}

RoutePlace near_on_path(std::span<const Vec3> points_m, const Vec3& from_m, double along_m, double height_counts,
                        const std::function<bool(const Vec3&)>& sees) {
    contract_pre(!points_m.empty());
    const auto off = [&](Vec3 way) {
        way.z *= height_counts;
        return glm::length(way);
    };
    struct Offer {
        double counts;
        RoutePlace place;
    };
    std::vector<Offer> offers;
    offers.reserve(points_m.size());
    visit_legs(points_m, from_m, [&](RoutePlace place) {
        place.distance_m = off(from_m - place.place_m);
        offers.push_back({place.distance_m + kFartherForEachMetreAlong_m * std::abs(place.along_m - along_m), place});
    });
    std::stable_sort(offers.begin(), offers.end(), [](const Offer& a, const Offer& b) { return a.counts < b.counts; });
    for (const Offer& offer : offers) {
        if (offer.counts > offers.front().counts + kRoundCorner_m) break;
        if (!sees || sees(offer.place.place_m)) return offer.place;
    }
    // No suitable place was found, so the former place is returned.
    RoutePlace stays{points_m[0], 0.0, 0.0, 0};
    for (std::size_t leg = 0; leg + 1 < points_m.size(); ++leg) {
        const double length_m = glm::length(points_m[leg + 1] - points_m[leg]);
        stays.leg = leg;
        if (stays.along_m + length_m >= along_m || leg + 2 == points_m.size()) {
            stays.along_m = std::clamp(along_m, stays.along_m, stays.along_m + length_m);
            break;
        }
        stays.along_m += length_m;
    }
    stays.place_m = place_along(points_m, stays.along_m);
    stays.distance_m = off(from_m - stays.place_m);
    return stays;
}

Vec3 place_along(std::span<const Vec3> points_m, double along_m) {
    contract_pre(!points_m.empty());
    if (!(along_m > 0.0)) return points_m.front();
    for (std::size_t leg = 0; leg + 1 < points_m.size(); ++leg) {
        const Vec3 way = points_m[leg + 1] - points_m[leg];
        const double length_m = glm::length(way);
        if (along_m <= length_m) return points_m[leg] + way * (along_m / length_m);
        along_m -= length_m;
    }
    return points_m.back();
}

}  // namespace handrail::navigation
