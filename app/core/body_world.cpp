#include "app/core/body_world.h"

#include <algorithm>
#include <cmath>

namespace handrail {
namespace {

// How far the plane must be pushed out so that the body's reference point meets it just when the body meets the plane.
double support(const Vec3& normal, const BodyShape& body) {
    const double sideways = body.radius_m > 0.0 ? body.radius_m * std::sqrt(normal.x * normal.x + normal.y * normal.y) : 0.0;
    return sideways + std::max(0.0, -normal.z * body.height_m);
}

}  // namespace

BodyWorld::BodyWorld(std::shared_ptr<const Scene> scene, std::span<const Placement> placed) : scene_(std::move(scene)) {
    add_scene(*scene_, nullptr, -1);
    for (std::size_t i = 0; i < scene_->placed.size(); ++i) {
        const PlacedFrame frame(i < placed.size() ? placed[i] : scene_->placed[i].at);
        add_scene(*scene_->placed[i].model, &frame, static_cast<std::int32_t>(i));
    }
    std::stable_sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) {
        return a.bounds_m.min_m.x != b.bounds_m.min_m.x ? a.bounds_m.min_m.x < b.bounds_m.min_m.x : a.bounds_m.min_m.y < b.bounds_m.min_m.y;
    });
    double reach = -std::numeric_limits<double>::infinity();
    for (const Piece& piece : pieces_) max_x_so_far_.push_back(reach = std::max(reach, piece.bounds_m.max_m.x));
}

// The pieces of a scene, or of a model that stands in the frame.
void BodyWorld::add_scene(const Scene& scene, const PlacedFrame* frame, std::int32_t placed) {
    const auto at = [frame](const Vec3& p) { return frame ? frame->to_world(p) : p; };
    std::vector<Bound> bounds;
    const auto add_bevels = [&bounds](const Aabb& box) {
        // Without the six axis planes the sum of a slanted solid and a wide body would stick out far at sharp edges.
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {1.0, -1.0}) {
                Vec3 normal{0.0};
                normal[axis] = sign;
                const bool there = std::any_of(bounds.begin(), bounds.end(), [&](const Bound& b) { return glm::dot(b.plane.normal, normal) > 1.0 - 1e-9; });
                if (!there) bounds.push_back({Plane{normal, sign > 0 ? box.max_m[axis] : -box.min_m[axis]}, -1});
            }
    };
    for (std::uint32_t i = 0; i < scene.solids.size(); ++i) {
        const Solid& solid = scene.solids[i];
        if (solid.role != SolidRole::Solid && solid.role != SolidRole::Mover && solid.role != SolidRole::BodyClip) continue;
        bounds.clear();
        Aabb box = solid.shape.bounds_m;
        if (frame) {
            box = {};
            for (const Polygon& face : solid.shape.faces)
                for (const Vec3& p : face.points_m) box.include(at(p));
        }
        for (std::size_t face = 0; face < solid.shape.planes.size(); ++face) {
            Plane plane = solid.shape.planes[face];
            if (frame) {
                plane.normal = frame->turned(plane.normal);
                plane.offset_m = solid.shape.planes[face].offset_m * frame->scale + glm::dot(plane.normal, frame->position_m);
            }
            bounds.push_back({plane, static_cast<std::int32_t>(face)});
        }
        add_bevels(box);
        add_piece(bounds, {0, 0, box, solid.role == SolidRole::BodyClip, i, false, placed});
    }
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        const MeshTriangle& t = scene.triangles[i];
        const Vec3 corners[3] = {at(t.a_m), at(t.b_m), at(t.c_m)};
        const Vec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = glm::length(area);
        if (!(length > 0.0)) continue;  // no area: nothing to bump into
        const Vec3 n = area / length;
        bounds.clear();
        bounds.push_back({Plane{n, glm::dot(n, corners[0])}, 0});
        bounds.push_back({Plane{-n, -glm::dot(n, corners[0])}, 0});
        Aabb box;
        for (int e = 0; e < 3; ++e) {
            box.include(corners[e]);
            const Vec3 side = glm::cross(corners[(e + 1) % 3] - corners[e], n);
            const double side_length = glm::length(side);
            if (side_length > 0.0) bounds.push_back({Plane{side / side_length, glm::dot(side / side_length, corners[e])}, 0});
        }
        add_bevels(box);
        add_piece(bounds, {0, 0, box, false, i, true, placed});
    }
}

void BodyWorld::add_piece(const std::vector<Bound>& bounds, Piece piece) {
    piece.first_plane = static_cast<std::uint32_t>(bounds_.size());
    piece.plane_count = static_cast<std::uint32_t>(bounds.size());
    pieces_.push_back(piece);
    bounds_.insert(bounds_.end(), bounds.begin(), bounds.end());
}

template <class Visit>
void BodyWorld::visit_near(const Aabb& box, Visit visit) const {
    const auto first = std::lower_bound(max_x_so_far_.begin(), max_x_so_far_.end(), box.min_m.x) - max_x_so_far_.begin();
    for (std::size_t i = static_cast<std::size_t>(first); i < pieces_.size(); ++i) {
        const Piece& piece = pieces_[i];
        if (piece.bounds_m.min_m.x > box.max_m.x) break;
        if (piece.bounds_m.max_m.x < box.min_m.x || piece.bounds_m.max_m.y < box.min_m.y || piece.bounds_m.min_m.y > box.max_m.y ||
            piece.bounds_m.max_m.z < box.min_m.z || piece.bounds_m.min_m.z > box.max_m.z)
            continue;
        visit(piece);
    }
}

TraceHit BodyWorld::trace(const Vec3& from_m, const Vec3& to_m, const BodyShape& body, bool through_clips) const {
    const Vec3 step = to_m - from_m;
    const double length = glm::length(step);
    Aabb sweep;
    sweep.include(from_m);
    sweep.include(to_m);
    const Vec3 around{body.radius_m + kContactGap_m, body.radius_m + kContactGap_m, kContactGap_m};
    sweep.min_m -= around;
    sweep.max_m += around + Vec3(0.0, 0.0, body.height_m);

    TraceHit best;
    const Piece* met = nullptr;
    std::int32_t met_face = -1;
    visit_near(sweep, [&](const Piece& piece) {
        if (through_clips && piece.clip_only) return;
        double enter = -1.0, leave = 1.0;
        Vec3 enter_normal{0.0};
        std::int32_t enter_face = -1;
        bool starts_outside = false;
        for (std::uint32_t k = piece.first_plane; k < piece.first_plane + piece.plane_count; ++k) {
            const Bound& bound = bounds_[k];
            const double grow = support(bound.plane.normal, body);
            const double d0 = signed_distance(bound.plane, from_m) - grow;
            const double d1 = signed_distance(bound.plane, to_m) - grow;
            if (d0 > 0.0) starts_outside = true;
            // Outside and not coming nearer; a tenth of a micrometre is rounding of a slide along the surface.
            if (d0 > 0.0 && d1 > 0.0 && d1 >= d0 - 1e-7) return;
            if (d0 <= 0.0 && d1 <= 0.0) continue;  // inside this plane all the way
            if (d0 > d1) {                         // comes in: stop a little before
                const double t = std::max(0.0, (d0 - kContactGap_m) / (d0 - d1));
                if (d1 > kContactGap_m) return;  // never reaches it
                if (t > enter) {
                    enter = t;
                    enter_normal = bound.plane.normal;
                    enter_face = bound.face;
                }
            } else {
                leave = std::min(leave, d0 / (d0 - d1));
            }
        }
        // Of pieces met at once the later one counts: the eastern, then the northern.
        if (!starts_outside || enter < 0.0 || enter > leave || enter > best.fraction) return;
        best.fraction = enter;
        best.normal = enter_normal;
        best.hit = true;
        met = &piece;
        met_face = enter_face;
    });
    best.end_m = from_m + step * best.fraction;
    if (met) name_hit(*met, met_face, best.normal, best.feature, best.material);
    if (length == 0.0) best.hit = false;
    return best;
}

void BodyWorld::name_hit(const Piece& piece, std::int32_t face, const Vec3& normal, FeatureId& feature, MaterialId& material) const {
    if (piece.placed >= 0) {
        feature = scene_->placed[static_cast<std::size_t>(piece.placed)].feature;
        material = scene_->placed[static_cast<std::size_t>(piece.placed)].material;
        return;
    }
    if (piece.triangle) {
        feature = scene_->triangles[piece.solid].feature;
        material = scene_->triangles[piece.solid].material;
        return;
    }
    const Solid& solid = scene_->solids[piece.solid];
    // A bevel has no face of its own: the visible face that looks most its way names it. So does a hidden face.
    double most = -2.0;
    for (std::size_t i = 0; i < solid.shape.planes.size(); ++i) {
        const bool named = i < solid.face_features.size() && solid.face_features[i];
        double likeness = glm::dot(solid.shape.planes[i].normal, normal);
        if (static_cast<std::int32_t>(i) == face) likeness = 1.0 + 1e-6;
        if (named && likeness > most) {
            most = likeness;
            feature = solid.face_features[i];
            material = solid.face_materials[i];
        }
    }
    if (!feature) feature = solid.feature;
}

std::vector<Crossing> BodyWorld::crossings(const Vec3& from_m, const Vec3& to_m) const {
    const double length = glm::length(to_m - from_m);
    std::vector<Crossing> found;
    if (length == 0.0) return found;
    Aabb sweep;
    sweep.include(from_m);
    sweep.include(to_m);
    visit_near(sweep, [&](const Piece& piece) {
        if (piece.clip_only) return;
        double enter = 0.0, leave = 1.0;
        Vec3 normal{0.0};
        std::int32_t face = -1;
        for (std::uint32_t k = piece.first_plane; k < piece.first_plane + piece.plane_count; ++k) {
            const Bound& bound = bounds_[k];
            const double d0 = signed_distance(bound.plane, from_m), d1 = signed_distance(bound.plane, to_m);
            if (d0 > 0.0 && d1 > 0.0) return;
            if (d0 > 0.0 && d0 / (d0 - d1) >= enter) {
                enter = d0 / (d0 - d1);
                normal = bound.plane.normal;
                face = bound.face;
            } else if (d1 > 0.0) {
                leave = std::min(leave, d0 / (d0 - d1));
            }
        }
        if (enter <= 0.0 || leave >= 1.0 || enter > leave) return;
        Crossing crossing{enter * length, leave * length, kNoFeature, kDefaultMaterial};
        name_hit(piece, face, normal, crossing.feature, crossing.material);
        found.push_back(crossing);
    });
    return found;
}

bool BodyWorld::blocked(const Vec3& feet_m, const BodyShape& body) const {
    Aabb box;
    box.include(feet_m - Vec3(body.radius_m, body.radius_m, 0.0));
    box.include(feet_m + Vec3(body.radius_m, body.radius_m, body.height_m));
    bool inside_any = false;
    visit_near(box, [&](const Piece& piece) {
        for (std::uint32_t k = piece.first_plane; k < piece.first_plane + piece.plane_count; ++k)
            if (signed_distance(bounds_[k].plane, feet_m) - support(bounds_[k].plane.normal, body) > 0.0) return;
        inside_any = true;
    });
    return inside_any;
}

std::vector<FeatureId> BodyWorld::volumes_at(const Vec3& feet_m, double height_m, SolidRole role) const {
    std::vector<FeatureId> found;
    const BodyShape line{0.0, height_m};
    for (const Solid& solid : scene_->solids) {
        if (solid.role != role || !solid.feature) continue;
        const bool inside = std::all_of(solid.shape.planes.begin(), solid.shape.planes.end(),
                                        [&](const Plane& plane) { return signed_distance(plane, feet_m) - support(plane.normal, line) <= 0.0; });
        if (inside && std::find(found.begin(), found.end(), solid.feature) == found.end()) found.push_back(solid.feature);
    }
    return found;
}

}  // namespace handrail
