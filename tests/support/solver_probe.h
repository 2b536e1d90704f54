// Shows tests and benchmarks what ProxySolver keeps to itself: its last path, its candidates, the bodies that it
// tracks, and what the last move cost. Costs nothing beyond the reads; use it on the thread that owns the solver.
#pragma once

#include "haptic/render/proxy_solver.h"

namespace handrail::render {

class SolverProbe {
public:
    // The solver must outlive the probe. Not explicit, so that a check that takes a probe can be given a solver.
    SolverProbe(const ProxySolver& solver) : solver_(solver) {}

    // Centre of the proxy, in the scene's own coordinates.
    Vec3 local_m() const { return solver_.local_m(); }
    // path_size() is the number of points of the last path, path_m() returns one of them in world metres.
    int path_size() const { return solver_.path_.size; }
    Vec3 path_m(int i) const { return solver_.scene_origin_m_ + solver_.anchor_m_ + solver_.path_[i]; }
    // The candidates with their cuts, in the scene's own coordinates.
    int candidates() const { return solver_.cuts_.count; }
    std::uint32_t candidate(int i) const { return solver_.cuts_.obstacles[static_cast<std::size_t>(i)]; }
    HalfSpace cut(int i) const {
        const HalfSpace& cut = solver_.cuts_.planes[static_cast<std::size_t>(i)];
        return {cut.normal, cut.offset_m + glm::dot(cut.normal, solver_.anchor_m_)};
    }
    // Number of gatherings since reset().
    std::uint64_t gatherings() const { return solver_.gatherings_; }
    // Number of nodes and obstacles that the last move visited, and the work that it counted, without the cheap parts.
    int looks() const { return solver_.work_.looks; }
    int work() const { return ProxySolver::kMostWork - solver_.work_.left; }
    // tracked() returns how many bodies the solver follows, tracks() whether it follows `body`. body_at() returns the
    // pose at which the solver has a body, which lags while the body waits.
    std::size_t tracked() const { return solver_.tracks_.count; }
    bool tracks(std::size_t body) const { return solver_.tracks_.follows(body); }
    Placement body_at(std::size_t body) const { return solver_.tracks_.of(body).at; }
    bool hurries() const { return solver_.hurry_ > 0; }
    // Makes the solver follow every body of the scene, however far, as long as there are tracks. The results stay
    // bit-identical at a higher cost, with one exception: while the proxy hurries after an obstacle vanished, a solver
    // that follows few bodies stops sooner.
    static void track_all(ProxySolver& solver) { solver.tracks_.all = true; }

private:
    const ProxySolver& solver_;
};

}  // namespace handrail::render
