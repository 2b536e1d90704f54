// Tables of the words in a map: the classes of its entities, the sounds that they make, and the names of its textures.
// The functions are pure; any thread may use them. The names are those that files use; for speech use phrase("kind." +
// name).
#pragma once

#include <string_view>

#include "worlds/scene/material.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

// A row of the table of entity classes. It states what the brushes of an entity become. The first row that matches is
// used. A class_name that ends in * matches as a prefix.
struct ClassRow {
    std::string_view class_name;
    SolidRole role;
    FeatureKind kind;
    std::string_view name;  // name of the feature if the map gives none; empty: the feature is named after its shape
};
// Returns null for a class without a row, whose entities are ordinary things.
const ClassRow* class_row(std::string_view class_name);

// Gives the feature one of our own names. Use this function if the map gives no name.
void give_name(Feature& feature, std::string_view name);

// True for classes that are part of the building itself. Their brushes are joined, and named by side unless the entity
// has a name.
bool is_structure(std::string_view class_name);
// True for classes of fire, fountains and similar effects. Other programs show them; in Handrail they can only be
// heard.
bool is_particles(std::string_view class_name);
// Returns the key of the text that names the sound of such an entity. Empty if the class has no sound.
std::string_view sound_of_class(std::string_view class_name);

// The meaning that a texture gives to the brush that it covers.
enum class TextureSense { Ordinary, Water, Slime, Lava, Teleport, Clip, Trigger, LeftOut };

struct TextureFacts {
    TextureSense sense = TextureSense::Ordinary;
    bool sky = false;
    const MaterialSpec* guess = nullptr;
};
TextureFacts facts_of_texture(std::string_view texture);

}  // namespace handrail::readers
