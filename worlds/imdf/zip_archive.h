// Unpacks the files of a ZIP archive. Pure functions; any thread may call them.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "worlds/base/result.h"

namespace handrail::imdf {

inline constexpr std::size_t kMostUnpacked_bytes = std::size_t{1} << 30;

// Returns the stored and deflated files that `wanted` accepts, by their paths in the archive. Fails with one sentence
// if the archive is damaged, cut short, encrypted, or unpacks to more than kMostUnpacked_bytes.
Result<std::map<std::string, std::string>> unzip(std::string_view bytes, const std::string& file_name,
                                                 bool (*wanted)(std::string_view path));

}  // namespace handrail::imdf
