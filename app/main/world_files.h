// Where the worlds that ship with the program lie: beside an installed program, else in the source tree it was built
// from.
#pragma once

#include <filesystem>

namespace handrail {

// HANDRAIL_WORLDS when set, else ../share/handrail/worlds from the program's own place, else the source tree's
// worlds/maps.
std::filesystem::path world_folder();
// The world is one of these.
bool is_shipped(const std::filesystem::path& world);
// The world that a first start explores.
std::filesystem::path first_world();

}  // namespace handrail
