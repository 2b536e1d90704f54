#include "app/core/world/wall_at_side.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "app/core/world/body_heights.h"
#include "worlds/base/contract.h"

namespace handrail::core {
namespace {

constexpr int kDirections = 16;
constexpr double kRange_m = 2.0;
constexpr double kLow_m = 0.3;        // height of the rays above the soles, below window sills, boards and table tops
constexpr double kUprightFace = 0.3;  // largest z of the normal of an upright face
constexpr double kSameWay = 0.995;    // least cosine of the angle between the normals of two pieces of one wall
constexpr double kSameLine_m = 0.08;  // largest distance between two pieces of one wall, across the wall
constexpr double kInside_m = 0.01, kHardly_m = 1e-3;
constexpr double kLines_m = 0.8;  // largest depth of furniture at a wall, including the gap behind it
constexpr double kPaneThick_m = 0.2, kPaneWide_m = 0.5, kPaneTall_m = 0.8;
constexpr double kRecess_m = 0.2;  // depth by which a pane or leaf is usually set back in its wall
constexpr double kTries_m = 0.25;  // step of the search along a wall for where it continues

// A piece of a wall, or of something at or in a wall, hit by a ray.
struct Met {
    enum class Kind : std::uint8_t { Wall, Lining, Pane };
    Vec3 at_m{0.0}, out{0.0};  // `out` is the horizontal normal
    Kind kind = Kind::Wall;
};

bool is_a(const WalkerWorld& world, const TraceHit& hit, FeatureKind kind) {
    return hit.hit && hit.feature && std::abs(hit.normal.z) <= kUprightFace &&
           world.scene().features[hit.feature.value].kind == kind;
}

// Returns true if the space between the hit face and a wall behind it is so small that nobody walks there.
bool lines_a_wall(const WalkerWorld& world, const TraceHit& hit, const Vec3& ahead) {
    const TraceHit behind =
        world.trace(hit.end_m + ahead * kInside_m, hit.end_m + ahead * kLines_m, WalkerShape{}, true);
    return is_a(world, behind, FeatureKind::Wall);
}

// Returns true if the hit thing is upright, thin, wide and tall, such as a pane, a door leaf or a screen.
bool is_a_pane(const WalkerWorld& world, const TraceHit& hit) {
    const Vec3 size = world.scene().features[hit.feature.value].bounds_m.size_m();
    if (std::max(size.x, size.y) < kPaneWide_m || size.z < kPaneTall_m) return false;
    for (const Crossing& crossing : world.crossings(hit.end_m + hit.normal * kInside_m, hit.end_m - hit.normal))
        if (crossing.feature == hit.feature) return crossing.leave_m - crossing.enter_m <= kPaneThick_m;
    return false;
}

std::optional<Met> met_on_route(const WalkerWorld& world, const Vec3& eye_m, const Vec3& to_m) {
    const TraceHit hit = world.trace(eye_m, to_m, WalkerShape{}, true);
    Met::Kind kind = Met::Kind::Wall;
    if (is_a(world, hit, FeatureKind::Object) || is_a(world, hit, FeatureKind::Door)) {
        kind = lines_a_wall(world, hit, glm::normalize(to_m - eye_m)) ? Met::Kind::Lining : Met::Kind::Pane;
        if (kind == Met::Kind::Pane && !is_a_pane(world, hit)) return std::nullopt;
    } else if (!is_a(world, hit, FeatureKind::Wall)) {
        return std::nullopt;
    }
    const Vec3 level(hit.normal.x, hit.normal.y, 0.0);
    return Met{Vec3(hit.end_m.x, hit.end_m.y, 0.0), level / std::hypot(level.x, level.y), kind};
}

// The line of the wall to which `piece` belongs, seen from a walker at `at_m`.
class WallLine {
public:
    WallLine(const Met& piece, const Vec3& at_m)
        : out_(piece.out),
          along_(-out_.y, out_.x, 0.0),
          away_m_(glm::dot(at_m - piece.at_m, out_)),
          foot_m_(at_m - out_ * away_m_) {}

    double away_m() const { return away_m_; }
    // Returns the position of a piece along this line, from the walker's foot point. Returns no value if the piece
    // belongs to another wall.
    std::optional<double> place_of(const Met& piece) const {
        const Vec3 off = piece.at_m - foot_m_;
        if (glm::dot(piece.out, out_) < kSameWay || std::abs(glm::dot(off, out_)) > kSameLine_m) return std::nullopt;
        return glm::dot(off, along_);
    }
    // Returns a point of the line, slightly behind the face of the wall.
    Vec3 point_m(double along_m) const { return foot_m_ + along_ * along_m - out_ * kSameLine_m; }

private:
    Vec3 out_, along_;
    double away_m_;
    Vec3 foot_m_;
};

// Returns true if pieces of the wall are on both sides of the foot point, and not too far apart.
bool goes_past(const WalkerWorld& world, const Vec3& eye_m, const WallLine& wall, const std::vector<Met>& pieces) {
    double before_m = -1e9, behind_m = 1e9;  // positions of the nearest pieces on either side
    for (const Met& piece : pieces)
        if (const auto place_m = wall.place_of(piece)) {
            if (*place_m <= 0.0) before_m = std::max(before_m, *place_m);
            if (*place_m >= 0.0) behind_m = std::min(behind_m, *place_m);
        }
    // Searches for a piece between the hits of the first rays.
    const auto look_along = [&](double sign, double least_m) {
        for (double along_m = kTries_m; along_m < std::min(least_m, kWallGoesOn_m); along_m += kTries_m) {
            const Vec3 to = wall.point_m(sign * along_m);
            const auto met = met_on_route(world, eye_m, Vec3(to.x, to.y, eye_m.z));
            if (const auto place_m = met && met->kind == Met::Kind::Wall ? wall.place_of(*met) : std::nullopt;
                place_m && sign * *place_m >= 0.0)
                return std::min(least_m, sign * *place_m);
        }
        return least_m;
    };
    behind_m = look_along(1.0, behind_m);
    before_m = -look_along(-1.0, -before_m);
    return behind_m - before_m <= kWallGoesOn_m;
}

}  // namespace

double wall_at_side_m(const WalkerWorld& world, const Vec3& feet_m) {
    contract_pre(is_finite(feet_m));
    const Vec3 at_m(feet_m.x, feet_m.y, 0.0);
    double nearest_m = 1e9;
    std::vector<Met> pieces;
    for (const double height_m : {kWaist_m, kLow_m}) {
        const Vec3 eye = feet_m + Vec3(0.0, 0.0, height_m);
        for (int i = 0; i < kDirections; ++i) {
            const auto met = met_on_route(world, eye, eye + forward_of_heading(i * 2.0 * kPi / kDirections) * kRange_m);
            if (!met) continue;
            if (met->kind == Met::Kind::Wall) pieces.push_back(*met);
            const double away_m = glm::length(met->at_m - at_m);
            nearest_m = std::min(nearest_m, met->kind == Met::Kind::Pane ? std::max(0.0, away_m - kRecess_m) : away_m);
        }
    }
    std::vector<WallLine> walls;
    for (const Met& piece : pieces) {
        if (std::any_of(walls.begin(), walls.end(), [&](const WallLine& wall) { return wall.place_of(piece); }))
            continue;
        const WallLine& wall = walls.emplace_back(piece, at_m);
        if (wall.away_m() >= 0.0 && wall.away_m() < nearest_m - kHardly_m &&
            goes_past(world, feet_m + Vec3(0.0, 0.0, kWaist_m), wall, pieces))
            nearest_m = wall.away_m();
    }
    return nearest_m;
}

}  // namespace handrail::core
