// Formats that are known and not read: which program writes them, and what to export there instead. One table, so that
// a row can become a reader. Pure functions; any thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace handrail {

// One sentence fit to be spoken for bytes that are known to be of such a format, whatever the file's name; else empty.
std::string foreign_by_content(std::string_view bytes);
// The same by the ending of the name.
std::string foreign_by_ending(const std::filesystem::path& path);

}  // namespace handrail
