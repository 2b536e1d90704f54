#include "worlds/exports/room_signs.h"

#include <algorithm>
#include <cctype>

#include "worlds/base/language.h"

namespace handrail::exports {
namespace {

// Returns the ASCII letters of a name, in lower case; "x" if it has none.
std::string letters_of(const std::string& name) {
    std::string letters;
    for (const char c : name)
        if (std::isalpha(static_cast<unsigned char>(c)) && static_cast<unsigned char>(c) < 0x80)
            letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return letters.empty() ? "x" : letters;
}

// Removes the storey from the end of a name, as in "Hall, west, storey 4" or "Stairs, Level -1".
std::string without_storey(const std::string& name, const plan::Storey& storey) {
    const std::string made = phrase("room_name.level", {{"room", ""}, {"level", storey.number}});
    for (const std::string& end : {made, storey.name})
        if (!end.empty() && name.size() > end.size() && name.ends_with(end))
            return name.substr(0, name.size() - end.size());
    return name;
}

}  // namespace

std::string free_letters(const std::string& name, const std::set<std::string>& used) {
    const std::string all = "abcdefghijklmnopqrstuvwxyz", letters = letters_of(name);
    for (const std::string& seconds : {letters.substr(1), all})
        for (const char second : seconds)
            if (std::string sign{letters[0], second}; !used.contains(sign)) return sign;
    for (std::string stem = "a";;) {
        for (const char last : all)
            if (std::string sign = stem + last; !used.contains(sign)) return sign;
        // Changes the stem to the next one: b after a, aa after z.
        std::size_t digit = stem.size();
        while (digit > 0 && stem[digit - 1] == 'z') stem[--digit] = 'a';
        if (digit > 0) ++stem[digit - 1];
        else stem.insert(stem.begin(), 'a');
    }
}

std::vector<RoomSign> room_signs(const plan::Storey& storey) {
    std::set<std::string> used;
    std::vector<RoomSign> signs;
    for (const plan::StoreyRoom& room : storey.rooms) {
        const std::string name = without_storey(room.name, storey);
        std::string number;
        for (std::size_t i = name.size(); i > 0 && std::isdigit(static_cast<unsigned char>(name[i - 1])); --i)
            number.insert(number.begin(), name[i - 1]);
        // A name such as "Cellar 4-1" contains two numbers, so neither 1 nor 4 is used for its sign.
        const bool other_numbers = std::any_of(name.begin(), name.end() - std::ptrdiff_t(number.size()),
                                               [](char c) { return std::isdigit(static_cast<unsigned char>(c)); });
        std::string sign = number.size() == name.size() ? number : letters_of(name).substr(0, 1) + number;
        if (number.empty() || number.size() > 3 || other_numbers || used.contains(sign))
            sign = free_letters(name, used);
        used.insert(sign);
        signs.push_back({sign, room.name});
    }
    return signs;
}

}  // namespace handrail::exports
