// Describes how the person gives commands: with the keys of a window, with the keys of a terminal, or by typing lines.
// Texts that explain how to give a command have a second form for typed lines, under the same key with "_typed"
// appended; phrase() chooses it automatically. For typed lines, KeyMap::keys_of returns the word of the command. For a
// terminal, it returns only keys that a terminal can send.
//
// This choice applies to the whole process, like the language. The app thread sets it once at the start. Any thread
// except the servo thread may read it.
#pragma once

namespace handrail {

enum class ActsBy { WindowKeys, TerminalKeys, Lines };

void speak_to(ActsBy who);
ActsBy spoken_to();

inline void speak_to_typist(bool typist) { speak_to(typist ? ActsBy::Lines : ActsBy::WindowKeys); }
inline bool speaks_to_typist() { return spoken_to() == ActsBy::Lines; }

}  // namespace handrail
