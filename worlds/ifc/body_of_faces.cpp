// Turns shells of flat faces into convex solids if they are convex or prisms, and otherwise into sheets.
#include <algorithm>
#include <array>
#include <map>

#include "worlds/geometry/clip.h"
#include "worlds/geometry/closed_mesh.h"
#include "worlds/geometry/exposed_surface.h"
#include "worlds/ifc/body.h"

namespace handrail::ifc {
namespace {

constexpr double kFlat_m = 1e-4;
constexpr double kAlikeShare = 0.01;  // two areas are equal if they differ by less than this share

struct Face {
    std::vector<std::vector<Vec3>> rings;
    Vec3 area{0.0};  // area vector of the outline, from which holes are not subtracted
    double size_m2 = 0.0;
};

Vec3 unit(const Vec3& v) { return v / std::max(glm::length(v), 1e-300); }

// Returns axes of which z is the given normal.
Frame frame_on(const Vec3& normal, const Vec3& origin_m) {
    Frame frame;
    frame.origin_m = origin_m;
    frame.z = normal;
    frame.x = any_perpendicular(normal);
    frame.y = glm::cross(frame.z, frame.x);
    return frame;
}
Ring ring_in(const Frame& frame, const std::vector<Vec3>& points) {
    Ring ring;
    for (const Vec3& p : points)
        ring.emplace_back(glm::dot(p - frame.origin_m, frame.x), glm::dot(p - frame.origin_m, frame.y));
    return ring;
}

Face face_of(const FlatFace& flat) {
    Face face;
    for (const std::vector<Vec3>& ring : flat.rings)
        if (ring.size() >= 3 && std::all_of(ring.begin(), ring.end(), [](const Vec3& p) { return is_finite(p); }))
            face.rings.push_back(ring);
    if (face.rings.empty()) return face;
    face.area = area_vector_m2(face.rings[0]);
    face.size_m2 = glm::length(face.area);
    for (std::size_t i = 1; i < face.rings.size(); ++i) face.size_m2 -= area_m2(face.rings[i]);
    return face;
}

void add_sheets(const Face& face, std::vector<Polygon>& sheets) {
    if (face.rings.size() == 1 && face.rings[0].size() == 3) {
        sheets.push_back({face.rings[0]});
        return;
    }
    const Frame frame = frame_on(unit(face.area), face.rings[0][0]);
    std::vector<Ring> rings;
    for (const std::vector<Vec3>& ring : face.rings) rings.push_back(ring_in(frame, ring));
    for (const Ring& part : convex_parts(rings)) {
        Polygon sheet;
        for (const Vec2& p : part) sheet.points_m.push_back(frame.at({p.x, p.y, 0.0}));
        sheets.push_back(std::move(sheet));
    }
}

// Returns the length of the outer border of adjacent flat pieces. Edges that two pieces share are inside the area and
// are left out.
double border_m(const std::vector<Ring>& rings) {
    using Corner = std::pair<long long, long long>;
    const auto corner = [](const Vec2& p) {
        return Corner{std::llround(std::clamp(p.x, -1e9, 1e9) * 1e4), std::llround(std::clamp(p.y, -1e9, 1e9) * 1e4)};
    };
    std::map<std::pair<Corner, Corner>, std::pair<int, double>> edges;
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            auto& [times, length_m] = edges[std::minmax(corner(a), corner(b))];
            ++times;
            length_m = glm::length(b - a);
        }
    double sum_m = 0.0;
    for (const auto& [edge, counted] : edges) sum_m += counted.first % 2 == 1 ? counted.second : 0.0;
    return sum_m;
}

class Shell {
public:
    explicit Shell(std::vector<Face> faces) : faces_(std::move(faces)) {
        for (const Face& face : faces_) {
            all_m2_ += face.size_m2;
            for (const std::vector<Vec3>& ring : face.rings)
                for (const Vec3& p : ring) {
                    points_.push_back(p);
                    box_.include(p);
                }
        }
    }

    void add_to(Body& body) const {
        if (convex(body) || prism_of(body)) return;
        for (const Face& face : faces_) add_sheets(face, body.sheets);
    }

private:
    bool convex(Body& body) const {
        if (faces_.size() < 4 || faces_.size() * points_.size() > 4'000'000) return false;
        Vec3 middle{0.0};
        for (const Vec3& p : points_) middle += p / static_cast<double>(points_.size());
        std::vector<Plane> planes;
        for (const Face& face : faces_) {
            Plane plane{unit(face.area), 0.0};
            plane.offset_m = glm::dot(plane.normal, face.rings[0][0]);
            if (signed_distance(plane, middle) > 0.0) plane = {-plane.normal, -plane.offset_m};
            double most = -1e300;
            for (const Vec3& p : points_) most = std::max(most, signed_distance(plane, p));
            if (most > kFlat_m) return false;
            plane.offset_m += std::max(0.0, most);
            const bool known = std::any_of(planes.begin(), planes.end(), [&](const Plane& o) {
                return glm::dot(o.normal, plane.normal) > 1.0 - 1e-8 && std::abs(o.offset_m - plane.offset_m) < kFlat_m;
            });
            if (!known) planes.push_back(plane);
        }
        std::optional<ConvexSolid> solid = solid_within(std::move(planes), middle, glm::length(box_.size_m()));
        if (!solid) return false;
        double closed_m2 = 0.0;
        for (const Polygon& face : solid->faces) closed_m2 += area_m2(face);
        if (std::abs(closed_m2 - all_m2_) > kAlikeShare * all_m2_) return false;  // the shell is open, like a tray
        body.solids.push_back(std::move(*solid));
        return true;
    }

    // True if the shell is a prism: all corners are in two parallel planes, the outline is the same in both, and there
    // are side faces all round.
    bool prism_of(Body& body) const {
        if (faces_.size() < 5 || points_.size() > 40'000) return false;
        std::vector<std::pair<double, Vec3>> directions;  // normals, each with the total area of the faces that have it
        for (const Face& face : faces_) {
            const Vec3 normal = unit(face.area);
            const auto known = std::find_if(directions.begin(), directions.end(), [&](const auto& d) {
                return std::abs(glm::dot(d.second, normal)) > 1.0 - 1e-8;
            });
            if (known != directions.end()) known->first += face.size_m2;
            else if (directions.size() < 64) directions.emplace_back(face.size_m2, normal);
        }
        std::stable_sort(directions.begin(), directions.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        for (std::size_t i = 0; i < std::min<std::size_t>(6, directions.size()); ++i)
            if (along(directions[i].second, body)) return true;
        return false;
    }
    bool along(const Vec3& way, Body& body) const {
        Reach reach{1e300, -1e300};
        for (const Vec3& p : points_)
            reach = {std::min(reach.least, glm::dot(p, way)), std::max(reach.most, glm::dot(p, way))};
        if (!(reach.most - reach.least > kFlush_m)) return false;
        for (const Vec3& p : points_) {
            const double at = glm::dot(p, way);
            if (at > reach.least + kFlat_m && at < reach.most - kFlat_m) return false;
        }
        const Frame frame = frame_on(way, box_.centre_m() + way * (reach.least - glm::dot(box_.centre_m(), way)));
        std::vector<Ring> low;
        double low_m2 = 0.0, high_m2 = 0.0, side_m2 = 0.0;
        for (const Face& face : faces_) {
            const double at = glm::dot(face.rings[0][0], way);
            const bool cap = std::abs(glm::dot(unit(face.area), way)) > 1.0 - 1e-6;
            if (!cap) side_m2 += face.size_m2;
            else if (at > reach.most - kFlat_m) high_m2 += face.size_m2;
            else {
                low_m2 += face.size_m2;
                for (const std::vector<Vec3>& ring : face.rings) low.push_back(ring_in(frame, ring));
            }
        }
        if (!(low_m2 > 1e-6) || std::abs(low_m2 - high_m2) > kAlikeShare * low_m2 || !(side_m2 > 0.0)) return false;
        const double sides_m2 = border_m(low) * (reach.most - reach.least);
        if (std::abs(side_m2 - sides_m2) > kAlikeShare * sides_m2) return false;
        Body made;
        double parts_m2 = 0.0;
        for (const Ring& part : convex_parts(low)) {
            parts_m2 += signed_area(part);
            if (std::optional<ConvexSolid> solid = prism(part, {0.0, 0.0, reach.most - reach.least}, frame))
                made.solids.push_back(std::move(*solid));
            else return false;
        }
        if (std::abs(parts_m2 - low_m2) > kAlikeShare * low_m2) return false;
        body.add(std::move(made));
        return true;
    }

    std::vector<Face> faces_;
    std::vector<Vec3> points_;
    Aabb box_;
    double all_m2_ = 0.0;
};

// The triangles of the sheets, in the form that closed_mesh.h expects.
struct Skin {
    std::vector<Vec3> points_m;
    std::vector<MeshCorners> triangles;
    Vec3 open_m2{0.0};  // sum of the area vectors of all sheets; zero for a closed skin
    double area_m2 = 0.0, six_volumes_m3 = 0.0;
};

Skin skin_of(const std::vector<Polygon>& sheets) {
    Skin skin;
    for (const Polygon& sheet : sheets) {
        const auto first = static_cast<std::uint32_t>(skin.points_m.size());
        skin.points_m.insert(skin.points_m.end(), sheet.points_m.begin(), sheet.points_m.end());
        for (std::uint32_t k = 1; k + 1 < sheet.points_m.size(); ++k)
            skin.triangles.push_back({first, first + k, first + k + 1});
        const Vec3 area = area_vector_m2(sheet.points_m);
        skin.open_m2 += area;
        skin.area_m2 += glm::length(area);
        skin.six_volumes_m3 += 2.0 * glm::dot(area, sheet.points_m[0] - skin.points_m[0]);
    }
    return skin;
}

}  // namespace

bool encloses(const Body& body) {
    constexpr double kClosedShare = 1e-4;
    if (body.sheets.empty()) return !body.solids.empty();
    const Skin skin = skin_of(body.sheets);
    return body.sheets.size() >= 4 && glm::length(skin.open_m2) <= kClosedShare * skin.area_m2;
}

void fill(Body& body) {
    if (body.sheets.empty() || !encloses(body)) return;
    Skin skin = skin_of(body.sheets);
    if (skin.six_volumes_m3 < 0.0)  // if the triangles face inwards, turns them round
        for (MeshCorners& corners : skin.triangles) std::swap(corners[1], corners[2]);
    std::vector<std::uint32_t> all(skin.triangles.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    FillLimits limits;
    std::size_t looks = 2'000'000;
    limits.most_triangles = 5'000;
    limits.looks_left = &looks;
    std::optional<std::vector<ConvexSolid>> solids = solids_within(skin.points_m, skin.triangles, all, limits);
    if (!solids || solids->empty()) return;
    body.sheets.clear();
    for (ConvexSolid& solid : *solids) body.solids.push_back(std::move(solid));
}

Body body_of_faces(const std::vector<FlatFace>& flat) {
    std::vector<Face> faces;
    for (const FlatFace& one : flat)
        if (Face face = face_of(one); face.size_m2 > 1e-9) faces.push_back(std::move(face));
    // Faces that share a corner belong to the same piece.
    std::map<std::array<long long, 3>, std::uint32_t> first_at;
    DisjointSets pieces(faces.size());
    for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (const std::vector<Vec3>& ring : faces[f].rings)
            for (const Vec3& p : ring) {
                const Vec3 scaled = glm::clamp(p * 1e5, Vec3(-9e17), Vec3(9e17));
                const auto [found, is_new] =
                    first_at.try_emplace({std::llround(scaled.x), std::llround(scaled.y), std::llround(scaled.z)}, f);
                if (!is_new) pieces.join(found->second, f);
            }
    std::map<std::uint32_t, std::vector<Face>> shells;
    for (std::uint32_t f = 0; f < faces.size(); ++f) shells[pieces.find(f)].push_back(std::move(faces[f]));
    Body body;
    for (auto& [root, shell] : shells) Shell(std::move(shell)).add_to(body);
    return body;
}

}  // namespace handrail::ifc
