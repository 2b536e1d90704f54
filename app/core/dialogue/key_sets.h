// Keys for one hand while the other holds the grip. The most used commands are under the left or the right half of the
// keyboard. Plain tables.
#pragma once

#include <span>
#include <string_view>

#include "settings/settings.h"

namespace handrail::core {

struct SetKeys {
    std::string_view word;  // word of a command
    std::string_view keys;  // separated by blanks; they replace the built-in keys
};

// Empty for both hands. F12, Escape and Control are in every set.
std::span<const SetKeys> keys_for(settings::KeyboardHand hand);
// True if that hand reaches the key while it rests on its half of the keyboard. Space and the modifiers belong to both.
bool reaches(settings::KeyboardHand hand, std::string_view key_name);

}  // namespace handrail::core
