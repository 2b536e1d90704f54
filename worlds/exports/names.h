// Joins names to a list for use in a sentence. Pure function; any thread may call it.
#pragma once

#include <span>
#include <string>

namespace handrail::exports {

// Returns a list such as "Table; 3 of Chair; Stove", in the order of first appearance. Equal names are counted.
std::string names_list(std::span<const std::string> names);

}  // namespace handrail::exports
