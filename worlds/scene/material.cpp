#include "worlds/scene/material.h"

#include <array>

#include "worlds/base/text.h"

namespace handrail {
namespace {

// Stiffness as a fraction of what the device can render, friction as Coulomb's mu. Plaster is the wall that most rooms have and stands a little
// below the untagged default; soft floors and rubber lie well below it so that they are told apart by touch alone.
constexpr std::array kLibrary{
    MaterialSpec{"plaster", SoundClass::Plaster, 0.75, 0.35}, MaterialSpec{"wood", SoundClass::Wood, 0.70, 0.35},
    MaterialSpec{"brick", SoundClass::Brick, 0.90, 0.60},     MaterialSpec{"concrete", SoundClass::Concrete, 0.95, 0.50},
    MaterialSpec{"stone", SoundClass::Stone, 0.95, 0.45},     MaterialSpec{"tile", SoundClass::Tile, 0.90, 0.20},
    MaterialSpec{"metal", SoundClass::Metal, 1.00, 0.20},     MaterialSpec{"glass", SoundClass::Glass, 0.95, 0.10},
    MaterialSpec{"carpet", SoundClass::Carpet, 0.35, 0.70},   MaterialSpec{"cloth", SoundClass::Carpet, 0.25, 0.50},
    MaterialSpec{"rubber", SoundClass::Rubber, 0.30, 0.90},   MaterialSpec{"plastic", SoundClass::Generic, 0.65, 0.25},
    MaterialSpec{"grass", SoundClass::Grass, 0.30, 0.60},     MaterialSpec{"sand", SoundClass::Grass, 0.25, 0.70},
    MaterialSpec{"earth", SoundClass::Grass, 0.45, 0.60},     MaterialSpec{"ice", SoundClass::Glass, 0.90, 0.03},
};

struct TextureRule {
    std::string_view part;
    std::string_view material;
    bool at_start = false;  // the texture's name must begin with it
};

// First match wins, so that "wizwood" is wood before "wiz" could say anything and "plaster" is plaster before "plat" is metal.
// The game's own sets: tech, slip, comp, base, key and m5 are panels of metal, cop and ecop copper, uwall, city and church cut stone.
constexpr std::array kTextureRules{
    TextureRule{"plaster", "plaster"},     TextureRule{"stucco", "plaster"},
    TextureRule{"plastic", "plastic"},     TextureRule{"wood", "wood"},
    TextureRule{"crate", "wood"},          TextureRule{"plank", "wood"},
    TextureRule{"brick", "brick"},         TextureRule{"carpet", "carpet"},
    TextureRule{"rug", "carpet", true},    TextureRule{"curtain", "cloth"},
    TextureRule{"cloth", "cloth"},         TextureRule{"concrete", "concrete"},
    TextureRule{"cement", "concrete"},     TextureRule{"glass", "glass"},
    TextureRule{"window", "glass"},        TextureRule{"grass", "grass"},
    TextureRule{"sand", "sand", true},     TextureRule{"ground", "earth"},
    TextureRule{"dirt", "earth"},          TextureRule{"rock", "stone"},
    TextureRule{"stone", "stone"},         TextureRule{"marble", "stone"},
    TextureRule{"tile", "tile"},           TextureRule{"rubber", "rubber"},
    TextureRule{"ice", "ice", true},       TextureRule{"met", "metal"},
    TextureRule{"steel", "metal"},         TextureRule{"iron", "metal", true},
    TextureRule{"sfloor", "metal", true},  TextureRule{"tech", "metal", true},
    TextureRule{"slip", "metal", true},    TextureRule{"comp", "metal", true},
    TextureRule{"plat_", "metal", true},   TextureRule{"cop", "metal", true},
    TextureRule{"ecop", "metal", true},    TextureRule{"edoor", "metal", true},
    TextureRule{"m5_", "metal", true},     TextureRule{"basebutn", "metal", true},
    TextureRule{"basebtn", "metal", true}, TextureRule{"city", "stone", true},
    TextureRule{"church", "stone", true},  TextureRule{"uwall", "stone", true},
    TextureRule{"twall", "metal", true},   TextureRule{"wall", "stone", true},
    TextureRule{"dem", "stone", true},     TextureRule{"wiz", "stone", true},
    TextureRule{"ceiling", "plaster"},
};

}  // namespace

std::span<const MaterialSpec> material_library() { return kLibrary; }

const MaterialSpec* find_material(std::string_view name) {
    const std::string wanted = lower_ascii(name);
    for (const MaterialSpec& spec : kLibrary)
        if (spec.name == wanted) return &spec;
    return nullptr;
}

const MaterialSpec* guess_material(std::string_view texture_name) {
    std::string name = lower_ascii(texture_name.substr(0, 64));
    if (const std::size_t slash = name.find_last_of("/\\"); slash != std::string::npos) name.erase(0, slash + 1);
    if (name.size() > 2 && (name[0] == '+' || name[0] == '-')) name.erase(0, 2);  // animated or alternating: "+0slip"
    if (name.starts_with('{')) name.erase(0, 1);                                  // see-through
    for (const TextureRule& rule : kTextureRules) {
        const std::size_t found = name.find(rule.part);
        if (found == 0 || (found != std::string::npos && !rule.at_start)) return find_material(rule.material);
    }
    return nullptr;
}

}  // namespace handrail
