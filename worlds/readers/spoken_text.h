// Turns text found in files into text that can be spoken. Pure functions; any thread may call them.
#pragma once

#include <string>
#include <string_view>

namespace handrail::readers {

// Converts bytes to UTF-8; bytes that are not UTF-8 are read as Latin-1. A backslash followed by "n", and control
// characters, become pauses. Blanks are joined. The result has at most 1,000 bytes.
std::string spoken_text(std::string_view raw);

// Turns the name of a file or an object into words, without ending and numbering: "north_corridor.map" -> "north
// corridor".
std::string words_of_name(std::string_view name);

}  // namespace handrail::readers
