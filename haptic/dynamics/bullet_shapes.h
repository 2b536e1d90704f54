// Converts the parts of a dynamics scene to Bullet's shapes. Private to haptic/dynamics, because no other folder may
// include Bullet's headers. Source: Bullet 3.24, double precision.
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

// Creates and owns the shapes. It must outlive the world that uses them.
class BulletShapes {
public:
    // The shape of one piece, and the pose of that shape in the frame of the piece's coordinates.
    struct Part {
        btCollisionShape* shape = nullptr;
        btTransform at = btTransform::getIdentity();
    };
    Part part(const render::DynamicsPiece& piece);
    // Combines all parts into one compound shape, whose child i is pieces[i]. A single part at the origin without
    // rotation is returned as a plain shape, unless `compound` is set.
    btCollisionShape* together(const std::vector<render::DynamicsPiece>& pieces, bool compound);
    // Returns the shape of a mesh, or null if the mesh is empty. The shape stores which edges are inner ones, so that
    // bodies do not catch on them.
    btCollisionShape* sheets(const TriangleMesh& mesh);

    ~BulletShapes();

private:
    template <class Shape>
    Shape* keep(std::unique_ptr<Shape> shape) {
        Shape* const raw = shape.get();
        shapes_.push_back(std::move(shape));
        return raw;
    }

    std::vector<std::unique_ptr<btCollisionShape>> shapes_;  // parts come before the compound shapes that use them
    std::unique_ptr<btTriangleIndexVertexArray> triangles_;
    std::unique_ptr<btTriangleInfoMap> edges_;
};

}  // namespace handrail::dynamics
