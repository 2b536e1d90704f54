#include "worlds/navigation/walk_clearance.h"

#include <cmath>
#include <vector>

#include "worlds/geometry/box_index.h"

namespace handrail::navigation {
namespace {

constexpr int kSampledColumns = 8'192;

}  // namespace

double standable_m2(const Obstacles& obstacles, const WalkerMeasures& body, const NearGround& ground,
                    double exact_enough_m2) {
    // Limits the estimate: the floor area cannot exceed the area of the tops of all obstacles together.
    std::vector<double> so_far;
    so_far.reserve(obstacles.all.size());
    double tops_m2 = 0.0;
    for (const WalkObstacle& o : obstacles.all) {
        const Vec3 size = o.box_m.size_m();
        so_far.push_back(tops_m2 += size.x * size.y);
    }
    for (const PassingFloor& o : obstacles.passing) tops_m2 += o.shape.box_m.size_m().x * o.shape.box_m.size_m().y;
    if (tops_m2 <= exact_enough_m2 || so_far.empty()) return tops_m2;
    // Samples columns that are spread evenly over the tops. If m tops overlap in a column, each place to stand in that
    // column adds 1/m to the sum.
    const BoxIndex index(boxes_of(obstacles.all));
    std::vector<std::uint32_t> near;
    std::vector<ColumnInterval> intervals;
    double places = 0.0;
    for (int k = 0; k < kSampledColumns; ++k) {
        const double at = (k + 0.5) / kSampledColumns * so_far.back();
        const auto chosen = std::min<std::size_t>(
            static_cast<std::size_t>(std::lower_bound(so_far.begin(), so_far.end(), at) - so_far.begin()),
            so_far.size() - 1);
        const Aabb& box = obstacles.all[chosen].box_m;
        // The whole part is not used. The fractions form Roberts' sequence, which is even over the plane and never in
        // step with a building's own grid.
        double part;
        const Vec3 size = box.size_m();
        const double x = box.min_m.x + size.x * std::modf((k + 1) * 0.7548776662466927, &part),
                     y = box.min_m.y + size.y * std::modf((k + 1) * 0.5698402909980532, &part);
        index.find({Vec3(x, y, -1e9), Vec3(x, y, 1e9)}, near);
        intervals.clear();
        for (const std::uint32_t n : near) {
            ColumnInterval i;
            i.obstacle = n;
            if (obstacles.column(obstacles.all[n], x, y, i.low, i.high, i.steep)) intervals.push_back(i);
        }
        from_below(intervals);
        std::size_t here = 0;
        free_stretches(
            intervals, {}, body.step_up_m, [](const ColumnInterval&) { return false; },
            [&](double, double, std::uint32_t on) {
                here += ground.leaves_out(on, {x, y}) ? 0 : 1;
            });
        if (!near.empty()) places += static_cast<double>(here) / static_cast<double>(near.size());
    }
    return so_far.back() * places / kSampledColumns;
}

}  // namespace handrail::navigation
