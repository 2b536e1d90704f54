// Where convex parts of a building meet flush, an engine finds contacts on their hidden sides: a sliding box gets
// caught, a rolling ball bumps. This code judges a contact on one part: it is real, it belongs on an open face instead,
// or it is no contact at all. Pure; any thread. It looks at the few parts that the compiled scene names as neighbours.
// A reference version that checks every part of the building is in tests/unit/dynamics.
#pragma once

#include <cstdint>

#include "haptic/render/dynamics_scene.h"

namespace handrail::dynamics {

struct SeamVerdict {
    enum class Kind : std::uint8_t {
        True,  // a face, edge or corner that can be touched
        None,  // inside the building
        Face,  // it belongs on this face
    };
    Kind kind = Kind::True;
    std::uint32_t face = 0;
};

constexpr double kSeamAhead_m = 4e-3;  // a face is shut where the point this far in front of it is inside another part
constexpr double kSeamOn_m = 3e-3;     // a contact belongs to faces that are this near
// Depth to which a body may be pressed into an object next to the one it stands on.
constexpr double kSeamPressed_m = 0.02;

// covered(face, point): whether the point is inside another part, grown by kLip_m, that may cover this face. A body
// pressed slightly into a wall stands on floor that the wall covers. A face therefore also counts as open if it is open
// slightly nearer to the body's centre.
template <class Covered>
SeamVerdict judge_seam(const render::DynamicsPiece& piece, const Vec3& at_m, const Vec3& normal, const Vec3& body_m,
                       Covered&& covered) {
    const auto shut = [&](std::uint32_t face, const Plane& plane) {
        const Vec3 ahead = plane.normal * kSeamAhead_m;
        if (!covered(face, at_m + ahead)) return false;
        Vec3 nearer = body_m - at_m;
        nearer -= plane.normal * glm::dot(plane.normal, nearer);
        const double way = glm::length(nearer);
        if (way > kSeamPressed_m) nearer *= kSeamPressed_m / way;
        return !contains(piece.solid, at_m + nearer, kSeamOn_m) || covered(face, at_m + nearer + ahead);
    };
    bool any_shut = false;
    double best = -2.0;
    SeamVerdict verdict{SeamVerdict::Kind::None, 0};
    for (std::uint32_t face = 0; face < piece.solid.planes.size(); ++face) {
        const Plane& plane = piece.solid.planes[face];
        const double height = signed_distance(plane, at_m);
        if (height > kSeamOn_m || height < -kSeamOn_m) continue;
        if (shut(face, plane)) any_shut = true;
        else if (const double along = glm::dot(plane.normal, normal); along > best) {
            best = along;
            verdict = {SeamVerdict::Kind::Face, face};
        }
    }
    if (!any_shut || best > 0.99999) return {};
    return verdict;
}

// Returns true if the point is in the solid grown by kLip_m.
inline bool in_grown(const render::DynamicsPiece& piece, const Vec3& point_m) noexcept {
    return contains(piece.solid, point_m, render::DynamicsScene::kLip_m);
}

// Local coordinates of the scene; normal: away from the building; body_m: the body's centre. Round parts have no faces,
// so a contact on them is always real.
inline SeamVerdict judge_seam(const render::DynamicsScene& scene, std::uint32_t piece, const Vec3& at_m,
                              const Vec3& normal, const Vec3& body_m) noexcept {
    return judge_seam(scene.building[piece], at_m, normal, body_m, [&](std::uint32_t face, const Vec3& p) {
        for (const std::uint32_t other : scene.beside(piece, face))
            if (in_grown(scene.building[other], p)) return true;
        return false;
    });
}

}  // namespace handrail::dynamics
