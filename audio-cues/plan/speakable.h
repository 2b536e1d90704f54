// Text made fit for voices, terminals and windows: what maps and files hold may be neither UTF-8 nor one line.
#pragma once

#include <string>
#include <string_view>

namespace handrail {

// One line of valid UTF-8: control characters and line ends become single spaces, outer spaces and direction controls
// go, and bytes that are no UTF-8 are read as Latin-1, which is what old maps were written in. Text that is already
// clean comes back unchanged.
std::string speakable(std::string_view text);

// The same with an upper-case first letter, as a label is spoken and printed.
std::string sentence_case(std::string_view text);

}  // namespace handrail
