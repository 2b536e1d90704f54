// Implements the free-cell proxy: a ball that stays outside a set of convex obstacles. Each candidate obstacle owns one
// cut, a half-space that supports the obstacle. A cut of a still obstacle stays valid for ever, so the proxy may move
// freely in the intersection of the cuts. No swept test is needed at any speed. Overlapping, doubled and cracked
// geometry needs no special case, and the proxy may stop anywhere on its path.
//
// One move projects the goal on the intersection, renews the cuts that hold the proxy, and repeats both steps until
// these cuts truly touch their obstacles. Candidates come from a cache. When the move refreshes the cache depends only
// on the samples. The cuts of a moving body are fixed in the body's frame. A body that approaches pushes the proxy in
// sub-steps of at most half the proxy's radius. If the body leaves too little room, the proxy shrinks.
//
// TouchState owns ProxySolver; one thread. Allocates only in its constructor; noexcept; reads no clock. Lengths in
// world metres. Sources: Zilles & Salisbury, A constraint-based god-object method, IROS 1995; Ruspini et al., The
// haptic display of complex graphical environments, SIGGRAPH 1997 (finite radius); supporting cuts and their lazy
// renewal: docs/architecture.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "haptic/render/haptic_scene.h"
#include "haptic/render/proxy_cuts.h"
#include "haptic/render/proxy_path.h"
#include "haptic/render/proxy_tracks.h"
#include "haptic/render/tick_features.h"
#include "worlds/geometry/half_space_projection.h"

namespace handrail::render {

class ProxySolver {
public:
    // Greatest number of candidates. If more obstacles are near, the nearest are kept and Step::truncated is set.
    static constexpr int kMaxCandidates = ProxyCuts::kMost;
    // Number of candidates above which the solver reduces the margin, because each candidate costs 6 instructions in
    // every scan.
    static constexpr int kComfortableCandidates = 38;
    // How many more candidates a search collects before it drops the farthest.
    static constexpr int kSpareCandidates = 16;
    static constexpr int kMaxIterations = ProxyPath::kMostRounds;
    // Greatest number of gatherings within one move, for long moves through crowded places.
    static constexpr int kMaxStages = 8;
    // Greatest number of nodes and obstacles that one gathering visits in one shape. Space beyond the visited ones is
    // unknown.
    static constexpr int kMostLooks = 2048;
    static constexpr double kSmallestRadius_m = 1e-5;
    // The work budget of one move, in units of about a nanosecond (see kLookWork and the others). The work is counted
    // and not timed, so that every machine does the same. Once the budget is spent, the proxy does not enter unknown
    // space and the existing cuts stay in use. The proxy, or a body that approaches it, waits for the next move.
    static constexpr int kMostWork = 88'000;
    // Part of the budget that gatherings leave for the rounds, because cuts are useless without rounds that use them.
    static constexpr int kRoundsWork = 18'000;

    struct Request {
        Vec3 goal_m{0.0};  // goal of the proxy, world
        double radius_m = 0.005;
        double path_cap_m = 0.0;  // limit for the length of the proxy's path in this move
        double margin_m = 0.02;   // desired distance that the proxy may move before candidates are gathered again
        double growth_m = 0.0;    // how much a shrunken proxy grows in this move
        // Greatest number of rounds, up to kMaxIterations. With fewer rounds the proxy never goes through an obstacle
        // but only lags (tests: I17). With 0, the move uses the cuts as they are. It then renews no cut and gathers no
        // candidates, as if it had no time (tests: I18).
        int most_rounds = kMaxIterations;
        const BodyPoses* bodies = nullptr;  // poses, each with a scale > 0; null: each body has its pose from the scene
    };

    // Value of `body` for an obstacle that belongs to no body.
    static constexpr std::uint16_t kStill = OwnedObstacle::kStill;

    // One surface that holds the proxy.
    struct Hold {
        std::uint32_t obstacle = 0;
        std::uint16_t body = kStill;  // the body to whose shape the obstacle belongs
        Vec3 normal{0.0};
        double multiplier_m = 0.0;
    };

    struct Step {
        std::array<Hold, 3> holds{};
        int count = 0;
        int iterations = 0;
        bool converged = true, truncated = false, capped = false, ghosted = false;
        bool waits = false;     // the move had more work than kMostWork; the next moves do the rest
        bool pushed = false;    // true if a body moved the proxy
        bool squeezed = false;  // true if the proxy had to shrink

        // Prepares for the next move. `holds` needs no clearing, because only its first `count` elements are valid.
        void begin() noexcept {
            count = iterations = 0;
            converged = true;
            truncated = capped = ghosted = waits = pushed = squeezed = false;
        }
    };

    // Makes the proxy start at the goal of the next move.
    void reset() noexcept;
    // Makes one move. `Has` is AllFeatures; it may be PlainFeatures if scene.plain is true.
    template <class Has = AllFeatures>
    const Step& move(const HapticScene& scene, const Request& request) noexcept;
    // Call it before move(). Returns true if no body is near enough to affect the proxy, so that the move may ignore
    // bodies.
    bool bodies_are_far(const HapticScene& scene, const Request& request) noexcept;
    // A quick version of bodies_are_far() for a tick in which nothing about the bodies has changed. False means that
    // bodies may be near.
    bool bodies_stay_far(const HapticScene& scene, const BodyPoses& bodies, double radius_m, double margin_m,
                         double path_cap_m) noexcept {
        if (all_far_in_ != &scene || generation_ != scene.generation) return false;
        const Vec3 way = local_m() - tracks_.far_from_m;
        if (bodies.ways_number() != tracks_.ways || glm::dot(way, way) > tracks_.far_enough_m2 ||
            near_for(radius_m, margin_m, path_cap_m) > tracks_.near_m)
            return false;
        tracks_.number = bodies.number;
        return true;
    }
    // Applies the friction cone. Call it after move() with at least one hold. Moves the proxy back along its path until
    // it is reach_m from where the goal pulls it, or to the start of the path, but never off the surfaces. A proxy that
    // was free first goes straight to its first contact, where friction begins.
    template <class Has = AllFeatures>
    void hold_back(const HapticScene& scene, double reach_m) noexcept;
    // Call it after move(). Until the next move, friction makes the proxy move along with `body` (kStill: with none).
    void ride(std::uint16_t body) noexcept { carrier_ = body; }

    // Converts a direction to the frame of the holding body, or of the still scene.
    Vec3 turned_to_own(const Hold& hold, const Vec3& direction) const noexcept {
        return hold.body == kStill ? direction : tracks_.of(hold.body).frame.turned_back(direction);
    }
    Vec3 turned_from_own(const Hold& hold, const Vec3& direction) const noexcept {
        return hold.body == kStill ? direction : tracks_.of(hold.body).frame.turned(direction);
    }
    double own_scale(const Hold& hold) const noexcept {
        return hold.body == kStill ? 1.0 : tracks_.of(hold.body).frame.scale;
    }
    static const HapticScene& shape_of(const HapticScene& scene, const Hold& hold) noexcept {
        return hold.body == kStill ? scene : *scene.bodies[hold.body].shape;
    }
    // Converts a position in the world to the coordinates of the holding shape, which its triangles, boxes and planes
    // use.
    Vec3 to_own(const HapticScene& scene, const Hold& hold, const Vec3& world_m) const noexcept;

    // Valid after move().
    // - offset_m: from the goal to the proxy; exactly zero in free space.
    // - slide_m: from the proxy's place before the move to its place now.
    // - press_m: from the goal to where the proxy would rest without friction and without the speed cap.
    Vec3 offset_m() const noexcept { return proxy_m_ - goal_m_; }
    Vec3 slide_m() const noexcept { return proxy_m_ - path_[0]; }
    // Displacement since the first contact of the move, without the free movement before it. Valid after hold_back().
    Vec3 rubbed_m() const noexcept { return proxy_m_ - path_[path_.rubs_from]; }
    Vec3 press_m() const noexcept { return basis_.point_m - goal_m_; }
    // The place where the proxy would rest without friction, in the scene's own coordinates.
    Vec3 rest_m() const noexcept { return anchor_m_ + basis_.point_m; }
    double radius_m() const noexcept { return radius_m_; }
    // Centre of the proxy, in the scene's own coordinates.
    Vec3 local_m() const noexcept { return anchor_m_ + proxy_m_; }
    Vec3 world_m() const noexcept { return scene_origin_m_ + anchor_m_ + proxy_m_; }

private:
    friend class SolverProbe;  // shows the parts below to tests and benchmarks

    struct Candidate {
        double distance_m;  // distance of the candidate's cut, which is at most the distance of the obstacle
        std::uint32_t obstacle;
        std::uint32_t normal;  // index in nearest_normals_
    };
    static inline const PlacedFrame kWorldFrame{};

    void place(const HapticScene& scene, const Request& request, const Vec3& local_m, double radius_m) noexcept;
    void place_in(const HapticScene& scene, std::uint16_t body, double radius_m) noexcept;
    // Returns the distance around the proxy within which bodies must have a track. It covers a push of 64 sub-steps by
    // bodies that carry the proxy, plus the range in which candidates are gathered.
    static double near_for(double radius_m, double margin_m, double path_cap_m) noexcept {
        return 70.0 * radius_m + 2.0 * margin_m + 5.0 * path_cap_m;
    }
    double least_distance_m(const HapticScene& scene, const Request& request, std::size_t body,
                            const Vec3& from_m) const noexcept;
    bool track_body(const HapticScene& scene, const Request& request, std::size_t body) noexcept;
    void untrack_far(const HapticScene& scene, double far_m) noexcept;
    void track_near(const HapticScene& scene, const Request& request) noexcept;
    void track_coming(const HapticScene& scene, const Request& request) noexcept;
    void watch_bodies(const HapticScene& scene, const Request& request, double radius_m) noexcept;
    void take_bodies(const HapticScene& scene, const Request& request, double radius_m) noexcept;
    static BodyPose wanted(const HapticScene& scene, const Request& request, std::size_t body) noexcept;
    static void stand(const HapticScene& scene, ProxyTrack& track, const Placement& at) noexcept;
    void advance_bodies(const HapticScene& scene, const Request& request, double radius_m) noexcept;
    bool sub_step(const HapticScene& scene, const Request& request, double radius_m, double part) noexcept;
    void renew_moved_cuts(const HapticScene& scene) noexcept;
    void make_room(const HapticScene& scene, const Vec3& target_m) noexcept;
    void drop_body(std::uint16_t body) noexcept;
    // Returns the distance around a place within which every obstacle is a candidate.
    template <class Has = AllFeatures>
    double known_around(const Vec3& at_m) noexcept {
        const double known = known_m_ - glm::length(at_m);
        return !Has::kBodies || (tracks_.count == 0 && !tracks_.far_short) ? known : known_of_bodies(at_m, known);
    }
    double known_of_bodies(const Vec3& at_m, double known_m) noexcept;
    // Counts work for each followed body. For only a few bodies, the work is not counted.
    void spend_on_tracked(int work) noexcept;
    void gather(const HapticScene& scene, double reach_m, double needed_m) noexcept;
    void gather_waiting(const HapticScene& scene, double reach_m, double needed_m) noexcept;
    void look_at_body(const HapticScene& scene, std::uint16_t body, double reach_m, double needed_m,
                      std::size_t share) noexcept;
    void drop_candidates(std::uint16_t body) noexcept;
    // Drops the candidates of every body for which leaves(owner) returns true.
    template <class Leaves>
    void drop_candidates_of(const Leaves& leaves) noexcept;
    // Counts work; call it after each costly step. Once the budget is spent, the rounds end.
    void spend(int work) noexcept {
        work_.left -= work;
        if (work_.left > 0) return;
        work_.most_rounds = 1;  // one round always remains, with the existing cuts
        step_.waits = true;
    }
    bool project_many(const Vec3& goal_m, ProjectionBasis& basis) noexcept;
    double collect(const HapticScene& shape, std::uint16_t body, const Vec3& at, double reach_m, double needed_m,
                   std::size_t room) noexcept;
    double gather_nearest(const HapticScene& shape, std::uint16_t body, const Vec3& at, double reach_m, double needed_m,
                          std::size_t most) noexcept;
    void release_ghosts(const HapticScene& scene) noexcept;
    ClosestPoint closest_of_body(const HapticScene& scene, std::uint32_t obstacle, std::uint16_t body,
                                 const Vec3& local_m) const noexcept;
    const HapticScene& shape_at(const HapticScene& scene, int candidate) const noexcept {
        const std::uint16_t body = cuts_.owners[static_cast<std::size_t>(candidate)];
        return body == kStill ? scene : *scene.bodies[body].shape;
    }
    template <class Has = AllFeatures>
    void keep_cut(int candidate, const HalfSpace& cut) noexcept;
    void grow(const HapticScene& scene, double radius_m, double growth_m) noexcept;
    bool project() noexcept;
    template <class Has>
    bool renew_holding_cuts(const HapticScene& scene) noexcept;
    // Returns how far a place is in front of the touchable side of a one-sided sheet.
    double in_front_m(const HapticScene& scene, int candidate, const PlacedFrame& frame,
                      const Vec3& at_m) const noexcept;
    double in_front_m(const HapticScene& scene, int candidate, const Vec3& at_m) const noexcept {
        const std::uint16_t body = cuts_.owners[static_cast<std::size_t>(candidate)];
        return in_front_m(scene, candidate, body == kStill ? kWorldFrame : tracks_.of(body).frame, at_m);
    }
    bool turn_sheets(const HapticScene& scene) noexcept;
    void turn_sheets_of(const HapticScene& scene, std::uint16_t body, const PlacedFrame& before) noexcept;
    double fraction_to_waking(const HapticScene& scene, const Vec3& step) const noexcept;
    bool arc_step(const HapticScene& scene, double way_left_m) noexcept;
    // Returns the fraction of a step that the proxy can move before it leaves the first cut. If `met` is given, it
    // receives the index of that cut. It stays unchanged if the step leaves no cut.
    double fraction_inside(const Vec3& step, int* met = nullptr) const noexcept;
    // The parts of hold_back().
    static constexpr int kMostTouched = 16;
    template <class Has>
    void touch_down(const HapticScene& scene) noexcept;
    template <class Has>
    int touched(const HapticScene& scene, std::array<HalfSpace, kMostTouched>& surfaces) noexcept;
    template <class Has>
    int hangs_over(const HapticScene& scene, const Vec3& goal_m, HalfSpace& surface) noexcept;
    template <class Has>
    void draw(const HapticScene& scene) noexcept;
    template <class Has>
    void rub(const HapticScene& scene, double share) noexcept;
    template <class Has = AllFeatures>
    HalfSpace support(const HapticScene& scene, int candidate, const Vec3& at, double& distance_m) const noexcept;
    // Returns the cut of candidate i moved outwards by the proxy's radius, which limits the proxy's centre.
    HalfSpace wall(int i) const noexcept { return cuts_.wall(i, radius_m_); }

    // The vectors below, and those of the cuts and the path, are relative to anchor_m_. That is the proxy's place, in
    // scene coordinates, when candidates were last gathered. The numbers stay small, so rounding errors do not grow
    // with the size of the building.
    Vec3 scene_origin_m_{0.0}, anchor_m_{0.0}, proxy_m_{0.0}, goal_m_{0.0};
    double radius_m_ = 0.0;
    ProjectionBasis basis_;
    ProxyCuts cuts_;
    ProxyGhosts ghosts_;
    ProxyTracks tracks_;
    ProxyPath path_;
    ProxyWork work_;
    Step step_;
    // Buffers that a gathering uses.
    std::vector<Candidate> nearest_ = std::vector<Candidate>(kMaxCandidates + kSpareCandidates);
    std::vector<Vec3> nearest_normals_ = std::vector<Vec3>(kMaxCandidates + kSpareCandidates);
    std::size_t nearest_count_ = 0;
    Bvh::Queue queue_{kMostLooks};
    double known_m_ = -1.0;  // radius around the anchor within which every obstacle of the still scene is a candidate
    double dense_m_ = 4.0;   // range of the last gathering of the still scene
    bool crowded_ = false;   // the last search found more near obstacles of the still scene than kComfortableCandidates
    bool gathers_on_ = false;  // true while a gathering takes several moves
    // State that lasts from move to move.
    const HapticScene* scene_ = nullptr;  // used only for comparison, together with the generation
    // Scene whose bodies were all far at the last check. The pointer is used only for comparison.
    const HapticScene* all_far_in_ = nullptr;
    std::uint32_t generation_ = 0;
    std::uint16_t carrier_ = kStill;
    // Number of moves left in which the proxy may hurry to its goal after the obstacle in between vanished.
    int hurry_ = 0;
    bool placed_ = false;
    std::uint64_t moves_ = 0, gatherings_ = 0;
};

}  // namespace handrail::render
