#include "haptic/compile/round_edges.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"
#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"

namespace handrail::compile {
namespace {

constexpr double kOfThickness = 0.25;  // greatest rounding radius as a share of the solid's thickness
// Least rounding as a share of the requested radius. If the solid permits only a smaller rounding, which the hand would
// not feel, the solid stays sharp.
constexpr double kLeastShare = 0.25;
constexpr double kFlush = 1e-6;  // sine of the angle between two faces below which they are treated as one plane
// Greatest number of cuts when covered() subtracts neighbours from a solid's extension. After that, covered() gives up
// and the extension is treated as not covered.
constexpr int kMostCuts = 300;

// What rounding did to a solid's edges. Apart means that the solid is not a candidate for rounding.
enum class Edges : std::uint8_t { Apart, Rounded, TooThin, AtSeam };

// An edge of a solid. It runs counter-clockwise around the face on its left, seen from outside.
struct Edge {
    Vec3 from_m, to_m;
    std::uint32_t face, beyond;  // `face` is on the left of the edge, `beyond` on its right
};

struct Part {
    Edges edges = Edges::Apart;
    double radius_m = 0.0;
    std::vector<double> out_m;  // for each face, how far the solid is extended into the neighbour that covers it
    std::vector<Edge> all_edges;
    std::vector<std::uint32_t> near;

    bool rounded() const { return edges == Edges::Rounded; }
    // Returns how far the flat parts of the faces around `face` extend beyond the plane of `face`. The result is
    // negative if the edge is rounded off before that plane.
    double flat_beyond_m(std::uint32_t face) const { return rounded() ? out_m[face] - radius_m : 0.0; }
    double felt_radius_m() const { return rounded() ? radius_m : 0.0; }
};

bool is_touchable(const Solid& solid) {
    return (solid.role == SolidRole::Solid || solid.role == SolidRole::Mover) &&
           std::holds_alternative<std::monostate>(solid.round);
}

// Returns the smallest thickness of the solid: the least distance, over all faces, to the corner farthest behind the
// face.
double thickness_m(const ConvexSolid& solid) {
    double least = std::numeric_limits<double>::infinity();
    for (const Plane& plane : solid.planes) {
        double deepest = 0.0;
        for (const Polygon& face : solid.faces)
            for (const Vec3& p : face.points_m) deepest = std::max(deepest, -signed_distance(plane, p));
        least = std::min(least, deepest);
    }
    return least;
}

class Rounder {
public:
    Rounder(const Scene& scene, double radius_m, const OwnRounding& own, const std::stop_token& stop)
        : scene_(scene),
          stop_(stop),
          radius_m_(radius_m),
          own_(own),
          touch_m_(std::clamp(1e-4 * scene.metres_per_unit, 1e-6, 1e-5)),
          parts_(scene.solids.size()),
          index_(boxes_of(scene)) {}

    std::vector<RoundedSolid> run(RoundingReport& report) {
        find_neighbours();
        for (std::uint32_t i = 0; i < parts_.size() && !stopped(); ++i) choose_radius(i);
        for (std::uint32_t i = 0; i < parts_.size() && !stopped(); ++i) extend(i);
        if (stopped()) return {};
        find_seams();
        // A solid that becomes sharp may open a seam to its neighbour, so the loop runs until no solid changes.
        for (bool changed = true; changed && !stopped();) {
            changed = false;
            for (const Seam& seam : seams_)
                if ((parts_[seam.one].rounded() || parts_[seam.other].rounded()) && is_open(seam))
                    for (const std::uint32_t part : {seam.one, seam.other}) changed = sharpen(part) || changed;
            for (std::uint32_t i = 0; i < parts_.size(); ++i)
                if (parts_[i].rounded() && !stopped()) changed = close_holes(i) || changed;
        }
        return result(report);
    }

private:
    static std::vector<Aabb> boxes_of(const Scene& scene) {
        std::vector<Aabb> boxes;
        for (const Solid& solid : scene.solids) boxes.push_back(solid.shape.bounds_m);
        return boxes;
    }
    const Solid& solid(std::uint32_t i) const { return scene_.solids[i]; }
    const ConvexSolid& shape(std::uint32_t i) const { return scene_.solids[i].shape; }

    // Returns the radius that is requested for this solid.
    double requested_m(std::uint32_t i) const {
        const std::optional<double>& own_hand_m = solid(i).edge_rounding_hand_m;
        return own_hand_m && own_.world_m_per_hand_m > 0.0
                   ? std::min(*own_hand_m * own_.world_m_per_hand_m, own_.most_m)
                   : radius_m_;
    }

    bool sharpen(std::uint32_t i) {
        if (!parts_[i].rounded()) return false;
        parts_[i].edges = Edges::AtSeam;
        return true;
    }

    // 1. Finds which solids touch, and the edges of each solid with the faces on both sides.
    void find_neighbours() {
        for (std::uint32_t i = 0; i < parts_.size(); ++i) {
            if (!is_touchable(solid(i))) continue;
            index_.find(grown(shape(i).bounds_m, touch_m_), parts_[i].near);
            std::erase_if(parts_[i].near, [&](std::uint32_t j) { return j == i || !is_touchable(solid(j)); });
            find_edges(i);
        }
    }

    void find_edges(std::uint32_t i) {
        const ConvexSolid& s = shape(i);
        for (std::uint32_t f = 0; f < s.faces.size(); ++f) {
            const std::vector<Vec3>& points = s.faces[f].points_m;
            for (std::size_t k = 0; k < points.size(); ++k) {
                const Vec3 &a = points[k], &b = points[(k + 1) % points.size()];
                Edge edge{a, b, f, f};
                double nearest = std::numeric_limits<double>::infinity();
                for (std::uint32_t g = 0; g < s.planes.size(); ++g) {
                    const double off =
                        std::max(std::abs(signed_distance(s.planes[g], a)), std::abs(signed_distance(s.planes[g], b)));
                    if (g == f || off >= nearest) continue;
                    nearest = off;
                    edge.beyond = g;
                }
                parts_[i].all_edges.push_back(edge);
            }
        }
    }

    // 2. Chooses how much each solid can be rounded.
    void choose_radius(std::uint32_t i) {
        Part& part = parts_[i];
        if (!is_touchable(solid(i)) || solid(i).soft) return;
        // If no face of a solid can be touched, it needs no rounding.
        if (std::find(solid(i).face_hidden.begin(), solid(i).face_hidden.end(), false) == solid(i).face_hidden.end())
            return;
        const double requested = requested_m(i);
        if (!(requested > 0.0)) return;
        part.radius_m = std::min(requested, kOfThickness * thickness_m(shape(i)));
        part.edges = Edges::TooThin;
        // Rounding must not make a face vanish. The bevelled faces of a solid leave less room than its thickness, so
        // the radius is halved until all faces remain or the radius is too small.
        for (; part.radius_m >= kLeastShare * requested; part.radius_m *= 0.5) {
            std::vector<Plane> inner = shape(i).planes;
            for (Plane& plane : inner) plane.offset_m -= part.radius_m;
            if (built(inner, i).faces.size() == inner.size()) {
                part.edges = Edges::Rounded;
                break;
            }
        }
    }

    // 3. Extends a solid through each wholly covered face into the solids that cover the face. The first attempt
    //    extends it by its own radius plus the distance by which those neighbours are rounded off. If the neighbours do
    //    not cover that extension, the second attempt uses the solid's own radius alone.
    void extend(std::uint32_t i) {
        Part& part = parts_[i];
        if (!part.rounded()) return;
        part.out_m.assign(shape(i).planes.size(), 0.0);
        std::vector<std::uint32_t> covers{i};
        for (const std::uint32_t j : part.near)
            if (!solid(j).soft && group(j) == group(i)) covers.push_back(j);
        for (const bool further : {true, false}) {
            std::vector<Plane> planes = shape(i).planes;
            bool any = false;
            for (std::uint32_t f = 0; f < planes.size(); ++f) {
                if (!solid(i).face_hidden[f]) continue;
                part.out_m[f] = part.radius_m + (further ? rounded_off_beyond_m(i, f) : 0.0);
                planes[f].offset_m += part.out_m[f];
                any = any || part.out_m[f] > 0.0;
            }
            cuts_left_ = kMostCuts;
            if (!any || covered(built(planes, i), covers, 0)) return;
        }
        part.edges = Edges::AtSeam;
    }

    // Returns how far the neighbours that touch `face` are rounded off there. A neighbour whose own touching face is
    // also wholly covered contributes 0.
    double rounded_off_beyond_m(std::uint32_t i, std::uint32_t face) const {
        double farthest = 0.0;
        for (const std::uint32_t j : parts_[i].near)
            for (std::uint32_t g = 0; g < shape(j).planes.size(); ++g) {
                if (solid(j).face_hidden[g] || !face_to_face(shape(i).planes[face], shape(j).planes[g])) continue;
                if (std::abs(signed_distance(shape(i).planes[face], shape(j).faces[g].points_m.front())) > touch_m_)
                    continue;
                farthest = std::max({farthest, parts_[i].radius_m, parts_[j].felt_radius_m()});
            }
        return farthest;
    }

    static bool face_to_face(const Plane& one, const Plane& other) {
        return glm::dot(one.normal, other.normal) < -1.0 + kFlush * kFlush;
    }

    // Returns the group of a solid, within which solids may cover each other. Each mover is a group by itself, because
    // it may move away from the building.
    std::uint32_t group(std::uint32_t i) const {
        return solid(i).role == SolidRole::Mover ? solid(i).feature.value : kNoFeature.value;
    }

    // Builds the solid behind these planes. It has no faces if the planes leave no space.
    ConvexSolid built(const std::vector<Plane>& planes, std::uint32_t near_solid) const {
        const Aabb& around = shape(near_solid).bounds_m;
        BuiltSolid made = solid_from_planes(planes, around.centre_m(),
                                            2.0 * glm::length(around.size_m()) + 8.0 * std::max(radius_m_, own_.most_m),
                                            {0.01 * touch_m_, 0.1 * touch_m_});
        if (made.fault != SolidFault::None || made.was_inside_out) return {};
        return std::move(made.solid);
    }

    template <class Condition>
    static bool all_corners(const ConvexSolid& piece, Condition&& holds) {
        return std::all_of(piece.faces.begin(), piece.faces.end(), [&](const Polygon& face) {
            return std::all_of(face.points_m.begin(), face.points_m.end(), holds);
        });
    }

    // Returns true if the whole of `piece` is inside the union of these solids, from index `next` on.
    bool covered(const ConvexSolid& piece, const std::vector<std::uint32_t>& solids, std::size_t next) {
        if (piece.faces.empty()) return true;
        for (std::size_t k = next; k < solids.size(); ++k)
            if (all_corners(piece, [&](const Vec3& p) { return contains(shape(solids[k]), p, touch_m_); })) return true;
        const auto apart = [&](std::uint32_t j) {
            if (!overlap(piece.bounds_m, shape(j).bounds_m)) return true;
            return std::any_of(shape(j).planes.begin(), shape(j).planes.end(), [&](const Plane& plane) {
                return all_corners(piece, [&](const Vec3& p) { return signed_distance(plane, p) >= -touch_m_; });
            });
        };
        while (next < solids.size() && apart(solids[next])) ++next;
        if (next == solids.size()) return false;
        ConvexSolid rest = piece;
        for (const Plane& plane : shape(solids[next]).planes) {
            if (all_corners(rest, [&](const Vec3& p) { return signed_distance(plane, p) <= touch_m_; })) continue;
            if (cuts_left_-- <= 0) return false;
            std::vector<Plane> planes = rest.planes;
            planes.push_back({-plane.normal, -plane.offset_m});
            if (!covered(built(planes, solids[next]), solids, next + 1)) return false;
            planes.back() = plane;
            rest = built(planes, solids[next]);
            if (rest.faces.empty()) return true;
        }
        return true;
    }

    // 4. Finds pairs of solids between which rounding may open a groove.
    struct Seam {
        std::uint32_t one, other;
        // The edges that run together; null: the solids share a face and stay flush only if both are sharp.
        const Edge *of_one, *of_other;
    };

    void find_seams() {
        std::vector<const Edge*> mine, theirs;
        for (std::uint32_t i = 0; i < parts_.size(); ++i)
            for (const std::uint32_t j : parts_[i].near) {
                if (j < i || !(parts_[i].rounded() || parts_[j].rounded())) continue;
                edges_within(i, shape(j).bounds_m, mine);
                edges_within(j, shape(i).bounds_m, theirs);
                for (const Edge* a : mine)
                    for (const Edge* b : theirs)
                        if (run_together(*a, *b)) seams_.push_back({i, j, a, b});
                if (share_a_face(i, j)) seams_.push_back({i, j, nullptr, nullptr});
            }
    }

    void edges_within(std::uint32_t i, const Aabb& box, std::vector<const Edge*>& edges) const {
        const Aabb around = grown(box, touch_m_);
        edges.clear();
        for (const Edge& edge : parts_[i].all_edges) {
            Aabb own;
            own.include(edge.from_m);
            own.include(edge.to_m);
            if (overlap(own, around)) edges.push_back(&edge);
        }
    }

    bool is_open(const Seam& seam) const {
        return !seam.of_one || opens_seam(seam.one, *seam.of_one, seam.other, *seam.of_other);
    }

    // Returns true if both edges are on the same line, in opposite directions, over more than a point.
    bool run_together(const Edge& a, const Edge& b) const {
        const Vec3 along = a.to_m - a.from_m, back = b.to_m - b.from_m;
        if (glm::dot(along, back) >= 0.0) return false;
        const double length = glm::length(along);
        const Vec3 unit = along / length;
        const auto off2 = [&](const Vec3& p) {
            const Vec3 from = p - a.from_m, side = from - unit * glm::dot(unit, from);
            return glm::dot(side, side);
        };
        if (off2(b.from_m) > touch_m_ * touch_m_ || off2(b.to_m) > touch_m_ * touch_m_) return false;
        return std::min(length, glm::dot(unit, b.from_m - a.from_m)) -
                   std::max(0.0, glm::dot(unit, b.to_m - a.from_m)) >
               10.0 * touch_m_;
    }

    bool opens_seam(std::uint32_t i, const Edge& a, std::uint32_t j, const Edge& b) const {
        const Plane &face_a = shape(i).planes[a.face], &face_b = shape(j).planes[b.face];
        const Plane &end_a = shape(i).planes[a.beyond], &end_b = shape(j).planes[b.beyond];
        // The solids touch each other with these two faces, so only the seam's other pair of faces can leave a groove.
        if (face_to_face(face_a, face_b)) return false;
        // The solids touch only along this line. A groove opens if both faces are flush with a wedge of air below, or
        // if neither solid is wholly in front of a face of the other.
        if (!face_to_face(end_a, end_b))
            return glm::dot(face_a.normal, face_b.normal) > 1.0 - kFlush * kFlush || !lies_beyond_a_face(i, j);
        const Vec3 onwards = end_a.normal - face_b.normal * glm::dot(end_a.normal, face_b.normal);
        const double rises = glm::dot(face_a.normal, onwards);
        if (rises > kFlush) return false;  // At an inner corner the proxy cannot enter the groove.
        if (rises < -kFlush) return true;  // At an outer edge between two solids, a groove would open.
        // Names and materials change exactly at the border, so neither solid may extend below the other's surface.
        const auto goes_on = [](const Part& part, const Edge& edge) {
            return part.rounded() && part.flat_beyond_m(edge.beyond) > 0.0;
        };
        if (!same_surface(i, a.face, j, b.face) && (goes_on(parts_[i], a) || goes_on(parts_[j], b))) return true;
        const double lean = glm::dot(face_a.normal, end_a.normal);
        const double overlap = parts_[i].flat_beyond_m(a.beyond) + parts_[j].flat_beyond_m(b.beyond) +
                               lean * (parts_[i].felt_radius_m() - parts_[j].felt_radius_m());
        return overlap < -touch_m_;
    }

    bool same_surface(std::uint32_t i, std::uint32_t f, std::uint32_t j, std::uint32_t g) const {
        return solid(i).face_materials[f] == solid(j).face_materials[g] &&
               solid(i).face_features[f] == solid(j).face_features[g];
    }

    // Returns true if one of the two solids is wholly in front of a face of the other.
    bool lies_beyond_a_face(std::uint32_t i, std::uint32_t j) const {
        const auto in_front = [this](const ConvexSolid& solid, const ConvexSolid& other) {
            return std::any_of(solid.planes.begin(), solid.planes.end(), [&](const Plane& plane) {
                return all_corners(other, [&](const Vec3& p) { return signed_distance(plane, p) >= -touch_m_; });
            });
        };
        return in_front(shape(i), shape(j)) || in_front(shape(j), shape(i));
    }

    // Returns true if the two solids have overlapping faces in one plane that face the same way.
    bool share_a_face(std::uint32_t i, std::uint32_t j) const {
        std::vector<Vec3> rest, scratch;
        for (std::uint32_t f = 0; f < shape(i).planes.size(); ++f)
            for (std::uint32_t g = 0; g < shape(j).planes.size(); ++g) {
                if (!in_one_plane(shape(i), f, shape(j), g)) continue;
                rest = shape(i).faces[f].points_m;
                for (std::uint32_t h = 0; h < shape(j).planes.size() && rest.size() >= 3; ++h)
                    if (h != g) keep_back(rest, shape(j).planes[h], touch_m_, scratch);
                tidy(rest, 10.0 * touch_m_);
                if (rest.size() >= 3) return true;
            }
        return false;
    }

    bool in_one_plane(const ConvexSolid& a, std::uint32_t f, const ConvexSolid& b, std::uint32_t g) const {
        return glm::dot(a.planes[f].normal, b.planes[g].normal) > 1.0 - kFlush * kFlush &&
               std::abs(signed_distance(a.planes[f], b.faces[g].points_m.front())) <= touch_m_;
    }

    // 5. Closes holes where the corners of several flush solids meet. Even if each seam is closed, a hole may remain
    //    between the solids, for example among four solids in a windmill pattern.
    bool close_holes(std::uint32_t i) {
        const ConvexSolid& s = shape(i);
        std::vector<SolidFace> here;
        for (std::uint32_t f = 0; f < s.faces.size(); ++f) {
            if (solid(i).face_hidden[f]) continue;
            for (const Vec3& corner : s.faces[f].points_m) {
                here.assign(1, {i, f});
                double widest = parts_[i].radius_m;
                for (const std::uint32_t j : parts_[i].near)
                    for (std::uint32_t g = 0; g < shape(j).faces.size(); ++g)
                        if (in_one_plane(s, f, shape(j), g) && contains(shape(j), corner, touch_m_)) {
                            here.push_back({j, g});
                            widest = std::max(widest, parts_[j].felt_radius_m());
                        }
                if (here.size() < 2 || !leaves_hole(corner, s.planes[f].normal, widest, here)) continue;
                bool changed = false;
                for (const SolidFace& one : here) changed = sharpen(one.solid) || changed;
                if (changed) return true;
            }
        }
        return false;
    }

    struct SolidFace {
        std::uint32_t solid, face;
    };

    // Returns true if rounding leaves a hole around the corner `at`. Samples points in the plane of the corner. Each
    // point on one of the original solids must be on the flat part of a rounded solid. Points near an edge of the whole
    // building are exempt, because rounding is expected there.
    bool leaves_hole(const Vec3& at, const Vec3& normal, double widest_m, const std::vector<SolidFace>& here) {
        constexpr int kWays = 12;
        const Vec3 u = any_perpendicular(normal), v = glm::cross(normal, u);
        for (int k = 0; k < 4 * kWays; ++k) {
            const double angle = 2.0 * kPi * (k + 0.37) / kWays, out = 0.35 * (k / kWays) * widest_m;
            const Vec3 p = at + (u * std::cos(angle) + v * std::sin(angle)) * out;
            const auto is_filed = [&](const SolidFace& one) { return contains(shape(one.solid), p, touch_m_); };
            const auto is_flat = [&](const SolidFace& one) {
                const Part& part = parts_[one.solid];
                const ConvexSolid& s = shape(one.solid);
                const Vec3 inside = p - s.planes[one.face].normal * part.felt_radius_m();
                for (std::uint32_t h = 0; h < s.planes.size(); ++h)
                    if (signed_distance(s.planes[h], inside) >
                        (h == one.face ? -part.felt_radius_m() : part.flat_beyond_m(h)) + touch_m_)
                        return false;
                return true;
            };
            if (std::any_of(here.begin(), here.end(), is_filed) && std::none_of(here.begin(), here.end(), is_flat) &&
                sphere_reaches(p, normal, 1.3 * widest_m))
                return true;
        }
        return false;
    }

    // Returns true if a ball that touches the surface at `p` from inside is wholly inside the building. The test uses
    // sample points on the ball.
    bool sphere_reaches(const Vec3& p, const Vec3& normal, double radius_m) {
        constexpr int kPlaces = 60;
        const Vec3 middle = p - normal * radius_m;
        index_.find(grown(Aabb{middle, middle}, radius_m), around_);
        for (int k = 0; k < kPlaces; ++k) {  // sample points along a spiral over the sphere
            const double z = 1.0 - 2.0 * (k + 0.5) / kPlaces, angle = 2.399963 * k, out = std::sqrt(1.0 - z * z);
            const Vec3 place = middle + Vec3(out * std::cos(angle), out * std::sin(angle), z) * (0.99 * radius_m);
            if (std::none_of(around_.begin(), around_.end(), [&](std::uint32_t j) {
                    return is_touchable(solid(j)) && contains(shape(j), place, touch_m_);
                }))
                return false;
        }
        return true;
    }

    std::vector<RoundedSolid> result(RoundingReport& report) const {
        report.radius_m = radius_m_;
        std::vector<RoundedSolid> out(parts_.size());
        for (std::uint32_t i = 0; i < parts_.size(); ++i) {
            const Part& part = parts_[i];
            out[i].planes = shape(i).planes;
            out[i].bounds_m = shape(i).bounds_m;
            if (part.edges == Edges::TooThin) note(i, report.too_thin, report.thin_names);
            if (part.edges == Edges::AtSeam) note(i, report.at_seams, report.seam_names);
            if (!part.rounded()) continue;
            ++report.rounded;
            if (part.radius_m < requested_m(i)) ++report.less;
            out[i].rounding_m = part.radius_m;
            for (std::size_t f = 0; f < part.out_m.size(); ++f) out[i].planes[f].offset_m += part.out_m[f];
            out[i].bounds_m = grown(out[i].bounds_m, *std::max_element(part.out_m.begin(), part.out_m.end()));
            if (const ConvexSolid whole = built(out[i].planes, i); !whole.faces.empty())
                out[i].bounds_m = whole.bounds_m;
        }
        return out;
    }

    void note(std::uint32_t i, std::size_t& count, std::vector<std::string>& names) const {
        ++count;
        FeatureId id = solid(i).feature;
        for (std::size_t f = 0; !id && f < solid(i).face_features.size(); ++f) id = solid(i).face_features[f];
        const std::string name = spoken_name(scene_, id);
        if (!name.empty() && names.size() < RoundingReport::kMostNames &&
            std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
    }

    bool stopped() const { return stop_.stop_requested(); }

    const Scene& scene_;
    std::stop_token stop_;
    double radius_m_;
    OwnRounding own_;
    double touch_m_;
    std::vector<Part> parts_;
    std::vector<Seam> seams_;
    BoxIndex index_;                     // spatial index of the solids' boxes
    std::vector<std::uint32_t> around_;  // scratch memory for query results
    int cuts_left_ = 0;
};

}  // namespace

RoundingReport& RoundingReport::operator+=(const RoundingReport& other) {
    radius_m = std::max(radius_m, other.radius_m);
    rounded += other.rounded;
    less += other.less;
    too_thin += other.too_thin;
    at_seams += other.at_seams;
    too_many = std::max(too_many, other.too_many);
    const auto join = [](std::vector<std::string>& names, const std::vector<std::string>& more) {
        for (const std::string& name : more)
            if (names.size() < kMostNames && std::find(names.begin(), names.end(), name) == names.end())
                names.push_back(name);
    };
    join(thin_names, other.thin_names);
    join(seam_names, other.seam_names);
    return *this;
}

std::vector<std::string> RoundingReport::sentences() const {
    std::vector<std::string> all;
    const auto stay = [&](std::size_t count, std::string_view says, const std::vector<std::string>& names) {
        if (count == 0) return;
        std::string listed;
        for (const std::string& name : names) listed += (listed.empty() ? "" : ", ") + name;
        all.push_back(phrase(says, {{"n", count},
                                    {"names", listed},
                                    {"listed", names.empty()          ? "none"
                                               : count > names.size() ? "some"
                                                                      : "all"}}));
    };
    if (rounded > 0) all.push_back(phrase("compile.rounded", {{"n", rounded}, {"radius", radius_m}, {"less", less}}));
    if (too_many > 0) all.push_back(phrase("compile.too_many", {{"n", too_many}, {"most", kMostRounded}}));
    stay(too_thin, "compile.too_thin", thin_names);
    stay(at_seams, "compile.at_seams", seam_names);
    return all;
}

double edge_rounding_m(double rounding_hand_mm, double world_m_per_hand_m) {
    contract_pre(rounding_hand_mm >= 0.0);
    contract_pre(world_m_per_hand_m > 0.0);
    constexpr double kDetails = 30.0;
    return world_m_per_hand_m < kDetails ? 0.0 : rounding_hand_mm * 1e-3 * world_m_per_hand_m;
}

bool has_own_rounding(const Scene& scene) {
    return std::any_of(scene.solids.begin(), scene.solids.end(),
                       [](const Solid& solid) { return solid.edge_rounding_hand_m.has_value(); }) ||
           std::any_of(scene.placed.begin(), scene.placed.end(),
                       [](const PlacedModel& placed) { return has_own_rounding(*placed.model); });
}

std::vector<RoundedSolid> round_edges(const Scene& scene, double radius_m, RoundingReport& report,
                                      const std::stop_token& stop, const OwnRounding& own) {
    contract_pre(radius_m >= 0.0 && std::isfinite(radius_m));
    if (scene.solids.size() > RoundingReport::kMostRounded) {
        report.too_many = scene.solids.size();
        return {};
    }
    return Rounder(scene, radius_m, own, stop).run(report);
}

}  // namespace handrail::compile
