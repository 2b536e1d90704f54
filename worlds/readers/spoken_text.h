// Turns text found in files into text that can be spoken. Pure functions.
#pragma once

#include <string>
#include <string_view>

namespace handrail::readers {

// Converts bytes that are UTF-8, or else Latin-1, to UTF-8. The two characters
//  and control characters become pauses; blanks are joined; at most 1,000 bytes.
std::string spoken_text(std::string_view raw);

// Turns a file's or object's name into words, without ending and numbering: "north_corridor.map" -> "north corridor".
std::string words_of_name(std::string_view name);

}  // namespace handrail::readers
