// Converts degrees of longitude and latitude near a place to metres east and north of it. A plain value; any thread may
// use it.
#pragma once

#include "worlds/base/vec.h"

namespace handrail::floorplan {

// The plane touches the WGS 84 ellipsoid. It is accurate to millimetres over half a kilometre.
class LocalPlane {
public:
    LocalPlane() = default;
    // `origin_deg` is the origin in degrees: x is its longitude, y its latitude.
    explicit LocalPlane(const Vec2& origin_deg) : origin_deg_(origin_deg) {
        // The equatorial radius of the Earth, and its eccentricity squared.
        constexpr double kEarth_m = 6378137.0, kFlatter = 0.00669437999014;
        const double sine = std::sin(radians_from_degrees(origin_deg.y)), rest = 1.0 - kFlatter * sine * sine;
        metres_per_deg_ = {
            radians_from_degrees(kEarth_m / std::sqrt(rest) * std::cos(radians_from_degrees(origin_deg.y))),
            radians_from_degrees(kEarth_m * (1.0 - kFlatter) / (rest * std::sqrt(rest)))};
    }

    // Returns the position in metres. The result is rounded to a tenth of a millimetre, which is finer than the degrees
    // in the files.
    Vec2 place_m(const Vec2& degrees) const {
        const Vec2 at = (degrees - origin_deg_) * metres_per_deg_;
        return {std::round(at.x * 1e4) / 1e4, std::round(at.y * 1e4) / 1e4};
    }

private:
    Vec2 origin_deg_{0.0}, metres_per_deg_{1.0};
};

}  // namespace handrail::floorplan
