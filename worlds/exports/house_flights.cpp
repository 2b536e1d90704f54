// Finds the climbing direction of stairs, for the text that describes a building.
#include <algorithm>
#include <array>
#include <cmath>

#include "worlds/exports/as_words.h"
#include "worlds/geometry/clip.h"

namespace handrail::exports {
namespace {

constexpr double kTread = 0.7;  // a surface is a tread if the vertical component of its normal is at least this
// Fraction of the climb, from the bottom, that is regarded as the foot of the stairs. The same fraction from the top is
// regarded as their top.
constexpr double kEnd = 0.2;
// If the distance between foot and top is below this fraction of the length of the stairs, they turn back.
constexpr double kTurns = 0.25;
constexpr double kLeastClimb_m = 0.3;

struct FlightTread {
    Vec3 middle_m{0.0};
    double area_m2 = 0.0;
};

std::vector<FlightTread> flight_treads(const Scene& scene, FeatureId stairs) {
    std::vector<FlightTread> treads;
    for (const Solid& solid : scene.solids)
        for (std::size_t f = 0; solid.feature == stairs && f < solid.shape.faces.size(); ++f)
            if (solid.shape.planes[f].normal.z > kTread)
                treads.push_back({centre_of(solid.shape.faces[f]), area_m2(solid.shape.faces[f])});
    for (const MeshTriangle& triangle : scene.triangles) {
        if (!(triangle.feature == stairs)) continue;
        const Vec3 area = area_vector_m2(std::array{triangle.a_m, triangle.b_m, triangle.c_m});
        if (std::abs(area.z) > kTread * glm::length(area))
            treads.push_back({(triangle.a_m + triangle.b_m + triangle.c_m) / 3.0, glm::length(area)});
    }
    return treads;
}

}  // namespace

std::optional<WordsHouse::Flight> flight_of(const Scene& scene, FeatureId stairs) {
    const Feature* feature = scene.find(stairs);
    if (!feature || feature->bounds_m.empty()) return std::nullopt;
    const std::vector<FlightTread> treads = flight_treads(scene, stairs);
    double low_m = 1e300, high_m = -1e300;
    for (const FlightTread& tread : treads)
        low_m = std::min(low_m, tread.middle_m.z), high_m = std::max(high_m, tread.middle_m.z);
    if (!(high_m - low_m > kLeastClimb_m)) return std::nullopt;
    const auto middle_between = [&](double from, double to) {
        Vec2 sum{0.0};
        double area_m2 = 0.0;
        for (const FlightTread& tread : treads)
            if (const double up = (tread.middle_m.z - low_m) / (high_m - low_m); up >= from && up <= to)
                sum += Vec2(tread.middle_m) * tread.area_m2, area_m2 += tread.area_m2;
        return area_m2 > 0.0 ? sum / area_m2 : Vec2(feature->bounds_m.centre_m());
    };
    WordsHouse::Flight flight;
    const Vec2 size(feature->bounds_m.size_m());
    // Rounds to a tenth of a millimetre, like all lengths in the text.
    flight.at_m = glm::round(Vec2(feature->bounds_m.centre_m()) * 1e4) * 1e-4;
    flight.size_m = glm::round(size * 1e4) * 1e-4;
    const Vec2 foot = middle_between(0.0, kEnd), top = middle_between(1.0 - kEnd, 1.0), climb = top - foot;
    const double length = std::max(size.x, size.y);
    flight.back = std::max(std::abs(climb.x), std::abs(climb.y)) < kTurns * length;
    const int axis = flight.back ? (size.x > size.y ? 0 : 1) : (std::abs(climb.x) > std::abs(climb.y) ? 0 : 1);
    // Stairs that turn back have their foot and their top at the same end. Both flights climb away from that end.
    const double way = flight.back ? feature->bounds_m.centre_m()[axis] - 0.5 * (foot + top)[axis] : climb[axis];
    flight.side = axis == 0 ? (way < 0.0 ? 6 : 2) : (way < 0.0 ? 4 : 0);
    return flight;
}

}  // namespace handrail::exports
