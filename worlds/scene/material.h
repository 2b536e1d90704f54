// Materials: what a surface is made of, in words and in fractions of what a device can render. The library is data.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "worlds/base/feature_id.h"

namespace handrail {

// How a material sounds; audio-cues/plan turns this into a synthesised contact, slide and footstep sound.
enum class SoundClass { Plaster, Wood, Brick, Concrete, Tile, Carpet, Metal, Glass, Stone, Rubber, Grass, Water, Generic };

// One surface as the world gives it. What the file does not say stays empty: exploring then takes the library's values
// (MaterialSpec below), replay takes the plain default wall (decisions of the touch contract).
struct Material {
    std::string name;  // spoken, lower case: "plaster"; empty for the default wall
    SoundClass sound = SoundClass::Generic;
    bool guessed = false;                      // true when only a texture name suggested it
    std::optional<double> stiffness_fraction;  // key `stiffness`, 0 to 1 of the device's rated stiffness
    std::optional<double> friction_mu;         // key `friction`, Coulomb coefficient, >= 0
};

// A row of the material library.
struct MaterialSpec {
    std::string_view name;
    SoundClass sound = SoundClass::Generic;
    double stiffness_fraction = 0.8;
    double friction_mu = 0.3;
};

// Every named material, fixed order. Names are what the map key `material` takes.
std::span<const MaterialSpec> material_library();
// Exact, case-insensitive; nullptr when there is none of that name.
const MaterialSpec* find_material(std::string_view name);
// What a texture name suggests ("sbrick2a" -> brick), or nullptr. Used when exploring and listed as guessed.
const MaterialSpec* guess_material(std::string_view texture_name);

}  // namespace handrail
