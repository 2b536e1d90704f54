// Decides what the surfaces of a map are made of, and which look alike: by the keys of their entity, else by guesses
// from textures. One reading thread.
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
    // `guess`: whether a texture's name may determine the material.
    explicit MapLooks(bool guess) : guess_(guess) {}

    // Must not depend on whether guessing is on; otherwise the same map would have different walls when replayed.
    FaceLook look_of(const MapMeaning& meaning, const TextureFacts& facts);
    // Returns a material of the scene and adds it if it is new.
    MaterialId material_of(Scene& scene, const MapMeaning& meaning, const TextureFacts& facts,
                           std::string_view texture);
    void tell_guesses(ReadReport& report) const;

private:
    using LookKey = std::pair<std::string, std::string>;  // material and keys

    bool guess_;
    std::map<LookKey, FaceLook> known_looks_;
    std::map<std::string, std::set<std::string>> guessed_from_;
};

}  // namespace handrail::readers
