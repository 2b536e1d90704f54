// Defines materials: what a surface is made of, as a name and as fractions of what a device can render. The library of
// materials is a table.
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

// Selects how a material sounds. audio-cues/plan synthesises sounds of contact, sliding and footsteps from it. Every
// named material has its own class.
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

// A texture that repeats along one direction. Its lengths are in hand travel, so that it feels the same at every zoom.
// haptic/render/relief.h describes how it changes the force.
enum class WaveShape { Level, Sine, Square };  // Level: no depth; only the friction may vary
struct TextureWave {
    WaveShape shape = WaveShape::Level;
    double depth_hand_m = 0.0;
    double period_hand_m = 0.01;
    // The friction varies between (1 - friction_share) and (1 + friction_share) times the material's friction.
    double friction_share = 0.0;
    double turn_rad = 0.0;  // counter-clockwise angle by which the direction of repetition is turned
    bool operator==(const TextureWave&) const = default;
};

// Depths from a grey picture, stored row by row from the top. 0 is the plain surface, 1 the greatest depth.
struct HeightPicture {
    int width = 0, height = 0;
    std::vector<float> depths;
};

// A picture on a surface. From either side of a face, the picture's lower left corner is at the lower left corner of
// the box. The picture repeats in both directions.
struct TexturePicture {
    std::shared_ptr<const HeightPicture> heights;
    double depth_hand_m = 0.0;
    double size_m = 1.0;  // width of one copy of the picture in the world
    double turn_rad = 0.0;
    Aabb box_m;  // bounds of the object that the picture is on
    bool operator==(const TexturePicture& other) const {
        return heights == other.heights && depth_hand_m == other.depth_hand_m && size_m == other.size_m &&
               turn_rad == other.turn_rad && box_m.min_m == other.box_m.min_m && box_m.max_m == other.box_m.max_m;
    }
};

// A surface material as the world states it. Values that the file does not state are empty. Exploring then uses the
// library's values (MaterialSpec below). Replay uses the plain default wall, as the touch contract requires.
struct Material {
    std::string name;  // for speech, in lower case: "plaster"; empty for the default wall
    SoundClass sound = SoundClass::Generic;
    bool guessed = false;                      // true if the material was only guessed from a texture name
    std::optional<double> stiffness_fraction;  // key `stiffness`: 0 to 1 times the device's rated stiffness
    std::optional<double> friction_mu;         // key `friction`: Coulomb coefficient while sliding, >= 0
    // Key `friction_static`: Coulomb coefficient at rest; empty: the same as while sliding.
    std::optional<double> friction_static;
    std::optional<double> damping_ns_per_m;  // key `damping`: force per speed of the hand
    std::optional<TextureWave> wave;
    std::optional<TexturePicture> picture;
    bool operator==(const Material&) const = default;
};

// Above this ratio of static to kinetic friction, a sliding hand sticks and slips in turns, although the person does
// not intend it.
inline constexpr double kMostStaticOverKinetic = 1.25;

// A row of the material library.
struct MaterialSpec {
    std::string_view name;
    SoundClass sound = SoundClass::Generic;
    double stiffness_fraction = 0.8;
    double friction_static = 0.3;
    double friction_mu = 0.3;        // Coulomb coefficient while sliding
    double damping_ns_per_m = -1.0;  // force per speed of the hand; negative: the person's own setting is used
    TextureWave wave{};
};

// Returns all named materials in a fixed order. Their names are the values of the map key `material`. Any two can be
// distinguished by touch alone (see lint.h).
std::span<const MaterialSpec> material_library();
// Finds the material with exactly this name, ignoring case. Returns nullptr if there is none.
const MaterialSpec* find_material(std::string_view name);
// Returns the material that a texture name suggests ("sbrick2a" -> brick), or nullptr. Used only for exploring; the
// report lists such a material as guessed.
const MaterialSpec* guess_material(std::string_view texture_name);

}  // namespace handrail
