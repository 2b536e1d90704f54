#include "worlds/check/gap_width.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handrail::check {
namespace {

constexpr int kDirections = 180;  // directions over half a turn: at 0.5 degrees off, the error is 0.04 mm per metre
constexpr int kPoints = 4;        // points on each side of the place, half a column apart
constexpr double kNoGap_m = 1.0;  // two solids farther apart than this leave a gap wide enough for any body

// Distance from a point along a horizontal direction to the solid. Infinite if the line misses the solid, or the point
// is inside.
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
                // Tests the heights at which a body meets a solid, above what it can step over.
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
