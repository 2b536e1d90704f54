// Finds which letter each key stands for. Letters act by the label of their key: on a French keyboard, the key at the
// place of the American Q is labelled A, and acts as A. Digits and signs act by the place of their key. Pure functions,
// except key_labels(), which must run on GLFW's thread.
#pragma once

#include <array>
#include <map>
#include <string>

namespace handrail::window {

// For each key that types something: the text that the key types without modifiers, in UTF-8. The map's key is GLFW's
// key token, which stands for the place of the key on the keyboard.
using KeyLabels = std::map<int, std::string>;

// Returns the labels in the current keyboard layout.
KeyLabels key_labels();

// For GLFW's token of each key, returns the token whose name the key gets. Every name belongs to exactly one key:
// - a key with the label of a letter is that letter;
// - a letter that is no key's label is at its American place, as on a Greek keyboard;
// - if a letter is on the key of a sign, the sign moves to a key that has lost its letter. If one of these keys is
//   labelled with the sign, the sign moves to that key.
std::map<int, int> keys_by_label(const KeyLabels& labels);

}  // namespace handrail::window
