// Who is spoken to: somebody at the keys of a window, at those of a terminal, or somebody who types lines of words.
// Texts that say how to act have a second form for the last, under the same key with "_typed" behind it, which phrase()
// then says; KeyMap::keys_of then gives the command's word, and at a terminal's keys only such as a terminal can send.
//
// One for the whole process, as the language is. App thread sets it once at the start; any thread but the servo's may
// read.
#pragma once

namespace handrail {

enum class ActsBy { WindowKeys, TerminalKeys, Lines };

void speak_to(ActsBy who);
ActsBy spoken_to();

inline void speak_to_typist(bool typist) { speak_to(typist ? ActsBy::Lines : ActsBy::WindowKeys); }
inline bool speaks_to_typist() { return spoken_to() == ActsBy::Lines; }

}  // namespace handrail
