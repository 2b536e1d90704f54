// Doors, lifts and buttons on their way: which go where, when they wait and when they come back. Plain state and one tick; it knows no body world and
// speaks no word: the caller tells who stands in the way and says what happened. App thread only.
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "worlds/scene/mover.h"

namespace handrail {

struct MoverEvent {
    enum class Kind : std::uint8_t { Leaves, Arrives, TurnsBack } kind = Kind::Leaves;
    std::uint32_t mover = 0;
    bool at_rest = false;  // Leaves: towards its rest; Arrives: there
};

class MoverPlay {
public:
    // All at rest. The movers must outlive the play.
    void enter(std::span<const Mover> movers);
    // Goes on with the same movers, which lie elsewhere in memory now.
    void follow(std::span<const Mover> movers) { movers_ = movers; }
    // Sends a mover and all of its group to the other end, or back to rest from there; and what it sets going, to the other end.
    void set_going(std::uint32_t mover);
    // Sends it, and its group, to the other end, or keeps it there longer; what it sets going likewise.
    void call(std::uint32_t mover);
    // `stands_in_way(mover, where)`: somebody stands where the mover would come to lie. Asked just before it arrives at rest, and it then turns back.
    void tick(double dt_s, const std::function<bool(std::uint32_t, const Placement&)>& stands_in_way, std::vector<MoverEvent>& events);

    std::size_t size() const { return parts_.size(); }
    Placement at(std::uint32_t mover) const { return movers_[mover].at(parts_[mover].part); }
    Placement at_rest(std::uint32_t mover) const { return movers_[mover].at(rest(mover)); }
    // How far it is from where it rests, as a part of its whole way, 0 to 1.
    double away(std::uint32_t mover) const { return std::abs(parts_[mover].part - rest(mover)); }
    bool any_moving() const;
    bool any_waiting() const;  // to go back by itself

private:
    struct Part {
        double part = 0.0, goal = 0.0;  // of the way that the file gives, 0 to 1
        double left_s = 0.0;            // until it goes back by itself
        bool told = true;               // that it left
    };
    double rest(std::uint32_t mover) const { return movers_[mover].rests_far ? 1.0 : 0.0; }
    void send(std::uint32_t group, bool to_rest);
    void call_others(std::uint32_t mover, int deep);

    std::span<const Mover> movers_;
    std::vector<Part> parts_;
};

}  // namespace handrail
