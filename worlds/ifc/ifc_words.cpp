// What words of a file mean for hand and ear.
#include <array>

#include "worlds/base/text.h"
#include "worlds/ifc/ifc_scene.h"

namespace handrail {
namespace {

struct Rule {
    std::string_view part, material;
};
// The first that is part of the word, in lower case. Longer words first where one holds the other.
constexpr std::array kRules{
    Rule{"kunststoff", "plastic"}, Rule{"plastic", "plastic"},   Rule{"pvc", "plastic"},
    Rule{"vinyl", "plastic"},      Rule{"linoleum", "plastic"},  Rule{"gypsum", "plaster"},
    Rule{"gips", "plaster"},       Rule{"putz", "plaster"},      Rule{"plaster", "plaster"},
    Rule{"drywall", "plaster"},    Rule{"wallboard", "plaster"}, Rule{"stucco", "plaster"},
    Rule{"glas", "glass"},         Rule{"glaz", "glass"},        Rule{"kalksand", "brick"},
    Rule{"ziegel", "brick"},       Rule{"brick", "brick"},       Rule{"mauer", "brick"},
    Rule{"masonry", "brick"},      Rule{"klinker", "brick"},     Rule{"beton", "concrete"},
    Rule{"concrete", "concrete"},  Rule{"cement", "concrete"},   Rule{"estrich", "concrete"},
    Rule{"holz", "wood"},          Rule{"wood", "wood"},         Rule{"timber", "wood"},
    Rule{"parkett", "wood"},       Rule{"parquet", "wood"},      Rule{"laminat", "wood"},
    Rule{"oak", "wood"},           Rule{"eiche", "wood"},        Rule{"buche", "wood"},
    Rule{"cherry", "wood"},        Rule{"fliese", "tile"},       Rule{"tile", "tile"},
    Rule{"ceramic", "tile"},       Rule{"keramik", "tile"},      Rule{"porcelain", "tile"},
    Rule{"stahl", "metal"},        Rule{"steel", "metal"},       Rule{"metal", "metal"},
    Rule{"alumin", "metal"},       Rule{"chrome", "metal"},      Rule{"teppich", "carpet"},
    Rule{"carpet", "carpet"},      Rule{"gummi", "rubber"},      Rule{"rubber", "rubber"},
    Rule{"marmor", "stone"},       Rule{"marble", "stone"},      Rule{"granit", "stone"},
    Rule{"stein", "stone"},        Rule{"stone", "stone"},       Rule{"stoff", "cloth"},
    Rule{"fabric", "cloth"},       Rule{"textile", "cloth"},     Rule{"rasen", "grass"},
    Rule{"grass", "grass"},
};

}  // namespace

std::string_view material_of_words(std::string_view words) {
    const std::string all = lower_ascii(words.substr(0, 400));
    for (std::size_t from = 0; from < all.size();) {
        const std::size_t end = std::min(all.find(';', from), all.size());
        const std::string_view one = std::string_view(all).substr(from, end - from);
        for (const Rule& rule : kRules)
            if (one.find(rule.part) != std::string_view::npos) return rule.material;
        from = end + 1;
    }
    return {};
}

std::string spoken_part_name(const std::string& name) {
    std::string kept = name.substr(0, name.find(':'));
    if (kept.starts_with("M_")) kept.erase(0, 2);
    for (char& c : kept)
        if (c == '_') c = ' ';
    while (!kept.empty() && (kept.back() == ' ' || kept.back() == '-')) kept.pop_back();
    const bool words = std::any_of(kept.begin(), kept.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
    });
    return words ? kept : std::string();
}

}  // namespace handrail
