// Moving by ear: along a wall, back along one's path, square to a wall, and by leaps from thing to thing (Leaping).
// This class says where the walker should go; Walking moves it. While it follows a wall it never turns or climbs
// silently: it announces each new direction, and it waits before stairs until the command is repeated. App thread only;
// world metres.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/core/context/session_part.h"
#include "app/core/dialogue/held_keys.h"
#include "app/core/walking/leaping.h"
#include "app/core/world/trail.h"

namespace handrail::core {

class ByEar : SessionPart {
public:
    // Turns `body`, and lays and takes up the trail of points for the way back.
    ByEar(const SessionContext& context, WalkerState& body, const HeldKeys& keys);

    void enter_world();
    // Call it after the walker was placed elsewhere in the same world.
    void set_down();
    // Call it with every command before it acts: any other action ends following and going back.
    void notice(Command command);
    // Returns false if the command belongs to another feature. times: number of steps along a wall or back.
    bool act(Command command, double now_s, int times = 1);
    // True while following a wall or going back moves the walker.
    bool leads() const;
    // The wished velocity of the walker, metres per second, level; no value: the person's own keys apply.
    std::optional<Vec3> lead(double now_s, double dt_s);
    // Drops the remaining distance of taps.
    void halt();
    // Adds the walker's place to the path for the way back.
    void lay_crumb();
    // Call it before leaps, Home and the like, so that they can be undone.
    void keep_place() { leaping_.keep_place(); }
    // The level normal of the wall that the walker follows; no value if there is none.
    std::optional<Vec3> wall_at_side() const;

    // Set by the session: the answer to "where am I", and the doors of the present room.
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

    WalkerState& body_;
    const HeldKeys& keys_;
    Trail trail_;
    double trail_left_m_ = 0.0;    // remaining distance of taps
    bool trail_to_event_ = false;  // until the next event of the wall
    double retrace_left_m_ = 0.0;  // remaining distance of taps back along the path
    bool retracing_ = false;
    double told_heading_rad_ = 0.0, told_z_m_ = 0.0;  // as last announced to the person
    // Stairs before which following waits. A repeated command continues over them, until the ground is level again.
    struct Stairs {
        bool held = false, climbs = false;
        double z_m = 0.0, level_m = 0.0;  // height in the last tick; distance on level ground
        Vec3 from_m{0.0}, looked_m{1e9};
    };
    Stairs stairs_;
    Leaping leaping_{context_, body_, where_am_i, doors_of_room};
};

}  // namespace handrail::core
