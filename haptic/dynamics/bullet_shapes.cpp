#include "haptic/dynamics/bullet_shapes.h"

#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>

#include <algorithm>

#include "worlds/base/overloaded.h"
#include "worlds/geometry/clip.h"

namespace handrail::dynamics {
namespace {

// Rounding margin of convex shapes. Bullet's default is 40 mm; thin shapes get less than kMargin_m. Corners are moved
// inwards by the margin, so the outer surface stays where it is.
constexpr double kMargin_m = 2e-3;

btTransform upright(const Vec3& middle_m, const Vec3& axis) {
    const Vec3 x = any_perpendicular(axis);
    return bullet(Placement{middle_m, rotation_of({x, glm::cross(axis, x), axis}), 1.0});
}

bool is_box(const ConvexSolid& solid) {
    return solid.planes.size() == 6 && std::all_of(solid.planes.begin(), solid.planes.end(), [](const Plane& plane) {
               const Vec3 n = glm::abs(plane.normal);
               return std::max({n.x, n.y, n.z}) > 1.0 - 1e-12;
           });
}

// Returns the corners of the solid, relative to its middle, after its faces were moved inwards by `by_m`. Returns none
// if nothing is left of the solid or a face vanishes.
std::vector<Vec3> corners_moved_in(const ConvexSolid& solid, double by_m) {
    std::vector<Plane> planes = solid.planes;
    const Vec3 middle = solid.bounds_m.centre_m();
    for (Plane& plane : planes) plane.offset_m -= by_m + glm::dot(plane.normal, middle);
    std::vector<Vec3> corners;
    const BuiltSolid built = solid_from_planes(planes, Vec3(0.0), 4.0 * glm::length(solid.bounds_m.size_m()) + 1.0);
    if (built.fault != SolidFault::None || built.was_inside_out || built.solid.planes.size() != solid.planes.size())
        return corners;
    for (const Polygon& face : built.solid.faces)
        for (const Vec3& p : face.points_m)
            if (std::none_of(corners.begin(), corners.end(), [&](const Vec3& q) { return glm::length(p - q) < 1e-6; }))
                corners.push_back(p);
    return corners;
}

}  // namespace

BulletShapes::~BulletShapes() {
    while (!shapes_.empty()) shapes_.pop_back();
}

BulletShapes::Part BulletShapes::part(const render::DynamicsPiece& piece) {
    return std::visit(
        Overloaded{[&](std::monostate) {
                       const Vec3 middle = piece.bounds_m.centre_m(), half = 0.5 * piece.bounds_m.size_m();
                       const double margin = std::min(kMargin_m, 0.25 * std::min({half.x, half.y, half.z}));
                       btTransform at = btTransform::getIdentity();
                       at.setOrigin(bullet(middle));
                       if (is_box(piece.solid)) {
                           auto* box = keep(std::make_unique<btBoxShape>(bullet(half)));
                           box->setMargin(margin);
                           return Part{box, at};
                       }
                       double used = margin;
                       std::vector<Vec3> corners = corners_moved_in(piece.solid, margin);
                       if (corners.size() < 4) {
                           used = 0.0;
                           for (const Polygon& face : piece.solid.faces)
                               for (const Vec3& p : face.points_m) corners.push_back(p - middle);
                       }
                       auto* hull = keep(std::make_unique<btConvexHullShape>());
                       for (const Vec3& p : corners) hull->addPoint(bullet(p), false);
                       hull->recalcLocalAabb();
                       hull->setMargin(used);
                       return Part{hull, at};
                   },
                   [&](const SphereShape& s) {
                       btTransform at = btTransform::getIdentity();
                       at.setOrigin(bullet(s.centre_m));
                       return Part{keep(std::make_unique<btSphereShape>(s.radius_m)), at};
                   },
                   [&](const CapsuleShape& s) {
                       return Part{keep(std::make_unique<btCapsuleShapeZ>(s.radius_m, s.length_m)),
                                   upright(s.start_m + s.axis * (0.5 * s.length_m), s.axis)};
                   },
                   [&](const CylinderShape& s) {
                       auto* cylinder = keep(
                           std::make_unique<btCylinderShapeZ>(btVector3(s.radius_m, s.radius_m, 0.5 * s.height_m)));
                       cylinder->setMargin(std::min(kMargin_m, 0.25 * std::min(s.radius_m, 0.5 * s.height_m)));
                       return Part{cylinder, upright(s.bottom_m + s.axis * (0.5 * s.height_m), s.axis)};
                   },
                   [&](const ConeShape& s) {
                       auto* cone = keep(std::make_unique<btConeShapeZ>(s.radius_m, s.height_m));
                       cone->setMargin(0.0);
                       return Part{cone, upright(s.base_m + s.axis * (0.5 * s.height_m), s.axis)};
                   }},
        piece.round);
}

btCollisionShape* BulletShapes::together(const std::vector<render::DynamicsPiece>& pieces, bool compound) {
    std::vector<Part> parts;
    for (const render::DynamicsPiece& piece : pieces) parts.push_back(part(piece));
    if (!compound && parts.size() == 1 && parts[0].at.getOrigin().length() < 1e-12 &&
        parts[0].at.getRotation().getAngleShortestPath() < 1e-12)
        return parts[0].shape;
    auto* all = keep(std::make_unique<btCompoundShape>(true, static_cast<int>(parts.size())));
    for (const Part& p : parts) all->addChildShape(p.at, p.shape);
    return all;
}

btCollisionShape* BulletShapes::sheets(const TriangleMesh& mesh) {
    if (mesh.triangles.empty()) return nullptr;
    btIndexedMesh part;
    part.m_numTriangles = static_cast<int>(mesh.triangles.size());
    part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(mesh.triangles.data());
    part.m_triangleIndexStride = sizeof(Corners);
    part.m_numVertices = static_cast<int>(mesh.points_m.size());
    part.m_vertexBase = reinterpret_cast<const unsigned char*>(mesh.points_m.data());
    part.m_vertexStride = sizeof(Vec3);
    part.m_indexType = PHY_INTEGER;
    part.m_vertexType = PHY_DOUBLE;
    triangles_ = std::make_unique<btTriangleIndexVertexArray>();
    triangles_->addIndexedMesh(part);
    auto* shape = keep(std::make_unique<btBvhTriangleMeshShape>(triangles_.get(), true));
    shape->setMargin(kMargin_m);
    edges_ = std::make_unique<btTriangleInfoMap>();
    btGenerateInternalEdgeInfo(shape, edges_.get());
    return shape;
}

}  // namespace handrail::dynamics
