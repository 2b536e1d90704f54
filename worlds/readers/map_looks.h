// Decides what the surfaces of a map are made of and which surfaces look alike. The keys of an entity decide; without
// such keys, the texture suggests a material. Used on the reading thread only.
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

    // Returns the look of a face. The result must not depend on whether guessing is on; otherwise the same map would
    // have different walls when it is replayed.
    FaceLook look_of(const MapMeaning& meaning, const TextureFacts& facts);
    // Returns the index of a material in the scene; adds the material if it is new.
    MaterialId material_of(Scene& scene, const MapMeaning& meaning, const TextureFacts& facts,
                           std::string_view texture);
    void tell_guesses(ReadReport& report) const;

private:
    using LookKey = std::pair<std::string, std::string>;  // the material and the entity's keys about the surface

    bool guess_;
    std::map<LookKey, FaceLook> known_looks_;
    std::map<std::string, std::set<std::string>> guessed_from_;
};

}  // namespace handrail::readers
