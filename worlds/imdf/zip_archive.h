// The files of a ZIP archive, unpacked. Pure functions; any thread.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "worlds/base/result.h"

namespace handrail {

inline constexpr std::size_t kMostUnpacked_bytes = std::size_t{1} << 30;

// By their paths in it, those for which `wanted` says so. Stored and deflated ones; fails with one sentence for an
// archive that is damaged, cut short, encrypted, or unpacks to more than kMostUnpacked_bytes.
Result<std::map<std::string, std::string>> unzip(std::string_view bytes, const std::string& file_name,
                                                 bool (*wanted)(std::string_view path));

}  // namespace handrail
