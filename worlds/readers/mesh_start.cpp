#include "worlds/readers/mesh_start.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "worlds/base/language.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"

namespace handrail::readers {
namespace {

constexpr double kHalf_m = 0.3, kTall_m = 1.9;  // half the width of a person, and the height of a person
constexpr double kKnee_m = 0.25;                // a person can step over obstacles lower than this
constexpr double kAside_m = 0.6, kSameFloor_m = 0.25;
constexpr double kRoof_m = 8.0;         // height of the highest ceiling
constexpr double kLevel = 0.7;          // least upward component of a floor's normal
constexpr double kFloorsAlike_m = 1.0;  // floors whose heights differ by less than this are on one storey
constexpr int kPlaces = 21;             // number of places tried in each direction
constexpr std::size_t kMostFloors = 16;

class Columns {
public:
    explicit Columns(const Scene& scene) : scene_(scene), index_(boxes_of(scene)) {}

    // A height at which a surface crosses the vertical line, and whether a person could stand on that surface.
    struct Crossing {
        double z_m = 0.0;
        bool floor = false;
    };
    const std::vector<Crossing>& at(const Vec2& p) {
        crossings_.clear();
        const Aabb& all = scene_.bounds_m;
        index_.find({{p.x, p.y, all.min_m.z - 1.0}, {p.x, p.y, all.max_m.z + 1.0}}, near_);
        for (const std::uint32_t i : near_)
            if (i < scene_.triangles.size()) cross(scene_.triangles[i], p);
            else cross(scene_.solids[i - scene_.triangles.size()], p);
        std::sort(crossings_.begin(), crossings_.end(),
                  [](const Crossing& a, const Crossing& b) { return a.z_m < b.z_m; });
        return crossings_;
    }
    // True if nothing blocks a person at this place above the knees.
    bool is_free(const Vec3& feet_m) {
        const Aabb body{feet_m + Vec3(-kHalf_m, -kHalf_m, kKnee_m), feet_m + Vec3(kHalf_m, kHalf_m, kTall_m)};
        index_.find(body, near_);
        return std::none_of(near_.begin(), near_.end(), [&](std::uint32_t i) {
            return i < scene_.triangles.size() ? meets(scene_.triangles[i], body)
                                               : readers::meets(scene_.solids[i - scene_.triangles.size()], body);
        });
    }
    bool stands_at(const Vec3& feet_m) {
        const std::vector<Crossing>& found = at({feet_m.x, feet_m.y});
        const auto floor = std::find_if(found.begin(), found.end(), [&](const Crossing& c) {
            return c.floor && std::abs(c.z_m - feet_m.z) < kSameFloor_m;
        });
        if (floor == found.end()) return false;
        return is_free({feet_m.x, feet_m.y, floor->z_m});
    }

private:
    static std::vector<Aabb> boxes_of(const Scene& scene) {
        std::vector<Aabb> boxes;
        boxes.reserve(scene.triangles.size() + scene.solids.size());
        for (const MeshTriangle& t : scene.triangles) {
            boxes.emplace_back();
            for (const Vec3& corner : {t.a_m, t.b_m, t.c_m}) boxes.back().include(corner);
        }
        for (const Solid& solid : scene.solids) boxes.push_back(solid.shape.bounds_m);
        return boxes;
    }

    void cross(const MeshTriangle& t, const Vec2& p) {
        const Vec3 normal = glm::cross(t.b_m - t.a_m, t.c_m - t.a_m);
        const auto side = [&](const Vec3& a, const Vec3& b) {
            return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        };
        const std::array sides{side(t.a_m, t.b_m), side(t.b_m, t.c_m), side(t.c_m, t.a_m)};
        const auto [least, most] = std::minmax_element(sides.begin(), sides.end());
        if (normal.z == 0.0 || (*least < 0.0 && *most > 0.0)) return;
        const double z_m = t.a_m.z - (normal.x * (p.x - t.a_m.x) + normal.y * (p.y - t.a_m.y)) / normal.z;
        crossings_.push_back({z_m, std::abs(normal.z) > kLevel * glm::length(normal)});
    }
    void cross(const Solid& solid, const Vec2& p) {
        double low_m = solid.shape.bounds_m.min_m.z, high_m = solid.shape.bounds_m.max_m.z;
        bool floor = false;
        for (const Plane& plane : solid.shape.planes) {
            const double level = plane.normal.x * p.x + plane.normal.y * p.y - plane.offset_m;
            if (std::abs(plane.normal.z) < 1e-12) {
                if (level > 0.0) return;
                continue;
            }
            const double z_m = -level / plane.normal.z;
            if (plane.normal.z < 0.0) low_m = std::max(low_m, z_m);
            else if (z_m <= high_m) high_m = z_m, floor = plane.normal.z > kLevel;
        }
        if (low_m > high_m) return;
        crossings_.push_back({low_m, false});
        crossings_.push_back({high_m, floor});
    }

    bool meets(const MeshTriangle& t, const Aabb& body) {
        std::vector<Vec3> part{t.a_m, t.b_m, t.c_m};
        for (int axis = 0; axis < 3 && part.size() >= 3; ++axis) {
            Vec3 out(0.0);
            out[axis] = 1.0;
            keep_back(part, {out, body.max_m[axis]}, 1e-9, scratch_);
            if (part.size() >= 3) keep_back(part, {-out, -body.min_m[axis]}, 1e-9, scratch_);
        }
        return part.size() >= 3;
    }

    const Scene& scene_;
    BoxIndex index_;
    std::vector<std::uint32_t> near_;
    std::vector<Crossing> crossings_;
    std::vector<Vec3> scratch_;
};

}  // namespace

bool meets(const Solid& solid, const Aabb& box) {
    const Vec3 half = 0.5 * box.size_m();
    return std::none_of(solid.shape.planes.begin(), solid.shape.planes.end(), [&](const Plane& plane) {
        return signed_distance(plane, box.centre_m()) >= glm::dot(glm::abs(plane.normal), half) - 1e-6;
    });
}

std::optional<Vec3> place_to_stand(const Scene& scene, const std::stop_token& stop) {
    if (scene.bounds_m.empty()) return std::nullopt;
    const Vec3 middle = scene.bounds_m.centre_m(), size = scene.bounds_m.size_m();
    if (std::min(size.x, size.y) < 2.0 * kAside_m) return std::nullopt;
    Columns columns(scene);
    // A place to stand. Places are sorted with the best first: under a roof, then on the lower storey, then nearer to
    // the middle of the mesh.
    struct Place {
        Vec3 feet_m{0.0};
        bool open = false;
        double storey = 0.0, far_m = 0.0;
    };
    std::vector<Place> places;
    for (int y = 0; y < kPlaces; ++y)
        for (int x = 0; x < kPlaces; ++x) {
            if (stop.stop_requested()) return std::nullopt;
            // The offsets keep the lines away from the edges of a regular mesh.
            const Vec2 p{scene.bounds_m.min_m.x + size.x * (x + 0.503) / kPlaces,
                         scene.bounds_m.min_m.y + size.y * (y + 0.497) / kPlaces};
            const std::vector<Columns::Crossing>& crossings = columns.at(p);
            std::size_t floors = 0;
            for (std::size_t i = 0; i < crossings.size() && floors < kMostFloors; ++i) {
                if (!crossings[i].floor) continue;
                const double z_m = crossings[i].z_m,
                             above_m = i + 1 < crossings.size() ? crossings[i + 1].z_m - z_m : 2.0 * kRoof_m;
                if (above_m < kTall_m) continue;
                ++floors;
                places.push_back({{p.x, p.y, z_m},
                                  above_m > kRoof_m,
                                  std::round((z_m - scene.bounds_m.min_m.z) / kFloorsAlike_m),
                                  std::hypot(p.x - middle.x, p.y - middle.y)});
            }
        }
    std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
        return std::tuple(a.open, a.storey, a.far_m) < std::tuple(b.open, b.storey, b.far_m);
    });
    for (const Place& place : places) {
        if (stop.stop_requested()) return std::nullopt;
        if (!columns.is_free(place.feet_m)) continue;
        int sides = 0;
        for (const Vec3& aside :
             {Vec3(kAside_m, 0, 0), Vec3(0, kAside_m, 0), Vec3(-kAside_m, 0, 0), Vec3(0, -kAside_m, 0)})
            sides += columns.stands_at(place.feet_m + aside) ? 1 : 0;
        if (sides >= 3) return place.feet_m;
    }
    return std::nullopt;
}

void start_on_floor(Scene& scene, const std::stop_token& stop) {
    const std::optional<Vec3> feet_m = place_to_stand(scene, stop);
    if (!feet_m) return;
    Start start;
    start.feet_m = *feet_m;
    start.base = true;
    scene.starts.push_back(std::move(start));
    scene.report.starts = 1;
    scene.report.guessed.push_back(phrase("mesh.start_on_floor"));
}

}  // namespace handrail::readers
