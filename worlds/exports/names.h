// Names in a row, as a sentence lists them. Pure; any thread.
#pragma once

#include <span>
#include <string>

namespace handrail {

// "Table; 3 of Chair; Stove": in the order in which they first come, those of one name counted.
std::string names_list(std::span<const std::string> names);

}  // namespace handrail
