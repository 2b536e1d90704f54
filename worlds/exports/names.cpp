#include "worlds/exports/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "worlds/base/language.h"

namespace handrail::exports {

std::string names_list(std::span<const std::string> names) {
    std::vector<std::string> said;
    for (auto it = names.begin(); it != names.end(); ++it) {
        if (std::find(names.begin(), it, *it) != it) continue;
        const auto count = std::count(names.begin(), names.end(), *it);
        said.push_back(count == 1 ? *it : phrase("export.several", {{"count", count}, {"name", *it}}));
    }
    return fmt::format("{}", fmt::join(said, "; "));
}

}  // namespace handrail::exports
