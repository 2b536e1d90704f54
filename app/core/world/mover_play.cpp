#include "app/core/world/mover_play.h"

#include <algorithm>

#include "worlds/base/contract.h"

namespace handrail::core {
namespace {

constexpr int kDeepestChain = 8;  // A button may press other buttons, up to this depth, so that a ring of buttons ends.

}  // namespace

void MoverPlay::enter(std::span<const Mover> movers) {
    movers_ = movers;
    parts_.assign(movers.size(), {});
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
        Part& part = parts_[i];
        part.part = part.goal = rest(i);
        if (!movers[i].endless()) continue;
        part.going = movers[i].starts_going;
        part.next_stop = 1;
        if (movers[i].stops.empty()) continue;
        part.at_m = movers[i].stops.front().at_m;
        part.left_s = std::max(0.0, movers[i].stops.front().wait_s);
    }
}

Placement MoverPlay::where(std::uint32_t mover, const Part& part) const {
    const Mover& m = movers_[mover];
    if (m.turn_rad_per_s != 0.0) return {m.pivot_m, rotation_about(m.turn_axis, part.turned_rad), 1.0};
    if (m.stops.size() > 1) return {part.at_m, {}, 1.0};
    return m.at(part.part);
}

Placement MoverPlay::at(std::uint32_t mover) const { return where(mover, parts_[mover]); }

void MoverPlay::send(std::uint32_t group, bool to_rest) {
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
        if (movers_[i].group != group || !movers_[i].moves() || parts_[i].held_shut) continue;
        Part& part = parts_[i];
        if (movers_[i].endless()) {
            // The train or turning part leaves the stop at which it waits.
            if (part.going == to_rest) part.left_s = 0.0;
            part.going = !to_rest;
            continue;
        }
        const double goal = to_rest ? rest(i) : 1.0 - rest(i);
        if (part.goal != goal) {
            part.reported = false;
            part.met_s = 0.0;
        }
        part.goal = goal;
        part.left_s = std::max(0.0, movers_[i].wait_s);
    }
}

void MoverPlay::hold_shut(std::uint32_t mover, bool held) {
    contract_pre(mover < parts_.size());
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
        if (movers_[i].group != movers_[mover].group || !movers_[i].moves() || movers_[i].endless()) continue;
        Part& part = parts_[i];
        if (part.held_shut == held) continue;
        part.held_shut = held;
        // The shut place is the place in the file, even if the door rests open.
        const double goal = held ? 0.0 : rest(i);
        part.reported = part.reported && part.goal == goal;
        part.goal = goal;
    }
}

// Sends a lift to a part of its path. If the lift is already there, its doors open.
void MoverPlay::send_lift(std::uint32_t lift, double part) {
    if (parts_[lift].part == part && parts_[lift].goal == part) return open_doors(lift);
    send(movers_[lift].group, part == rest(lift));
    if (parts_[lift].goal == part) return;
    parts_[lift].goal = part;  // The goal is a halt between the ends.
    parts_[lift].reported = false;
}

// Returns the next halt above the lift's goal. If the goal is the highest halt, returns the lowest one.
double MoverPlay::next_halt(std::uint32_t lift) const {
    const std::vector<double>& halts = movers_[lift].halts;
    const auto above =
        std::find_if(halts.begin(), halts.end(), [&](double halt) { return halt > parts_[lift].goal + 1e-9; });
    return above == halts.end() ? halts.front() : *above;
}

bool MoverPlay::lift_is_at(const Mover& door) const {
    const Part& lift = parts_[door.lift];
    return lift.part == door.lift_part && lift.goal == door.lift_part;
}

void MoverPlay::open_doors(std::uint32_t lift) {
    for (const Mover& door : movers_)
        if (door.lift == lift && lift_is_at(door)) send(door.group, false);
}

bool MoverPlay::doors_shut(std::uint32_t lift) const {
    for (std::uint32_t i = 0; i < parts_.size(); ++i)
        if (movers_[i].lift == lift && (parts_[i].part != rest(i) || parts_[i].goal != rest(i))) return false;
    return true;
}

void MoverPlay::call_others(std::uint32_t mover, int deep) {
    if (deep == 0) return;
    for (const std::uint32_t other : movers_[mover].sets_going) {
        if (movers_[mover].sends_to >= 0.0) send_lift(other, movers_[mover].sends_to);
        else send(movers_[other].group, false);
        call_others(other, deep - 1);
    }
}

void MoverPlay::call(std::uint32_t mover) {
    contract_pre(mover < parts_.size());
    if (movers_[mover].lift != kNoMover) return send_lift(movers_[mover].lift, movers_[mover].lift_part);
    send(movers_[mover].group, false);
    call_others(mover, kDeepestChain);
}

void MoverPlay::come_near(std::uint32_t mover) {
    if (parts_[mover].shy) return;
    if (movers_[mover].lift == kNoMover) call(mover);
    else if (lift_is_at(movers_[mover])) send(movers_[mover].group, false);
}

void MoverPlay::set_going(std::uint32_t mover) {
    contract_pre(mover < parts_.size());
    if (!movers_[mover].halts.empty()) return send_lift(mover, next_halt(mover));
    const bool away = parts_[mover].goal != rest(mover);
    if (!away || movers_[mover].lift != kNoMover) return call(mover);
    send(movers_[mover].group, true);
}

void MoverPlay::ride(std::uint32_t lift, double part) {
    contract_pre(lift < parts_.size() && part >= 0.0 && part <= 1.0);
    send_lift(lift, part);
}

bool MoverPlay::any_moving() const {
    return std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.part != part.goal; });
}

bool MoverPlay::any_waiting() const {
    for (std::uint32_t i = 0; i < parts_.size(); ++i)
        if (parts_[i].part != rest(i) && movers_[i].wait_s >= 0.0) return true;
    return false;
}

bool MoverPlay::any_endless() const {
    return std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.going; });
}

// Sends the whole group of the mover back from where it is.
void MoverPlay::turn_back(std::uint32_t mover) {
    const bool goes_out = parts_[mover].goal != rest(mover);
    send(movers_[mover].group, goes_out);
    for (std::uint32_t other = 0; other < parts_.size(); ++other) {
        if (movers_[other].group != movers_[mover].group) continue;
        parts_[other].reported = true;
        parts_[other].shy = goes_out;
        parts_[other].held_s = kPatience_s;
    }
}

void MoverPlay::tick_ends(std::uint32_t i, double dt_s, const Meets& meets, std::vector<MoverEvent>& events) {
    Part& part = parts_[i];
    const Mover& mover = movers_[i];
    // The door of a lift shuts as soon as the lift is about to leave. If the door has met a person, it tries again
    // after a pause.
    if (mover.lift != kNoMover && part.goal != rest(i) && !lift_is_at(mover)) {
        part.held_s -= dt_s;
        if (part.held_s <= 0.0) send(mover.group, true);
    }
    if (part.part == part.goal) {
        if (part.part == rest(i) || mover.wait_s < 0.0) return;
        part.left_s -= dt_s;
        if (part.left_s <= 0.0) send(mover.group, true);
        if (part.part == part.goal) return;
    }
    if ((part.part == 0.0 || part.part == 1.0 || !part.reported) && !doors_shut(i)) return;
    const bool to_rest = part.goal == rest(i);
    if (!part.reported) {
        part.reported = true;
        events.push_back({MoverEvent::Kind::Leaves, i, to_rest});
    }
    const double step = dt_s / mover.travel_s;
    const double next =
        part.part < part.goal ? std::min(part.goal, part.part + step) : std::max(part.goal, part.part - step);
    const Meeting met = meets(i, mover.at(part.part), mover.at(next));
    if (met == Meeting::None) {
        part.met_s = 0.0;
        part.part = next;
        if (part.part != part.goal) return;
        part.left_s = std::max(0.0, mover.wait_s);
        events.push_back({MoverEvent::Kind::Arrives, i, to_rest});
        open_doors(i);
        return;
    }
    part.met_s += dt_s;
    if (met == Meeting::Mover && part.met_s < kPatience_s) return;
    turn_back(i);
    part.met_s = 0.0;
    if (met == Meeting::Body) events.push_back({MoverEvent::Kind::TurnsBack, i, !to_rest});
}

void MoverPlay::tick_endless(std::uint32_t i, double dt_s, const Meets& meets, std::vector<MoverEvent>& events) {
    Part& part = parts_[i];
    const Mover& mover = movers_[i];
    if (!part.going) return;
    Part next = part;
    bool leaves = false, arrives = false;
    if (mover.turn_rad_per_s != 0.0) {
        next.turned_rad = std::remainder(part.turned_rad + mover.turn_rad_per_s * dt_s, 2.0 * kPi);
    } else {
        double left_s = dt_s;
        // The number of stops in one step is limited, so that a ring of stops at the same place ends too.
        for (std::size_t stops = 0; stops < mover.stops.size() && left_s > 0.0; ++stops) {
            if (next.left_s > 0.0) {
                const double waited_s = std::min(left_s, next.left_s);
                next.left_s -= waited_s;
                left_s -= waited_s;
                if (next.left_s > 0.0) break;
                leaves = true;
            }
            const TrainStop& stop = mover.stops[next.next_stop];
            const Vec3 way = stop.at_m - next.at_m;
            const double length_m = glm::length(way), step_m = mover.speed_m_per_s * left_s;
            if (length_m > step_m) {
                next.at_m += way * (step_m / length_m);
                break;
            }
            next.at_m = stop.at_m;
            left_s -= length_m / mover.speed_m_per_s;
            const bool last = next.next_stop + 1 == mover.stops.size();
            if (last && mover.after_last >= 0) next.next_stop = static_cast<std::uint32_t>(mover.after_last);
            else if (!last) ++next.next_stop;
            next.left_s = std::max(0.0, stop.wait_s);
            if (stop.wait_s < 0.0 || (last && mover.after_last < 0)) next.going = false;
            arrives = arrives || stop.wait_s != 0.0 || !next.going;
            if (!next.going) break;
        }
    }
    const Placement from = where(i, part), to = where(i, next);
    if (!(from == to)) {
        const Meeting met = meets(i, from, to);
        if (met != Meeting::None) {
            if (part.met_s == 0.0 && met == Meeting::Body) events.push_back({MoverEvent::Kind::Waits, i, false});
            part.met_s += dt_s;
            return;
        }
        next.met_s = 0.0;
    }
    part = next;
    if (leaves) events.push_back({MoverEvent::Kind::Leaves, i, false});
    if (arrives) events.push_back({MoverEvent::Kind::Arrives, i, false});
}

void MoverPlay::tick(double dt_s, const Meets& meets, std::vector<MoverEvent>& events) {
    contract_pre(dt_s >= 0.0);
    contract_pre(movers_.size() == parts_.size());
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
        if (movers_[i].endless()) tick_endless(i, dt_s, meets, events);
        else tick_ends(i, dt_s, meets, events);
    }
}

}  // namespace handrail::core
