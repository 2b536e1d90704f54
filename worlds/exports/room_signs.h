// Chooses the signs of rooms on a sheet or plate: a few cells of braille that a key explains. Pure functions; any
// thread.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/plan/storey.h"

namespace handrail::exports {

// The sign of a room on the sheet.
struct RoomSign {
    std::string sign;  // letters, or a letter and a number; unique within a storey
    std::string name;
    bool on_sheet = false;  // otherwise only the key names the room, because there was no space for the sign
    Vec2 at_mm{0.0};        // its centre on the sheet
    Vec2 half_mm{0.0};      // its half width and half height
    // For a room without a sign: the signed rooms to which its doors lead, if this list is unique among the rooms
    // without signs.
    std::vector<std::string> doors_to{};
    std::vector<std::string> leads_to{};  // otherwise all rooms to which its doors lead

    bool by_lines = false;  // stairs that are recognised by their lines on the sheet

    bool is_known() const { return on_sheet || by_lines || !doors_to.empty(); }
};
// One sign for each entry of Storey::rooms, in the same order. A sign is the first letter of the name, followed by the
// number if the name ends in its only number, otherwise by a later letter of the name. A name that is a number is its
// own sign. If these are taken, other letters follow, never another number.
std::vector<RoomSign> room_signs(const plan::Storey& storey);

// Two unused letters: the first of the name and a later one, otherwise the first and any other, otherwise any two.
// After all 676 are used, it continues with more letters.
std::string free_letters(const std::string& name, const std::set<std::string>& used);

}  // namespace handrail::exports
