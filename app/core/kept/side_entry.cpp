// Implements the access to the values of an entry in a side file. side_file.h declares it.
#include <cmath>

#include "app/core/kept/side_file.h"
#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::core {

std::string text_of(const SideEntry& entry, const std::string& key, const std::string& otherwise) {
    const auto found = entry.find(key);
    const auto* text = found == entry.end() ? nullptr : std::get_if<std::string>(&found->second);
    return text ? *text : otherwise;
}

double number_of(const SideEntry& entry, const std::string& key, double otherwise) {
    const auto found = entry.find(key);
    if (found == entry.end()) return otherwise;
    if (const auto* whole = std::get_if<std::int64_t>(&found->second)) return static_cast<double>(*whole);
    const auto* number = std::get_if<double>(&found->second);
    return number && std::isfinite(*number) ? *number : otherwise;
}

std::vector<double> numbers_of(const SideEntry& entry, const std::string& key, std::size_t count) {
    contract_pre(count > 0);
    const auto found = entry.find(key);
    const auto* numbers = found == entry.end() ? nullptr : std::get_if<std::vector<double>>(&found->second);
    if (!numbers || numbers->size() != count) return {};
    for (const double number : *numbers)
        if (!std::isfinite(number)) return {};
    return *numbers;
}

std::optional<Vec3> place_of(const SideEntry& entry) {
    const std::vector<double> at = numbers_of(entry, "place_m", 3);
    if (at.empty()) return std::nullopt;
    return Vec3(at[0], at[1], at[2]);
}

Result<NamedPlace> named_place_of(const SideEntry& entry, std::string_view no_name, std::string_view no_place) {
    const auto name = good_name(text_of(entry, "name"));
    if (!name) return fail(phrase(no_name));
    const auto place = place_of(entry);
    if (!place) return fail(phrase(no_place, {{"name", *name}}));
    return NamedPlace{*name, *place};
}

void put_place(SideEntry& entry, const Vec3& place_m) {
    entry["place_m"] = std::vector<double>{place_m.x, place_m.y, place_m.z};
}

SideEntry without(SideEntry entry, std::initializer_list<const char*> known) {
    for (const char* key : known) entry.erase(key);
    return entry;
}

Result<std::string> good_name(std::string_view typed) {
    const std::size_t first = typed.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return fail(phrase("side_file.name_empty"));
    const std::string name(typed.substr(first, typed.find_last_not_of(" \t\r\n") - first + 1));
    if (!is_utf8(name)) return fail(phrase("side_file.name_no_text"));
    if (name.size() > kLongestName_bytes)
        return fail(phrase("side_file.name_too_long", {{"most", kLongestName_bytes}}));
    for (const char c : name)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return fail(phrase("side_file.name_control"));
    return name;
}

}  // namespace handrail::core
