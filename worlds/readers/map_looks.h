// Determines the material of a map's surfaces and which surfaces look alike. The keys of an entity state the material;
// without such keys, the texture suggests one. Used on the reading thread only.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "worlds/readers/map_meaning.h"
#include "worlds/readers/map_words.h"
#include "worlds/scene/scene.h"
#include "worlds/scene/surfaces.h"

namespace handrail::readers {

class MapLooks {
public:
    // `guess` says whether a texture's name may determine the material.
    explicit MapLooks(bool guess) : guess_(guess) {}

    // Returns the look of a face. The result must not depend on whether guessing is on. Otherwise the walls of the same
    // map would be joined differently when the map is replayed.
    FaceLook look_of(const MapMeaning& meaning, const TextureFacts& facts);
    // Returns the index of a material in the scene; adds the material if it is new.
    MaterialId material_of(Scene& scene, const MapMeaning& meaning, const TextureFacts& facts,
                           std::string_view texture);
    void report_guesses(ReadReport& report) const;

private:
    // Name of the material, and the entity's keys about the surface.
    using LookKey = std::pair<std::string, std::string>;

    bool guess_;
    std::map<LookKey, FaceLook> known_looks_;
    std::map<std::string, std::set<std::string>> guessed_from_;
};

}  // namespace handrail::readers
