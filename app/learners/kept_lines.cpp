#include "app/learners/kept_lines.h"

#include <algorithm>
#include <system_error>

#include "worlds/base/files.h"

namespace handrail::learners {

void each_kept_line(const std::filesystem::path& file, std::size_t longest_bytes, std::vector<Error>& faults,
                    const std::function<void(std::string_view line, int number)>& take) {
    std::error_code ec;
    if (!std::filesystem::exists(file, ec)) return;
    const auto text = read_whole_file(file, longest_bytes);
    if (!text) return faults.push_back(text.error());
    int number = 0;
    for (std::size_t at = 0; at < text->size();) {
        const std::size_t end = std::min(text->find('\n', at), text->size());
        take(std::string_view(*text).substr(at, end - at), ++number);
        at = end + 1;
    }
}

}  // namespace handrail::learners
