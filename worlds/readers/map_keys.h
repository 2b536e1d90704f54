// Reads the values of map keys. If a value is not a number or is out of range, the reader reports it with its place and
// uses the default or the nearest legal value.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "worlds/geometry/triangle_mesh.h"
#include "worlds/readers/map_syntax.h"

namespace handrail::readers {

std::string_view trimmed(std::string_view text);

// Reads "both", "front" or "back", ignoring case. Empty for any other word.
std::optional<TouchSide> touch_side_named(std::string_view word);

// Returns the value of a key as text that can be spoken.
std::string text_of(const MapEntity& entity, std::string_view key);
// Returns the translations of a key's text: for `name`, the values of `name_de` and so on.
OtherLanguages texts_in(const MapEntity& entity, std::string_view key);

// The legal range of a number key. `range` is the key of the text that states this range, with {least} and {most}.
struct NumberKey {
    std::string_view key;
    double least, most;
    std::string_view range;
};

class MapKeys {
public:
    MapKeys(Diagnostics& diagnostics, double metres_per_unit) : diagnostics_(diagnostics), units_(metres_per_unit) {}

    // Reads a number from `least` to `most`. A value that is not a number is ignored, and a value out of range is
    // replaced with the nearer limit. In both cases the function adds a warning. `range` is the key of the text that
    // states the range, with {least} and {most}.
    std::optional<double> number_of(const MapEntity& entity, std::string_view key, double least, double most,
                                    std::string_view range) const;
    std::optional<double> number_of(const MapEntity& entity, const NumberKey& key) const {
        return number_of(entity, key.key, key.least, key.most, key.range);
    }
    // Reads "x y z" in the units of the map. A missing key gives no warning. `otherwise` is the key of the text that
    // says what happens if the value is faulty.
    std::optional<Vec3> vector_of(const MapEntity& entity, std::string_view key,
                                  std::string_view otherwise = "map.then_no_place") const;
    bool yes_no_of(const MapEntity& entity, std::string_view key) const;
    // Returns the side that the key states: "north", "left" and so on. Empty if the key is missing.
    std::string side_of(const MapEntity& entity, std::string_view key) const;
    // The value of the key `axis`: x, y or z, with a minus sign for the opposite direction. `turn` rotates z into that
    // direction.
    struct AxisTurn {
        int axis = 2;
        Rotation turn;
    };
    AxisTurn axis_of(const MapEntity& entity) const;

private:
    Diagnostics& diagnostics_;
    double units_;  // metres per map unit
};

}  // namespace handrail::readers
