// Recognises formats that Handrail knows but does not read. It states which programs write them and which format to
// export instead. The formats are rows of one table, so that a row can later become a reader. Pure functions; any
// thread may call them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace handrail::readers {

// If the bytes are in a format that Handrail knows but does not read, returns one sentence that can be spoken. The
// file's name has no influence. Otherwise returns an empty string.
std::string foreign_by_content(std::string_view bytes);
// Like foreign_by_content, but only the ending of the file name is compared.
std::string foreign_by_ending(const std::filesystem::path& path);

}  // namespace handrail::readers
