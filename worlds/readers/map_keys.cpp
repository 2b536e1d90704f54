#include "worlds/readers/map_keys.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/text.h"

namespace handrail {

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && static_cast<unsigned char>(text.front()) <= ' ') text.remove_prefix(1);
    while (!text.empty() && static_cast<unsigned char>(text.back()) <= ' ') text.remove_suffix(1);
    return text;
}

std::optional<TouchSide> touch_side_named(std::string_view word) {
    const std::string name = lower_ascii(trimmed(word).substr(0, 16));
    if (name == "both") return TouchSide::Both;
    if (name == "front") return TouchSide::Front;
    if (name == "back") return TouchSide::Back;
    return std::nullopt;
}

std::optional<double> MapKeys::number_of(const MapEntity& entity, std::string_view key, double least, double most, std::string_view range) const {
    const MapKey* found = entity.find(key);
    if (!found) return std::nullopt;
    double value = 0.0;
    if (!parse_finite(trimmed(found->value), value)) {
        diagnostics_.warn(found->place, "map.then_default", "map.no_number",
                          {{"value", excerpt(found->value)}, {"key", key}, {"range", phrase(range, {{"least", least}, {"most", most}})}});
        return std::nullopt;
    }
    const double legal = std::clamp(value, least, most);
    if (legal != value)
        diagnostics_.warn(found->place, "map.then_number", "map.out_of_range",
                          {{"value", value}, {"key", key}, {"range", phrase(range, {{"least", least}, {"most", most}})}, {"taken", legal}});
    return legal;
}

std::optional<Vec3> MapKeys::vector_of(const MapEntity& entity, std::string_view key, std::string_view otherwise) const {
    const MapKey* found = entity.find(key);
    if (!found) return std::nullopt;
    std::string_view rest = found->value;
    Vec3 v{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        rest = trimmed(rest);
        const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
        if (!parse_finite(rest.substr(0, end), v[axis]) || std::abs(v[axis] * units_) > kFarthestM) {
            diagnostics_.warn(found->place, otherwise, "map.no_vector", {{"value", excerpt(found->value)}, {"key", key}});
            return std::nullopt;
        }
        rest.remove_prefix(end);
    }
    return v;
}

}  // namespace handrail
