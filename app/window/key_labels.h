// Letters act by what is printed on their keys: Q of a French keyboard is where an American one has A. Digits and signs
// act by their place. Pure functions but for key_labels(); GLFW's thread.
#pragma once

#include <array>
#include <map>
#include <string>

namespace handrail {

// What each key that types something types alone, UTF-8, by GLFW's token, which says where the key is.
using KeyLabels = std::map<int, std::string>;

// Of the keyboard layout that is chosen now.
KeyLabels key_labels();

// By GLFW's token the token whose name the key has. Every name stays on exactly one key:
// - a key with the label of a letter is that letter;
// - a letter that no key has as its label is at its American place, as on a Greek keyboard;
// - if a letter is on the key of a sign, the sign moves to a key that has lost its letter: to one that is labelled with
//   the sign, if there is one.
std::map<int, int> keys_by_label(const KeyLabels& labels);

}  // namespace handrail
