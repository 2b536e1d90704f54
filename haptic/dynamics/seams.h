// Judges contacts near the seams of a building. Where convex parts are flush, a physics engine also finds contacts on
// their hidden sides, so that a sliding box gets caught and a rolling ball bumps. For each contact the functions decide
// whether it is real, belongs on an open face instead, or must be dropped. Pure functions, any thread. Each call
// examines the few parts that the compiled scene names as neighbours. tests/unit/dynamics has a reference version that
// checks every part of the building.
#pragma once

#include <cstdint>

#include "haptic/render/dynamics_scene.h"

namespace handrail::dynamics {

struct SeamVerdict {
    enum class Kind : std::uint8_t {
        True,  // the contact is on a face, edge or corner that can be touched
        None,  // the contact is inside the building, so it must be dropped
        Face,  // the contact belongs on the face with index `face`
    };
    Kind kind = Kind::True;
    std::uint32_t face = 0;
};

// Distance in front of a face at which a point is tested. If the point is inside another part, the face is covered
// there.
constexpr double kSeamAhead_m = 4e-3;
constexpr double kSeamOn_m = 3e-3;  // greatest distance of a contact from the faces that it belongs to
// Greatest depth to which a body on the floor may be pressed into an object next to it.
constexpr double kSeamPressed_m = 0.02;

// Judges a contact on `piece`. covered(face, point) returns true if `point` is inside another part that may cover
// `face`, grown by kLip_m. A body pressed slightly into a wall stands on floor that the wall covers. A face is
// therefore also open if it is open slightly nearer to the body's centre.
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

// Returns true if the point is in the solid of `piece`, grown by kLip_m.
inline bool in_grown(const render::DynamicsPiece& piece, const Vec3& point_m) noexcept {
    return contains(piece.solid, point_m, render::DynamicsScene::kLip_m);
}

// Judges a contact on part `piece` of the building, in local coordinates of the scene. `normal` points away from the
// building; `body_m` is the body's centre. Round parts have no faces, so a contact on them is always real.
inline SeamVerdict judge_seam(const render::DynamicsScene& scene, std::uint32_t piece, const Vec3& at_m,
                              const Vec3& normal, const Vec3& body_m) noexcept {
    return judge_seam(scene.building[piece], at_m, normal, body_m, [&](std::uint32_t face, const Vec3& p) {
        for (const std::uint32_t other : scene.beside(piece, face))
            if (in_grown(scene.building[other], p)) return true;
        return false;
    });
}

}  // namespace handrail::dynamics
