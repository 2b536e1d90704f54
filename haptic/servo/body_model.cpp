#include "haptic/servo/body_model.h"

#include <algorithm>
#include <cmath>

#include "haptic/servo/vectors.h"

namespace handrail::servo {
namespace {

Rotation turned(const Rotation& q, const Vec3& by_rad) noexcept {
    const Rotation p = Rotation{0.0, by_rad.x, by_rad.y, by_rad.z} * q;
    return normalized({q.w + 0.5 * p.w, q.x + 0.5 * p.x, q.y + 0.5 * p.y, q.z + 0.5 * p.z});
}

// Inverse of the inertia tensor about the centre of mass, in world axes.
struct InverseInertia {
    std::array<Vec3, 3> axes;
    Vec3 inverse;

    InverseInertia(const Placement& at, const Vec3& inertia) noexcept
        : axes(PlacedFrame(at).axes), inverse(1.0 / inertia) {}
    Vec3 operator()(const Vec3& v) const noexcept {
        return axes[0] * (glm::dot(axes[0], v) * inverse.x) + axes[1] * (glm::dot(axes[1], v) * inverse.y) +
               axes[2] * (glm::dot(axes[2], v) * inverse.z);
    }
};

}  // namespace

// One direction in which a contact acts.
struct Direction {
    // `along` is the unit vector of the direction. `turns` is the cross product of arm and direction. `spins` is the
    // change of angular velocity per unit impulse.
    Vec3 along{0.0}, turns{0.0}, spins{0.0};
    double mass_kg = 0.0;  // effective mass in this direction

    void make(const Vec3& direction, const Vec3& arm, double inverse_kg, const InverseInertia& inverse) noexcept {
        along = direction;
        turns = glm::cross(arm, direction);
        spins = inverse(turns);
        mass_kg = 1.0 / (inverse_kg + glm::dot(turns, spins));
    }
};

struct BodyModel::Point {
    std::array<Direction, 3> ways;
    double want_m_per_s = 0.0;  // least velocity along the normal that the solver enforces
    double friction = 0.0;
};

void BodyModel::begin(const render::RigidBodyState& reported, const State& seen) noexcept {
    *this = {};
    state_ = seen;
    reported_ = reported;
    reported_.time_s = -1e300;
    history_[0] = state_;
    count_ = 1;
    hear(reported);
}

void BodyModel::hear(const render::RigidBodyState& reported) noexcept {
    if (!(reported.time_s > reported_.time_s)) return;
    // Contacts that continue keep their impulses. Without them, a resting body would sag with every new message.
    std::array<Vec3, render::RigidBodyState::kMostPlanes> kept{};
    for (std::size_t i = 0; i < reported.count; ++i)
        for (std::size_t k = 0; k < reported_.count; ++k)
            if (glm::dot(reported.planes[i].normal, reported_.planes[k].normal) > 0.99 &&
                glm::length(reported.planes[i].own_m - reported_.planes[k].own_m) < 0.02) {
                kept[i] = impulse_[k];
                break;
            }
    impulse_ = kept;
    reported_ = reported;
    // The model's state at the time of the message.
    const State* then = &history_[first_];
    for (std::size_t i = 0; i < count_; ++i) {
        const State& old = history_[(first_ + i) % kHistory];
        if (std::abs(old.time_s - reported.time_s) < std::abs(then->time_s - reported.time_s)) then = &old;
    }
    const double late_s = std::clamp(reported.time_s - then->time_s, -0.02, 0.02);
    owed_m_ = reported.at.position_m - (then->at.position_m + then->speed_m_per_s * late_s);
    owed_m_per_s_ = reported.speed_m_per_s - then->speed_m_per_s;
    owed_rad_ = turn_between(turned(then->at.rotation, then->turn_rad_per_s * late_s), reported.at.rotation);
    owed_rad_per_s_ = reported.turn_rad_per_s - then->turn_rad_per_s;
    apart_m_ = glm::length(owed_m_);
}

// Applies a part of the pending correction to the present state and to the earlier states in the history.
void BodyModel::correct(double dt_s) noexcept {
    const double part = std::min(1.0, dt_s / kCorrect_s);
    const Vec3 way = owed_m_ * part, speed = owed_m_per_s_ * part, turn = owed_rad_ * part,
               turning = owed_rad_per_s_ * part;
    owed_m_ -= way;
    owed_m_per_s_ -= speed;
    owed_rad_ -= turn;
    owed_rad_per_s_ -= turning;
    const auto shift = [&](State& s) {
        s.at.position_m += way;
        s.at.rotation = turned(s.at.rotation, turn);
        s.speed_m_per_s += speed;
        s.turn_rad_per_s += turning;
    };
    shift(state_);
    for (std::size_t i = 0; i < count_; ++i) shift(history_[(first_ + i) % kHistory]);
}

void BodyModel::solve(double dt_s) noexcept {
    const InverseInertia inverse(state_.at, reported_.inertia_kg_m2);
    const PlacedFrame frame(state_.at);
    const double inverse_kg = 1.0 / reported_.mass_kg, stick = stick_.factor(reported_.sticks);
    std::array<Point, render::RigidBodyState::kMostPlanes> points;
    Vec3 &v = state_.speed_m_per_s, &w = state_.turn_rad_per_s;
    const auto kick = [&](const Direction& d, double impulse) {
        v += d.along * (impulse * inverse_kg);
        w += d.spins * impulse;
    };
    const auto speed = [&](const Direction& d) { return glm::dot(d.along, v) + glm::dot(d.turns, w); };
    for (std::size_t i = 0; i < reported_.count; ++i) {
        const render::ContactPlane& plane = reported_.planes[i];
        Point& p = points[i];
        const Vec3 arm = plane.round ? plane.normal * -plane.radius_m : frame.turned(plane.own_m);
        const double gap =
            glm::dot(plane.normal, state_.at.position_m + arm) -
            (plane.offset_m + glm::dot(plane.normal, plane.speed_m_per_s) * (state_.time_s - reported_.time_s));
        // In this tick, the point may approach the plane by at most the gap. If the point is already behind the plane,
        // it is pushed out gently.
        p.want_m_per_s =
            (gap > 0.0 ? -gap / dt_s : std::min(-0.02 * gap / dt_s, 0.2)) + glm::dot(plane.normal, plane.speed_m_per_s);
        p.friction = plane.friction * stick;
        const Vec3 tangent = any_perpendicular(plane.normal);
        p.ways[0].make(plane.normal, arm, inverse_kg, inverse);
        p.ways[1].make(tangent, arm, inverse_kg, inverse);
        p.ways[2].make(glm::cross(plane.normal, tangent), arm, inverse_kg, inverse);
        for (int k = 0; k < 3; ++k) kick(p.ways[static_cast<std::size_t>(k)], impulse_[i][k]);
    }
    for (int round = 0; round < kRounds; ++round)
        for (std::size_t i = 0; i < reported_.count; ++i) {
            const Point& p = points[i];
            const Vec3 glides = reported_.planes[i].speed_m_per_s;
            Vec3& done = impulse_[i];
            const double normal = std::max(0.0, done.x + (p.want_m_per_s - speed(p.ways[0])) * p.ways[0].mass_kg);
            kick(p.ways[0], normal - done.x);
            done.x = normal;
            double a = done.y - (speed(p.ways[1]) - glm::dot(p.ways[1].along, glides)) * p.ways[1].mass_kg;
            double b = done.z - (speed(p.ways[2]) - glm::dot(p.ways[2].along, glides)) * p.ways[2].mass_kg;
            const double most = p.friction * normal, is = std::sqrt(a * a + b * b);
            if (is > most) {
                a *= most / is;
                b *= most / is;
            }
            kick(p.ways[1], a - done.y);
            kick(p.ways[2], b - done.z);
            done.y = a;
            done.z = b;
        }
    // Rolling friction reduces the rotation of a ball on the floor.
    if (reported_.rolling_m > 0.0) {
        double pressed = 0.0;
        for (std::size_t i = 0; i < reported_.count; ++i)
            if (reported_.planes[i].round) pressed += impulse_[i].x;
        const double turning = glm::length(w), takes = reported_.rolling_m * pressed *
                                                       glm::length(inverse(turning > 0.0 ? w / turning : Vec3(0.0)));
        w = turning > takes ? w * ((turning - takes) / turning) : Vec3(0.0);
    }
}

void BodyModel::tick(const Vec3& force_n, const Vec3& moment_nm, double dt_s) noexcept {
    correct(dt_s);
    const InverseInertia inverse(state_.at, reported_.inertia_kg_m2);
    const Vec3 pulls = (reported_.string_at_m - state_.at.position_m) * reported_.string_n_per_m -
                       state_.speed_m_per_s * reported_.string_ns_per_m;
    state_.speed_m_per_s +=
        ((force_n + reported_.others_n + pulls) / reported_.mass_kg + reported_.gravity_m_per_s2) * dt_s;
    state_.turn_rad_per_s += inverse(moment_nm + reported_.others_nm) * dt_s;
    stick_.go(glm::length(state_.speed_m_per_s), dt_s);
    solve(dt_s);
    state_.at.position_m += state_.speed_m_per_s * dt_s;
    state_.at.rotation = turned(state_.at.rotation, state_.turn_rad_per_s * dt_s);
    state_.time_s += dt_s;
    history_[(first_ + count_) % kHistory] = state_;
    if (count_ < kHistory) ++count_;
    else first_ = (first_ + 1) % kHistory;
}

void BodyModel::rest() noexcept {
    state_.speed_m_per_s = state_.turn_rad_per_s = Vec3(0.0);
    owed_m_ = owed_m_per_s_ = owed_rad_ = owed_rad_per_s_ = Vec3(0.0);
    impulse_.fill(Vec3(0.0));
}

void BodyModel::limit_speed(double most_m_per_s) noexcept {
    const double speed = glm::length(state_.speed_m_per_s);
    if (speed > most_m_per_s) state_.speed_m_per_s *= most_m_per_s / speed;
}

}  // namespace handrail::servo
