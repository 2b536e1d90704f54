// Moving by ear: along a wall, back the way one came, square to a wall; from one thing to the next by Leaping. Says
// where the body shall go; Walking moves it. Trailing never turns or climbs without a word: each new direction is told,
// and before stairs it waits to be asked again. App thread only; world metres.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/dialogue/held_keys.h"
#include "app/core/walking/leaping.h"
#include "app/core/world/trail.h"

namespace handrail {

class ByEar : SessionPart {
public:
    // It turns `body`, and lays and takes up the crumbs it goes back along.
    ByEar(const SessionContext& context, BodyState& body, const HeldKeys& keys);

    void enter_world();
    // The body was set down elsewhere in the same world.
    void set_down();
    // Whatever else the person does ends trailing and going back; told of every command before it is acted on.
    void notice(Command command);
    // False: it is another's.
    // times: of steps along a wall or back.
    bool act(Command command, double now_s, int times = 1);
    // Trailing or going back leads the body now.
    bool leads() const;
    // Where they want the body to go, metres per second, level; none: the person's own keys count.
    std::optional<Vec3> lead(double now_s, double dt_s);
    // What is still to go of taps is not gone any more.
    void halt();
    // Where the body stands counts among the places that one goes back along.
    void lay_crumb();
    // Leaps, Home and the like can be taken back: called before them.
    void keep_place() { leaping_.keep_place(); }
    // Out of the wall that the body's side is at while it trails, level.
    std::optional<Vec3> wall_at_side() const;

    // Set by the session: the answer to "where am I", and the doors of the room one is in.
    std::function<std::string()> where_am_i;
    std::function<std::vector<LeapDoor>()> doors_of_room;

private:
    bool start_trail(TrailSide side, double now_s);
    void tell_start(double now_s);
    void tell_trail(const TrailEvent& event, double now_s);
    std::string going_words();
    void tell_turn_and_climb(double now_s);
    bool waits_at_stairs(double heading_rad, double now_s);
    std::optional<Vec3> retrace(double now_s, double dt_s);
    void square_up(double now_s);

    BodyState& body_;
    const HeldKeys& keys_;
    Trail trail_;
    double trail_left_m_ = 0.0;    // of taps, still to go
    bool trail_to_event_ = false;  // until something is met
    double retrace_left_m_ = 0.0;  // of taps, still to go back along the body's crumbs
    bool retracing_ = false;
    double told_heading_rad_ = 0.0, told_z_m_ = 0.0;  // of the trail: as the person knows them
    // The stairs before which trailing waits: it goes on over them when it is asked again, until it is on the level.
    struct Stairs {
        bool held = false, climbs = false;
        double z_m = 0.0, level_m = 0.0;  // where it was last tick, and how far it has been on the level
        Vec3 from_m{0.0}, looked_m{1e9};
    };
    Stairs stairs_;
    Leaping leaping_{context_, body_, where_am_i, doors_of_room};
};

}  // namespace handrail
