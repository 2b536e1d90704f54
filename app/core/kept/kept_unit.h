// The length of a world's unit as the person has set it, from the table [unit] of the world's side file.
#pragma once

#include <filesystem>
#include <optional>

#include "app/core/kept/side_file.h"

namespace handrail::core {

// Metres; no value if none was set or the value is unusable. Reads the file and changes nothing; any thread. See
// SideFile::of_world.
std::optional<double> kept_unit(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                bool shipped, const settings::TomlReader& toml = settings::toml_of);
// Stays in memory until the file is saved. Other keys of the table stay as they are.
void keep_unit(SideFile& file, double metres);

}  // namespace handrail::core
