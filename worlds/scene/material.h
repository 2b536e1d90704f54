// Materials: what a surface is made of, as a name and as fractions of what a device can render. The library is data.
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

// How a material sounds. audio-cues/plan synthesises contact, slide and footstep sounds from it. Every named material
// has its own class.
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

// A texture that repeats along one direction. Lengths are hand travel, so that it feels the same at every zoom.
// haptic/render/relief.h describes its effect on the force.
enum class WaveShape { Level, Sine, Square };  // Level: no depth; only the friction may vary
struct TextureWave {
    WaveShape shape = WaveShape::Level;
    double depth_hand_m = 0.0;
    double period_hand_m = 0.01;
    double friction_share = 0.0;  // the friction varies between 1 - share and 1 + share times the material's friction
    double turn_rad = 0.0;        // counter-clockwise turn of the direction along which it repeats
    bool operator==(const TextureWave&) const = default;
};

// Depths from a grey picture: 0 is the plain surface, 1 the deepest. Row by row, top row first.
struct HeightPicture {
    int width = 0, height = 0;
    std::vector<float> depths;
};

// A picture on a surface. Its lower left corner is at that of the box, from whichever side a face is viewed, and it
// repeats in both directions.
struct TexturePicture {
    std::shared_ptr<const HeightPicture> heights;
    double depth_hand_m = 0.0;
    double size_m = 1.0;  // width of one copy in the world
    double turn_rad = 0.0;
    Aabb box_m;  // of the thing that the picture is on
    bool operator==(const TexturePicture& other) const {
        return heights == other.heights && depth_hand_m == other.depth_hand_m && size_m == other.size_m &&
               turn_rad == other.turn_rad && box_m.min_m == other.box_m.min_m && box_m.max_m == other.box_m.max_m;
    }
};

// A surface material as the world states it. Values that the file does not state are empty: exploring then uses the
// library's values (MaterialSpec below), and replay uses the plain default wall, as the touch contract requires.
struct Material {
    std::string name;  // spoken, lower case: "plaster"; empty for the default wall
    SoundClass sound = SoundClass::Generic;
    bool guessed = false;                      // true when only a texture name suggested it
    std::optional<double> stiffness_fraction;  // key `stiffness`, 0 to 1 times the device's rated stiffness
    std::optional<double> friction_mu;         // key `friction`, Coulomb coefficient, >= 0, while sliding
    std::optional<double> friction_static;     // key `friction_static`, at rest; empty: the same as while sliding
    std::optional<double> damping_ns_per_m;    // key `damping`, per hand speed
    std::optional<TextureWave> wave;
    std::optional<TexturePicture> picture;
    bool operator==(const Material&) const = default;
};

// Above this ratio of static to kinetic friction, a hand alternately sticks and slips without wanting to.
inline constexpr double kMostStaticOverKinetic = 1.25;

// A row of the material library.
struct MaterialSpec {
    std::string_view name;
    SoundClass sound = SoundClass::Generic;
    double stiffness_fraction = 0.8;
    double friction_static = 0.3;
    double friction_mu = 0.3;        // while sliding
    double damping_ns_per_m = -1.0;  // negative: the person's own setting is used
    TextureWave wave{};
};

// All named materials in a fixed order. Their names are the values of the map key `material`. Any two can be told apart
// by touch alone (see lint.h).
std::span<const MaterialSpec> material_library();
// Finds the whole name, ignoring case; nullptr if there is none.
const MaterialSpec* find_material(std::string_view name);
// The material that a texture name suggests ("sbrick2a" -> brick), or nullptr. Used when exploring; the report lists it
// as guessed.
const MaterialSpec* guess_material(std::string_view texture_name);

}  // namespace handrail
