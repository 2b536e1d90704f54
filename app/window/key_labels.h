// Letters act by the label of their key: Q of a French keyboard is where an American one has A. Digits and signs act by
// their place. Pure functions, except key_labels(), which belongs to GLFW's thread.
#pragma once

#include <array>
#include <map>
#include <string>

namespace handrail::window {

// For each key that types something: what it types without modifiers, UTF-8. The map is keyed by GLFW's token, which
// stands for the place of the key.
using KeyLabels = std::map<int, std::string>;

// The labels in the current keyboard layout.
KeyLabels key_labels();

// Maps GLFW's token of each key to the token whose name the key has. Every name stays on exactly one key:
// - a key with the label of a letter is that letter;
// - a letter that no key has as its label is at its American place, as on a Greek keyboard;
// - if a letter is on the key of a sign, the sign moves to a key that has lost its letter: to one that is labelled
//   with
//   the sign, if there is one.
std::map<int, int> keys_by_label(const KeyLabels& labels);

}  // namespace handrail::window
