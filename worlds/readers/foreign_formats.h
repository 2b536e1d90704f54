// Formats that Handrail knows but does not read: which programs write them, and which format to export instead. They
// are rows of one table, so that a row can later become a reader. Pure functions; any thread may call them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace handrail::readers {

// If the bytes are in such a format, returns one sentence that can be spoken, whatever the file's name is. Otherwise
// returns an empty string.
std::string foreign_by_content(std::string_view bytes);
// Like foreign_by_content, but decides by the ending of the file name.
std::string foreign_by_ending(const std::filesystem::path& path);

}  // namespace handrail::readers
