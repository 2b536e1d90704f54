// Joins and names the surfaces of a Scene's solids that a hand can reach. This is the last step of building a Scene
// from solids. Loading thread.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

// How a face looks, for joining neighbours into one wall: faces with equal numbers look alike. kSkyLook means painted
// sky.
using FaceLook = std::uint32_t;
inline constexpr FaceLook kSkyLook = 0xffffffffU;

// Expects scene.solids with shape, role, face_materials and, for named things and volumes, `feature`.
// Fills face_features, face_hidden and surfaces, and appends a Feature for every wall, floor and ceiling. Gives the
// features of things their area, size and main material; a thing without a name is named after its shape. `looks` has
// one entry per solid with one look per face. If stopped, it leaves a Scene that must not be used.
void derive_surfaces(Scene& scene, std::span<const std::vector<FaceLook>> looks, double metres_per_unit,
                     const std::stop_token& stop = {});

// One of eight compass directions, such as "north-east", for a heading or a direction. compass_point returns the
// English form that names are made of, compass_word the form in the spoken language.
std::string_view compass_point(double heading_rad) noexcept;
std::string compass_word(double heading_rad);
std::string compass_word(const Vec3& direction);
// Names a thing without a name by its size: "pillar", "low block". This is one of our own names: see
// Feature::made_name.
std::string shape_name(const Aabb& bounds_m);

}  // namespace handrail
