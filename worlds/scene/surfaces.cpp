#include "worlds/scene/surfaces.h"

#include <algorithm>
#include <map>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/geometry/exposed_surface.h"

namespace handrail {
namespace {

std::string_view compass_point(const Vec3& direction) noexcept {
    return handrail::compass_point(std::atan2(direction.x, direction.y));
}

bool is_touchable(SolidRole role) { return role == SolidRole::Solid || role == SolidRole::Mover; }

// The kind and name of a face depend on its direction. A face within 10 degrees of level is level; a face steeper than
// 80 degrees is a wall.
constexpr double kLevel = 0.985;
constexpr double kSteep = 0.174;

FeatureKind kind_of_face(const Vec3& normal) {
    if (normal.z >= kLevel) return FeatureKind::Floor;
    if (normal.z <= -kLevel) return FeatureKind::Ceiling;
    return std::abs(normal.z) <= kSteep ? FeatureKind::Wall : FeatureKind::Slope;
}

// Sizes in metres that determine the name of a flat surface or a small thing.
constexpr double kNarrow = 0.4;     // a level strip narrower than this is a ledge, not a floor
constexpr double kSmallArea = 0.3;  // in square metres; a level surface smaller than this is a ledge, not a floor
constexpr double kStepDepth[] = {0.15, 1.1};
constexpr double kStepHeight[] = {0.08, 0.6};
constexpr double kThingWidth = 2.5;  // a free-standing solid wider than this is part of the building and not a thing

std::string name_of_surface(FeatureKind kind, const Vec3& normal, const Aabb& bounds_m, double area_m2) {
    const Vec3 size = bounds_m.size_m();
    const bool small = std::min(size.x, size.y) < kNarrow || area_m2 < kSmallArea;
    switch (kind) {
        case FeatureKind::Floor:
            return small ? "ledge" : "floor";
        case FeatureKind::Ceiling:
            return small ? "underside" : "ceiling";
        case FeatureKind::Wall:
            // A wall is named after the side of the room on which it is. Its normal points into the room, so the wall
            // is on the opposite side.
            return std::string(compass_point(-normal)) + " wall";
        default:
            return normal.z > 0.0 ? "slope rising " + std::string(compass_point(-normal)) : "sloping ceiling";
    }
}

// A joined flat surface of the building, before it has a name.
struct Surface {
    Vec3 normal{0.0};
    FeatureKind kind = FeatureKind::Wall;
    Aabb bounds_m;
    double area_m2 = 0.0;
    double largest_piece_m2 = -1.0;
    MaterialId material = kDefaultMaterial;
    bool sky = false;
    bool outside = true;  // true if every piece of the surface faces away from the building
    std::vector<std::uint32_t> pieces;
    FeatureId feature = kNoFeature;
};

class SurfaceBuilder {
public:
    SurfaceBuilder(Scene& scene, std::span<const std::vector<FaceLook>> looks, double metres_per_unit,
                   const std::stop_token& stop)
        : scene_(scene),
          looks_(looks),
          unit_m_(metres_per_unit),
          stop_(stop),
          index_(boxes_of(scene)),
          sheets_(sheet_boxes_of(scene)) {}

    void build() {
        for (const auto step :
             {&SurfaceBuilder::expose, &SurfaceBuilder::look_outside, &SurfaceBuilder::find_things,
              &SurfaceBuilder::join, &SurfaceBuilder::fold_outer_sides, &SurfaceBuilder::join_steps,
              &SurfaceBuilder::name_surfaces, &SurfaceBuilder::name_hidden_faces, &SurfaceBuilder::finish}) {
            if (stop_.stop_requested()) return;
            (this->*step)();
        }
    }

private:
    static std::vector<Aabb> boxes_of(const Scene& scene) {
        std::vector<Aabb> boxes;
        boxes.reserve(scene.solids.size());
        for (const Solid& solid : scene.solids) boxes.push_back(solid.shape.bounds_m);
        return boxes;
    }
    static std::vector<Aabb> sheet_boxes_of(const Scene& scene) {
        std::vector<Aabb> boxes;
        boxes.reserve(scene.triangles.size());
        for (const MeshTriangle& sheet : scene.triangles) {
            Aabb& box = boxes.emplace_back();
            for (const Vec3& corner : {sheet.a_m, sheet.b_m, sheet.c_m}) box.include(corner);
        }
        return boxes;
    }

    FeatureId add_feature(Feature feature) {
        scene_.features.push_back(std::move(feature));
        return {static_cast<std::uint32_t>(scene_.features.size() - 1)};
    }
    bool is_building(std::uint32_t solid) const {
        return scene_.solids[solid].role == SolidRole::Solid && !scene_.solids[solid].feature;
    }
    const Plane& plane_of(const ExposedPiece& piece) const {
        return scene_.solids[piece.solid].shape.planes[piece.face];
    }

    // 1. Finds the parts of each face that nothing covers. A moving thing covers only its own faces, because the
    //   surfaces behind it may become visible.
    void expose() {
        std::vector<SurfaceSolid> solids;
        for (const Solid& solid : scene_.solids) {
            SurfaceSolid& input = solids.emplace_back();
            input.shape = &solid.shape;
            input.group = solid.role == SolidRole::Mover ? solid.feature.value : kNoFeature.value;
            input.covers = is_touchable(solid.role);
            input.rank = solid.feature ? 1 : 0;
        }
        pieces_ = exposed_surface(solids, index_, {1e-4 * unit_m_, 1e-3 * unit_m_}, stop_);
        for (const ExposedPiece& piece : pieces_) areas_m2_.push_back(area_m2(piece.polygon));
        first_piece_.assign(scene_.solids.size() + 1, 0);
        for (const ExposedPiece& piece : pieces_) ++first_piece_[piece.solid + 1];
        for (std::size_t s = 0; s < scene_.solids.size(); ++s) first_piece_[s + 1] += first_piece_[s];
        for (std::uint32_t s = 0; s < scene_.solids.size(); ++s) {
            Solid& solid = scene_.solids[s];
            solid.face_features.assign(solid.shape.planes.size(), solid.feature);
            solid.face_hidden.assign(solid.shape.planes.size(), true);
            for (const ExposedPiece& piece : pieces_of(s)) solid.face_hidden[piece.face] = false;
        }
        for (const Solid& solid : scene_.solids) all_m_.include(solid.shape.bounds_m);
        for (const MeshTriangle& sheet : scene_.triangles)
            for (const Vec3& corner : {sheet.a_m, sheet.b_m, sheet.c_m}) all_m_.include(corner);
    }

    std::span<const ExposedPiece> pieces_of(std::uint32_t solid) const {
        return std::span(pieces_).subspan(first_piece_[solid], first_piece_[solid + 1] - first_piece_[solid]);
    }

    // True if the line from from_m to to_m passes through the triangle or its border. A sheet without area stops
    // nothing. Source: Moeller, Trumbore, Fast, minimum storage ray-triangle intersection, 1997.
    static bool crosses(const MeshTriangle& sheet, const Vec3& from_m, const Vec3& to_m) {
        const Vec3 way = to_m - from_m, ab = sheet.b_m - sheet.a_m, ac = sheet.c_m - sheet.a_m;
        const Vec3 across = glm::cross(way, ac), off = from_m - sheet.a_m, turned = glm::cross(off, ab);
        const double det = glm::dot(ab, across);
        if (det == 0.0) return false;
        const double u = glm::dot(off, across) / det, v = glm::dot(way, turned) / det, at = glm::dot(ac, turned) / det;
        return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && at >= 0.0 && at <= 1.0;
    }

    // True if a straight line from `from_m` in that direction leaves the world without hitting a solid or a sheet of
    // the building.
    bool escapes(const Vec3& from_m, const Vec3& direction) {
        const Vec3 to_m = from_m + direction * (2.0 * glm::length(all_m_.size_m()) + 1.0);
        Aabb box;
        box.include(from_m);
        box.include(to_m);
        sheets_.find(box, near_);
        if (std::any_of(near_.begin(), near_.end(),
                        [&](std::uint32_t t) { return crosses(scene_.triangles[t], from_m, to_m); }))
            return false;
        index_.find(box, near_);
        return std::none_of(near_.begin(), near_.end(), [&](std::uint32_t s) {
            if (!is_touchable(scene_.solids[s].role)) return false;
            double enter = 0.0, leave = 1.0;  // the range of the line that is inside the solid
            for (const Plane& plane : scene_.solids[s].shape.planes) {
                const double a = signed_distance(plane, from_m), b = signed_distance(plane, to_m);
                if (a > 0.0 && b > 0.0) return false;
                if (a > 0.0) enter = std::max(enter, a / (a - b));
                else if (b > 0.0) leave = std::min(leave, a / (a - b));
            }
            return enter <= leave;
        });
    }

    // 2. Finds the pieces that face away from the building: a straight line outwards from them hits nothing. If the
    //   start of the world is under a roof, a piece also faces away if a line straight up from it hits nothing.
    void look_outside() {
        bool roofed = false;
        for (const Start& start : scene_.starts) {
            if (!start.base) continue;
            const Vec3 eye_m = start.feet_m + Vec3{0.0, 0.0, 40.0 * unit_m_};
            roofed = !escapes(eye_m, {0, 0, 1});
            for (const Vec3& side : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}})
                roofed = roofed && !escapes(eye_m, side);
        }
        outside_.assign(pieces_.size(), false);
        for (std::size_t i = 0; i < pieces_.size() && !stop_.stop_requested(); ++i) {
            if (!is_building(pieces_[i].solid)) continue;  // only pieces of the building need this test
            const Vec3& normal = plane_of(pieces_[i]).normal;
            const Vec3 middle_m = centre_of(pieces_[i].polygon);
            const auto looks_out = [&](const Vec3& p) {
                const Vec3 before_m = p + normal * (0.1 * unit_m_);
                return escapes(before_m, normal) || (roofed && normal.z > -kSteep && escapes(before_m, {0, 0, 1}));
            };
            outside_[i] = looks_out(middle_m);
            for (const Vec3& corner : pieces_[i].polygon.points_m)
                outside_[i] = outside_[i] && looks_out(middle_m + 0.8 * (corner - middle_m));
        }
    }

    // 3. Makes things of small free-standing solids, alone or in clusters: pillars, blocks.
    void find_things() {
        const auto small = [&](std::uint32_t s) {
            const Vec3 size = scene_.solids[s].shape.bounds_m.size_m();
            return is_building(s) && std::max(size.x, size.y) <= kThingWidth;
        };
        DisjointSets clusters(scene_.solids.size());
        std::vector<std::uint32_t> near;
        for (std::uint32_t s = 0; s < scene_.solids.size() && !stop_.stop_requested(); ++s) {
            if (!small(s)) continue;
            index_.find(grown(scene_.solids[s].shape.bounds_m, 0.01 * unit_m_), near);
            for (const std::uint32_t other : near)
                if (other > s && small(other)) clusters.join(s, other);
        }
        std::map<std::uint32_t, std::vector<std::uint32_t>> members;
        for (std::uint32_t s = 0; s < scene_.solids.size(); ++s)
            if (small(s)) members[clusters.find(s)].push_back(s);
        for (const auto& [root, solids] : members) name_thing(solids);
    }

    void name_thing(const std::vector<std::uint32_t>& solids) {
        Aabb box, sides_m;
        for (const std::uint32_t s : solids) box.include(scene_.solids[s].shape.bounds_m);
        const Vec3 size = box.size_m();
        if (std::max(size.x, size.y) > kThingWidth) return;
        std::array<double, 4> seen_m2{};  // areas of the surface visible from the east, west, north and south
        bool top = false, bottom = false, sky = false;
        for (const std::uint32_t s : solids) {
            for (std::uint32_t i = first_piece_[s]; i < first_piece_[s + 1]; ++i) {
                const Vec3& n = plane_of(pieces_[i]).normal;
                top = top || n.z > kLevel;
                bottom = bottom || n.z < -kLevel;
                sky = sky || look_of(pieces_[i]) == kSkyLook;
                if (std::abs(n.z) >= kLevel || glm::dot(n, centre_of(pieces_[i].polygon) - box.centre_m()) <= 0.0)
                    continue;
                sides_m.include(bounds_of(pieces_[i].polygon));
                const std::array<double, 4> facing{n.x, -n.x, n.y, -n.y};
                for (std::size_t k = 0; k < 4; ++k) seen_m2[k] += std::max(0.0, facing[k]) * areas_m2_[i];
            }
        }
        if (sides_m.empty() || sky) return;
        const double height_m = sides_m.size_m().z;
        const int shown = static_cast<int>(seen_m2[0] > 0.6 * size.y * height_m) +
                          static_cast<int>(seen_m2[1] > 0.6 * size.y * height_m) +
                          static_cast<int>(seen_m2[2] > 0.6 * size.x * height_m) +
                          static_cast<int>(seen_m2[3] > 0.6 * size.x * height_m);
        if (shown < 3 || continues_a_wall(solids)) return;
        Feature thing;
        thing.kind = FeatureKind::Object;
        Aabb felt = box;
        felt.min_m.z = sides_m.min_m.z;
        felt.max_m.z = sides_m.max_m.z;
        thing.name = (bottom && !top ? "hanging " : "") + shape_name(felt);
        thing.made_name = true;
        thing.source = scene_.solids[solids.front()].source;
        const FeatureId id = add_feature(thing);
        for (const std::uint32_t s : solids) {
            scene_.solids[s].feature = id;
            scene_.solids[s].face_features.assign(scene_.solids[s].shape.planes.size(), id);
        }
    }

    // A short piece of wall next to a doorway or above it shows three sides, like a thing. It belongs to the wall that
    // it touches if one of its upright faces continues in a face of that wall with the same material.
    bool continues_a_wall(const std::vector<std::uint32_t>& solids) {
        for (const std::uint32_t s : solids) {
            index_.find(grown(scene_.solids[s].shape.bounds_m, 0.01 * unit_m_), near_);
            for (const std::uint32_t other : near_)
                if (is_building(other) && std::find(solids.begin(), solids.end(), other) == solids.end() &&
                    share_an_upright_plane(scene_.solids[s], scene_.solids[other]))
                    return true;
        }
        return false;
    }

    bool share_an_upright_plane(const Solid& a, const Solid& b) const {
        for (std::size_t i = 0; i < a.shape.planes.size(); ++i)
            for (std::size_t k = 0; k < b.shape.planes.size(); ++k) {
                const Plane &one = a.shape.planes[i], &other = b.shape.planes[k];
                if (std::abs(one.normal.z) <= kSteep && glm::dot(one.normal, other.normal) > 1.0 - 1e-6 &&
                    a.face_materials[i] == b.face_materials[k] &&
                    std::abs(one.offset_m - other.offset_m) < 4e-3 * unit_m_)
                    return true;
            }
        return false;
    }

    FaceLook look_of(const ExposedPiece& piece) const { return looks_[piece.solid][piece.face]; }

    // 4. Joins coplanar neighbours of the building into one surface.
    void join() {
        std::vector<FlatPiece> flat;
        std::vector<std::uint32_t> which;
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            if (!is_building(pieces_[i].solid)) continue;
            const std::uint64_t face = (std::uint64_t{pieces_[i].solid} << 32) | pieces_[i].face;
            flat.push_back({&pieces_[i].polygon, plane_of(pieces_[i]), look_of(pieces_[i]), face});
            which.push_back(i);
        }
        const std::vector<std::uint32_t> number = joined_surfaces(flat, 4e-3 * unit_m_, stop_);
        surface_of_piece_.assign(pieces_.size(), kNone);
        for (std::size_t k = 0; k < number.size(); ++k) {
            const std::uint32_t i = which[k];
            if (number[k] >= surfaces_.size()) surfaces_.resize(number[k] + 1);
            Surface& surface = surfaces_[number[k]];
            surface_of_piece_[i] = number[k];
            add_piece(surface, i);
            surface.normal = plane_of(pieces_[surface.pieces.front()]).normal;
            surface.kind = kind_of_face(surface.normal);
            surface.sky = look_of(pieces_[i]) == kSkyLook;
        }
    }

    void add_piece(Surface& surface, std::uint32_t i) {
        surface.pieces.push_back(i);
        surface.bounds_m.include(bounds_of(pieces_[i].polygon));
        surface.area_m2 += areas_m2_[i];
        surface.outside = surface.outside && outside_[i];
        if (areas_m2_[i] <= surface.largest_piece_m2) return;
        surface.largest_piece_m2 = areas_m2_[i];
        surface.material = scene_.solids[pieces_[i].solid].face_materials[pieces_[i].face];
    }

    // 5. Gives the outer side of a wall the name of the wall: the outer pieces of a solid join the largest inner
    //   surface of the same solid.
    void fold_outer_sides() {
        std::vector<Surface> rest(surfaces_.size());
        for (std::uint32_t g = 0; g < surfaces_.size(); ++g) {
            Surface& surface = surfaces_[g];
            if (!surface.outside) continue;
            std::vector<std::uint32_t> kept;
            for (const std::uint32_t i : surface.pieces) {
                std::uint32_t inner = kNone;
                const std::uint32_t s = pieces_[i].solid;
                for (std::uint32_t k = first_piece_[s]; k < first_piece_[s + 1]; ++k) {
                    const std::uint32_t candidate = surface_of_piece_[k];
                    if (candidate == kNone || surfaces_[candidate].outside) continue;
                    if (inner == kNone || surfaces_[candidate].area_m2 > surfaces_[inner].area_m2) inner = candidate;
                }
                if (inner == kNone) kept.push_back(i);
                else folded_into_[i] = inner;
            }
            if (kept.size() == surface.pieces.size()) continue;
            Surface smaller;
            smaller.normal = surface.normal;
            smaller.kind = surface.kind;
            smaller.sky = surface.sky;
            for (const std::uint32_t i : kept) add_piece(smaller, i);
            rest[g] = std::move(smaller);
            // Marks the surface. Its extent is replaced later, when the old extent is no longer needed.
            surface.largest_piece_m2 = -2.0;
        }
        for (std::uint32_t g = 0; g < surfaces_.size(); ++g)
            if (surfaces_[g].largest_piece_m2 == -2.0) surfaces_[g] = std::move(rest[g]);
        for (const auto& [piece, surface] : folded_into_) surface_of_piece_[piece] = surface;
    }

    static bool within(double value, const double (&range)[2]) { return value >= range[0] && value <= range[1]; }

    // 6. Joins a narrow tread and the low riser under its edge into one step.
    void join_steps() {
        step_.assign(surfaces_.size(), false);
        DisjointSets sets(surfaces_.size());
        for (std::uint32_t s = 0; s < scene_.solids.size(); ++s) {
            for (std::uint32_t t = first_piece_[s]; t < first_piece_[s + 1]; ++t) {
                const std::uint32_t tread = surface_of_piece_[t];
                if (tread == kNone || surfaces_[tread].kind != FeatureKind::Floor || folded_into_.contains(t)) continue;
                const Aabb& top = surfaces_[tread].bounds_m;
                if (!within(std::min(top.size_m().x, top.size_m().y), kStepDepth)) continue;
                for (std::uint32_t r = first_piece_[s]; r < first_piece_[s + 1]; ++r) {
                    const std::uint32_t riser = surface_of_piece_[r];
                    if (riser == kNone || surfaces_[riser].kind != FeatureKind::Wall || folded_into_.contains(r))
                        continue;
                    const Aabb& front = surfaces_[riser].bounds_m;
                    if (!within(front.size_m().z, kStepHeight) || std::abs(front.max_m.z - top.max_m.z) > 0.1 * unit_m_)
                        continue;
                    sets.join(tread, riser);
                    step_[tread] = step_[riser] = true;
                }
            }
        }
        for (std::uint32_t g = 0; g < surfaces_.size(); ++g) {
            const std::uint32_t root = sets.find(g);
            if (root == g) continue;
            for (const std::uint32_t i : surfaces_[g].pieces) {
                add_piece(surfaces_[root], i);
                surface_of_piece_[i] = root;
            }
            for (auto& [piece, surface] : folded_into_)
                if (surface == g) surface = surface_of_piece_[piece] = root;
            surfaces_[g].pieces.clear();
        }
    }

    // 7. Makes a feature with a name of every surface.
    void name_surfaces() {
        for (std::uint32_t g = 0; g < surfaces_.size(); ++g) {
            Surface& surface = surfaces_[g];
            if (surface.pieces.empty()) continue;
            Feature feature;
            feature.kind = step_[g] ? FeatureKind::Object : surface.kind;
            feature.name = step_[g] ? "step"
                           : surface.sky
                               ? "sky"
                               : name_of_surface(surface.kind, surface.normal, surface.bounds_m, surface.area_m2);
            feature.made_name = true;
            if (!step_[g]) feature.normal = surface.normal;
            feature.material = surface.sky ? kDefaultMaterial : surface.material;
            feature.bounds_m = surface.bounds_m;
            feature.area_m2 = surface.area_m2;
            feature.source = scene_.solids[pieces_[surface.pieces.front()].solid].source;
            surface.feature = add_feature(std::move(feature));
        }
        for (std::uint32_t i = 0; i < pieces_.size(); ++i)
            if (surface_of_piece_[i] != kNone)
                scene_.solids[pieces_[i].solid].face_features[pieces_[i].face] =
                    surfaces_[surface_of_piece_[i]].feature;
    }

    // 8. Names hidden faces, because a hand that slides over a seam may touch the edge of such a face. The face gets
    //   the name of the surface that covers it, or else of the solid's largest surface.
    void name_hidden_faces() {
        std::vector<Aabb> boxes;
        for (const ExposedPiece& piece : pieces_) boxes.push_back(bounds_of(piece.polygon));
        const BoxIndex piece_index(boxes);
        const double near_m = 4e-3 * unit_m_;
        for (std::uint32_t s = 0; s < scene_.solids.size() && !stop_.stop_requested(); ++s) {
            if (!is_building(s)) continue;
            Solid& solid = scene_.solids[s];
            FeatureId largest = kNoFeature;
            for (const FeatureId id : solid.face_features)
                if (id && (!largest || scene_.features[id.value].area_m2 > scene_.features[largest.value].area_m2))
                    largest = id;
            for (std::uint32_t f = 0; f < solid.shape.planes.size(); ++f) {
                if (solid.face_features[f]) continue;
                solid.face_features[f] = largest;
                const Plane& plane = solid.shape.planes[f];
                piece_index.find(grown(bounds_of(solid.shape.faces[f]), near_m), near_);
                FeatureId meets = kNoFeature;
                for (const std::uint32_t i : near_) {
                    const FeatureId there = scene_.solids[pieces_[i].solid].face_features[pieces_[i].face];
                    if (!there || !is_touchable(scene_.solids[pieces_[i].solid].role)) continue;
                    if (!meets) meets = there;
                    if (glm::dot(plane.normal, plane_of(pieces_[i]).normal) < 1.0 - 1e-8) continue;
                    if (std::abs(signed_distance(plane, pieces_[i].polygon.points_m.front())) > near_m) continue;
                    solid.face_features[f] = there;
                    break;
                }
                if (!solid.face_features[f]) solid.face_features[f] = meets;
            }
        }
    }

    // 9. Fills the list of drawn surfaces, and the area, bounds and material of things.
    void finish() {
        std::map<std::uint32_t, double> largest_m2;
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            ExposedPiece& piece = pieces_[i];
            const Solid& solid = scene_.solids[piece.solid];
            if (solid.role == SolidRole::Trigger || solid.role == SolidRole::BodyClip) continue;
            const MaterialId material = solid.face_materials[piece.face];
            if (solid.feature) {
                Feature& thing = scene_.features[solid.feature.value];
                thing.area_m2 += areas_m2_[i];
                double& most = largest_m2[solid.feature.value];
                if (areas_m2_[i] > most) {
                    most = areas_m2_[i];
                    thing.material = material;
                }
            }
            scene_.surfaces.push_back({std::move(piece.polygon), plane_of(piece).normal,
                                       solid.face_features[piece.face], material, solid.role});
        }
        for (const Solid& solid : scene_.solids) {
            if (solid.feature) scene_.features[solid.feature.value].bounds_m.include(solid.shape.bounds_m);
            // The flat faces around a round solid are not in the file, so they are not counted.
            if (is_touchable(solid.role) && std::holds_alternative<std::monostate>(solid.round))
                scene_.report.polygons_hidden +=
                    static_cast<int>(std::count(solid.face_hidden.begin(), solid.face_hidden.end(), true));
        }
        scene_.report.polygons_kept = scene_.report.polygons - scene_.report.polygons_hidden;
        for (Feature& feature : scene_.features)
            if (feature.name.empty()) {
                feature.name = shape_name(feature.bounds_m);
                feature.made_name = true;
            }
    }

    static constexpr std::uint32_t kNone = 0xffffffffU;

    Scene& scene_;
    std::span<const std::vector<FaceLook>> looks_;
    double unit_m_ = 1.0;
    std::stop_token stop_;
    BoxIndex index_;   // index over the boxes of the solids
    BoxIndex sheets_;  // index over the boxes of the triangles
    Aabb all_m_;
    std::vector<ExposedPiece> pieces_;
    std::vector<double> areas_m2_;                 // area of each piece
    std::vector<std::uint32_t> first_piece_;       // index of each solid's first piece, with one more entry at the end
    std::vector<bool> outside_;                    // for each piece: whether it faces away from the building
    std::vector<std::uint32_t> surface_of_piece_;  // indexed by piece; kNone for things and volumes
    std::map<std::uint32_t, std::uint32_t> folded_into_;  // outer pieces, each with the inner surface that it joined
    std::vector<Surface> surfaces_;
    std::vector<bool> step_;           // for each surface: whether it is part of a step
    std::vector<std::uint32_t> near_;  // results of queries, kept to reuse their memory
};

}  // namespace

std::string_view compass_point(double heading_rad) noexcept {
    constexpr std::array<std::string_view, 8> kWords{"north", "north-east", "east", "south-east",
                                                     "south", "south-west", "west", "north-west"};
    return kWords[nearest_eighth(heading_rad)];
}

std::string compass_word(double heading_rad) {
    contract_pre(std::isfinite(heading_rad));
    constexpr std::array kWords{"compass.north", "compass.north_east", "compass.east", "compass.south_east",
                                "compass.south", "compass.south_west", "compass.west", "compass.north_west"};
    return phrase(kWords[nearest_eighth(heading_rad)]);
}

std::string compass_word(const Vec3& direction) { return compass_word(std::atan2(direction.x, direction.y)); }

std::string shape_name(const Aabb& bounds_m) {
    const Vec3 size = bounds_m.size_m();
    const double wide_m = std::max(size.x, size.y), deep_m = std::min(size.x, size.y);
    if (size.z >= 1.2 && wide_m <= 0.5 * size.z) return "pillar";
    if (size.z >= 1.0 && deep_m <= 0.4) return "partition";
    if (size.z <= 0.1) return "plate";
    if (size.z <= 0.6) return "low block";
    return size.z <= 1.2 ? "block" : "large block";
}

void derive_surfaces(Scene& scene, std::span<const std::vector<FaceLook>> looks, double metres_per_unit,
                     const std::stop_token& stop) {
    contract_pre(looks.size() == scene.solids.size());
    contract_pre(metres_per_unit > 0.0);
    SurfaceBuilder(scene, looks, metres_per_unit, stop).build();
}

}  // namespace handrail
