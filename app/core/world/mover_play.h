// Doors, lifts, buttons, trains and turning parts on their way: which go where, when they wait and when they come back.
// Plain state and one tick; it knows no body world and speaks no word: the caller tells what a step would meet and says
// what happened. App thread only.
//
// What meets what (told to authors in docs/map-authors-guide.md): a step that would meet a body or another mover is not
// made. One with two ends then goes back to where it came from, at once before a body and after kPatience_s before a
// mover; a train or turning part waits. They are moved in their order, so of two that want the same place the earlier
// goes first.
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "worlds/scene/mover.h"

namespace handrail {

struct MoverEvent {
    enum class Kind : std::uint8_t { Leaves, Arrives, TurnsBack, Waits } kind = Kind::Leaves;
    std::uint32_t mover = 0;
    bool at_rest = false;  // Leaves: towards its rest; Arrives: there; TurnsBack: it came from there
};

enum class Meeting : std::uint8_t { None, Body, Mover };

class MoverPlay {
public:
    // What stands where the mover would be after its next step.
    using Meets = std::function<Meeting(std::uint32_t mover, const Placement& from, const Placement& to)>;
    static constexpr double kPatience_s = 3.0;  // before another mover

    // All at rest. The movers must outlive the play.
    void enter(std::span<const Mover> movers);
    // Goes on with the same movers, which lie elsewhere in memory now.
    void follow(std::span<const Mover> movers) { movers_ = movers; }
    // Sends a mover and all of its group to the other end, or back to rest from there; and what it sets going, to the
    // other end. A lift's door and a lift's button bring the lift, or open its door where it is there. A lift with
    // halts goes to the next one above, and from the highest to the lowest.
    void set_going(std::uint32_t mover);
    // Sends a lift to one of its stops, a part of its way from 0 to 1; where it stands there its doors open.
    void ride(std::uint32_t lift, double part);
    // Sends it, and its group, to the other end, or keeps it there longer; what it sets going likewise.
    void call(std::uint32_t mover);
    // Somebody has come near one that goes by itself then, or stays there: like call, but a lift's door only keeps open
    // where the lift stands, and a lift that has met somebody on its way waits until nobody is near.
    void come_near(std::uint32_t mover);
    // Nobody is near.
    void leave_alone(std::uint32_t mover) { parts_[mover].shy = false; }
    // Shuts it and its group, and nothing sends them elsewhere until they are let go of.
    void hold_shut(std::uint32_t mover, bool held);
    bool held_shut(std::uint32_t mover) const { return parts_[mover].held_shut; }
    // In the order of the movers; `meets` is asked for each that is about to move, before it does, and sees the earlier
    // ones where they have come to.
    void tick(double dt_s, const Meets& meets, std::vector<MoverEvent>& events);

    std::size_t size() const { return parts_.size(); }
    Placement at(std::uint32_t mover) const;
    Placement at_rest(std::uint32_t mover) const { return movers_[mover].at(rest(mover)); }
    // Where it is when it has come to where it goes.
    Placement at_goal(std::uint32_t mover) const { return movers_[mover].at(parts_[mover].goal); }
    // How far it is from where the file has it, 0 to 1. There a door is shut, also one that rests open.
    double part(std::uint32_t mover) const { return parts_[mover].part; }
    bool goes_shut(std::uint32_t mover) const { return parts_[mover].goal == 0.0; }
    // How far it is from where it rests, as a part of its whole way, 0 to 1; of an endless one 0.
    double away(std::uint32_t mover) const { return std::abs(parts_[mover].part - rest(mover)); }
    bool goes_to_rest(std::uint32_t mover) const {
        return !movers_[mover].endless() && parts_[mover].goal == rest(mover);
    }
    // A lift's door, while the lift is elsewhere or about to leave.
    bool lift_is_away(std::uint32_t door) const { return movers_[door].lift != kNoMover && !lift_is_at(movers_[door]); }
    // Something is on its way to an end. What never comes to rest does not count.
    bool any_moving() const;
    bool any_waiting() const;  // to go back by itself
    bool any_endless() const;  // is going

private:
    struct Part {
        double part = 0.0, goal = 0.0;  // of the way that the file gives, 0 to 1
        double left_s = 0.0;            // until it goes back by itself, or goes on from a stop
        double met_s = 0.0;             // how long something has been in its way
        bool told = true;               // that it left
        double held_s = 0.0;            // a lift's door that met somebody: until it tries to shut again
        bool shy = false;               // it met somebody on its way out, who is still near
        bool held_shut = false;
        bool going = false;  // an endless one
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

}  // namespace handrail
