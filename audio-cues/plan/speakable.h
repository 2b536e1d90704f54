// Makes text suitable for voices, terminals and windows. Text from maps and files may be invalid UTF-8 or have several
// lines.
#pragma once

#include <string>
#include <string_view>

namespace handrail::cues {

// Returns one line of valid UTF-8. Control characters and line ends become single spaces; outer spaces and direction
// controls are removed. Bytes that are not UTF-8 are read as Latin-1, in which old maps were written. Clean text is
// returned unchanged.
std::string speakable(std::string_view text);

// Does the same as speakable() and makes the first letter upper case, for labels that are spoken and printed.
std::string sentence_case(std::string_view text);

}  // namespace handrail::cues
