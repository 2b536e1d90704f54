// Joins and names those surfaces of a Scene's solids that a hand can reach. This is the last step of building a Scene
// from solids. Used on the loading thread.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "worlds/scene/scene.h"

namespace handrail {

// The appearance of a face, as a number. Neighbouring faces are joined into one wall only if their numbers are equal.
// kSkyLook means painted sky.
using FaceLook = std::uint32_t;
inline constexpr FaceLook kSkyLook = 0xffffffffU;

// Derives surfaces from the scene's solids. Each solid must have shape, role and face_materials, and `feature` if it is
// a named thing or volume. Fills face_features, face_hidden and surfaces, and appends a Feature for every wall, floor
// and ceiling. Gives the features of things their area, size and main material; a thing without a name is named after
// its shape. `looks` has one entry per solid, with one look per face. After a stop request, the Scene must not be used.
void derive_surfaces(Scene& scene, std::span<const std::vector<FaceLook>> looks, double metres_per_unit,
                     const std::stop_token& stop = {});

// These functions return the nearest of eight compass directions, such as "north-east", for a heading or a direction.
// compass_point returns the English form, which is part of names. compass_word returns the form in the spoken language.
std::string_view compass_point(double heading_rad) noexcept;
std::string compass_word(double heading_rad);
std::string compass_word(const Vec3& direction);
// Returns a name for an unnamed thing, based on its size: "pillar", "low block". It is one of our own names (see
// Feature::made_name).
std::string shape_name(const Aabb& bounds_m);

}  // namespace handrail
