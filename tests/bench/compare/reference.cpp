#include "tests/bench/compare/reference.h"

#include <cmath>
#include <limits>

namespace handrail::bench {
namespace {

using test::LHalfSpace;
using test::LVec;
using test::Nearest;

long double dot(const LVec& a, const LVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
long double length(const LVec& a) { return std::sqrt(dot(a, a)); }

class Walk {
public:
    explicit Walk(const BenchWorld& world) : judge_(world.judge), radius_(world.radius_m) {}

    bool begin(const LVec& at) {
        ball_ = at;
        look();
        return walls_.empty() && gap_ >= 0.0L;
    }

    // One more step towards the hand; false when there is none.
    bool step(const LVec& goal) {
        constexpr long double kArrived = 1e-13L;
        look();
        const LVec pull = goal - ball_;
        if (length(pull) == 0.0L) return false;
        const std::optional<LVec> way = test::project_by_enumeration(walls_, pull, 1e-15L);
        if (!way) return false;
        const long double far = length(*way);
        if (!(far > kArrived)) return false;
        // With nothing near, as far as nothing can be.
        const long double allowed = walls_.empty() ? std::max(kStep, gap_ * 0.9L) : kStep;
        if (far <= allowed && walls_.empty()) {
            ball_ = goal;
            return true;
        }
        ball_ += *way * std::min(1.0L, allowed / far);
        return true;
    }
    const LVec& ball() const { return ball_; }
    double work() const { return work_; }  // comparisons, about

private:
    static constexpr long double kStep = 1e-5L, kNear = 0.01L;

    // Contact planes around the ball, relative to it.
    void look() {
        if (near_.empty() || length(ball_ - centre_) > kNear) {
            near_.clear();
            centre_ = ball_;
            for (const test::BruteForce::Thing& t : judge_.things())
                if (length(t.centre - ball_) - t.reach < radius_ + 2.0L * kNear) near_.push_back(&t);
            if (near_.empty()) near_.push_back(nullptr);
        }
        walls_.clear();
        gap_ = kNear;
        for (const test::BruteForce::Thing* t : near_) {
            if (!t || length(t->centre - ball_) - t->reach > radius_ + gap_) continue;
            const Nearest nearest = judge_.nearest(*t, ball_);
            const double planes = static_cast<double>(t->planes.size());
            work_ += t->solid ? planes * planes * planes * planes / 24.0 + planes * planes : 8.0;
            const long double gap = nearest.distance - radius_;
            gap_ = std::min(gap_, gap);
            if (gap > 2.0L * kStep || nearest.distance <= 0.0L) continue;
            const LHalfSpace wall{(ball_ - nearest.point) / nearest.distance, std::min(0.0L, -gap)};
            bool known = false;
            for (LHalfSpace& w : walls_)
                if (dot(w.normal, wall.normal) > 1.0L - 1e-17L) {
                    w.offset = std::max(w.offset, wall.offset);
                    known = true;
                    break;
                }
            if (!known) walls_.push_back(wall);
        }
        const double walls = static_cast<double>(walls_.size());
        work_ += walls * walls * walls * walls / 24.0 + walls * walls + static_cast<double>(near_.size());
    }

    const test::BruteForce& judge_;
    long double radius_;
    LVec ball_{0.0L}, centre_{0.0L};
    std::vector<const test::BruteForce::Thing*> near_;
    std::vector<LHalfSpace> walls_;
    long double gap_ = 0.0L;
    double work_ = 0.0;
};

}  // namespace

std::vector<Vec3> reference_walk(const BenchWorld& world, double most_work) {
    constexpr int kMostPerTick = 20000;
    std::vector<Vec3> balls;
    Walk walk(world);
    if (world.goals_m.empty() || !walk.begin(LVec(world.goals_m.front()))) return balls;
    balls.reserve(world.goals_m.size());
    for (const Vec3& goal : world.goals_m) {
        for (int i = 0; i < kMostPerTick && walk.step(LVec(goal)); ++i)
            if (walk.work() > most_work) return {};
        balls.emplace_back(walk.ball());
    }
    return balls;
}

}  // namespace handrail::bench
