// Brushes of a map as solids, with what their textures say of them, and the count of both. One reading thread.
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

namespace handrail {

class MapBrushes {
public:
    // What is given by reference outlives this object, and so does the text of the map.
    MapBrushes(double metres_per_unit, Diagnostics& diagnostics, ReadReport& report)
        : units_(metres_per_unit), diagnostics_(diagnostics), report_(report) {}

    // In world metres. `report`: with warnings about what is amiss.
    BuiltSolid solid_of(const MapBrush& brush, bool report);
    // With warnings, and counted in the report.
    BuiltSolid counted_solid_of(const MapBrush& brush);
    void count(const BuiltSolid& built);
    // Of the brush that was built last: which face one of its planes was.
    std::uint32_t face_of_plane(std::uint32_t plane) const { return face_of_plane_[plane]; }

    const TextureFacts& facts_of(std::string_view texture);
    // Special only when every face is: the first face then names the kind.
    TextureSense sense_of(const MapBrush& brush);

    // The line of an earlier brush of this owner, of which the one that was built last is an exact repetition; 0: it is
    // none, and counts as an earlier one from now on. `owner`: brushes of another are never the same.
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
    std::vector<std::uint32_t> face_of_plane_;  // likewise
    int left_out_ = 0, dropped_faces_ = 0;
    std::unordered_map<std::string, int> lines_;  // of brushes, by owner and planes
};

}  // namespace handrail
