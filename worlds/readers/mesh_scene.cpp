#include "worlds/readers/mesh_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>

#include "worlds/base/text.h"
#include "worlds/geometry/clip.h"
#include "worlds/readers/mesh_bodies.h"
#include "worlds/readers/mesh_materials.h"
#include "worlds/readers/mesh_start.h"
#include "worlds/readers/spoken_text.h"
#include "worlds/scene/surfaces.h"

namespace handrail::readers {
namespace {

constexpr double kSurfaceUnit_m = 1.0 / 32.0;  // unit for the tolerances of derive_surfaces, the same as for maps
constexpr std::size_t kMostShells = 1000;      // greatest number of shells that are examined, in the file's order

// A body, or the triangles of a mesh that belong to no body.
struct Piece {
    Aabb box;
    std::size_t part = 0;
    std::size_t first_solid = 0, solids = 0;  // the position and number of this piece's solids in the scene's list
};

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
        std::vector<MeshPiece> meshes;
        for (const MeshPart& part : file_.parts) meshes.push_back({part.points_m, part.triangles});
        MeshBodies sorted = mesh_bodies(meshes, options_.stop);
        for (std::size_t i = 0, b = 0; i < file_.parts.size(); ++i) {
            if (options_.stop.stop_requested()) return fail(phrase("files.stopped"), scene_.source_file);
            for (; b < sorted.bodies.size() && sorted.bodies[b].piece == i; ++b) add_body(sorted.bodies[b]);
            if (sorted.rest[i].empty()) continue;
            pieces_.push_back({{}, i, 0, 0});
            add_sheets(i, sorted.rest[i], TouchSide::Both);
        }
        start_within();
        if (scene_.starts.empty()) start_upon();
        if (scene_.starts.empty()) start_on_floor(scene_, options_.stop);
        if (scene_.solids.empty() && scene_.triangles.empty())
            return nothing_to_touch(diagnostics_, scene_.source_file, "mesh");
        if (!scene_.solids.empty()) derive_surfaces(scene_, looks_, kSurfaceUnit_m, options_.stop);
        if (options_.stop.stop_requested()) return fail(phrase("files.stopped"), scene_.source_file);
        write_report();
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
                if (!is_finite(p)) p = Vec3(0.0);  // no triangle uses this point any more, so its value has no effect
        }
        std::erase_if(file_.parts, [](const MeshPart& part) { return part.triangles.empty(); });
    }

    void add_body(MeshBody& body) {
        const MeshPart& part = file_.parts[body.piece];
        pieces_.push_back({body.box, body.piece, scene_.solids.size(), body.solids.size()});
        if (body.solids.empty()) {
            ++outsides_;
            add_sheets(body.piece, body.triangles, TouchSide::Front);
            return;
        }
        ++filled_;
        const FeatureId id = thing_of(part);
        const MaterialId material = material_of(part.material);
        scene_.bounds_m.include(body.box);
        scene_.features[id.value].bounds_m.include(body.box);
        scene_.report.polygons += static_cast<int>(body.triangles.size());
        for (ConvexSolid& shape : body.solids) {
            ++scene_.report.brushes;
            Solid solid;
            solid.shape = std::move(shape);
            solid.feature = id;
            solid.face_materials.assign(solid.shape.planes.size(), material);
            looks_.emplace_back(solid.shape.planes.size(), material);
            scene_.solids.push_back(std::move(solid));
        }
    }

    void add_sheets(std::size_t of_part, const std::vector<std::uint32_t>& which, TouchSide side) {
        const MeshPart& part = file_.parts[of_part];
        const FeatureId id = thing_of(part);
        const MaterialId material = material_of(part.material);
        Feature& feature = scene_.features[id.value];
        Aabb& box = pieces_.back().box;
        for (const std::uint32_t t : which) {
            const auto& [a, b, c] = part.triangles[t];
            const Vec3 &p = part.points_m[a], &q = part.points_m[b], &r = part.points_m[c];
            scene_.triangles.push_back({p, q, r, id, material, side});
            feature.area_m2 += 0.5 * glm::length(glm::cross(q - p, r - p));
            for (const Vec3& corner : {p, q, r}) box.include(corner);
        }
        feature.material = material;
        feature.bounds_m.include(box);
        scene_.bounds_m.include(box);
        scene_.report.polygons += static_cast<int>(which.size());
    }

    bool is_free(const Aabb& body, std::size_t shell) const {
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            if (i != shell && overlap(pieces_[i].box, body)) return false;
        // The body is compared with the solids of the shell instead of its box, because these solids may be its walls.
        const auto solids = std::span(scene_.solids).subspan(pieces_[shell].first_solid, pieces_[shell].solids);
        return std::none_of(solids.begin(), solids.end(), [&](const Solid& solid) { return meets(solid, body); });
    }

    // Returns the heights at which a person may stand in a shell: on its bottom, and on the solids in it.
    std::vector<double> floors_of(const Piece& shell, double highest_m) const {
        constexpr std::size_t kMostFloors = 8;
        std::vector<double> floors{shell.box.min_m.z};
        for (std::size_t i = shell.first_solid; i < shell.first_solid + shell.solids; ++i)
            if (const double top_m = scene_.solids[i].shape.bounds_m.max_m.z; top_m <= highest_m)
                floors.push_back(top_m);
        std::sort(floors.begin(), floors.end());
        floors.erase(std::unique(floors.begin(), floors.end(), [](double a, double b) { return b - a < 0.01; }),
                     floors.end());
        if (floors.size() > kMostFloors) floors.resize(kMostFloors);
        return floors;
    }

    // Chooses the start, because mesh formats state none. It is in the shell that contains the most other pieces, on
    // the floor of the shell, at the free place nearest to its middle.
    void start_within() {
        constexpr Vec3 kBody_m{0.6, 0.6, 1.9};
        constexpr int kPlaces = 21;  // number of places tried in each direction
        std::size_t shell = pieces_.size(), most = 0;
        for (std::size_t i = 0; i < std::min(pieces_.size(), kMostShells); ++i) {
            const Aabb& outer = pieces_[i].box;
            const Vec3 size = outer.size_m();
            if (size.x < 2.0 * kBody_m.x || size.y < 2.0 * kBody_m.y || size.z < kBody_m.z) continue;
            const auto held =
                static_cast<std::size_t>(std::count_if(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
                    return glm::all(glm::greaterThanEqual(piece.box.min_m, outer.min_m)) &&
                           glm::all(glm::lessThanEqual(piece.box.max_m, outer.max_m));
                }));  // the number includes the shell itself
            if (held > std::max<std::size_t>(most, 1)) shell = i, most = held;
        }
        if (shell == pieces_.size()) return;
        const Aabb& room = pieces_[shell].box;
        const Vec3 middle = room.centre_m(), step = (room.size_m() - 2.0 * kBody_m) / double{kPlaces - 1};
        std::optional<Vec3> best;
        for (const double floor_m : floors_of(pieces_[shell], room.max_m.z - kBody_m.z)) {
            for (int x = 0; x < kPlaces; ++x)
                for (int y = 0; y < kPlaces; ++y) {
                    const Vec3 feet(room.min_m.x + kBody_m.x + x * step.x, room.min_m.y + kBody_m.y + y * step.y,
                                    floor_m);
                    const Aabb body{feet - Vec3(0.5 * kBody_m.x, 0.5 * kBody_m.y, 0.0),
                                    feet + Vec3(0.5 * kBody_m.x, 0.5 * kBody_m.y, kBody_m.z)};
                    if ((!best || glm::length(Vec2(feet - middle)) < glm::length(Vec2(*best - middle))) &&
                        is_free(body, shell))
                        best = feet;
                }
            if (best) break;
        }
        if (best) start_at(*best, pieces_[shell]);
    }

    // Chooses the start if no shell contains other pieces, as in a building made of slabs. Without this choice, the
    // person would start next to the mesh and fall. The start is on the widest slab that has room for a person above
    // it, at the free place nearest to the slab's middle. Slabs under a roof are preferred; of two equal slabs, the
    // lower one is used.
    void start_upon() {
        constexpr Vec3 kBody_m{0.6, 0.6, 1.9};
        constexpr std::size_t kTried = 12;
        constexpr int kPlaces = 21;  // number of places tried in each direction
        std::vector<std::size_t> widest;
        for (std::size_t i = 0; i < std::min(pieces_.size(), kMostShells); ++i)
            if (const Vec3 size = pieces_[i].box.size_m(); pieces_[i].solids > 0 && std::min(size.x, size.y) >= 1.2)
                widest.push_back(i);
        const auto wide_m2 = [&](std::size_t i) {
            return std::round(pieces_[i].box.size_m().x * pieces_[i].box.size_m().y);
        };
        std::stable_sort(widest.begin(), widest.end(), [&](std::size_t a, std::size_t b) {
            return std::pair(wide_m2(b), pieces_[a].box.max_m.z) < std::pair(wide_m2(a), pieces_[b].box.max_m.z);
        });
        if (widest.size() > kTried) widest.resize(kTried);
        const bool roofs = std::any_of(widest.begin(), widest.end(), [&](std::size_t i) {
            return is_covered(pieces_[i].box.centre_m() * Vec3(1.0, 1.0, 0.0) + Vec3(0.0, 0.0, pieces_[i].box.max_m.z));
        });
        for (const std::size_t i : widest) {
            const Aabb& floor = pieces_[i].box;
            const Vec3 middle = floor.centre_m(), step = (floor.size_m() - kBody_m) / double{kPlaces - 1};
            std::optional<Vec3> best;
            for (int x = 0; x < kPlaces; ++x)
                for (int y = 0; y < kPlaces; ++y) {
                    const Vec3 feet(floor.min_m.x + 0.5 * kBody_m.x + x * step.x,
                                    floor.min_m.y + 0.5 * kBody_m.y + y * step.y, floor.max_m.z + 1e-3);
                    const Aabb body{feet - Vec3(0.5 * kBody_m.x, 0.5 * kBody_m.y, 0.0),
                                    feet + Vec3(0.5 * kBody_m.x, 0.5 * kBody_m.y, kBody_m.z)};
                    if ((!best || glm::length(Vec2(feet - middle)) < glm::length(Vec2(*best - middle))) &&
                        (!roofs || is_covered(feet)) && is_solid_at(pieces_[i], feet - Vec3(0.0, 0.0, 0.01)) &&
                        is_free(body, i))
                        best = feet;
                }
            if (best) return start_at(*best, pieces_[i]);
        }
    }

    // True if a wide part is above the place at the height of a ceiling.
    bool is_covered(const Vec3& feet_m) const {
        constexpr double kLow_m = 1.9, kHigh_m = 8.0;
        return std::any_of(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
            const Aabb& box = piece.box;
            return std::min(box.size_m().x, box.size_m().y) >= 1.2 && box.min_m.x <= feet_m.x &&
                   box.max_m.x >= feet_m.x && box.min_m.y <= feet_m.y && box.max_m.y >= feet_m.y &&
                   box.min_m.z >= feet_m.z + kLow_m && box.min_m.z <= feet_m.z + kHigh_m;
        });
    }

    bool is_solid_at(const Piece& piece, const Vec3& at_m) const {
        const auto solids = std::span(scene_.solids).subspan(piece.first_solid, piece.solids);
        return std::any_of(solids.begin(), solids.end(),
                           [&](const Solid& solid) { return contains(solid.shape, at_m); });
    }

    void start_at(const Vec3& feet_m, const Piece& in) {
        Start start;
        start.feet_m = feet_m;
        start.base = true;
        scene_.starts.push_back(std::move(start));
        scene_.report.starts = 1;
        const FeatureId of_room = thing_of(file_.parts[in.part]);
        scene_.report.guessed.push_back(phrase("mesh.start", {{"room", scene_.features[of_room.value].name}}));
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

    void write_report() {
        ReadReport& report = scene_.report;
        report.polygons_kept = report.polygons;
        // The hidden faces are cuts through the inside of bodies, not faces of the file, so they are not counted.
        report.polygons_hidden = 0;
        report.triangles = static_cast<int>(scene_.triangles.size());
        if (filled_ > 0)
            report.guessed.push_back(phrase("mesh.solids", {{"solids", filled_}, {"all", pieces_.size()}}));
        if (outsides_ > 0) report.simplified.push_back(phrase("mesh.outsides", {{"n", outsides_}}));
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
    std::vector<Piece> pieces_;
    // Number of bodies filled with solids, and of bodies with only an outer surface.
    std::size_t filled_ = 0, outsides_ = 0;
    std::map<std::uint32_t, FeatureId> things_;
    std::map<std::string, MaterialId> materials_;
};

}  // namespace

Result<Scene> scene_of_meshes(MeshFile file, Diagnostics diagnostics, const std::string& file_name,
                              const ReadOptions& options) {
    return MeshSceneBuilder(std::move(file), std::move(diagnostics), file_name, options).build();
}

}  // namespace handrail::readers
