// Formats that Handrail knows but does not read: which programs write them, and which format to export instead. They
// are in one table, so that a row can later become a reader. Pure functions; any thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace handrail::readers {

// If the bytes are of such a format, whatever the file's name, returns one sentence that can be spoken; else an empty
// string.
std::string foreign_by_content(std::string_view bytes);
// The same, by the ending of the file name.
std::string foreign_by_ending(const std::filesystem::path& path);

}  // namespace handrail::readers
