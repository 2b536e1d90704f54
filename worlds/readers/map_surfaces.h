// Reads from an entity's keys how its surfaces feel: stiffness, friction, waves and pictures. Used on the reading
// thread only.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "worlds/geometry/clip.h"
#include "worlds/readers/map_keys.h"
#include "worlds/readers/reader.h"
#include "worlds/scene/material.h"

namespace handrail::readers {

// Returns a text that is equal for surfaces that feel alike, whatever material they are made of.
std::string look_of_surface(const Material& surface);

class MapSurfaces {
public:
    // `built` turns a brush into a solid, without warnings. The referenced objects must outlive this object.
    MapSurfaces(const ReadOptions& options, double metres_per_unit, Diagnostics& diagnostics, const MapKeys& keys,
                std::function<BuiltSolid(const MapBrush&)> built)
        : options_(options),
          units_(metres_per_unit),
          diagnostics_(diagnostics),
          keys_(keys),
          built_(std::move(built)) {}

    // Reads all keys about the surface except the material's name.
    Material read(const MapEntity& entity);

private:
    void read_wave(const MapEntity& entity, std::optional<double> depth_mm, double turn_rad, Material& surface);
    void read_picture(const MapEntity& entity, std::optional<double> depth_mm, double turn_rad, Material& surface);

    const ReadOptions& options_;
    double units_;
    Diagnostics& diagnostics_;
    const MapKeys& keys_;
    std::function<BuiltSolid(const MapBrush&)> built_;
    // The pictures that have been read, by file name. Null: the file was unusable, which has been reported.
    std::map<std::string, std::shared_ptr<const HeightPicture>> pictures_;
};

}  // namespace handrail::readers
