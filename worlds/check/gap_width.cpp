#include "worlds/check/gap_width.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handrail::check {
namespace {

// Number of directions tested over half a turn; the best one is at most 0.5 degrees off, an error of 0.04 mm per metre.
constexpr int kDirections = 180;
// Number of points tested on each side of the place, half a column of the walkable space apart.
constexpr int kPoints = 4;
// A gap between two solids that are farther apart than this is wide enough for any body.
constexpr double kNoGap_m = 1.0;

// Returns the distance from a point in a horizontal direction to the solid. Infinite if the line misses the solid or
// the point is inside it.
double way_to(const ConvexSolid& solid, const Vec3& from_m, const Vec2& along) {
    double enter = 0.0, leave = std::numeric_limits<double>::infinity();
    for (const Plane& plane : solid.planes) {
        const double inside = -signed_distance(plane, from_m),
                     speed = plane.normal.x * along.x + plane.normal.y * along.y;
        if (std::abs(speed) < 1e-12) {
            if (inside < 0.0) return std::numeric_limits<double>::infinity();
        } else if (speed > 0.0) {
            leave = std::min(leave, inside / speed);
        } else {
            enter = std::max(enter, inside / speed);
        }
    }
    return enter > 0.0 && enter < leave ? enter : std::numeric_limits<double>::infinity();
}

}  // namespace

double gap_width(const Examined& world, const Vec3& at_m, double about_m) {
    const navigation::WalkerMeasures& body = world.space->body;
    const double close_m = 2.0 * body.cell_m;
    Aabb near{at_m - Vec3(kNoGap_m, kNoGap_m, 0.0), at_m + Vec3(kNoGap_m, kNoGap_m, body.height_m)};
    const std::vector<std::uint32_t> solids = world.solids_near(near);
    double best = std::numeric_limits<double>::infinity();
    for (int px = -kPoints; px <= kPoints; ++px)
        for (int py = -kPoints; py <= kPoints; ++py)
            for (int k = 0; k < kDirections; ++k) {
                const double angle = kPi * k / kDirections;
                const Vec2 along(std::cos(angle), std::sin(angle));
                double ahead = kNoGap_m, behind = kNoGap_m;
                // Tests heights between the highest step that the body can climb and the top of the body.
                for (const double part : {0.0, 0.5, 1.0}) {
                    const double up_m = body.step_up_m + part * (body.height_m - 0.05 - body.step_up_m);
                    const Vec3 from = at_m + Vec3(0.5 * body.cell_m * px, 0.5 * body.cell_m * py, up_m);
                    for (const std::uint32_t s : solids) {
                        ahead = std::min(ahead, way_to(world.scene.solids[s].shape, from, along));
                        behind = std::min(behind, way_to(world.scene.solids[s].shape, from, -along));
                    }
                }
                const double wide = ahead + behind;
                if (wide >= about_m - close_m) best = std::min(best, wide);
            }
    return best <= about_m + close_m ? best : about_m;
}

}  // namespace handrail::check
