// Chooses the signs of rooms on a sheet or plate. A sign is a few cells of braille that a key explains. Pure functions;
// any thread may call them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "worlds/base/vec.h"
#include "worlds/plan/storey.h"

namespace handrail::exports {

// The sign of a room on the sheet, and where it is.
struct RoomSign {
    std::string sign;  // letters, or a letter and a number; unique within a storey
    std::string name;
    bool on_sheet = false;  // false: there was no space for the sign on the sheet, so only the key names the room
    Vec2 at_mm{0.0};        // centre of the sign on the sheet
    Vec2 half_mm{0.0};      // half width and half height of the sign
    // For a room without a sign: the rooms with signs to which its doors lead. Empty if another room without a sign has
    // the same list.
    std::vector<std::string> doors_to{};
    std::vector<std::string> leads_to{};  // if doors_to is empty: all rooms to which its doors lead

    bool by_lines = false;  // the room is a flight of stairs that is recognised by its lines on the sheet

    bool is_known() const { return on_sheet || by_lines || !doors_to.empty(); }
};
// Returns one sign for each entry of Storey::rooms, in the same order. If the name contains a single number, at its
// end, the sign is the first letter and that number. Otherwise it is the first letter and a later letter of the name. A
// name that is a number is its own sign. If such a sign is already used, other letters are chosen, never another
// number.
std::vector<RoomSign> room_signs(const plan::Storey& storey);

// Returns two unused letters: the first letter of the name and a later one, otherwise the first and any other,
// otherwise any two. If all 676 pairs are used, it returns more letters.
std::string free_letters(const std::string& name, const std::set<std::string>& used);

}  // namespace handrail::exports
