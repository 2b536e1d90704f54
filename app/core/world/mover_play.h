// Doors, lifts, buttons, trains and turning parts in motion: which ones move, when they wait and when they return.
// Plain state and one tick. It knows no solids and announces nothing: the caller reports what a step would meet, and
// announces events. App thread only.
//
// Collisions (docs/map-authors-guide.md explains them to authors): a step that would meet a walker or another mover is
// not made. A mover with two ends then returns to where it came from, at once before a walker and after kPatience_s
// before a mover; a train or turning part waits. Movers are moved in their order, so of two that want the same place
// the earlier one goes first.
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "worlds/scene/mover.h"

namespace handrail::core {

struct MoverEvent {
    enum class Kind : std::uint8_t { Leaves, Arrives, TurnsBack, Waits } kind = Kind::Leaves;
    std::uint32_t mover = 0;
    bool at_rest = false;  // Leaves: towards its rest; Arrives: at its rest; TurnsBack: it came from its rest
};

enum class Meeting : std::uint8_t { None, Body, Mover };

class MoverPlay {
public:
    // What is where the mover would be after its next step.
    using Meets = std::function<Meeting(std::uint32_t mover, const Placement& from, const Placement& to)>;
    static constexpr double kPatience_s = 3.0;  // before another mover

    // Starts with all movers at rest. The movers must outlive this object.
    void enter(std::span<const Mover> movers);
    // Continues with the same movers at a new address.
    void follow(std::span<const Mover> movers) { movers_ = movers; }
    // Sends a mover and its whole group to the other end, or back to rest from there; what it sets going goes to the
    // other end. A lift's door and a lift's button call the lift, or open its door if the lift is there. A lift with
    // halts goes to the next one above, and from the highest to the lowest.
    void set_going(std::uint32_t mover);
    // Sends a lift to one of its stops, given as a share of its path from 0 to 1. If it is there already, its doors
    // open.
    void ride(std::uint32_t lift, double part);
    // Sends a mover and its group to the other end, or keeps it there longer; also what it sets going.
    void call(std::uint32_t mover);
    // Somebody has come near, or stays near, a mover that then acts automatically. Like call, but a lift's door only
    // stays open while the lift is there. A lift that has met somebody on its path waits until nobody is near.
    void come_near(std::uint32_t mover);
    // Nobody is near any more.
    void leave_alone(std::uint32_t mover) { parts_[mover].shy = false; }
    // Shuts a mover and its group and keeps them shut until they are released.
    void hold_shut(std::uint32_t mover, bool held);
    bool held_shut(std::uint32_t mover) const { return parts_[mover].held_shut; }
    // Moves in the order of the movers. `meets` is called for each one that is about to move, before it does, when
    // earlier ones have already moved.
    void tick(double dt_s, const Meets& meets, std::vector<MoverEvent>& events);

    std::size_t size() const { return parts_.size(); }
    Placement at(std::uint32_t mover) const;
    Placement at_rest(std::uint32_t mover) const { return movers_[mover].at(rest(mover)); }
    // Its place at the end of its present movement.
    Placement at_goal(std::uint32_t mover) const { return movers_[mover].at(parts_[mover].goal); }
    // Distance from its place in the file, 0 to 1. There a door is shut, even if it rests open.
    double part(std::uint32_t mover) const { return parts_[mover].part; }
    bool goes_shut(std::uint32_t mover) const { return parts_[mover].goal == 0.0; }
    // Distance from its rest as a share of its whole path, 0 to 1; 0 for an endless one.
    double away(std::uint32_t mover) const { return std::abs(parts_[mover].part - rest(mover)); }
    bool goes_to_rest(std::uint32_t mover) const {
        return !movers_[mover].endless() && parts_[mover].goal == rest(mover);
    }
    // True for a lift's door while the lift is elsewhere or about to leave.
    bool lift_is_away(std::uint32_t door) const { return movers_[door].lift != kNoMover && !lift_is_at(movers_[door]); }
    // True while something moves to an end. Endless movers do not count.
    bool any_moving() const;
    bool any_waiting() const;  // to return automatically
    bool any_endless() const;  // that is moving

private:
    struct Part {
        double part = 0.0, goal = 0.0;  // share of the path in the file, 0 to 1
        double left_s = 0.0;            // until it returns automatically, or continues from a stop
        double met_s = 0.0;             // how long something has been in its way
        bool told = true;               // its departure has been reported
        double held_s = 0.0;            // for a lift's door that met somebody: until it tries to shut again
        bool shy = false;               // it met somebody on its way out, who is still near
        bool held_shut = false;
        bool going = false;  // for an endless one
        std::uint32_t next_stop = 0;
        Vec3 at_m{0.0};           // of a train
        double turned_rad = 0.0;  // of a turning part, -pi to pi
    };
    double rest(std::uint32_t mover) const { return movers_[mover].rests_far ? 1.0 : 0.0; }
    Placement where(std::uint32_t mover, const Part& part) const;
    void send(std::uint32_t group, bool to_rest);
    void send_lift(std::uint32_t lift, double part);
    double next_halt(std::uint32_t lift) const;
    void call_others(std::uint32_t mover, int deep);
    void open_doors(std::uint32_t lift);
    bool doors_shut(std::uint32_t lift) const;
    bool lift_is_at(const Mover& door) const;
    void turn_back(std::uint32_t mover);
    void tick_endless(std::uint32_t mover, double dt_s, const Meets& meets, std::vector<MoverEvent>& events);
    void tick_ends(std::uint32_t mover, double dt_s, const Meets& meets, std::vector<MoverEvent>& events);

    std::span<const Mover> movers_;
    std::vector<Part> parts_;
};

}  // namespace handrail::core
