// Bullet's shapes for parts of the dynamics scene. Private to this folder: Bullet's headers stay in it. Source:
// Bullet 3.24, double precision.
#pragma once

#include <BulletCollision/CollisionShapes/btTriangleInfoMap.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "haptic/render/dynamics_scene.h"

namespace handrail {

inline btVector3 bullet(const Vec3& v) { return {v.x, v.y, v.z}; }
inline Vec3 ours(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
inline btTransform bullet(const Placement& at) {
    return btTransform(btQuaternion(at.rotation.x, at.rotation.y, at.rotation.z, at.rotation.w), bullet(at.position_m));
}
inline Placement ours(const btTransform& at) {
    const btQuaternion q = at.getRotation();
    return {ours(at.getOrigin()), {q.w(), q.x(), q.y(), q.z()}, 1.0};
}

// Owns the shapes that it made; goes after the world that uses them.
class BulletShapes {
public:
    // One part, and where it stands in the frame of its own coordinates.
    struct Part {
        btCollisionShape* shape = nullptr;
        btTransform at = btTransform::getIdentity();
    };
    Part part(const DynamicsPiece& piece);
    // All parts as one; child i is pieces[i]. A single part at zero without a turn stays what it is unless `compound`
    // is asked for.
    btCollisionShape* together(const std::vector<DynamicsPiece>& pieces, bool compound);
    // Null where there are none. Knows its own inner edges.
    btCollisionShape* sheets(const TriangleMesh& mesh);

    ~BulletShapes();

private:
    template <class Shape>
    Shape* keep(std::unique_ptr<Shape> shape) {
        Shape* const raw = shape.get();
        shapes_.push_back(std::move(shape));
        return raw;
    }

    std::vector<std::unique_ptr<btCollisionShape>> shapes_;  // parts before what is made of them
    std::unique_ptr<btTriangleIndexVertexArray> triangles_;
    std::unique_ptr<btTriangleInfoMap> edges_;
};

}  // namespace handrail
