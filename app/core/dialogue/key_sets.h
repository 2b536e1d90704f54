// Lists sets of keys for one hand while the other hand holds the device. The most used commands are in the left or in
// the right half of the keyboard. Plain tables.
#pragma once

#include <span>
#include <string_view>

#include "settings/settings.h"

namespace handrail::core {

struct SetKeys {
    std::string_view word;  // the word of the command
    std::string_view keys;  // key names separated by blanks, which replace the built-in keys
};

// Returns the keys for this hand, or an empty list if the person uses both hands. F12, Escape and Control are in every
// set.
std::span<const SetKeys> keys_for(settings::KeyboardHand hand);
// Returns true if this hand reaches the key while it rests on its half of the keyboard. Space and the modifier keys
// belong to both halves.
bool reaches(settings::KeyboardHand hand, std::string_view key_name);

}  // namespace handrail::core
