#include "worlds/osm/osm_levels.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/text.h"

namespace handrail::osm {
namespace {

constexpr double kLowest = -100.0, kHighest = 300.0;
constexpr std::size_t kMost = 200;

// Reads a level at the start of the text and removes it from the text.
bool take_level(std::string_view& text, double& level) {
    std::string_view digits = text;
    if (digits.starts_with('-') || digits.starts_with('+')) digits.remove_prefix(1);
    if (digits.empty() || digits.front() < '0' || digits.front() > '9') return false;
    const auto taken = take_number(text, false);
    if (!taken || !taken->in_range) return false;
    level = taken->value + 0.0;  // adding 0.0 turns -0 into 0
    return level >= kLowest && level <= kHighest;
}

std::string_view trimmed_of_blanks(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    return text;
}

void add(std::string_view text, OsmLevels& into) {
    for (std::size_t from = 0; from <= text.size() && !text.empty();) {
        const std::size_t end = std::min(text.find_first_of(";,", from), text.size());
        std::string_view one = trimmed_of_blanks(text.substr(from, end - from));
        from = end + 1;
        if (one.empty()) continue;
        double low = 0.0, high = 0.0;
        if (!take_level(one, low)) {
            into.damaged = true;
            continue;
        }
        high = low;
        one = trimmed_of_blanks(one);
        if (one.starts_with('-')) {
            one = trimmed_of_blanks(one.substr(1));
            if (!take_level(one, high)) into.damaged = true, high = low;
        }
        if (!trimmed_of_blanks(one).empty()) into.damaged = true;
        if (high < low) std::swap(low, high);
        for (double level = low; level < high && into.levels.size() < kMost; level += 1.0) into.levels.push_back(level);
        if (into.levels.size() < kMost) into.levels.push_back(high);
        else into.damaged = true;
    }
}

}  // namespace

OsmLevels levels_of(std::string_view level, std::string_view repeat_on) {
    OsmLevels found;
    add(level, found);
    add(repeat_on, found);
    std::sort(found.levels.begin(), found.levels.end());
    found.levels.erase(std::unique(found.levels.begin(), found.levels.end()), found.levels.end());
    return found;
}

}  // namespace handrail::osm
