// What a hand can reach of a Scene's solids, joined and named: the last step of building a Scene from solids. Loading
// thread.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

// How a face looks, for joining neighbours into one wall: faces with equal numbers are alike. kSkyLook stands for
// painted sky.
using FaceLook = std::uint32_t;
inline constexpr FaceLook kSkyLook = 0xffffffffU;

// Expects scene.solids with shape, role, face_materials and, for named things and volumes, `feature`. Fills
// face_features, face_hidden and surfaces, appends a Feature for every wall, floor and ceiling and gives the features
// of things their area, size and main material; a thing whose name is empty gets one from its shape. `looks` has one
// entry per solid with one look per face. Stopped in the middle it leaves a Scene that is of no use.
void derive_surfaces(Scene& scene, std::span<const std::vector<FaceLook>> looks, double metres_per_unit,
                     const std::stop_token& stop = {});

// "north-east" for a heading or a direction that points there, of the eight sides of the compass: as names are made of
// it, and as it is said.
std::string_view compass_point(double heading_rad) noexcept;
std::string compass_word(double heading_rad);
std::string compass_word(const Vec3& direction);
// What a thing without a name is called, by its size: "pillar", "low block". One of our own names: see
// Feature::made_name.
std::string shape_name(const Aabb& bounds_m);

}  // namespace handrail
