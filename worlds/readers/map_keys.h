// Values of map keys: what is no number or out of range is told with its place, and the nearest legal value or the
// default taken.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "worlds/geometry/triangle_mesh.h"
#include "worlds/readers/map_syntax.h"

namespace handrail {

std::string_view trimmed(std::string_view text);

// "both", "front" or "back", in any case.
std::optional<TouchSide> touch_side_named(std::string_view word);

// What the value says, as it is spoken.
std::string text_of(const MapEntity& entity, std::string_view key);
// The key's texts in other languages: `name_de` and so on for `name`.
OtherLanguages texts_in(const MapEntity& entity, std::string_view key);

// A number that a key may have. `range`: the key of the text that says it, from {least} and {most}.
struct NumberKey {
    std::string_view key;
    double least, most;
    std::string_view range;
};

class MapKeys {
public:
    MapKeys(Diagnostics& diagnostics, double metres_per_unit) : diagnostics_(diagnostics), units_(metres_per_unit) {}

    // A number from `least` to `most`; what is no number is left out, what lies outside is moved to the nearest end,
    // both with a warning. `range` is the key of the text that says the range, from {least} and {most}.
    std::optional<double> number_of(const MapEntity& entity, std::string_view key, double least, double most,
                                    std::string_view range) const;
    std::optional<double> number_of(const MapEntity& entity, const NumberKey& key) const {
        return number_of(entity, key.key, key.least, key.most, key.range);
    }
    // "x y z", as it stands. Without a warning about what is missing. `otherwise` is the key of what is done about a
    // bad one.
    std::optional<Vec3> vector_of(const MapEntity& entity, std::string_view key,
                                  std::string_view otherwise = "map.then_no_place") const;
    bool yes_no_of(const MapEntity& entity, std::string_view key) const;
    // "north" or "left" and so on; empty: not given.
    std::string side_of(const MapEntity& entity, std::string_view key) const;
    // The key `axis`: x, y or z, or the other way with a minus sign. The turn that brings z there.
    struct AxisTurn {
        int axis = 2;
        Rotation turn;
    };
    AxisTurn axis_of(const MapEntity& entity) const;

private:
    Diagnostics& diagnostics_;
    double units_;  // metres in one
};

}  // namespace handrail
