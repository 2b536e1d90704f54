// Stores the length of a world's unit, as the person has set it, in the table [unit] of the world's side file.
#pragma once

#include <filesystem>
#include <optional>

#include "app/core/kept/side_file.h"

namespace handrail::core {

// Returns the unit in metres, or no value if the person set none or the value is unusable. Reads the file and changes
// nothing. Any thread may call it. SideFile::of_world explains the parameters.
std::optional<double> kept_unit(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                bool shipped, const settings::TomlReader& toml = settings::toml_of);
// Sets the unit in memory. The owner saves `file` later. Other keys of the table stay as they are.
void keep_unit(SideFile& file, double metres);

}  // namespace handrail::core
