// Translates the words of a file into touch materials, prefabs and names that can be spoken.
#include <algorithm>
#include <array>

#include "worlds/base/text.h"
#include "worlds/ifc/ifc_scene.h"

namespace handrail::ifc {
namespace {

struct Rule {
    std::string_view part, material;
};
// The first rule whose text occurs in the word, in lower case, applies. If one text contains another, the longer one
// comes first.
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

// The place where the text must occur: anywhere in a word, at the start of a word, or as the whole word.
enum class Found { Anywhere, AtStart, Alone };
struct KindRule {
    std::string_view part, prefab;
    Found found = Found::Anywhere;
};
// The rules for furniture. The first rule that matches applies.
constexpr std::array kKindRules{
    KindRule{"elevator", "lift_cabin"},
    KindRule{"aufzug", "lift_cabin"},
    KindRule{"lift", "lift_cabin", Found::Alone},
    KindRule{"schreibtisch", "desk"},
    KindRule{"desk", "desk", Found::AtStart},
    KindRule{"washhandbasin", "basin"},
    KindRule{"waschbecken", "basin"},
    KindRule{"waschtisch", "basin"},
    KindRule{"washbasin", "basin"},
    KindRule{"lavatory", "basin"},
    KindRule{"sink", "basin", Found::AtStart},
    KindRule{"spüle", "basin"},
    KindRule{"toilet", "toilet"},
    KindRule{"wcseat", "toilet"},
    KindRule{"wc", "toilet", Found::Alone},
    KindRule{"klosett", "toilet"},
    KindRule{"bathtub", "bathtub"},
    KindRule{"badewanne", "bathtub"},
    KindRule{"bath", "bathtub", Found::Alone},
    KindRule{"fridge", "fridge"},
    KindRule{"refrigerator", "fridge"},
    KindRule{"kühlschrank", "fridge"},
    KindRule{"electriccooker", "stove"},
    KindRule{"stove", "stove"},
    KindRule{"cooker", "stove", Found::AtStart},
    KindRule{"herd", "stove", Found::Alone},
    KindRule{"wardrobe", "wardrobe"},
    KindRule{"kleiderschrank", "wardrobe"},
    KindRule{"schrank", "wardrobe", Found::Alone},
    KindRule{"bookcase", "shelf"},
    KindRule{"shelf", "shelf"},
    KindRule{"regal", "shelf"},
    KindRule{"sofa", "sofa"},
    KindRule{"couch", "sofa"},
    KindRule{"bench", "bench", Found::AtStart},
    KindRule{"sitzbank", "bench"},
    KindRule{"counter", "counter", Found::AtStart},
    KindRule{"theke", "counter", Found::Alone},
    KindRule{"tresen", "counter"},
    KindRule{"chair", "chair"},
    KindRule{"stuhl", "chair"},
    KindRule{"wastebin", "bin"},
    KindRule{"mülleimer", "bin"},
    KindRule{"papierkorb", "bin"},
    KindRule{"table", "table", Found::AtStart},
    KindRule{"tisch", "table"},
    KindRule{"bett", "bed"},
    KindRule{"bed", "bed", Found::AtStart},
};
// Words for things on, at or next to furniture, and for things that are not furniture.
constexpr std::array<std::string_view, 11> kNoKind{"bedroom",   "lamp",    "leuchte",   "light",
                                                   "cloth",     "mirror",  "spiegel",   "wheelchair",
                                                   "rollstuhl", "bedside", "nachttisch"};

}  // namespace

const Prefab* prefab_for(const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        const std::string text = lower_ascii(std::string_view(word).substr(0, 100));
        const auto holds = [&](std::string_view part) { return text.find(part) != std::string::npos; };
        const auto fits = [&](const KindRule& rule) {
            if (rule.found == Found::Alone) return text == rule.part;
            if (rule.found == Found::Anywhere) return holds(rule.part);
            const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80; };
            for (std::size_t at = text.find(rule.part); at != std::string::npos; at = text.find(rule.part, at + 1))
                if (at == 0 || !letter(text[at - 1])) return true;
            return false;
        };
        if (std::any_of(kNoKind.begin(), kNoKind.end(), holds)) return nullptr;
        for (const KindRule& rule : kKindRules)
            if (fits(rule)) return find_prefab(rule.prefab);
    }
    return nullptr;
}

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

}  // namespace handrail::ifc
