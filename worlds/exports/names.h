// Joins names to a list as used in a sentence. Pure; any thread.
#pragma once

#include <span>
#include <string>

namespace handrail::exports {

// "Table; 3 of Chair; Stove": in the order of first appearance, with equal names counted.
std::string names_list(std::span<const std::string> names);

}  // namespace handrail::exports
