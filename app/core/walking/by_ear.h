// Moves the walker by ear: along a wall, back along the walked path, facing a wall squarely, and by leaps from thing to
// thing (Leaping). This class says where the walker should go, and Walking moves the walker. While it follows a wall,
// it announces each new direction and each climb, and it stops before stairs until the person repeats the command. Use
// it on the app thread only. Lengths are in world metres.
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
    // Turns the walker in `body`, and stores there the trail of points for the way back.
    ByEar(const SessionContext& context, WalkerState& avatar, const HeldKeys& keys);

    void enter_world();
    // Ends following a wall and going back. Call it after the walker was moved elsewhere in the same world.
    void set_down();
    // Call it with every command before the command acts. A command other than those of this class ends following a
    // wall and going back.
    void notice(Command command);
    // Carries out a command. `times` is the number of steps along a wall or back. Returns false if the command belongs
    // to another feature.
    bool act(Command command, double now_s, int times = 1);
    // Returns true while following a wall or going back moves the walker.
    bool leads() const;
    // Returns the intended horizontal velocity of the walker in metres per second. Returns no value if the walker moves
    // by the person's own keys.
    std::optional<Vec3> lead(double now_s, double dt_s);
    // Drops the remaining distance of tapped keys, so that the walker stops.
    void halt();
    // Adds the walker's position to the trail for the way back.
    void lay_crumb();
    // Stores the present place for undoing. Call it before leaps, before the command Home, and before any other command
    // that moves the walker elsewhere.
    void keep_place() { leaping_.keep_place(); }
    // Returns the horizontal normal of the wall that the walker follows, or no value if it follows none.
    std::optional<Vec3> wall_at_side() const;

    // The session sets these functions. They return the answer to "where am I" and the doors of the present room.
    std::function<std::string()> where_am_i;
    std::function<std::vector<LeapDoor>()> doors_of_room;

private:
    bool start_trail(TrailSide side, double now_s);
    void announce_start(double now_s);
    void announce_trail(const TrailEvent& event, double now_s);
    std::string going_words();
    void announce_turn_and_climb(double now_s);
    bool waits_at_stairs(double heading_rad, double now_s);
    std::optional<Vec3> retrace(double now_s, double dt_s);
    void square_up(double now_s);

    WalkerState& avatar_;
    const HeldKeys& keys_;
    Trail trail_;
    double trail_left_m_ = 0.0;    // remaining distance along the wall for tapped keys
    bool trail_to_event_ = false;  // true: the walker continues until the next event of the wall, such as a corner
    double retrace_left_m_ = 0.0;  // remaining distance back along the trail for tapped keys
    bool retracing_ = false;
    double announced_heading_rad_ = 0.0, announced_z_m_ = 0.0;  // direction and height that were announced last
    // Stairs at which following a wall stops (`held`). If the person repeats the command, the walker continues over
    // them (`climbs`) until the ground is level again.
    struct Stairs {
        bool held = false, climbs = false;
        // `z_m`: height in the last tick. `level_m`: distance since then on level ground.
        double z_m = 0.0, level_m = 0.0;
        Vec3 from_m{0.0}, looked_m{1e9};
    };
    Stairs stairs_;
    Leaping leaping_{context_, avatar_, where_am_i, doors_of_room};
};

}  // namespace handrail::core
