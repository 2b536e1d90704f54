// Turns words found in files into words fit to be spoken. Pure functions.
#pragma once

#include <string>
#include <string_view>

namespace handrail {

// UTF-8 from bytes that are UTF-8 or else Latin-1; the two characters \n and control characters become pauses; blanks
// are joined; at most 1,000 bytes.
std::string spoken_text(std::string_view raw);

// "north_corridor.map" -> "north corridor": a file's or object's name as words, without ending and numbering.
std::string words_of_name(std::string_view name);

}  // namespace handrail
