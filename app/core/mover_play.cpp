#include "app/core/mover_play.h"

#include <algorithm>

namespace handrail {
namespace {

constexpr int kDeepestChain = 8;  // buttons that press buttons: a ring of them must end

}  // namespace

void MoverPlay::enter(std::span<const Mover> movers) {
    movers_ = movers;
    parts_.assign(movers.size(), {});
    for (std::uint32_t i = 0; i < parts_.size(); ++i) parts_[i].part = parts_[i].goal = rest(i);
}

void MoverPlay::send(std::uint32_t group, bool to_rest) {
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
        if (movers_[i].group != group || !movers_[i].moves()) continue;
        Part& part = parts_[i];
        const double goal = to_rest ? rest(i) : 1.0 - rest(i);
        if (part.goal != goal) part.told = false;
        part.goal = goal;
        part.left_s = std::max(0.0, movers_[i].wait_s);
    }
}

void MoverPlay::call_others(std::uint32_t mover, int deep) {
    if (deep == 0) return;
    for (const std::uint32_t other : movers_[mover].sets_going) {
        send(movers_[other].group, false);
        call_others(other, deep - 1);
    }
}

void MoverPlay::call(std::uint32_t mover) {
    send(movers_[mover].group, false);
    call_others(mover, kDeepestChain);
}

void MoverPlay::set_going(std::uint32_t mover) {
    const bool away = parts_[mover].goal != rest(mover);
    if (!away) return call(mover);
    send(movers_[mover].group, true);
}

bool MoverPlay::any_moving() const {
    return std::any_of(parts_.begin(), parts_.end(), [](const Part& part) { return part.part != part.goal; });
}

bool MoverPlay::any_waiting() const {
    for (std::uint32_t i = 0; i < parts_.size(); ++i)
        if (parts_[i].part != rest(i) && movers_[i].wait_s >= 0.0) return true;
    return false;
}

void MoverPlay::tick(double dt_s, const std::function<bool(std::uint32_t, const Placement&)>& stands_in_way, std::vector<MoverEvent>& events) {
    for (std::uint32_t i = 0; i < parts_.size(); ++i) {
        Part& part = parts_[i];
        const Mover& mover = movers_[i];
        if (part.part == part.goal) {
            if (part.part == rest(i) || mover.wait_s < 0.0) continue;
            part.left_s -= dt_s;
            if (part.left_s <= 0.0) send(mover.group, true);
            if (part.part == part.goal) continue;
        }
        const bool to_rest = part.goal == rest(i);
        if (!part.told) {
            part.told = true;
            events.push_back({MoverEvent::Kind::Leaves, i, to_rest});
        }
        const double step = dt_s / mover.travel_s;
        const double next = part.part < part.goal ? std::min(part.goal, part.part + step) : std::max(part.goal, part.part - step);
        if (to_rest && stands_in_way(i, mover.at(next))) {
            send(mover.group, false);
            for (std::uint32_t other = 0; other < parts_.size(); ++other)
                if (movers_[other].group == mover.group) parts_[other].told = true;
            events.push_back({MoverEvent::Kind::TurnsBack, i, false});
            continue;
        }
        part.part = next;
        if (part.part == part.goal) {
            part.left_s = std::max(0.0, mover.wait_s);
            events.push_back({MoverEvent::Kind::Arrives, i, to_rest});
        }
    }
}

}  // namespace handrail
