#include "tests/unit/navigation/grid_twin.h"
#include "tests/support/names.h"

#include <array>
#include <cmath>
#include <queue>
#include <set>

namespace handrail::test {
namespace {

constexpr std::array<std::array<int, 2>, 8> kWays{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

}  // namespace

std::shared_ptr<const Scene> without_doors(const Scene& scene) {
    auto open = std::make_shared<Scene>(scene);
    std::erase_if(open->solids, [&](const Solid& solid) {
        if (solid.role != SolidRole::Mover || !solid.feature ||
            scene.features[solid.feature.value].kind != FeatureKind::Door)
            return false;
        return std::any_of(scene.movers.begin(), scene.movers.end(),
                           [&](const Mover& m) { return m.feature.value == solid.feature.value && m.moves(); });
    });
    return open;
}

double length_with_rides_m(const Route& route) {
    double sum_m = route.length_m;
    for (const RoutePassage& passage : route.passages)
        if (passage.kind == PassageKind::Lift) sum_m += std::abs(passage.rise_m);
    return sum_m;
}

GridTwin::GridTwin(const Scene& scene, const WalkerSize& body, double side_m)
    : scene_(without_doors(scene)), world_(std::make_unique<WalkerWorld>(scene_)), body_(body), side_m_(side_m) {
    for (const Mover& mover : scene.movers) {
        const Feature* lift = scene.find(mover.feature);
        if (!lift || lift->kind != FeatureKind::Lift || lift->bounds_m.empty() || mover.slide_m.z == 0.0) continue;
        const Vec3 middle = lift->bounds_m.centre_m(), top{middle.x, middle.y, lift->bounds_m.max_m.z};
        const Vec3 other = top + mover.slide_m;
        rides_.push_back(mover.slide_m.z < 0.0 ? Ride{other, top} : Ride{top, other});
    }
}

std::optional<Vec3> GridTwin::stand(const Vec3& feet_m, double up_m, double down_m) const {
    const WalkerShape shape{body_.radius_m, body_.height_m};
    const Vec3 high = feet_m + Vec3(0.0, 0.0, up_m);
    if (world_->blocked(high, shape)) return std::nullopt;
    const TraceHit ground = world_->trace(high, feet_m - Vec3(0.0, 0.0, down_m), shape);
    if (!ground.hit || ground.normal.z < 0.7) return std::nullopt;
    return ground.end_m;
}

int GridTwin::number(const Vec3& feet_m) {
    const auto key =
        std::tuple(std::lround(feet_m.x / side_m_), std::lround(feet_m.y / side_m_), std::lround(feet_m.z / 0.4));
    for (const long level : {0L, 1L, -1L}) {
        const auto found = known_.find({std::get<0>(key), std::get<1>(key), std::get<2>(key) + level});
        if (found != known_.end() && std::abs(places_[static_cast<std::size_t>(found->second)].z - feet_m.z) < 0.05)
            return found->second;
    }
    const int made = static_cast<int>(places_.size());
    known_[key] = made;
    places_.push_back(feet_m);
    next_.push_back({-1, -1, -1, -1, -1, -1, -1, -1});
    return made;
}

bool GridTwin::flood_from(const Vec3& feet_m) {
    const Vec3 middle{std::lround(feet_m.x / side_m_) * side_m_, std::lround(feet_m.y / side_m_) * side_m_, feet_m.z};
    const std::optional<Vec3> first = stand(middle, 0.05, 1.0);
    if (!first) return false;
    const WalkerShape shape{body_.radius_m, body_.height_m};
    const std::size_t before = places_.size();
    number(*first);
    if (places_.size() == before) return true;
    for (std::size_t at = before; at < places_.size(); ++at)
        for (std::size_t way = 0; way < kWays.size(); ++way) {
            const Vec3 here = places_[at];
            const Vec3 aim{(std::lround(here.x / side_m_) + kWays[way][0]) * side_m_,
                           (std::lround(here.y / side_m_) + kWays[way][1]) * side_m_, here.z};
            const TraceHit up = world_->trace(here, here + Vec3(0.0, 0.0, body_.step_up_m), shape);
            const double lift = up.end_m.z - here.z;
            const TraceHit over = world_->trace(up.end_m, aim + Vec3(0.0, 0.0, lift), shape);
            if (over.hit) continue;
            const TraceHit down =
                world_->trace(over.end_m, over.end_m - Vec3(0.0, 0.0, lift + body_.step_up_m + 0.02), shape);
            if (!down.hit || down.normal.z < 0.7) continue;
            // number() may enlarge next_, so the code must call it before it writes to next_.
            const int there = number({aim.x, aim.y, down.end_m.z});
            next_[at][way] = there;
        }
    return true;
}

int GridTwin::nearest(const Vec3& feet_m) const {
    int best = -1;
    double far = 2.0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Vec3 off = places_[i] - feet_m;
        if (std::abs(off.x) >= far || std::abs(off.y) >= far || std::abs(off.z) >= far) continue;
        if (const double d = std::hypot(off.x, off.y) + std::abs(off.z); d < far) {
            far = d;
            best = static_cast<int>(i);
        }
    }
    return best;
}

// Returns whether the walker can go straight from one square to another. The walker must not cross the corner of a
// square that is not walkable.
bool GridTwin::straight(int from, int to) const {
    const auto cell = [&](int place, int axis) {
        return std::lround(places_[static_cast<std::size_t>(place)][axis] / side_m_);
    };
    const long x0 = cell(from, 0), y0 = cell(from, 1), dx = cell(to, 0) - x0, dy = cell(to, 1) - y0;
    const std::size_t along_x = dx > 0 ? 0 : 4, along_y = dy > 0 ? 2 : 6;
    const long nx = std::abs(dx), ny = std::abs(dy);
    int here = from;
    long ix = 0, iy = 0;
    while (here >= 0 && (ix < nx || iy < ny)) {
        const long decide = (1 + 2 * ix) * ny - (1 + 2 * iy) * nx;
        if (decide == 0) {
            const std::size_t diagonal = dx > 0 ? (dy > 0 ? 1 : 7) : (dy > 0 ? 3 : 5);
            here = next_[static_cast<std::size_t>(here)][diagonal];
            ++ix;
            ++iy;
        } else if (decide < 0) {
            here = next_[static_cast<std::size_t>(here)][along_x];
            ++ix;
        } else {
            here = next_[static_cast<std::size_t>(here)][along_y];
            ++iy;
        }
    }
    return here == to;
}

std::vector<std::optional<double>> GridTwin::lengths(const Vec3& from_m, const std::vector<Vec3>& to_m) const {
    std::vector<std::optional<double>> found(to_m.size());
    const int start = nearest(from_m);
    if (start < 0) return found;
    std::vector<double> best(places_.size(), 1e300);
    std::vector<int> came(places_.size(), -1);
    std::map<int, std::vector<int>> ridden;
    for (const Ride& ride : rides_)
        if (const int low = nearest(ride.low_m), high = nearest(ride.high_m); low >= 0 && high >= 0) {
            ridden[low].push_back(high);
            ridden[high].push_back(low);
        }
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    best[static_cast<std::size_t>(start)] = 0.0;
    open.emplace(0.0, start);
    std::vector<int> goals;
    for (const Vec3& to : to_m) goals.push_back(nearest(to));
    std::set<int> wanted(goals.begin(), goals.end());
    while (!open.empty() && !wanted.empty()) {
        const double so_far = open.top().first;
        const int here = open.top().second;
        open.pop();
        if (so_far > best[static_cast<std::size_t>(here)]) continue;
        wanted.erase(here);
        const auto go = [&](int n) {
            if (n < 0) return;
            const double through =
                so_far + glm::length(places_[static_cast<std::size_t>(n)] - places_[static_cast<std::size_t>(here)]);
            if (through >= best[static_cast<std::size_t>(n)]) return;
            best[static_cast<std::size_t>(n)] = through;
            came[static_cast<std::size_t>(n)] = here;
            open.emplace(through, n);
        };
        for (const int n : next_[static_cast<std::size_t>(here)]) go(n);
        if (const auto found_ride = ridden.find(here); found_ride != ridden.end())
            for (const int n : found_ride->second) go(n);
    }
    for (std::size_t i = 0; i < to_m.size(); ++i) {
        const int goal = goals[i];
        if (goal < 0 || best[static_cast<std::size_t>(goal)] > 1e200) continue;
        std::vector<int> way;
        for (int s = goal; s >= 0; s = came[static_cast<std::size_t>(s)]) way.push_back(s);
        // Straightens the path: any two of its squares may be joined by a straight walkable line. Computes the shortest
        // length that results.
        std::vector<double> short_to(way.size(), 1e300);
        short_to[0] = 0.0;
        for (std::size_t a = 0; a < way.size(); ++a)
            for (std::size_t b = a + 1; b < way.size(); ++b) {
                const double leg =
                    glm::length(places_[static_cast<std::size_t>(way[a])] - places_[static_cast<std::size_t>(way[b])]);
                if (short_to[a] + leg < short_to[b] && (b == a + 1 || straight(way[b], way[a])))
                    short_to[b] = short_to[a] + leg;
            }
        found[i] = short_to.back();
    }
    return found;
}

}  // namespace handrail::test
