// Reads Wavefront .obj meshes. Closed objects become solids (see mesh_bodies). All others become sheets of triangles.
// Sheets are two-sided, unless a comment "#touch_side front" or "back" changes that for the faces below it. Damage is
// reported by line, and the rest of the file loads.
#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "worlds/base/text.h"
#include "worlds/geometry/clip.h"
#include "worlds/geometry/closest_point.h"
#include "worlds/readers/diagnostics.h"
#include "worlds/readers/map_keys.h"
#include "worlds/readers/mesh_bodies.h"
#include "worlds/readers/mesh_materials.h"
#include "worlds/readers/mesh_start.h"
#include "worlds/readers/reader.h"
#include "worlds/readers/spoken_text.h"
#include "worlds/scene/surfaces.h"

namespace handrail::readers {
namespace {

constexpr double kObjSurfaceUnit_m = 1.0 / 32.0;  // unit for the tolerances of derive_surfaces, the same as for maps
// Greatest number of corners of a polygon; splitting a larger one would take minutes.
constexpr std::size_t kMostCorners = 4096;

double twice_area(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Cuts a polygon into triangles of corner numbers, one ear at a time, so that concave polygons are cut correctly. If no
// ears are left (in a twisted polygon or one without area), the rest is cut as a fan. The result always has (corners -
// 2) triangles. Cost: O(corners squared) for convex polygons.
std::vector<std::array<std::size_t, 3>> triangles_of(const std::vector<Vec3>& corners_m, const std::stop_token& stop) {
    Vec3 normal{0.0};
    for (std::size_t i = 1; i + 1 < corners_m.size(); ++i)
        normal += glm::cross(corners_m[i] - corners_m[0], corners_m[i + 1] - corners_m[0]);
    // Projects along the axis nearest to the normal. The view is from the side where the corners run counter-clockwise.
    const Vec3 size = glm::abs(normal);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    std::vector<Vec2> flat;
    for (const Vec3& p : corners_m)
        flat.emplace_back(p[(axis + 1) % 3], p[(axis + 2) % 3] * (normal[axis] < 0.0 ? -1.0 : 1.0));

    std::vector<std::size_t> ring(corners_m.size());
    for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = i;
    std::vector<std::array<std::size_t, 3>> triangles;
    const auto is_ear = [&](std::size_t at) {
        const std::size_t a = ring[(at + ring.size() - 1) % ring.size()], b = ring[at],
                          c = ring[(at + 1) % ring.size()];
        if (twice_area(flat[a], flat[b], flat[c]) <= 0.0) return false;
        return std::none_of(ring.begin(), ring.end(), [&](std::size_t p) {
            if (p == a || p == b || p == c) return false;
            return twice_area(flat[a], flat[b], flat[p]) >= 0.0 && twice_area(flat[b], flat[c], flat[p]) >= 0.0 &&
                   twice_area(flat[c], flat[a], flat[p]) >= 0.0;
        });
    };
    while (ring.size() > 3 && !stop.stop_requested()) {
        std::size_t ear = 1;  // if there is no ear, the next corner is cut off, so that the rest becomes a fan
        for (std::size_t at = 0; at < ring.size() && !stop.stop_requested(); ++at) {
            if (!is_ear(at)) continue;
            ear = at;
            break;
        }
        triangles.push_back({ring[(ear + ring.size() - 1) % ring.size()], ring[ear], ring[(ear + 1) % ring.size()]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({ring[0], ring[1], ring[2]});
    return triangles;
}

class ObjSceneBuilder {
public:
    ObjSceneBuilder(std::string_view bytes, const std::string& file_name, const ReadOptions& options)
        : options_(options), bytes_(bytes), diagnostics_(file_name) {
        scene_.source_file = file_name;
        scene_.name = words_of_name(file_name);
        scene_.materials.emplace_back();
        scene_.report.format = "obj";
        scene_.metres_per_unit = options.obj_metres_per_unit;
    }

    // Reads the file's y axis as up. `how` is a sentence that says why.
    void stand_y_up(std::string how) {
        y_up_ = true;
        scene_.report.guessed.push_back(std::move(how));
    }
    void count_in(double metres_per_unit) { scene_.metres_per_unit = metres_per_unit; }

    Result<Scene> build() {
        if (bytes_.starts_with("\xEF\xBB\xBF")) at_ = 3;
        while (next_line() && !options_.stop.stop_requested()) read_line();
        if (options_.stop.stop_requested()) return fail(phrase("files.stopped"), scene_.source_file);
        if (scene_.triangles.empty()) return nothing_to_touch(diagnostics_, scene_.source_file, "mesh");
        name_main_materials();
        if (options_.solid_meshes) fill_closed();
        start_on_floor(scene_, options_.stop);
        if (options_.stop.stop_requested()) return fail(phrase("files.stopped"), scene_.source_file);
        ReadReport& report = scene_.report;
        report.polygons_kept = report.polygons;
        // The hidden faces are cuts through the inside of bodies, not faces of the file, so they are not counted.
        report.polygons_hidden = 0;
        report.triangles = static_cast<int>(scene_.triangles.size());
        if (curves_ > 0) report.left_out.push_back(phrase("obj.curves_left_out", {{"n", curves_}}));
        if (faces_left_out_ > 0) report.left_out.push_back(phrase("obj.faces_left_out", {{"n", faces_left_out_}}));
        for (const auto& [material, from] : guessed_from_)
            report.guessed.push_back(
                phrase("obj.guessed", {{"material", spoken_material(material)}, {"name", excerpt(from)}}));
        diagnostics_.move_into(report);
        if (options_.progress) options_.progress(1.0);
        return std::move(scene_);
    }

private:
    // Moves to the next line. Lines end with LF, CR LF or CR; a backslash at the end joins the next line to it.
    bool next_line() {
        if (at_ >= bytes_.size()) return false;
        words_.clear();
        line_ = next_line_;
        std::size_t begin = at_;
        for (bool more = true; more;) {
            const std::size_t end = std::min(bytes_.find_first_of("\r\n", begin), bytes_.size());
            std::string_view text = bytes_.substr(begin, end - begin);
            if (constexpr std::string_view kSide = "#touch_side"; text.starts_with(kSide))
                read_side(text.substr(kSide.size()));
            text = text.substr(0, text.find('#'));
            more = text.ends_with('\\') && end < bytes_.size();
            if (more) text.remove_suffix(1);
            add_words(text);
            begin = end < bytes_.size() && bytes_[end] == '\r' && end + 1 < bytes_.size() && bytes_[end + 1] == '\n'
                        ? end + 2
                        : end + 1;
            ++next_line_;
        }
        at_ = begin;
        return true;
    }

    // Reads "#touch_side". The key is written as a comment so that other programs ignore it.
    void read_side(std::string_view word) {
        if (const std::optional<TouchSide> side = touch_side_named(word)) side_ = *side;
        else
            diagnostics_.warn({next_line_, 1}, "map.then_passed_over", "obj.touch_side",
                              {{"value", excerpt(trimmed(word))}});
    }

    struct Word {
        std::string_view text;
        int column = 0;
    };

    void add_words(std::string_view text) {
        for (std::size_t i = 0; i < text.size();) {
            const auto blank = [&](std::size_t k) { return static_cast<unsigned char>(text[k]) <= ' '; };
            if (blank(i)) {
                ++i;
                continue;
            }
            std::size_t end = i;
            while (end < text.size() && !blank(end)) ++end;
            words_.push_back({text.substr(i, end - i), static_cast<int>(i) + 1});
            i = end;
        }
    }

    TextPlace place(std::size_t word) const { return {line_, word < words_.size() ? words_[word].column : 0}; }

    void read_line() {
        if (words_.empty()) return;
        const std::string_view what = words_[0].text;
        if (what == "v") read_vertex();
        else if (what == "f") read_face();
        else if (what == "o" || what == "g") name_ = rest_of_line();
        else if (what == "usemtl") material_ = material_of(rest_of_line());
        else if (what == "l" || what == "p" || what == "curv" || what == "surf") ++curves_;
        else if (what != "vt" && what != "vn" && what != "vp" && what != "s" && what != "mtllib" &&
                 !complained_unknown_) {
            // The fault is reported only once, because a file in another format would give thousands of such warnings.
            complained_unknown_ = true;
            diagnostics_.warn(place(0), "map.then_passed_over", "obj.no_statement", {{"word", excerpt(what)}});
        }
    }

    std::string rest_of_line() const {
        std::string text;
        for (std::size_t i = 1; i < words_.size() && text.size() < 256; ++i)
            text += (i > 1 ? " " : "") + std::string(words_[i].text.substr(0, 256));
        return text;
    }

    void read_vertex() {
        Vertex vertex;
        vertex.good = words_.size() >= 4;
        if (!vertex.good) diagnostics_.warn(place(0), "obj.then_its_faces", "obj.short_point");
        for (int axis = 0; vertex.good && axis < 3; ++axis) {
            const Word& word = words_[static_cast<std::size_t>(axis) + 1];
            vertex.good = parse_finite(word.text, vertex.at_m[axis]) &&
                          std::abs(vertex.at_m[axis] * scene_.metres_per_unit) <= kFarthestM;
            vertex.at_m[axis] *= scene_.metres_per_unit;
            if (!vertex.good)
                diagnostics_.warn({line_, word.column}, "obj.then_point_faces", "obj.bad_number",
                                  {{"found", excerpt(word.text)}});
        }
        if (y_up_) vertex.at_m = {vertex.at_m.x, -vertex.at_m.z, vertex.at_m.y};
        vertices_.push_back(vertex);
    }

    // Returns the point that a corner such as "7", "7/1/3" or "-1" refers to; reports faults.
    const Vec3* corner(const Word& word) {
        long long number = 0;
        const std::string_view text = word.text.substr(0, word.text.find('/'));
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const auto count = static_cast<long long>(vertices_.size());
        const auto refuse = [&](std::string_view why, long long point = 0) -> const Vec3* {
            diagnostics_.warn({line_, word.column}, "obj.then_face", why,
                              {{"found", excerpt(word.text)}, {"point", point}, {"count", count}});
            return nullptr;
        };
        if (error != std::errc{} || end != text.data() + text.size()) return refuse("obj.no_number");
        const long long index = number < 0 ? count + number : number - 1;
        if (number == 0 || index < 0 || index >= count) return refuse("obj.no_point", number);
        const Vertex& vertex = vertices_[static_cast<std::size_t>(index)];
        if (!vertex.good) return refuse("obj.damaged_point", index + 1);
        return &vertex.at_m;
    }

    void read_face() {
        std::vector<Vec3> corners_m;
        const bool fits = words_.size() >= 4 && words_.size() <= kMostCorners + 1;
        if (!fits)
            diagnostics_.warn(place(0), "map.then_left_out", "obj.corners",
                              {{"n", words_.size() - 1}, {"most", kMostCorners}});
        for (std::size_t i = 1; fits && i < words_.size(); ++i) {
            const Vec3* at_m = corner(words_[i]);
            if (!at_m) break;
            corners_m.push_back(*at_m);
        }
        if (!fits || corners_m.size() + 1 < words_.size()) {
            ++faces_left_out_;
            return;
        }
        ++scene_.report.polygons;
        const FeatureId id = feature_of(name_);
        Feature& feature = scene_.features[id.value];
        for (const auto& [a, b, c] : triangles_of(corners_m, options_.stop)) {
            scene_.triangles.push_back({corners_m[a], corners_m[b], corners_m[c], id, material_, side_});
            const double area = 0.5 * glm::length(glm::cross(corners_m[b] - corners_m[a], corners_m[c] - corners_m[a]));
            feature.area_m2 += area;
            areas_m2_[{id.value, material_}] += area;
        }
        for (const Vec3& p : corners_m) {
            feature.bounds_m.include(p);
            scene_.bounds_m.include(p);
        }
    }

    FeatureId feature_of(const std::string& name) {
        const auto [found, is_new] =
            features_.try_emplace(name, FeatureId{static_cast<std::uint32_t>(scene_.features.size())});
        if (!is_new) return found->second;
        Feature feature;
        feature.kind = FeatureKind::Object;
        feature.name = name.empty() || name == "default" || name == "off" ? scene_.name : words_of_name(name);
        if (feature.name.empty()) feature.name = "surface", feature.made_name = true;
        feature.source.line = line_;
        scene_.features.push_back(std::move(feature));
        return found->second;
    }

    MaterialId material_of(const std::string& name) {
        const auto [known, is_new] = materials_.try_emplace(name, kDefaultMaterial);
        if (!is_new) return known->second;
        const std::optional<Material> material = mesh_material(name, options_.guess_materials);
        if (!material) return kDefaultMaterial;
        if (material->guessed) guessed_from_.try_emplace(material->name, name);
        known->second = material_id(scene_, *material);
        return known->second;
    }

    void name_main_materials() {
        std::map<std::uint32_t, double> most_m2;
        for (const auto& [what, area] : areas_m2_) {
            double& most = most_m2.try_emplace(what.first, -1.0).first->second;
            if (area <= most) continue;
            most = area;
            scene_.features[what.first].material = what.second;
        }
    }

    // Makes an object solid if all of its faces are two-sided and form a closed surface.
    void fill_closed() {
        struct Thing {
            std::vector<Vec3> points_m;
            std::vector<MeshCorners> corners;
            std::vector<std::size_t> triangles;  // triangles of the thing, as indices into the scene's triangles
            bool two_sided = true;
        };
        std::vector<Thing> things(scene_.features.size());
        for (std::size_t t = 0; t < scene_.triangles.size(); ++t) {
            const MeshTriangle& triangle = scene_.triangles[t];
            Thing& thing = things[triangle.feature.value];
            const auto first = static_cast<std::uint32_t>(thing.points_m.size());
            thing.points_m.insert(thing.points_m.end(), {triangle.a_m, triangle.b_m, triangle.c_m});
            thing.corners.push_back({first, first + 1, first + 2});
            thing.triangles.push_back(t);
            thing.two_sided = thing.two_sided && triangle.side == TouchSide::Both;
        }
        std::vector<MeshPiece> meshes;
        for (const Thing& thing : things) meshes.push_back({thing.points_m, thing.corners});
        MeshBodies sorted = mesh_bodies(meshes, options_.stop);
        std::vector<bool> within(scene_.triangles.size(), false);
        std::size_t filled = 0, outsides = 0, all = 0;
        for (const std::vector<std::uint32_t>& rest : sorted.rest) all += rest.empty() ? 0 : 1;
        for (MeshBody& body : sorted.bodies) {
            const Thing& thing = things[body.piece];
            ++all;
            if (!thing.two_sided) continue;
            std::vector<std::size_t> skin;
            for (const std::uint32_t t : body.triangles) skin.push_back(thing.triangles[t]);
            ++(body.solids.empty() ? outsides : filled);
            for (const std::size_t t : skin) {
                if (body.solids.empty()) scene_.triangles[t].side = TouchSide::Front;
                else within[t] = true;
            }
            for (ConvexSolid& shape : body.solids) add_solid(std::move(shape), skin);
        }
        if (filled > 0) {
            drop_triangles(within);
            scene_.report.guessed.push_back(phrase("mesh.solids", {{"solids", filled}, {"all", all}}));
            derive_surfaces(scene_, looks_, kObjSurfaceUnit_m, options_.stop);
        }
        if (outsides > 0) scene_.report.simplified.push_back(phrase("mesh.outsides", {{"n", outsides}}));
    }

    // Adds a solid of a body. Each face gets the material of the mesh surface at the middle of the face. A face that is
    // only a cut through the body gets the material of the first triangle.
    void add_solid(ConvexSolid shape, const std::vector<std::size_t>& skin) {
        const MeshTriangle& first = scene_.triangles[skin.front()];
        const bool alike = std::all_of(skin.begin(), skin.end(),
                                       [&](std::size_t t) { return scene_.triangles[t].material == first.material; });
        Solid solid;
        solid.feature = first.feature;
        solid.face_materials.assign(shape.planes.size(), first.material);
        for (std::size_t f = 0; f < shape.faces.size() && !alike; ++f) {
            const Vec3 middle = centre_of(shape.faces[f]);
            double least_m = 1e300;
            for (const std::size_t t : skin) {
                const MeshTriangle& triangle = scene_.triangles[t];
                const Vec3 area = glm::cross(triangle.b_m - triangle.a_m, triangle.c_m - triangle.a_m);
                if (!(glm::dot(area, shape.planes[f].normal) > 0.99 * glm::length(area))) continue;
                const double far_m = glm::length(
                    middle - closest_point_of_triangle(triangle.a_m, triangle.b_m, triangle.c_m, middle).point_m);
                if (far_m >= least_m) continue;
                least_m = far_m;
                solid.face_materials[f] = triangle.material;
            }
        }
        looks_.emplace_back(solid.face_materials.begin(), solid.face_materials.end());
        solid.shape = std::move(shape);
        ++scene_.report.brushes;
        scene_.solids.push_back(std::move(solid));
    }

    void drop_triangles(const std::vector<bool>& gone) {
        std::size_t kept = 0;
        for (std::size_t t = 0; t < scene_.triangles.size(); ++t) {
            const MeshTriangle& triangle = scene_.triangles[t];
            if (!gone[t]) scene_.triangles[kept++] = triangle;
            else
                scene_.features[triangle.feature.value].area_m2 -=
                    0.5 * glm::length(glm::cross(triangle.b_m - triangle.a_m, triangle.c_m - triangle.a_m));
        }
        scene_.triangles.resize(kept);
        for (Feature& feature : scene_.features) feature.area_m2 = std::max(0.0, feature.area_m2);
    }

    struct Vertex {
        Vec3 at_m{0.0};
        bool good = false;
    };

    const ReadOptions& options_;
    std::string_view bytes_;
    Diagnostics diagnostics_;
    Scene scene_;
    std::size_t at_ = 0;
    int line_ = 0, next_line_ = 1;
    std::vector<Word> words_;  // words of the current line
    std::vector<Vertex> vertices_;
    std::string name_;                        // name of the current object or group
    MaterialId material_ = kDefaultMaterial;  // material of the faces that follow
    TouchSide side_ = TouchSide::Both;        // touchable side of the faces that follow
    std::map<std::string, FeatureId> features_;
    std::map<std::string, MaterialId> materials_;
    std::map<std::string, std::string> guessed_from_;
    std::map<std::pair<std::uint32_t, MaterialId>, double> areas_m2_;
    std::vector<std::vector<FaceLook>> looks_;  // looks of the faces, for each of the scene's solids
    int curves_ = 0, faces_left_out_ = 0;
    bool complained_unknown_ = false;
    bool y_up_ = false;
};

// True if Sweet Home 3D wrote the file. That program states its name in the file, and its files always have the same
// axes and unit.
bool is_of_sweet_home(std::string_view bytes) {
    constexpr std::size_t kHead = 1024;
    const std::string_view head = bytes.substr(0, kHead);
    const std::size_t at = head.find("Sweet Home 3D");
    return at != std::string_view::npos && head.find_last_of('#', at) != std::string_view::npos &&
           head.substr(head.find_last_of('#', at), at - head.find_last_of('#', at)).find('\n') ==
               std::string_view::npos;
}

// True if the mesh appears to have y up: the objects called floor or ceiling are thin from south to north, and none of
// them is thin in height.
bool lies_on_its_side(const Scene& scene) {
    constexpr std::array<std::string_view, 6> kFlatThings{"floor", "ceiling", "ground", "boden", "decke", "slab"};
    constexpr double kThin = 0.2;
    int lying = 0, standing = 0;
    for (const Feature& feature : scene.features) {
        const std::string name = lower_ascii(feature.name);
        if (feature.bounds_m.empty() ||
            std::none_of(kFlatThings.begin(), kFlatThings.end(),
                         [&](std::string_view word) { return name.find(word) != std::string::npos; }))
            continue;
        const Vec3 size = feature.bounds_m.size_m();
        lying += size.z < kThin * std::min(size.x, size.y) ? 1 : 0;
        standing += size.y < kThin * std::min(size.x, size.z) ? 1 : 0;
    }
    return standing > 0 && lying == 0;
}

}  // namespace

Result<Scene> read_obj(std::string_view bytes, const std::string& file_name, const ReadOptions& options) {
    ObjSceneBuilder builder(bytes, file_name, options);
    const bool of_sweet_home = is_of_sweet_home(bytes);
    if (of_sweet_home) {
        if (!options.unit_is_known) builder.count_in(0.01);
        builder.stand_y_up(phrase(options.unit_is_known ? "obj.sweet_home_axes" : "obj.sweet_home"));
    }
    Result<Scene> scene = builder.build();
    if (of_sweet_home || !scene || !lies_on_its_side(*scene)) return scene;
    ObjSceneBuilder upright(bytes, file_name, options);
    upright.stand_y_up(phrase("obj.y_up"));
    return upright.build();
}

}  // namespace handrail::readers
