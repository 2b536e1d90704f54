// Walks and turns by keys and sticks. This class moves the walker, announces what the walker meets, and records the
// walker's path. ByEar guides the walker along walls or back, and Footing stops the walker at edges. Use it on the app
// thread only.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/walking/by_ear.h"
#include "app/core/walking/footing.h"
#include "app/core/walking/gait.h"
#include "app/core/walking/paces.h"
#include "app/core/walking/steering.h"

namespace handrail::core {

class Walking : SessionPart {
public:
    Walking(const SessionContext& context, WalkerState& avatar, const HeldKeys& keys, ByEar& by_ear, Footing& footing)
        : SessionPart(context), avatar_(avatar), keys_(keys), by_ear_(by_ear), footing_(footing) {}

    // Call it after the walker has been placed at the base of a world.
    void enter_world();
    // Moves the walker elsewhere in this world, to `feet_m` or as near above it as there is room. Pending movements
    // end.
    void set_down(const Vec3& feet_m, double heading_rad);
    // Carries out steps, turns, following a wall, leaps and the command Home. `times` is the number of steps or turns.
    // Returns false if the command belongs to another feature.
    bool act(Command command, double now_s, int times = 1);
    // Call it for commands of other features, because some of them end following a wall.
    void notice(Command command, double now_s);
    // Turns, tilts and moves the walker for `dt_s`, which is at most 0.1 s.
    void tick(double now_s, double dt_s);
    // Plays the tone of the nearest wall ahead, if the person has switched that tone on.
    void announce_walls(double now_s);
    // Moves the walker to the base.
    void go_home(double now_s);
    // Moves a walker that is inside a solid to the nearest free place. Returns the distance in words, or a sentence if
    // there is no such place. Returns an empty text if the walker is already free.
    std::string bring_out(double now_s);
    // Sets the position of the sticks, which acts until the next call. A value that is not finite is replaced by the
    // rest position.
    void steer(const Steering& steering);
    // Drops the steps that have not been walked.
    void halt() {
        pending_ = {};
        gait_.stand();
    }
    // Turns the walker to this heading and announces it.
    void face(double heading_rad, double now_s);
    // Does the same as halt(), and resets the wall tone. Call it after all sounds have been stopped, including the wall
    // tone.
    void fall_silent();

    // Returns true if nothing is pending: no steps, no turn, no guided walk.
    bool idle() const;
    double tilt_rad() const { return tilt_rad_; }  // returns the tilt of the eyes; up is positive
    // Returns the walked path at floor level: points a quarter of a metre apart, the oldest first.
    const std::vector<Vec3>& path_m() const { return path_m_; }
    // Returns the free width across the walking direction at the height of the waist, or 0 if a side is open.
    double passage_width_m() const;

    // The session sets this function, which is called before each step. It pushes movable things in front of the
    // walker, and removes from `intended_m_per_s` the part that leads into a body that overlaps the walker. It returns
    // true if a thing moves aside. In that case, the contact is not a bump.
    std::function<bool(Vec3& intended_m_per_s, double now_s)> push_ahead;
    // Called after each step, with what the walker did and met.
    std::function<void(const WalkResult& walked, double now_s)> on_walked;
    // Called for each audible bump, which is a contact of a walker that was free before.
    std::function<void(FeatureId feature, double now_s)> on_bumped;
    // Returns how far to the right a walker that was stopped at this place must slide to get into a doorway
    // (BlindGround::line_up_m).
    std::function<std::optional<double>(const Vec3& feet_m, double heading_rad)> line_up_m;

private:
    void stand();  // resets everything for a walker that was just placed: nothing is pending, and nothing has been met
    void step(double& pending_m, double sign, int times);
    void turn_by(double by_rad, int times, double now_s);
    void turn(double now_s, double dt_s);
    void walk(double now_s, double dt_s);
    Vec3 own_velocity(double& way_m, double dt_s);
    void take_from_pending(double way_m);
    void end_fall(double now_s);
    void hover(bool wants_to_go, double now_s);
    bool go_on(const WalkResult& walked, const Vec3& intended, double way_m, double now_s);
    void announce_frame(double now_s);
    void announce_slide(const TraceHit& met, double way_m, double now_s);
    void announce_step(const WalkerMotion& before, const WalkResult& walked, double now_s);
    void announce_heading(double now_s);
    void announce_rest(bool goes, double now_s);
    void announce_bump(const TraceHit& met, double way_rad, double now_s);

    WalkerState& avatar_;
    const HeldKeys& keys_;
    ByEar& by_ear_;
    Footing& footing_;
    Steering steering_;
    // Remaining distances of tapped keys. The walker continues after the key is released.
    struct Pending {
        double ahead_m = 0.0;  // negative: backwards
        double right_m = 0.0;
    };
    Pending pending_;
    Gait gait_;
    struct Brushed {
        double slid_m = 0.0;          // distance that the walker has slid along a surface since its last sound
        std::optional<TraceHit> met;  // last contact of this walk
    };
    Brushed brushed_;
    double since_footstep_m_ = 0.0;
    bool went_ = false;     // true: the walker moved in the last tick because the person wanted it
    bool blocked_ = false;  // true: a bump was announced, and the walker has not moved away since then
    // True: no ground of this world holds the walker. The walker then stays in place until it is placed elsewhere.
    bool hovers_ = false;
    bool stick_turns_ = false, free_keys_announced_ = false;
    double last_turn_repeat_s_ = 0.0;
    std::optional<double> heading_due_s_;  // time at which to announce the heading; each further turn postpones it
    Paces paces_;
    double walked_s_ = -1e9;  // time when the walker last moved
    double tilt_rad_ = 0.0;
    // The tone of walls, and the place where the walker stopped last.
    struct Tone {
        double loudness = 0.0;
        Vec3 feet_m{0.0};
        double heading_rad = 0.0, since_s = 0.0;
    };
    Tone tone_;
    std::vector<Vec3> path_m_;
};

}  // namespace handrail::core
