#include "worlds/scene/material.h"

#include <array>

#include "worlds/base/text.h"

namespace handrail {
namespace {

// Stiffness is a fraction of what the device can render, friction is Coulomb's mu. There are four steps of stiffness,
// each at least a third above the step below. More steps could not be distinguished on a device of 3 N. Two materials
// of the same step differ by half in friction, or one of them has a texture (test:
// any_two_can_be_distinguished_by_touch). Plaster is the material of the walls in most rooms. Depths and periods of
// textures are in hand travel.
constexpr TextureWave kBars{WaveShape::Square, 0.4e-3, 10e-3};
constexpr TextureWave kJoints{WaveShape::Sine, 0.2e-3, 7e-3};
constexpr TextureWave kTufts{WaveShape::Sine, 0.3e-3, 5e-3};
constexpr TextureWave kGrains{WaveShape::Level, 0.0, 5e-3, 0.2};
constexpr std::array kLibrary{
    MaterialSpec{"plaster", SoundClass::Plaster, 0.75, 0.30, 0.30},
    MaterialSpec{"wood", SoundClass::Wood, 0.75, 0.50, 0.45},
    MaterialSpec{"plastic", SoundClass::Plastic, 0.75, 0.20, 0.18},
    MaterialSpec{"brick", SoundClass::Brick, 1.00, 0.70, 0.60, -1.0, kJoints},
    MaterialSpec{"concrete", SoundClass::Concrete, 1.00, 0.70, 0.60},
    MaterialSpec{"stone", SoundClass::Stone, 1.00, 0.45, 0.38},
    MaterialSpec{"tile", SoundClass::Tile, 1.00, 0.28, 0.24},
    MaterialSpec{"metal", SoundClass::Metal, 1.00, 0.18, 0.15},
    MaterialSpec{"steel grille", SoundClass::Grille, 1.00, 0.18, 0.15, -1.0, kBars},
    MaterialSpec{"glass", SoundClass::Glass, 1.00, 0.10, 0.09},
    MaterialSpec{"ice", SoundClass::Ice, 1.00, 0.03, 0.03},
    MaterialSpec{"carpet", SoundClass::Carpet, 0.50, 0.80, 0.70, 8.0},
    MaterialSpec{"sand", SoundClass::Sand, 0.50, 0.45, 0.45, 10.0, kGrains},
    MaterialSpec{"earth", SoundClass::Earth, 0.50, 0.28, 0.28, 10.0},
    MaterialSpec{"rubber", SoundClass::Rubber, 0.30, 0.75, 0.60, 8.0},
    MaterialSpec{"cloth", SoundClass::Cloth, 0.30, 0.35, 0.35, 8.0},
    MaterialSpec{"grass", SoundClass::Grass, 0.30, 0.60, 0.60, 8.0, kTufts},
};

struct TextureRule {
    std::string_view part;
    std::string_view material;
    bool at_start = false;  // the pattern matches only at the beginning of the texture's name
};

// The first rule that matches is used. So "wizwood" is wood, although a name that begins with "wiz" is stone; and
// "plaster" is plaster, although "plat" means metal. In the game's own texture sets, tech, slip, comp, base, key and m5
// are metal panels, cop and ecop are copper, and uwall, city and church are cut stone.
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
    TextureRule{"grille", "steel grille"}, TextureRule{"grate", "steel grille"},
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
    // Removes the prefix of animated or alternating textures: "+0slip".
    if (name.size() > 2 && (name[0] == '+' || name[0] == '-')) name.erase(0, 2);
    if (name.starts_with('{')) name.erase(0, 1);  // removes the prefix of see-through textures
    for (const TextureRule& rule : kTextureRules) {
        const std::size_t found = name.find(rule.part);
        if (found == 0 || (found != std::string::npos && !rule.at_start)) return find_material(rule.material);
    }
    return nullptr;
}

}  // namespace handrail
