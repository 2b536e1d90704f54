// Keys for one hand, while the other holds the grip: what is most used lies under the left or the right half of the
// keyboard. Plain tables.
#pragma once

#include <span>
#include <string_view>

#include "settings/settings.h"

namespace handrail {

struct SetKeys {
    std::string_view word;  // a command's
    std::string_view keys;  // in place of its built-in ones, separated by blanks
};

// Empty for both hands. F12, Escape and Control are in every set.
std::span<const SetKeys> keys_for(KeyboardHand hand);
// True when that hand, at rest on its half of the keyboard, reaches the key; Space and the modifiers belong to both.
bool reaches(KeyboardHand hand, std::string_view key_name);

}  // namespace handrail
