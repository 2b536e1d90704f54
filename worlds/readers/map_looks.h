// What the surfaces of a map are made of and which of them look alike, by the keys of their entity and, where these say
// nothing, by guesses from textures. One reading thread.
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

namespace handrail {

class MapLooks {
public:
    // Whether a texture's name may tell the material.
    explicit MapLooks(bool guess) : guess_(guess) {}

    // Alike or not must not depend on whether guessing is on, or the same map would have other walls when replayed.
    FaceLook look_of(const MapMeaning& meaning, const TextureFacts& facts);
    // One of the scene's, added where it is not among them yet.
    MaterialId material_of(Scene& scene, const MapMeaning& meaning, const TextureFacts& facts,
                           std::string_view texture);
    void tell_guesses(ReadReport& report) const;

private:
    using LookKey = std::pair<std::string, std::string>;  // material and keys

    bool guess_;
    std::map<LookKey, FaceLook> known_looks_;
    std::map<std::string, std::set<std::string>> guessed_from_;
};

}  // namespace handrail
