// The free-cell proxy: a ball kept outside a set of convex obstacles. Each candidate obstacle owns one cut, a
// half-space that supports it; any cut of a still obstacle is valid for ever, so the ball may move freely in the
// intersection of the cuts: no swept test is needed at any speed, overlapping, doubled and cracked geometry needs no
// special case, and stopping anywhere on the path is safe. One move projects the goal on the intersection, renews the
// cuts that act, and repeats until they truly touch. Candidates come from a cache that is refreshed inside the move,
// decided by the samples alone. The cuts of a moving body stand still in its own frame; where the body comes nearer it
// pushes the ball, in sub-steps of at most half the ball's radius, and where it leaves too little room the ball
// shrinks. Owned by TouchState, one thread. Allocates only in its constructor; noexcept; reads no clock. Lengths in
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

namespace handrail {

class ProxySolver {
public:
    // Beyond it the nearest are kept and Step::truncated is set.
    static constexpr int kMaxCandidates = ProxyCuts::kMost;
    // More make the margin shrink first: each costs 6 instructions in every scan.
    static constexpr int kComfortableCandidates = 38;
    static constexpr int kSpareCandidates = 16;  // found beyond these before the farthest are dropped
    static constexpr int kMaxIterations = ProxyPath::kMostRounds;
    static constexpr int kMaxStages = 8;  // gatherings within one move, for leaps through crowded places
    // Nodes and obstacles looked at in one gathering in one shape; what lies farther counts as unknown.
    static constexpr int kMostLooks = 2048;
    static constexpr double kSmallestRadius_m = 1e-5;
    // What one move may do, counted and not clocked, so that every machine does the same: in units of about a
    // nanosecond (see kLookWork and its like). Over it what is not known counts as occupied, the cuts that there are
    // go on, and the ball, or a body that comes at it, waits for the next move.
    static constexpr int kMostWork = 88'000;
    // Of it gatherings leave that for the rounds: cuts that were found and not used help nobody.
    static constexpr int kRoundsWork = 18'000;

    struct Request {
        Vec3 goal_m{0.0};  // world
        double radius_m = 0.005;
        double path_cap_m = 0.0;  // longest way the ball may run in this move
        double margin_m = 0.02;   // wish: how far the ball may go before candidates are gathered again
        double growth_m = 0.0;    // how much a shrunken ball grows in this move
        // At most this many rounds, up to kMaxIterations. Fewer never let the ball through anything, it only lags
        // (tests: I17). 0: the cuts as they are, none renewed and none gathered, what a move with no time to look at
        // the scene would do (tests: I18).
        int most_rounds = kMaxIterations;
        const BodyPoses* bodies = nullptr;  // each scale > 0; null: all as the scene has them
    };

    static constexpr std::uint16_t kStill = OwnedObstacle::kStill;  // belongs to no body

    // One surface that holds the ball.
    struct Hold {
        std::uint32_t obstacle = 0;
        std::uint16_t body = kStill;  // whose shape the obstacle belongs to
        Vec3 normal{0.0};
        double multiplier_m = 0.0;
    };

    struct Step {
        std::array<Hold, 3> holds{};
        int count = 0;
        int iterations = 0;
        bool converged = true, truncated = false, capped = false, ghosted = false;
        bool waits = false;     // the move had more to do than kMostWork: the rest comes with the next ones
        bool pushed = false;    // a body moved the ball
        bool squeezed = false;  // the ball had to shrink

        // For the next move; the holds are written up to the count anyhow.
        void begin() noexcept {
            count = iterations = 0;
            converged = true;
            truncated = capped = ghosted = waits = pushed = squeezed = false;
        }
    };

    // The next move starts at its goal.
    void reset() noexcept;
    // Has: AllFeatures, or PlainFeatures where scene.plain.
    template <class Has = AllFeatures>
    const Step& move(const HapticScene& scene, const Request& request) noexcept;
    // Before move(): true when no body is near enough to have a part in it, so that it may be a move without bodies.
    bool bodies_are_far(const HapticScene& scene, const Request& request) noexcept;
    // The same at a glance, for a tick on which nothing about them has changed: false says nothing.
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
    // After move(), with at least one hold: the friction cone. Walks back along the path until the ball is reach_m from
    // where the goal pulls it, or to its start, but never off the surfaces: a ball that was free goes straight to where
    // it touches first, and friction begins there.
    template <class Has = AllFeatures>
    void hold_back(const HapticScene& scene, double reach_m) noexcept;
    // After move(): from now to the next move the ball goes with this body (kStill: with none), as friction makes it.
    void ride(std::uint16_t body) noexcept { carrier_ = body; }

    // The frame of a body as it stands, in world metres, and the shape that holds.
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
    // A world place in the coordinates of the shape that holds (those of its triangles, boxes and planes).
    Vec3 to_own(const HapticScene& scene, const Hold& hold, const Vec3& world_m) const noexcept;

    // After move(). From the goal to the ball (zero, exactly, in free space), from where the ball was before the move
    // to where it is now, and the same pull without friction or speed cap: where surfaces alone would let the ball go.
    Vec3 offset_m() const noexcept { return ball_m_ - goal_m_; }
    Vec3 slide_m() const noexcept { return ball_m_ - path_[0]; }
    // The same without the way through the air to the first touch, after hold_back().
    Vec3 rubbed_m() const noexcept { return ball_m_ - path_[path_.rubs_from]; }
    Vec3 press_m() const noexcept { return basis_.point_m - goal_m_; }
    Vec3 rest_m() const noexcept { return anchor_m_ + basis_.point_m; }  // of that, in the scene's own coordinates
    double radius_m() const noexcept { return radius_m_; }
    Vec3 local_m() const noexcept { return anchor_m_ + ball_m_; }  // in the scene's own coordinates
    Vec3 world_m() const noexcept { return scene_origin_m_ + anchor_m_ + ball_m_; }
    // For checks: every point of the last path, in world metres.
    int path_size() const noexcept { return path_.size; }
    Vec3 path_m(int i) const noexcept { return scene_origin_m_ + anchor_m_ + path_[i]; }
    // For checks: the candidates with their cuts (in the scene's own coordinates), and gatherings since the reset.
    int candidates() const noexcept { return cuts_.count; }
    std::uint32_t candidate(int i) const noexcept { return cuts_.obstacles[static_cast<std::size_t>(i)]; }
    HalfSpace cut(int i) const noexcept {
        const HalfSpace& cut = cuts_.planes[static_cast<std::size_t>(i)];
        return {cut.normal, cut.offset_m + glm::dot(cut.normal, anchor_m_)};
    }
    std::uint64_t gatherings() const noexcept { return gatherings_; }
    // Nodes and obstacles looked at in the last move for starting and gathering, and its work, without what is cheap.
    int looks() const noexcept { return work_.looks; }
    int work() const noexcept { return kMostWork - work_.left; }
    // Bodies that the tick follows, and where it has one of them, which lags while it waits.
    std::size_t tracked() const noexcept { return tracks_.count; }
    bool tracks(std::size_t body) const noexcept { return tracks_.follows(body); }
    Placement body_at(std::size_t body) const noexcept { return tracks_.of(body).at; }
    // For checks: follows every body of the scene, however far, as far as there is room. The same numbers come out, bit
    // for bit, and it costs more; except while the ball hurries after something that vanished, where who follows few
    // stops sooner.
    void track_all() noexcept { tracks_.all = true; }
    bool hurries() const noexcept { return hurry_ > 0; }

private:
    struct Candidate {
        double distance_m;  // at most that of the obstacle: how far its cut is
        std::uint32_t obstacle;
        std::uint32_t normal;  // of nearest_normals_
    };
    static inline const PlacedFrame kWorldFrame{};

    void place(const HapticScene& scene, const Request& request, const Vec3& local_m, double radius_m) noexcept;
    void place_in(const HapticScene& scene, std::uint16_t body, double radius_m) noexcept;
    // How far around the ball bodies must have a track: a push of 64 sub-steps of bodies that carry it, and as far as
    // candidates are gathered.
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
    void make_room(const HapticScene& scene, const Vec3& wish_m) noexcept;
    void drop_body(std::uint16_t body) noexcept;
    // How far around a place every obstacle is a candidate.
    template <class Has = AllFeatures>
    double known_around(const Vec3& at_m) noexcept {
        const double known = known_m_ - glm::length(at_m);
        return !Has::kBodies || (tracks_.count == 0 && !tracks_.far_short) ? known : known_of_bodies(at_m, known);
    }
    double known_of_bodies(const Vec3& at_m, double known_m) noexcept;
    // Something done with each body that is followed. A few need not be counted.
    void spend_on_tracked(int work) noexcept;
    void gather(const HapticScene& scene, double reach_m, double needed_m) noexcept;
    void gather_waiting(const HapticScene& scene, double reach_m, double needed_m) noexcept;
    void look_at_body(const HapticScene& scene, std::uint16_t body, double reach_m, double needed_m,
                      std::size_t share) noexcept;
    void drop_candidates(std::uint16_t body) noexcept;
    // leaves(owner): what is of that body goes.
    template <class Leaves>
    void drop_candidates_of(const Leaves& leaves) noexcept;
    // After something costly: over the budget the rounds end.
    void spend(int work) noexcept {
        work_.left -= work;
        if (work_.left > 0) return;
        work_.most_rounds = 1;  // one at least, with what is known
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
    // Sheets of one side.
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
    // Of a step from the ball, before it leaves the first cut; met, where given, is that cut, and untouched when it
    // leaves none.
    double fraction_inside(const Vec3& step, int* met = nullptr) const noexcept;
    // Of hold_back.
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
    // The cut with the ball's radius: what the ball's centre must satisfy.
    HalfSpace wall(int i) const noexcept { return cuts_.wall(i, radius_m_); }

    // Vectors below, of cuts and of the path, too, are relative to anchor_m_, the ball's place (scene coordinates) when
    // candidates were last gathered: short numbers, so rounding does not grow with the building.
    Vec3 scene_origin_m_{0.0}, anchor_m_{0.0}, ball_m_{0.0}, goal_m_{0.0};
    double radius_m_ = 0.0;
    ProjectionBasis basis_;
    ProxyCuts cuts_;
    ProxyGhosts ghosts_;
    ProxyTracks tracks_;
    ProxyPath path_;
    ProxyWork work_;
    Step step_;
    // Of what is gathered.
    std::vector<Candidate> nearest_ = std::vector<Candidate>(kMaxCandidates + kSpareCandidates);
    std::vector<Vec3> nearest_normals_ = std::vector<Vec3>(kMaxCandidates + kSpareCandidates);
    std::size_t nearest_count_ = 0;
    Bvh::Queue queue_{kMostLooks};
    double known_m_ = -1.0;    // every obstacle nearer to the anchor than this is a candidate
    double dense_m_ = 4.0;     // as far as the last gathering of what stands still went
    bool crowded_ = false;     // more than are comfortable stood near when what stands still was looked at last
    bool gathers_on_ = false;  // a gathering takes more than one move
    // Of moves.
    const HapticScene* scene_ = nullptr;       // only compared, together with the generation
    const HapticScene* all_far_in_ = nullptr;  // whose bodies were all found far at the last look; only compared
    std::uint32_t generation_ = 0;
    std::uint16_t carrier_ = kStill;
    int hurry_ = 0;  // moves left in which the ball may hasten to a goal that a vanished thing kept it from
    bool placed_ = false;
    std::uint64_t moves_ = 0, gatherings_ = 0;
};

}  // namespace handrail
