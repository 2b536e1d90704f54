// Turns the brushes of a map into solids, finds the special meaning of their textures, and counts the brushes. Used on
// the reading thread only.
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

    // Returns the solid in world metres. `report` says whether to add warnings about faults.
    BuiltSolid solid_of(const MapBrush& brush, bool report);
    // Like solid_of with warnings; also counts the brush in the report.
    BuiltSolid counted_solid_of(const MapBrush& brush);
    void count(const BuiltSolid& built);
    // Returns the face of the brush that gave this plane of its solid. Refers to the brush that was built last.
    std::uint32_t face_of_plane(std::uint32_t plane) const { return face_of_plane_[plane]; }

    const TextureFacts& facts_of(std::string_view texture);
    // Returns the special meaning that a brush's textures give it. The brush has one only if every face has a special
    // texture; the meaning is then that of the first face.
    TextureSense sense_of(const MapBrush& brush);

    // Returns the line of an earlier brush of the same owner that equals the last built brush exactly. Returns 0 if
    // there is no such brush; later calls then compare with the last built brush, too. Brushes of different owners are
    // never equal.
    int repeats(const BuiltSolid& built, std::uint32_t owner, int line);

    void leave_out() { ++left_out_; }
    int left_out() const { return left_out_; }
    int dropped_faces() const { return dropped_faces_; }

private:
    double units_;
    Diagnostics& diagnostics_;
    ReadReport& report_;
    std::map<std::string_view, TextureFacts> textures_;
    std::vector<Plane> planes_;                 // planes of the brush built last
    std::vector<std::uint32_t> face_of_plane_;  // faces of the brush built last, indexed by plane
    int left_out_ = 0, dropped_faces_ = 0;
    std::unordered_map<std::string, int> lines_;  // line of each brush, by owner and planes
};

}  // namespace handrail::readers
