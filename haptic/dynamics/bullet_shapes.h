// Bullet's shapes for parts of the dynamics scene. Private to this folder, because Bullet's headers must stay in it.
// Source: Bullet 3.24, double precision.
#pragma once

#include <BulletCollision/CollisionShapes/btTriangleInfoMap.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "haptic/render/dynamics_scene.h"

namespace handrail::dynamics {

inline btVector3 bullet(const Vec3& v) { return {v.x, v.y, v.z}; }
inline Vec3 ours(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
inline btTransform bullet(const Placement& at) {
    return btTransform(btQuaternion(at.rotation.x, at.rotation.y, at.rotation.z, at.rotation.w), bullet(at.position_m));
}
inline Placement ours(const btTransform& at) {
    const btQuaternion q = at.getRotation();
    return {ours(at.getOrigin()), {q.w(), q.x(), q.y(), q.z()}, 1.0};
}

// Owns the shapes that it made; must outlive the world that uses them.
class BulletShapes {
public:
    // One part, and its pose in the frame of its own coordinates.
    struct Part {
        btCollisionShape* shape = nullptr;
        btTransform at = btTransform::getIdentity();
    };
    Part part(const render::DynamicsPiece& piece);
    // Combines all parts into one shape; child i is pieces[i]. A single part at zero without rotation stays as it is,
    // unless `compound` is set.
    btCollisionShape* together(const std::vector<render::DynamicsPiece>& pieces, bool compound);
    // Null if the mesh is empty. The shape knows its inner edges.
    btCollisionShape* sheets(const TriangleMesh& mesh);

    ~BulletShapes();

private:
    template <class Shape>
    Shape* keep(std::unique_ptr<Shape> shape) {
        Shape* const raw = shape.get();
        shapes_.push_back(std::move(shape));
        return raw;
    }

    std::vector<std::unique_ptr<btCollisionShape>> shapes_;  // parts come before the shapes made of them
    std::unique_ptr<btTriangleIndexVertexArray> triangles_;
    std::unique_ptr<btTriangleInfoMap> edges_;
};

}  // namespace handrail::dynamics
