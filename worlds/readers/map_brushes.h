// Turns the brushes of a map into solids, finds out what their textures mean, and counts them. One reading thread.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "worlds/geometry/clip.h"
#include "worlds/readers/map_syntax.h"
#include "worlds/readers/map_words.h"

namespace handrail::readers {

class MapBrushes {
public:
    // The referenced objects and the text of the map must outlive this object.
    MapBrushes(double metres_per_unit, Diagnostics& diagnostics, ReadReport& report)
        : units_(metres_per_unit), diagnostics_(diagnostics), report_(report) {}

    // The solid in world metres. `report`: whether to add warnings about faults.
    BuiltSolid solid_of(const MapBrush& brush, bool report);
    // The same with warnings; also counts the brush in the report.
    BuiltSolid counted_solid_of(const MapBrush& brush);
    void count(const BuiltSolid& built);
    // For the brush built last: the face that a plane of the solid came from.
    std::uint32_t face_of_plane(std::uint32_t plane) const { return face_of_plane_[plane]; }

    const TextureFacts& facts_of(std::string_view texture);
    // A brush has a special meaning only if all its faces have one; the first face then decides which.
    TextureSense sense_of(const MapBrush& brush);

    // Returns the line of an earlier brush of the same owner that the brush built last repeats exactly. Returns 0 if it
    // repeats none; it then counts as an earlier brush from now on. Brushes of different owners are never the same.
    int repeats(const BuiltSolid& built, std::uint32_t owner, int line);

    void leave_out() { ++left_out_; }
    int left_out() const { return left_out_; }
    int dropped_faces() const { return dropped_faces_; }

private:
    double units_;
    Diagnostics& diagnostics_;
    ReadReport& report_;
    std::map<std::string_view, TextureFacts> textures_;
    std::vector<Plane> planes_;                 // of the brush built last
    std::vector<std::uint32_t> face_of_plane_;  // of the brush built last
    int left_out_ = 0, dropped_faces_ = 0;
    std::unordered_map<std::string, int> lines_;  // lines of brushes, by owner and planes
};

}  // namespace handrail::readers
