// What the words of a map mean: the classes of its entities, the sounds they make, and the names of its textures.
// Tables and pure functions; names are those that files know things by, spoken as phrase("kind." + name). Any thread.
#pragma once

#include <string_view>

#include "worlds/scene/material.h"
#include "worlds/scene/scene.h"

namespace handrail {

// What the class of an entity makes of its brushes. The first row that fits counts; a name ending in * fits as a
// beginning.
struct ClassRow {
    std::string_view class_name;
    SolidRole role;
    FeatureKind kind;
    std::string_view name;  // spoken where the map gives none; empty: by shape
};
const ClassRow* class_row(std::string_view class_name);  // null: an ordinary thing

// One of our own names, where the map gives none.
void give_name(Feature& feature, std::string_view name);

// Part of the building itself: its brushes are joined and named by side unless the entity has a name of its own.
bool is_structure(std::string_view class_name);
// Fire, fountains and the like: seen in other programs, felt in none, heard here.
bool is_particles(std::string_view class_name);
// The key of the text that names the sound of such an entity; empty: the class has none.
std::string_view sound_of_class(std::string_view class_name);

// What one texture says about the brush it covers.
enum class TextureSense { Ordinary, Water, Slime, Lava, Teleport, Clip, Trigger, LeftOut };

struct TextureFacts {
    TextureSense sense = TextureSense::Ordinary;
    bool sky = false;
    const MaterialSpec* guess = nullptr;
};
TextureFacts facts_of_texture(std::string_view texture);

}  // namespace handrail
