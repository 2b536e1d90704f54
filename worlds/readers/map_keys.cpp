#include "worlds/readers/map_keys.h"

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"
#include "worlds/base/text.h"
#include "worlds/readers/spoken_text.h"

namespace handrail::readers {

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

namespace {

std::string words_of_value(std::string_view value) { return spoken_text(unquoted(value.substr(0, 4096))); }

}  // namespace

std::string text_of(const MapEntity& entity, std::string_view key) { return words_of_value(entity.value(key)); }

OtherLanguages texts_in(const MapEntity& entity, std::string_view key) {
    OtherLanguages texts;
    for (const MapKey& other : entity.keys) {
        const std::string_view all = other.key;
        if (all.size() <= key.size() + 1 || !all.starts_with(key) || all[key.size()] != '_') continue;
        const std::string_view code = all.substr(key.size() + 1);
        if (std::string text = words_of_value(other.value); !text.empty())
            texts.push_back({std::string(code), std::move(text)});
    }
    return texts;
}

std::optional<double> MapKeys::number_of(const MapEntity& entity, std::string_view key, double least, double most,
                                         std::string_view range) const {
    contract_pre(least <= most);
    contract_pre(!key.empty());
    const MapKey* found = entity.find(key);
    if (!found) return std::nullopt;
    double value = 0.0;
    if (!parse_finite(trimmed(found->value), value)) {
        diagnostics_.warn(found->place, "map.then_default", "map.no_number",
                          {{"value", excerpt(found->value)},
                           {"key", key},
                           {"range", phrase(range, {{"least", least}, {"most", most}})}});
        return std::nullopt;
    }
    const double legal = std::clamp(value, least, most);
    if (legal != value)
        diagnostics_.warn(found->place, "map.then_number", "map.out_of_range",
                          {{"value", value},
                           {"key", key},
                           {"range", phrase(range, {{"least", least}, {"most", most}})},
                           {"taken", legal}});
    return legal;
}

std::optional<Vec3> MapKeys::vector_of(const MapEntity& entity, std::string_view key,
                                       std::string_view otherwise) const {
    const MapKey* found = entity.find(key);
    if (!found) return std::nullopt;
    std::string_view rest = found->value;
    Vec3 v{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        rest = trimmed(rest);
        const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
        if (!parse_finite(rest.substr(0, end), v[axis]) || std::abs(v[axis] * units_) > kFarthestM) {
            diagnostics_.warn(found->place, otherwise, "map.no_vector",
                              {{"value", excerpt(found->value)}, {"key", key}});
            return std::nullopt;
        }
        rest.remove_prefix(end);
    }
    return v;
}

bool MapKeys::yes_no_of(const MapEntity& entity, std::string_view key) const {
    const MapKey* found = entity.find(key);
    if (!found) return false;
    const std::string value = lower_ascii(trimmed(found->value).substr(0, 16));
    if (value == "1" || value == "yes" || value == "true") return true;
    if (value == "0" || value == "no" || value == "false") return false;
    double number = 1.0;
    const bool yes = !parse_finite(value, number) || number > 0.5;
    diagnostics_.warn(found->place, "map.then_number", "map.no_switch",
                      {{"value", excerpt(found->value)}, {"key", key}, {"taken", yes ? 1 : 0}});
    return yes;
}

std::string MapKeys::side_of(const MapEntity& entity, std::string_view key) const {
    static const std::vector<std::string> kSides{"north", "north-east", "east", "south-east", "south", "south-west",
                                                 "west",  "north-west", "left", "right",      "top",   "bottom"};
    const MapKey* found = entity.find(key);
    if (!found) return {};
    const std::string value = lower_ascii(trimmed(found->value).substr(0, 32));
    if (std::find(kSides.begin(), kSides.end(), value) != kSides.end()) return value;
    const std::string nearest = nearest_name(value, kSides);
    diagnostics_.warn(found->place, "map.then_word", "map.no_side",
                      {{"value", excerpt(found->value)}, {"key", key}, {"taken", nearest}});
    return nearest;
}

MapKeys::AxisTurn MapKeys::axis_of(const MapEntity& entity) const {
    const MapKey* key = entity.find("axis");
    if (!key) return {};
    const std::string value = lower_ascii(trimmed(key->value).substr(0, 8));
    const bool back = value.starts_with('-');
    const std::string name = back ? value.substr(1) : value;
    if (name == "x") return {0, rotation_about({0, 1, 0}, back ? -0.5 * kPi : 0.5 * kPi)};
    if (name == "y") return {1, rotation_about({1, 0, 0}, back ? 0.5 * kPi : -0.5 * kPi)};
    if (name != "z")
        diagnostics_.warn(key->place, "map.then_word", "map.no_axis", {{"value", excerpt(key->value)}, {"taken", "z"}});
    return {2, name == "z" && back ? rotation_about({1, 0, 0}, kPi) : Rotation{}};
}

}  // namespace handrail::readers
