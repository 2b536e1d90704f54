// Moves doors, lifts, buttons, trains and turning parts: it decides which of them move, when they wait and when they
// return. Plain state and one tick. This class knows no solids and makes no announcements. The caller reports what a
// step would meet, and announces the events. Use it on the app thread only.
// Collisions, which docs/map-authors-guide.md explains to authors, follow these rules:
// - A step that would meet a walker or another mover is not made.
// - A mover with two ends then returns to where it came from, at once if it meets a walker, and after kPatience_s
//   if it meets a mover.
// - A train or a turning part waits.
// - The movers move in the order of the list, so if two of them need the same place, the earlier one gets it.
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
    // True: the mover moves towards its rest for Leaves, is at its rest for Arrives, or came from its rest for
    // TurnsBack.
    bool at_rest = false;
};

enum class Meeting : std::uint8_t { None, Body, Mover };

class MoverPlay {
public:
    // Returns what a mover would meet if it moved from `from` to `to`.
    using Meets = std::function<Meeting(std::uint32_t mover, const Placement& from, const Placement& to)>;
    static constexpr double kPatience_s = 3.0;  // how long a mover waits for another mover before it returns

    // Starts with all movers at rest. `movers` must outlive this object.
    void enter(std::span<const Mover> movers);
    // Continues with the same movers after they have moved to another address.
    void follow(std::span<const Mover> movers) { movers_ = movers; }
    // Sends a mover and its whole group to the other end, or back to rest from there. Movers that are set going by the
    // mover move to their other end. The door or the button of a lift calls the lift, or opens the lift's door if the
    // lift is there. A lift with halts moves to the next halt above, and from the highest to the lowest.
    void set_going(std::uint32_t mover);
    // Sends a lift to one of its halts, given as a share of its path from 0 to 1. If the lift is already there, its
    // doors open.
    void ride(std::uint32_t lift, double part);
    // Sends a mover and its group to the other end, or keeps them there longer. The same happens to the movers that are
    // set going by the mover.
    void call(std::uint32_t mover);
    // Call it while a person is near a mover that then acts automatically. It does the same as call(), but the door of
    // a lift stays open only while the lift is there. A lift that has met a person on its path waits until no person is
    // near.
    void come_near(std::uint32_t mover);
    // Call it when no person is near this mover any more.
    void leave_alone(std::uint32_t mover) { parts_[mover].shy = false; }
    // Shuts a mover and its group and keeps them shut until they are released.
    void hold_shut(std::uint32_t mover, bool held);
    bool held_shut(std::uint32_t mover) const { return parts_[mover].held_shut; }
    // Moves the movers, in their order. `meets` is called for each mover immediately before it moves, when the earlier
    // ones have already moved.
    void tick(double dt_s, const Meets& meets, std::vector<MoverEvent>& events);

    std::size_t size() const { return parts_.size(); }
    Placement at(std::uint32_t mover) const;
    Placement at_rest(std::uint32_t mover) const { return movers_[mover].at(rest(mover)); }
    // Returns the position of a mover at the end of its present movement.
    Placement at_goal(std::uint32_t mover) const { return movers_[mover].at(parts_[mover].goal); }
    // Returns how far a mover is from its place in the file, 0 to 1. A door is shut at that place, even if it rests
    // open.
    double part(std::uint32_t mover) const { return parts_[mover].part; }
    bool goes_shut(std::uint32_t mover) const { return parts_[mover].goal == 0.0; }
    // Returns how far a mover is from its rest, as a share of its whole path, 0 to 1. Returns 0 for an endless mover.
    double away(std::uint32_t mover) const { return std::abs(parts_[mover].part - rest(mover)); }
    bool goes_to_rest(std::uint32_t mover) const {
        return !movers_[mover].endless() && parts_[mover].goal == rest(mover);
    }
    // Returns true for the door of a lift while the lift is elsewhere or about to leave.
    bool lift_is_away(std::uint32_t door) const { return movers_[door].lift != kNoMover && !lift_is_at(movers_[door]); }
    // Returns true while a mover moves to one of its ends. Endless movers are ignored.
    bool any_moving() const;
    bool any_waiting() const;  // returns true if a mover waits before it returns automatically
    bool any_endless() const;  // returns true if an endless mover is moving

private:
    struct Part {
        double part = 0.0, goal = 0.0;  // present position and goal, as shares of the path in the file, 0 to 1
        double left_s = 0.0;            // time until the mover returns automatically, or continues from a stop
        double met_s = 0.0;             // how long something has been in the mover's way
        bool reported = true;           // true: the departure of the mover has been reported
        double held_s = 0.0;  // for the door of a lift that has met somebody: time until it tries to shut again
        bool shy = false;     // true: the mover met a person on its way out, and the person is still near
        bool held_shut = false;
        bool going = false;  // true: this endless mover is moving
        std::uint32_t next_stop = 0;
        Vec3 at_m{0.0};           // position of a train
        double turned_rad = 0.0;  // angle of a turning part, -pi to pi
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
