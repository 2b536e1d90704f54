// The signs of rooms on a sheet or plate: a few cells of braille that a key explains. Pure functions; any thread.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/plan/storey.h"

namespace handrail {

// How a room is called on the sheet.
struct RoomSign {
    std::string sign;  // letters, or a letter and a number; of one storey no two are alike
    std::string name;
    bool on_sheet = false;  // else the key alone names it: there was no room for the sign
    Vec2 at_mm{0.0};        // its middle there
    Vec2 half_mm{0.0};      // and what it covers on either side of that
    // Where it has no sign: the signed rooms that its doors lead to, if no other room without a sign has the same.
    std::vector<std::string> doors_to{};
    std::vector<std::string> leads_to{};  // otherwise all rooms that its doors lead to

    bool by_lines = false;  // stairs, whose lines are on the sheet

    bool is_known() const { return on_sheet || by_lines || !doors_to.empty(); }
};
// In the order of Storey::rooms. The first letter of the name, followed by its number if it ends in the only one that
// it has, otherwise by a later letter of the name. A name that is a number is its own sign. When these are taken, other
// letters follow, never another number.
std::vector<RoomSign> room_signs(const Storey& storey);

// Two letters that are not used: the first of the name and a later one, otherwise the first and any, otherwise any.
// When all 676 are used it goes on with more letters.
std::string free_letters(const std::string& name, const std::set<std::string>& used);

}  // namespace handrail
