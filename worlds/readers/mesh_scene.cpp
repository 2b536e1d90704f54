#include "worlds/readers/mesh_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "worlds/base/text.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"
#include "worlds/readers/mesh_materials.h"
#include "worlds/readers/spoken_text.h"
#include "worlds/scene/surfaces.h"

namespace handrail {
namespace {

constexpr std::size_t kMostPlanes = 64;        // of a solid; rounder ones stay sheets
constexpr double kFlat = 1e-5;                 // of the mesh's size: what still lies in one plane
constexpr double kSurfaceUnit_m = 1.0 / 32.0;  // as derive_surfaces has it for maps
constexpr double kLeastSolid_m = 1e-4;
constexpr std::size_t kMostShells = 1000;  // looked at, in the file's order

Aabb bounds_of_part(const MeshPart& part) {
    Aabb box;
    for (const auto& triangle : part.triangles)
        for (const std::uint32_t corner : triangle) box.include(part.points_m[corner]);
    return box;
}

// Each edge is gone along once in each direction.
bool is_closed(const MeshPart& part) {
    std::map<std::array<double, 3>, std::uint32_t> numbers;  // points of one place are one
    std::vector<std::uint32_t> joined;
    for (const Vec3& p : part.points_m)
        joined.push_back(
            numbers.try_emplace({p.x + 0.0, p.y + 0.0, p.z + 0.0}, static_cast<std::uint32_t>(numbers.size()))
                .first->second);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& [a, b, c] : part.triangles)
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
            edges.emplace_back(joined[from], joined[to]);
    std::sort(edges.begin(), edges.end());
    if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
    return std::all_of(edges.begin(), edges.end(), [&](const auto& edge) {
        return edge.first != edge.second &&
               std::binary_search(edges.begin(), edges.end(), std::pair{edge.second, edge.first});
    });
}

double volume_m3(const MeshPart& part) {
    double six = 0.0;
    const Vec3 from = part.points_m[part.triangles.front()[0]];
    for (const auto& [a, b, c] : part.triangles)
        six += glm::dot(part.points_m[a] - from, glm::cross(part.points_m[b] - from, part.points_m[c] - from));
    return six / 6.0;
}

// The solid that a closed mesh is the skin of, where it is convex and seen from outside.
std::optional<ConvexSolid> solid_of(const MeshPart& part, const Aabb& box) {
    const Vec3 size = box.size_m();
    const double flat_m = kFlat * std::max({size.x, size.y, size.z});
    if (std::min({size.x, size.y, size.z}) < kLeastSolid_m || !is_closed(part) || volume_m3(part) <= 0.0)
        return std::nullopt;
    std::vector<Plane> planes;
    for (const auto& [a, b, c] : part.triangles) {
        const Vec3 area = glm::cross(part.points_m[b] - part.points_m[a], part.points_m[c] - part.points_m[a]);
        const double length = glm::length(area);
        if (!(length > 1e-12)) return std::nullopt;
        const Plane plane{area / length, glm::dot(area / length, part.points_m[a])};
        if (std::any_of(planes.begin(), planes.end(), [&](const Plane& known) {
                return glm::dot(known.normal, plane.normal) > 1.0 - 1e-9 &&
                       std::abs(known.offset_m - plane.offset_m) <= flat_m;
            }))
            continue;
        if (planes.size() == kMostPlanes) return std::nullopt;
        planes.push_back(plane);
    }
    for (const Plane& plane : planes)
        for (const Vec3& p : part.points_m)
            if (signed_distance(plane, p) > flat_m) return std::nullopt;
    BuiltSolid built = solid_from_planes(planes, box.centre_m(), 4.0 * glm::length(size) + 1.0);
    if (built.fault != SolidFault::None || built.was_inside_out) return std::nullopt;
    const Vec3 low = glm::abs(built.solid.bounds_m.min_m - box.min_m),
               high = glm::abs(built.solid.bounds_m.max_m - box.max_m);
    if (std::max({low.x, low.y, low.z, high.x, high.y, high.z}) > 100.0 * flat_m) return std::nullopt;
    return std::move(built.solid);
}

class MeshSceneBuilder {
public:
    MeshSceneBuilder(MeshFile file, Diagnostics diagnostics, const std::string& file_name, const ReadOptions& options)
        : file_(std::move(file)), diagnostics_(std::move(diagnostics)), options_(options) {
        scene_.source_file = file_name;
        scene_.name = words_of_name(file_name);
        scene_.materials.emplace_back();
        scene_.report.format = file_.format;
        scene_.metres_per_unit = file_.metres_per_unit;
    }

    Result<Scene> build() {
        drop_what_is_damaged();
        std::vector<Aabb> boxes;
        for (const MeshPart& part : file_.parts) boxes.push_back(bounds_of_part(part));
        const BoxIndex index(boxes);
        std::size_t solids = 0;
        for (std::size_t i = 0; i < file_.parts.size(); ++i) {
            if (options_.stop.stop_requested()) return fail(phrase("files.stopped"), scene_.source_file);
            add_part(file_.parts[i], boxes[i], solid_unless_it_holds(i, boxes, index), solids);
        }
        start_within(boxes);
        if (scene_.solids.empty() && scene_.triangles.empty())
            return nothing_to_touch(diagnostics_, scene_.source_file, "mesh");
        if (!scene_.solids.empty()) derive_surfaces(scene_, looks_, kSurfaceUnit_m, options_.stop);
        if (options_.stop.stop_requested()) return fail(phrase("files.stopped"), scene_.source_file);
        write_report(solids);
        if (options_.progress) options_.progress(1.0);
        return std::move(scene_);
    }

private:
    void drop_what_is_damaged() {
        for (MeshPart& part : file_.parts) {
            const auto bad = [&](std::uint32_t corner) {
                if (corner >= part.points_m.size()) return true;
                const Vec3& p = part.points_m[corner];
                return !is_finite(p) || std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kFarthestM;
            };
            const auto damaged = std::erase_if(part.triangles, [&](const std::array<std::uint32_t, 3>& t) {
                return bad(t[0]) || bad(t[1]) || bad(t[2]);
            });
            file_.faces_left_out += static_cast<int>(damaged);
            for (Vec3& p : part.points_m)
                if (!is_finite(p)) p = Vec3(0.0);  // nobody's corner by now
        }
        std::erase_if(file_.parts, [](const MeshPart& part) { return part.triangles.empty(); });
    }

    std::optional<ConvexSolid> solid_unless_it_holds(std::size_t i, const std::vector<Aabb>& boxes,
                                                     const BoxIndex& index) {
        if (file_.parts.size() < 2) return std::nullopt;
        std::optional<ConvexSolid> solid = solid_of(file_.parts[i], boxes[i]);
        if (!solid) return std::nullopt;
        index.find(boxes[i], near_);
        for (const std::uint32_t other : near_)
            if (other != i && contains(*solid, boxes[other].centre_m(), -kLeastSolid_m)) return std::nullopt;
        return solid;
    }

    void add_part(const MeshPart& part, const Aabb& box, std::optional<ConvexSolid> shape, std::size_t& solids) {
        const FeatureId id = thing_of(part);
        const MaterialId material = material_of(part.material);
        scene_.bounds_m.include(box);
        Feature& feature = scene_.features[id.value];
        feature.bounds_m.include(box);
        scene_.report.polygons += static_cast<int>(part.triangles.size());
        if (shape) {
            ++solids;
            ++scene_.report.brushes;
            Solid solid;
            solid.shape = std::move(*shape);
            solid.feature = id;
            solid.face_materials.assign(solid.shape.planes.size(), material);
            looks_.emplace_back(solid.shape.planes.size(), material);
            scene_.solids.push_back(std::move(solid));
            return;
        }
        double area_m2 = 0.0;
        for (const auto& [a, b, c] : part.triangles) {
            const Vec3 &p = part.points_m[a], &q = part.points_m[b], &r = part.points_m[c];
            scene_.triangles.push_back({p, q, r, id, material, TouchSide::Both});
            area_m2 += 0.5 * glm::length(glm::cross(q - p, r - p));
        }
        feature.area_m2 += area_m2;
        feature.material = material;
    }

    // No format of meshes knows a start: in the shell that holds most others, on its floor, at the free place nearest
    // to its middle.
    void start_within(const std::vector<Aabb>& boxes) {
        constexpr Vec3 kBody_m{0.6, 0.6, 1.9};
        constexpr int kPlaces = 21;  // each way
        std::size_t shell = boxes.size(), most = 0;
        for (std::size_t i = 0; i < std::min(boxes.size(), kMostShells); ++i) {
            const Vec3 size = boxes[i].size_m();
            if (size.x < 2.0 * kBody_m.x || size.y < 2.0 * kBody_m.y || size.z < kBody_m.z) continue;
            const auto held = static_cast<std::size_t>(std::count_if(boxes.begin(), boxes.end(), [&](const Aabb& box) {
                return glm::all(glm::greaterThanEqual(box.min_m, boxes[i].min_m)) &&
                       glm::all(glm::lessThanEqual(box.max_m, boxes[i].max_m));
            }));  // itself too
            if (held > std::max<std::size_t>(most, 1)) shell = i, most = held;
        }
        if (shell == boxes.size()) return;
        const Aabb& room = boxes[shell];
        const Vec3 middle = room.centre_m(), step = (room.size_m() - 2.0 * kBody_m) / double{kPlaces - 1};
        std::optional<Vec3> best;
        for (int x = 0; x < kPlaces; ++x)
            for (int y = 0; y < kPlaces; ++y) {
                const Vec3 feet(room.min_m.x + kBody_m.x + x * step.x, room.min_m.y + kBody_m.y + y * step.y,
                                room.min_m.z);
                const Aabb body{feet - Vec3(0.5 * kBody_m.x, 0.5 * kBody_m.y, 0.0),
                                feet + Vec3(0.5 * kBody_m.x, 0.5 * kBody_m.y, kBody_m.z)};
                bool free = true;
                for (std::size_t i = 0; i < boxes.size() && free; ++i) free = i == shell || !overlap(boxes[i], body);
                if (free && (!best || glm::length(Vec2(feet - middle)) < glm::length(Vec2(*best - middle))))
                    best = feet;
            }
        if (!best) return;
        Start start;
        start.feet_m = *best;
        start.base = true;
        scene_.starts.push_back(std::move(start));
        scene_.report.starts = 1;
        scene_.report.guessed.push_back(
            phrase("mesh.start", {{"room", scene_.features[thing_of(file_.parts[shell]).value].name}}));
    }

    FeatureId thing_of(const MeshPart& part) {
        const auto [found, is_new] =
            things_.try_emplace(part.thing, FeatureId{static_cast<std::uint32_t>(scene_.features.size())});
        if (!is_new) return found->second;
        Feature feature;
        feature.kind = FeatureKind::Object;
        feature.name = part.name.empty() ? scene_.name : words_of_name(part.name);
        if (feature.name.empty()) feature.name = "surface", feature.made_name = true;
        scene_.features.push_back(std::move(feature));
        return found->second;
    }

    MaterialId material_of(const std::string& name) {
        const auto [known, is_new] = materials_.try_emplace(name, kDefaultMaterial);
        if (!is_new || name.empty()) return known->second;
        const std::optional<Material> material = mesh_material(name, options_.guess_materials);
        if (!material) return kDefaultMaterial;
        if (material->guessed)
            scene_.report.guessed.push_back(
                phrase("obj.guessed", {{"material", spoken_material(material->name)}, {"name", excerpt(name)}}));
        return known->second = material_id(scene_, *material);
    }

    void write_report(std::size_t solids) {
        ReadReport& report = scene_.report;
        report.polygons_kept = report.polygons;
        report.triangles = static_cast<int>(scene_.triangles.size());
        if (solids > 0)
            report.guessed.push_back(phrase("mesh.solids", {{"solids", solids}, {"all", file_.parts.size()}}));
        if (file_.faces_left_out > 0)
            report.left_out.push_back(phrase("obj.faces_left_out", {{"n", file_.faces_left_out}}));
        if (file_.parts_left_out > 0)
            report.left_out.push_back(phrase("mesh.parts_left_out", {{"n", file_.parts_left_out}}));
        diagnostics_.move_into(report);
    }

    MeshFile file_;
    Diagnostics diagnostics_;
    const ReadOptions& options_;
    Scene scene_;
    std::vector<std::vector<FaceLook>> looks_;
    std::vector<std::uint32_t> near_;
    std::map<std::uint32_t, FeatureId> things_;
    std::map<std::string, MaterialId> materials_;
};

}  // namespace

Result<Scene> scene_of_meshes(MeshFile file, Diagnostics diagnostics, const std::string& file_name,
                              const ReadOptions& options) {
    return MeshSceneBuilder(std::move(file), std::move(diagnostics), file_name, options).build();
}

}  // namespace handrail
