#include "app/core/world/walker_world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "worlds/base/contract.h"
#include "worlds/scene/outer_ground.h"

namespace handrail::core {
namespace {

// If a body approaches a surface by less than this, the approach is a rounding error of sliding along the surface.
constexpr double kAlong_m = 1e-7;
constexpr double kSameDepth_m = 1e-9;  // faces whose distances differ by less than this are equally near

// Returns how far to move a plane outwards, so that the body's reference point meets it exactly when the body meets the
// original plane.
double support(const Vec3& normal, const WalkerShape& body) {
    const double sideways =
        body.radius_m > 0.0 ? body.radius_m * std::sqrt(normal.x * normal.x + normal.y * normal.y) : 0.0;
    return sideways + std::max(0.0, -normal.z * body.height_m);
}

// Returns the part of the body that can meet this kind of piece.
WalkerShape next_to(bool narrow, const WalkerShape& body) {
    return narrow ? WalkerShape{StairRule::reach_m(body.radius_m), StairRule::height_m(body.height_m)} : body;
}

// Returns true if piece `a` comes before piece `b` in the order of all pieces. The order is by box, and for equal boxes
// by number.
bool comes_before(const Aabb& a, std::uint32_t number_a, const Aabb& b, std::uint32_t number_b) {
    if (a.min_m.x != b.min_m.x) return a.min_m.x < b.min_m.x;
    if (a.min_m.y != b.min_m.y) return a.min_m.y < b.min_m.y;
    return number_a < number_b;
}

const Scene& there(const std::shared_ptr<const Scene>& scene) {
    contract_pre(scene != nullptr);
    return *scene;
}

}  // namespace

bool named_when_seen(const Feature& feature) {
    const bool surface = feature.kind == FeatureKind::Wall || feature.kind == FeatureKind::Floor ||
                         feature.kind == FeatureKind::Ceiling || feature.kind == FeatureKind::Slope;
    return !feature.bounds_m.empty() && feature.kind != FeatureKind::Trigger && !is_outer_ground(feature) &&
           (!surface || feature.landmark || feature.clue);
}

WalkerWorld::WalkerWorld(std::shared_ptr<const Scene> scene, std::span<const Placement> placed)
    : scene_(std::move(scene)), building_(built(there(scene_))) {
    contract_pre(placed.empty() || placed.size() <= scene_->placed.size());
    set_down(placed, nullptr);
}

WalkerWorld::WalkerWorld(const WalkerWorld& before, std::shared_ptr<const Scene> scene,
                         std::span<const Placement> placed)
    : scene_(std::move(scene)), building_(before.building_) {
    contract_pre(scene_ != nullptr);
    contract_pre(scene_->solids.size() == before.scene_->solids.size() &&
                 scene_->triangles.size() == before.scene_->triangles.size());
    set_down(placed, &before);
}

std::shared_ptr<const WalkerWorld::Building> WalkerWorld::built(const Scene& scene) {
    auto made = std::make_shared<Building>();
    made->stairs = StairRule(scene);
    made->pieces.add_scene(scene, nullptr, -1, &made->stairs);
    made->pieces.arrange();
    // A hit on any face of a solid may get this feature's name, so the feature's box includes the whole solid. See
    // name_hit().
    std::vector<Aabb> boxes(scene.features.size());
    const auto include = [&](FeatureId feature, const Aabb& box) {
        if (feature.value < boxes.size()) boxes[feature.value].include(box);
    };
    for (std::uint32_t i = 0; i < scene.solids.size(); ++i) {
        const Solid& solid = scene.solids[i];
        if (solid.feature && solid.role != SolidRole::Solid && solid.role != SolidRole::Mover &&
            solid.role != SolidRole::BodyClip)
            made->volumes.push_back(i);
        include(solid.feature, solid.shape.bounds_m);
        for (const FeatureId feature : solid.face_features) include(feature, solid.shape.bounds_m);
    }
    for (const MeshTriangle& t : scene.triangles)
        for (const Vec3& p : {t.a_m, t.b_m, t.c_m}) include(t.feature, Aabb{p, p});
    std::vector<bool> moves(scene.features.size(), false);
    for (const PlacedModel& thing : scene.placed)
        if (thing.feature.value < moves.size()) moves[thing.feature.value] = true;
    for (std::uint32_t i = 0; i < scene.features.size(); ++i) {
        if (moves[i] || !named_when_seen(scene.features[i])) continue;
        boxes[i].include(scene.features[i].bounds_m);
        made->sights.features.push_back(FeatureId{i});
        made->sights.boxes.push_back(boxes[i]);
    }
    made->sights.tree = BoxIndex(made->sights.boxes);
    return made;
}

WalkerWorld::Thing WalkerWorld::thing_of(const PlacedModel& placed, const Placement& at, std::int32_t number) {
    Thing thing{placed.model, at, {}, {}};
    const PlacedFrame frame(at);
    thing.pieces.add_scene(*placed.model, &frame, number, nullptr);
    for (const Piece& piece : thing.pieces.pieces) thing.box_m.include(piece.bounds_m);
    return thing;
}

void WalkerWorld::set_down(std::span<const Placement> placed, const WalkerWorld* before) {
    things_.reserve(scene_->placed.size());
    for (std::size_t i = 0; i < scene_->placed.size(); ++i) {
        const PlacedModel& thing = scene_->placed[i];
        const Placement& at = i < placed.size() ? placed[i] : thing.at;
        const bool stays = before && i < before->things_.size() && before->things_[i]->model == thing.model &&
                           before->things_[i]->at == at;
        things_.push_back(stays ? before->things_[i]
                                : std::make_shared<const Thing>(thing_of(thing, at, static_cast<std::int32_t>(i))));
        const Pieces& own = things_.back()->pieces;
        const auto first = static_cast<std::uint32_t>(placed_.bounds.size());
        placed_.bounds.insert(placed_.bounds.end(), own.bounds.begin(), own.bounds.end());
        for (Piece piece : own.pieces) {
            piece.first_plane += first;
            placed_.pieces.push_back(piece);
        }
    }
    placed_.arrange();
}

// If a body meets several pieces at once, the last of them is reported. So the result depends on the order of the
// pieces, which must not depend on the tree.
void WalkerWorld::Pieces::arrange() {
    std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
        return a.bounds_m.min_m.x != b.bounds_m.min_m.x ? a.bounds_m.min_m.x < b.bounds_m.min_m.x
                                                        : a.bounds_m.min_m.y < b.bounds_m.min_m.y;
    });
    std::vector<Aabb> boxes;
    boxes.reserve(pieces.size());
    for (const Piece& piece : pieces) boxes.push_back(piece.bounds_m);
    tree = BoxIndex(boxes);
}

// Adds the pieces of a scene, or of a model that is placed in `frame`.
void WalkerWorld::Pieces::add_scene(const Scene& scene, const PlacedFrame* frame, std::int32_t placed,
                                    const StairRule* stairs) {
    const auto at = [frame](const Vec3& p) { return frame ? frame->to_world(p) : p; };
    std::vector<Bound> of_piece;
    const auto add_bevels = [&of_piece](const Aabb& box) {
        // Adds the six axis planes. Without them, a slanted solid that is enlarged by the walker's width would reach
        // far beyond its sharp edges.
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {1.0, -1.0}) {
                Vec3 normal{0.0};
                normal[axis] = sign;
                const bool there = std::any_of(of_piece.begin(), of_piece.end(), [&](const Bound& b) {
                    return glm::dot(b.plane.normal, normal) > 1.0 - 1e-9;
                });
                if (!there) of_piece.push_back({Plane{normal, sign > 0 ? box.max_m[axis] : -box.min_m[axis]}, -1});
            }
    };
    for (std::uint32_t i = 0; i < scene.solids.size(); ++i) {
        const Solid& solid = scene.solids[i];
        if (solid.role != SolidRole::Solid && solid.role != SolidRole::Mover && solid.role != SolidRole::BodyClip)
            continue;
        of_piece.clear();
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
                plane.offset_m =
                    solid.shape.planes[face].offset_m * frame->scale + glm::dot(plane.normal, frame->position_m);
            }
            of_piece.push_back({plane, static_cast<std::int32_t>(face)});
        }
        add_bevels(box);
        add_piece(of_piece, {0, 0, box, solid.role == SolidRole::BodyClip, stairs && stairs->narrow(solid.feature, box),
                             i, false, placed});
    }
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        const MeshTriangle& t = scene.triangles[i];
        const Vec3 corners[3] = {at(t.a_m), at(t.b_m), at(t.c_m)};
        const Vec3 area = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double length = glm::length(area);
        if (!(length > 0.0)) continue;  // A triangle without area has nothing to bump into.
        const Vec3 n = area / length;
        of_piece.clear();
        of_piece.push_back({Plane{n, glm::dot(n, corners[0])}, 0});
        of_piece.push_back({Plane{-n, -glm::dot(n, corners[0])}, 0});
        Aabb box;
        for (int e = 0; e < 3; ++e) {
            box.include(corners[e]);
            const Vec3 side = glm::cross(corners[(e + 1) % 3] - corners[e], n);
            const double side_length = glm::length(side);
            if (side_length > 0.0)
                of_piece.push_back({Plane{side / side_length, glm::dot(side / side_length, corners[e])}, 0});
        }
        add_bevels(box);
        add_piece(of_piece, {0, 0, box, false, stairs && stairs->narrow(t.feature, box), i, true, placed});
    }
}

void WalkerWorld::Pieces::add_piece(const std::vector<Bound>& of_piece, Piece piece) {
    piece.first_plane = static_cast<std::uint32_t>(bounds.size());
    piece.plane_count = static_cast<std::uint32_t>(of_piece.size());
    pieces.push_back(piece);
    bounds.insert(bounds.end(), of_piece.begin(), of_piece.end());
}

const WalkerWorld::Piece& WalkerWorld::piece(std::uint32_t number) const {
    const std::vector<Piece>& standing = building_->pieces.pieces;
    return number < standing.size() ? standing[number] : placed_.pieces[number - standing.size()];
}

bool WalkerWorld::is_stairs(std::uint32_t number) const {
    const std::vector<Piece>& standing = building_->pieces.pieces;
    if (!has_stairs() || number >= standing.size()) return false;
    const Piece& one = standing[number];
    return building_->stairs.is_stairs(one.triangle ? scene_->triangles[one.solid].feature
                                                    : scene_->solids[one.solid].feature);
}

template <class Visit>
void WalkerWorld::visit_near(const Aabb& box, Visit visit) const {
    for (const Pieces* some : {&building_->pieces, &placed_})
        some->tree.meeting(box, [&](std::uint32_t i) { visit(*some, some->pieces[i]); });
}

TraceHit WalkerWorld::trace(const Vec3& from_m, const Vec3& to_m, const WalkerShape& body, bool through_clips,
                            std::int32_t but_placed) const {
    contract_pre(is_finite(from_m) && is_finite(to_m));
    contract_pre(body.radius_m >= 0.0 && body.height_m >= 0.0);
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
    std::uint32_t number = 0;  // number of the first piece in `some`
    // Returns true if a body that overlaps the piece from the start would move farther into it. The face with the
    // shortest way out decides. If several faces are equally near, the one from which the path leads away most decides.
    // Vertical movement is always permitted. Otherwise an overlapping piece would keep the body above the ground.
    const Vec3 level_step(step.x, step.y, 0.0);
    const auto goes_deeper = [&](const Pieces& some, const Piece& piece, const WalkerShape& body_there, Vec3& normal,
                                 std::int32_t& face) {
        const WalkerShape middle{0.0, body_there.height_m};
        bool rim_alone = false;
        double nearest = -std::numeric_limits<double>::infinity(), leaves = 0.0;
        for (std::uint32_t k = piece.first_plane; k < piece.first_plane + piece.plane_count; ++k) {
            const Bound& bound = some.bounds[k];
            const double grow = support(bound.plane.normal, body_there);
            const double d0 = signed_distance(bound.plane, from_m) - grow;
            const double away = glm::dot(bound.plane.normal, level_step);
            rim_alone = rim_alone || d0 + grow - support(bound.plane.normal, middle) > -kContactGap_m;
            if (d0 < nearest - kSameDepth_m || (d0 <= nearest + kSameDepth_m && away <= leaves)) continue;
            nearest = std::max(nearest, d0);
            leaves = away;
            normal = bound.plane.normal;
            face = bound.face;
        }
        if (body_there.radius_m == 0.0 || !rim_alone || leaves >= -kAlong_m) return false;
        normal = glm::normalize(Vec3(normal.x, normal.y, 0.0));
        return true;
    };
    const auto look_at = [&](const Pieces& some, std::uint32_t i, double& reach) {
        const Piece& piece = some.pieces[i];
        if ((through_clips && piece.clip_only) || piece.placed == but_placed || !BoxIndex::meets(piece.bounds_m, sweep))
            return;
        const WalkerShape body_there = next_to(piece.narrow, body);
        double enter = -1.0, leave = 1.0;
        Vec3 enter_normal{0.0};
        std::int32_t enter_face = -1;
        bool starts_outside = false;
        for (std::uint32_t k = piece.first_plane; k < piece.first_plane + piece.plane_count; ++k) {
            const Bound& bound = some.bounds[k];
            const double grow = support(bound.plane.normal, body_there);
            const double d0 = signed_distance(bound.plane, from_m) - grow;
            const double d1 = signed_distance(bound.plane, to_m) - grow;
            if (d0 > 0.0) starts_outside = true;
            // The path is outside this plane and does not approach it.
            if (d0 > 0.0 && d1 > 0.0 && d1 >= d0 - kAlong_m) return;
            if (d0 <= 0.0 && d1 <= 0.0) continue;  // The path is inside this plane at both ends.
            if (d0 > d1) {  // The path enters through this plane. Stop slightly before the plane.
                const double t = std::max(0.0, (d0 - kContactGap_m) / (d0 - d1));
                if (d1 > kContactGap_m) return;  // The path ends before it reaches the plane.
                if (t > enter) {
                    enter = t;
                    enter_normal = bound.plane.normal;
                    enter_face = bound.face;
                }
            } else {
                leave = std::min(leave, d0 / (d0 - d1));
            }
        }
        if (!starts_outside) {
            if (!goes_deeper(some, piece, body_there, enter_normal, enter_face)) return;
            enter = 0.0;
        }
        if (enter < 0.0 || enter > leave || enter > best.fraction) return;
        // If several pieces are met at once, the last one is reported: the eastern, then the northern, then a placed
        // thing.
        if (met && enter == best.fraction && comes_before(piece.bounds_m, number + i, met->bounds_m, best.piece))
            return;
        best.fraction = reach = enter;
        best.normal = enter_normal;
        best.hit = true;
        best.piece = number + i;
        met = &piece;
        met_face = enter_face;
    };
    // This slack is larger than any rounding error of an entry point, so that no piece before the hit is excluded.
    constexpr double kSlack_m = 1e-3;
    const Vec3 low(body.radius_m + kSlack_m, body.radius_m + kSlack_m, body.height_m + kSlack_m);
    const Vec3 high(body.radius_m + kSlack_m, body.radius_m + kSlack_m, kSlack_m);
    for (const Pieces* some : {&building_->pieces, &placed_}) {
        some->tree.along(from_m, to_m, low, high, [&](std::uint32_t i, double& reach) {
            reach = std::min(reach, best.fraction);
            look_at(*some, i, reach);
        });
        number += static_cast<std::uint32_t>(some->pieces.size());
    }
    best.end_m = from_m + step * best.fraction;
    if (met) name_hit(*met, met_face, best.normal, best.feature, best.material);
    if (length == 0.0) best.hit = false;
    return best;
}

void WalkerWorld::name_hit(const Piece& piece, std::int32_t face, const Vec3& normal, FeatureId& feature,
                           MaterialId& material) const {
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
    // A bevel has no face, so the visible face with the most similar direction gives the name. The same applies to a
    // hidden face.
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

std::vector<Crossing> WalkerWorld::crossings(const Vec3& from_m, const Vec3& to_m) const {
    contract_pre(is_finite(from_m) && is_finite(to_m));
    const double length = glm::length(to_m - from_m);
    std::vector<Crossing> found;
    if (length == 0.0) return found;
    Aabb sweep;
    sweep.include(from_m);
    sweep.include(to_m);
    visit_near(sweep, [&](const Pieces& some, const Piece& piece) {
        if (piece.clip_only) return;
        double enter = 0.0, leave = 1.0;
        Vec3 normal{0.0};
        std::int32_t face = -1;
        for (std::uint32_t k = piece.first_plane; k < piece.first_plane + piece.plane_count; ++k) {
            const Bound& bound = some.bounds[k];
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

bool WalkerWorld::blocked(const Vec3& feet_m, const WalkerShape& body) const {
    contract_pre(is_finite(feet_m));
    contract_pre(body.radius_m >= 0.0 && body.height_m >= 0.0);
    Aabb box;
    box.include(feet_m - Vec3(body.radius_m, body.radius_m, 0.0));
    box.include(feet_m + Vec3(body.radius_m, body.radius_m, body.height_m));
    bool inside_any = false;
    visit_near(box, [&](const Pieces& some, const Piece& piece) {
        const WalkerShape body_there = next_to(piece.narrow, body);
        for (std::uint32_t k = piece.first_plane; k < piece.first_plane + piece.plane_count; ++k)
            if (signed_distance(some.bounds[k].plane, feet_m) - support(some.bounds[k].plane.normal, body_there) > 0.0)
                return;
        inside_any = true;
    });
    return inside_any;
}

std::vector<FeatureId> WalkerWorld::volumes_at(const Vec3& feet_m, double height_m, SolidRole role) const {
    contract_pre(is_finite(feet_m) && height_m >= 0.0);
    std::vector<FeatureId> found;
    const WalkerShape line{0.0, height_m};
    for (const std::uint32_t volume : building_->volumes) {
        const Solid& solid = scene_->solids[volume];
        if (solid.role != role) continue;
        const bool inside = std::all_of(solid.shape.planes.begin(), solid.shape.planes.end(), [&](const Plane& plane) {
            return signed_distance(plane, feet_m) - support(plane.normal, line) <= 0.0;
        });
        if (inside && std::find(found.begin(), found.end(), solid.feature) == found.end())
            found.push_back(solid.feature);
    }
    return found;
}

// Suppose a convex piece crosses the lines from the eye to all corners of a box. Then the piece also crosses every line
// into the box, no later than where that line ends. The reason is that a weighted mean of the crossing points on the
// corner lines is on that line. If the piece is apart from the box, such a line meets the piece before anything inside
// the box. The test uses a slightly smaller piece, so that a trace cannot miss the piece by rounding.
bool WalkerWorld::hides(std::uint32_t number, const Vec3& eye_m, const Aabb& box) const {
    constexpr double kDrawnIn_m = 2e-3, kApart_m = 1e-2;
    const Piece& one = piece(number);
    const Aabb around{box.min_m - Vec3(kApart_m), box.max_m + Vec3(kApart_m)};
    if (one.clip_only || BoxIndex::meets(one.bounds_m, around)) return false;
    const std::vector<Bound>& bounds =
        number < building_->pieces.pieces.size() ? building_->pieces.bounds : placed_.bounds;
    // A sheet has no inside, so a line crosses it from one side to the other.
    const std::uint32_t sides = one.triangle ? 2 : 0;
    bool outside = false;
    for (std::uint32_t k = 0; k < one.plane_count; ++k)
        outside = outside || signed_distance(bounds[one.first_plane + k].plane, eye_m) > kDrawnIn_m;
    if (!outside) return false;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 to(corner & 1 ? box.max_m.x : box.min_m.x, corner & 2 ? box.max_m.y : box.min_m.y,
                      corner & 4 ? box.max_m.z : box.min_m.z);
        double in = 0.0, out = 1.0;
        for (std::uint32_t k = 0; k < one.plane_count; ++k) {
            const Plane& plane = bounds[one.first_plane + k].plane;
            double d0 = signed_distance(plane, eye_m), d1 = signed_distance(plane, to);
            if (k < sides) {
                if (std::min(std::abs(d0), std::abs(d1)) < kDrawnIn_m || (d0 > 0.0) == (d1 > 0.0)) return false;
            } else {
                d0 += kDrawnIn_m;
                d1 += kDrawnIn_m;
            }
            if (d0 > 0.0 && d1 > 0.0) return false;
            if (d0 > 0.0) in = std::max(in, d0 / (d0 - d1));
            else if (d1 > 0.0) out = std::min(out, d0 / (d0 - d1));
        }
        if (in > out) return false;
    }
    return true;
}

}  // namespace handrail::core
