// What a person has said that one unit of a world is: kept in the table [unit] of its side file.
#pragma once

#include <filesystem>
#include <optional>

#include "app/core/kept/side_file.h"

namespace handrail {

// Metres; nothing where none was said, or nonsense stands there. Reads the file and changes nothing; any thread. See
// SideFile::of_world.
std::optional<double> kept_unit(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                bool shipped, const TomlReader& toml = toml_of);
// In memory until it is saved. Whatever else stands in the table stays.
void keep_unit(SideFile& file, double metres);

}  // namespace handrail
