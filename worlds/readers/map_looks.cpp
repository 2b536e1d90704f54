#include "worlds/readers/map_looks.h"

#include <algorithm>

#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::readers {
namespace {

std::string_view guessed_name(const MapMeaning& meaning, const TextureFacts& facts) {
    return meaning.surface.name.empty() && facts.guess ? facts.guess->name : std::string_view{};
}

}  // namespace

FaceLook MapLooks::look_of(const MapMeaning& meaning, const TextureFacts& facts) {
    const std::string_view guess = guessed_name(meaning, facts);
    const LookKey key{guess.empty() ? meaning.surface.name : std::string(guess), meaning.look};
    return known_looks_.try_emplace(key, static_cast<FaceLook>(known_looks_.size())).first->second;
}

MaterialId MapLooks::material_of(Scene& scene, const MapMeaning& meaning, const TextureFacts& facts,
                                 std::string_view texture) {
    Material material = meaning.surface;
    if (const std::string_view guess = guessed_name(meaning, facts); guess_ && !guess.empty()) {
        material.name = guess;
        material.guessed = true;
        guessed_from_[material.name].insert(lower_ascii(texture.substr(0, 64)));
    }
    if (const MaterialSpec* spec = find_material(material.name)) material.sound = spec->sound;
    return material_id(scene, material);
}

void MapLooks::report_guesses(ReadReport& report) const {
    for (const auto& [material, textures] : guessed_from_) {
        std::string names;
        int shown = 0;
        for (const std::string& texture : textures)
            if (shown++ < 3) names += (shown > 1 ? ", " : "") + excerpt(texture);
        report.guessed.push_back(phrase("map.guessed", {{"material", spoken_material(material)},
                                                        {"n", shown},
                                                        {"names", names},
                                                        {"more", std::max(0, shown - 3)}}));
    }
}

}  // namespace handrail::readers
