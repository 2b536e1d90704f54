// The meaning of the words of a map: the classes of its entities, the sounds that they make, and the names of its
// textures. Tables and pure functions. Names are those that files use; speech uses phrase("kind." + name). Any thread.
#pragma once

#include <string_view>

#include "worlds/scene/material.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

// What an entity of this class makes of its brushes. The first row that matches counts; a name that ends in * matches
// as a prefix.
struct ClassRow {
    std::string_view class_name;
    SolidRole role;
    FeatureKind kind;
    std::string_view name;  // used if the map gives no name; empty: named by shape
};
const ClassRow* class_row(std::string_view class_name);  // null: an ordinary thing

// Gives the feature one of our own names, for when the map gives none.
void give_name(Feature& feature, std::string_view name);

// True for parts of the building itself: their brushes are joined, and named by side unless the entity has a name.
bool is_structure(std::string_view class_name);
// Fire, fountains and the like: other programs show them; in Handrail they can only be heard.
bool is_particles(std::string_view class_name);
// The key of the text that names the sound of such an entity; empty if the class has no sound.
std::string_view sound_of_class(std::string_view class_name);

// What a texture says about the brush that it covers.
enum class TextureSense { Ordinary, Water, Slime, Lava, Teleport, Clip, Trigger, LeftOut };

struct TextureFacts {
    TextureSense sense = TextureSense::Ordinary;
    bool sky = false;
    const MaterialSpec* guess = nullptr;
};
TextureFacts facts_of_texture(std::string_view texture);

}  // namespace handrail::readers
