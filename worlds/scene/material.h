// Materials: what a surface is made of, in words and in fractions of what a device can render. The library is data.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "worlds/base/feature_id.h"
#include "worlds/geometry/convex.h"

namespace handrail {

// How a material sounds; audio-cues/plan turns this into a synthesised contact, slide and footstep sound. Every named
// material has one of its own.
enum class SoundClass {
    Plaster,
    Wood,
    Brick,
    Concrete,
    Tile,
    Carpet,
    Metal,
    Glass,
    Stone,
    Rubber,
    Grass,
    Water,
    Plastic,
    Cloth,
    Sand,
    Earth,
    Ice,
    Grille,
    Generic
};

// A texture that repeats along one direction. Lengths are hand travel, so that it feels alike at every zoom. What it
// does to the force: haptic/render/relief.h.
enum class WaveShape { Level, Sine, Square };  // Level: no depth, only friction may vary
struct TextureWave {
    WaveShape shape = WaveShape::Level;
    double depth_hand_m = 0.0;
    double period_hand_m = 0.01;
    double friction_share = 0.0;  // friction runs from 1 - share to 1 + share times the material's
    double turn_rad = 0.0;        // counter-clockwise, of the direction along which it repeats
    bool operator==(const TextureWave&) const = default;
};

// Depths from a grey picture: 0 plain to 1 deepest, row by row, the top row first.
struct HeightPicture {
    int width = 0, height = 0;
    std::vector<float> depths;
};

// A picture laid on: its lower left corner in that of the box, however a face of it is looked at, and repeated both
// ways.
struct TexturePicture {
    std::shared_ptr<const HeightPicture> heights;
    double depth_hand_m = 0.0;
    double size_m = 1.0;  // width of one copy in the world
    double turn_rad = 0.0;
    Aabb box_m;  // of the thing it lies on
    bool operator==(const TexturePicture& other) const {
        return heights == other.heights && depth_hand_m == other.depth_hand_m && size_m == other.size_m &&
               turn_rad == other.turn_rad && box_m.min_m == other.box_m.min_m && box_m.max_m == other.box_m.max_m;
    }
};

// One surface as the world gives it. What the file does not say stays empty: exploring then takes the library's values
// (MaterialSpec below), replay takes the plain default wall (decisions of the touch contract).
struct Material {
    std::string name;  // spoken, lower case: "plaster"; empty for the default wall
    SoundClass sound = SoundClass::Generic;
    bool guessed = false;                      // true when only a texture name suggested it
    std::optional<double> stiffness_fraction;  // key `stiffness`, 0 to 1 of the device's rated stiffness
    std::optional<double> friction_mu;         // key `friction`, Coulomb coefficient, >= 0, while sliding
    std::optional<double> friction_static;     // key `friction_static`, at rest; without it as while sliding
    std::optional<double> damping_ns_per_m;    // key `damping`, of hand speed
    std::optional<TextureWave> wave;
    std::optional<TexturePicture> picture;
    bool operator==(const Material&) const = default;
};

// Above this ratio of friction at rest to friction while sliding a hand sticks and slips by itself.
inline constexpr double kMostStaticOverKinetic = 1.25;

// A row of the material library.
struct MaterialSpec {
    std::string_view name;
    SoundClass sound = SoundClass::Generic;
    double stiffness_fraction = 0.8;
    double friction_static = 0.3;
    double friction_mu = 0.3;        // while sliding
    double damping_ns_per_m = -1.0;  // negative: as the person has set it
    TextureWave wave{};
};

// Every named material, fixed order. Names are what the map key `material` takes. Every two can be told apart by touch
// alone (see lint.h).
std::span<const MaterialSpec> material_library();
// Exact, case-insensitive; nullptr when there is none of that name.
const MaterialSpec* find_material(std::string_view name);
// What a texture name suggests ("sbrick2a" -> brick), or nullptr. Used when exploring and listed as guessed.
const MaterialSpec* guess_material(std::string_view texture_name);

}  // namespace handrail
