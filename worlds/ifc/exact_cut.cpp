#include "worlds/ifc/exact_cut.h"

// Without this definition, every program that links this file would check at its start that the processor can round up
// and down. That check fails under Valgrind, which does not support such rounding. The check is not needed, because the
// tests compare volumes.
#define CGAL_DISABLE_ROUNDING_MATH_CHECK
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <map>

#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"
#include "worlds/geometry/closed_mesh.h"
#include "worlds/geometry/mass_properties.h"

namespace handrail::ifc {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Grid steps per metre. The number is a power of two, so that corners on the grid are exact and have short numbers.
constexpr double kGrid = 1048576.0;
constexpr double kOnEdge_m = 2e-6;  // a corner this close to an edge is inserted into that edge

struct Refused {};

void count(ExactLimits& limits, std::size_t steps, const std::stop_token& stop) {
    if (limits.steps_left < steps || stop.stop_requested()) throw Refused{};
    limits.steps_left -= steps;
}

// CGAL calls this visitor at each step. The visitor stops CGAL with an exception when a limit is reached.
struct Counter : pmp::Corefinement::Default_visitor<Mesh> {
    ExactLimits* limits = nullptr;
    std::stop_token stop;

    void step() const { count(*limits, 1, stop); }
    void intersection_point_detected(std::size_t, int, Mesh::Halfedge_index, Mesh::Halfedge_index, const Mesh&,
                                     const Mesh&, bool, bool) const {
        step();
    }
    void edge_face_intersections_step() const { step(); }
    void intersection_of_coplanar_faces_step() const { step(); }
    void triangulating_faces_step() const { step(); }
    void after_subface_created(Mesh::Face_index, Mesh&) const { step(); }
};

// While it exists, failed CGAL checks throw without a message on standard error, because such messages would help
// nobody.
class QuietChecks {
public:
    QuietChecks() : before_(CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {})) {}
    ~QuietChecks() { CGAL::set_error_handler(before_); }
    QuietChecks(const QuietChecks&) = delete;
    QuietChecks& operator=(const QuietChecks&) = delete;

private:
    CGAL::Failure_function before_;
};

struct Less {
    bool operator()(const Vec3& a, const Vec3& b) const { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }
};

// Polygons whose corners are indices of points. Two neighbours share both corners of their common edge.
struct Soup {
    std::vector<Vec3> points_m;
    std::vector<std::vector<std::size_t>> polygons;
};

Soup soup_of(const std::vector<Polygon>& polygons) {
    Soup soup;
    std::map<Vec3, std::size_t, Less> numbers;
    for (const Polygon& polygon : polygons) {
        std::vector<std::size_t> corners;
        for (const Vec3& p : polygon.points_m) {
            if (!is_finite(p) || glm::length(p) > kFarthestPart_m) throw Refused{};
            const Vec3 on_grid = glm::round(p * kGrid) / kGrid + Vec3(0.0);  // adding 0.0 turns -0 into 0
            const auto [found, is_new] = numbers.try_emplace(on_grid, soup.points_m.size());
            if (is_new) soup.points_m.push_back(on_grid);
            if (corners.empty() || corners.back() != found->second) corners.push_back(found->second);
        }
        while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
        if (corners.size() >= 3) soup.polygons.push_back(std::move(corners));
    }
    return soup;
}

// Inserts each corner that is on the edge of another polygon into that edge. Such corners exist because faces were cut
// into convex parts without regard to their neighbours.
void share_corners(Soup& soup, ExactLimits& limits, const std::stop_token& stop) {
    std::vector<Aabb> boxes;
    for (const Vec3& p : soup.points_m) boxes.push_back({p, p});
    const BoxIndex index(boxes);
    std::vector<std::uint32_t> near;
    for (std::vector<std::size_t>& polygon : soup.polygons) {
        std::vector<std::size_t> whole;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const std::size_t from = polygon[i], to = polygon[(i + 1) % polygon.size()];
            const Vec3 &a = soup.points_m[from], way = soup.points_m[to] - a;
            const double length_m = glm::length(way);
            Aabb box;
            box.include(a);
            box.include(a + way);
            index.find(grown(box, kOnEdge_m), near);
            count(limits, near.size(), stop);
            std::vector<std::pair<double, std::size_t>> between;
            for (const std::uint32_t p : near) {
                const double at = glm::dot(soup.points_m[p] - a, way) / length_m;
                if (p == from || p == to || at <= 0.0 || at >= length_m) continue;
                if (glm::length(soup.points_m[p] - a - way * (at / length_m)) <= kOnEdge_m) between.emplace_back(at, p);
            }
            std::sort(between.begin(), between.end());
            whole.push_back(from);
            for (const auto& [at, p] : between) whole.push_back(p);
        }
        polygon = std::move(whole);
    }
}

// Divides polygons into triangles. A polygon with collinear corners is divided around its centre, so that no triangle
// is degenerate.
void cut_into_triangles(Soup& soup) {
    std::vector<std::vector<std::size_t>> triangles;
    for (const std::vector<std::size_t>& polygon : soup.polygons) {
        const std::size_t n = polygon.size();
        const auto corner = [&](std::size_t i) { return soup.points_m[polygon[i % n]]; };
        bool bent = true;
        for (std::size_t i = 0; i < n; ++i)
            bent = bent && glm::length(glm::cross(corner(i + 1) - corner(i), corner(i + 2) - corner(i + 1))) > 1e-6;
        if (n == 3 || (n == 4 && bent)) {
            for (std::size_t i = 1; i + 1 < n; ++i) triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
            continue;
        }
        Vec3 middle(0.0);
        for (std::size_t i = 0; i < n; ++i) middle += corner(i) / static_cast<double>(n);
        soup.points_m.push_back(glm::round(middle * kGrid) / kGrid + Vec3(0.0));
        for (std::size_t i = 0; i < n; ++i)
            triangles.push_back({polygon[i], polygon[(i + 1) % n], soup.points_m.size() - 1});
    }
    soup.polygons = std::move(triangles);
}

// Adds the number of pairs of nearby triangles of two meshes to the steps, because each pair costs time whatever the
// result is.
void count_pairs(const std::vector<Aabb>& some, const std::vector<Aabb>& others, ExactLimits& limits,
                 const std::stop_token& stop) {
    const BoxIndex index(others);
    std::vector<std::uint32_t> near;
    for (const Aabb& box : some) {
        index.find(box, near);
        count(limits, near.size(), stop);
    }
}

struct Piece {
    Mesh mesh;
    Aabb box;
    std::vector<Aabb> boxes;  // boxes of the triangles before any cut
};

Piece piece_of(const std::vector<Polygon>& polygons, ExactLimits& limits, const std::stop_token& stop) {
    Soup soup = soup_of(polygons);
    share_corners(soup, limits, stop);
    cut_into_triangles(soup);
    if (soup.polygons.size() < 4 || soup.polygons.size() > limits.most_triangles) throw Refused{};
    Piece piece;
    std::vector<Kernel::Point_3> points;
    for (const Vec3& p : soup.points_m) points.emplace_back(p.x, p.y, p.z), piece.box.include(p);
    for (const std::vector<std::size_t>& triangle : soup.polygons) {
        Aabb box;
        for (const std::size_t corner : triangle) box.include(soup.points_m[corner]);
        piece.boxes.push_back(box);
    }
    count_pairs(piece.boxes, piece.boxes, limits, stop);
    if (!pmp::orient_polygon_soup(points, soup.polygons) || !pmp::is_polygon_soup_a_polygon_mesh(soup.polygons))
        throw Refused{};
    pmp::polygon_soup_to_polygon_mesh(points, soup.polygons, piece.mesh);
    if (!CGAL::is_closed(piece.mesh) || pmp::does_self_intersect(piece.mesh)) throw Refused{};
    pmp::orient_to_bound_a_volume(piece.mesh);
    return piece;
}

std::vector<Piece> pieces_of(const Body& body, ExactLimits& limits, const std::stop_token& stop) {
    std::vector<Piece> pieces;
    for (const ConvexSolid& solid : body.solids) pieces.push_back(piece_of(solid.faces, limits, stop));
    if (!body.sheets.empty()) pieces.push_back(piece_of(body.sheets, limits, stop));
    return pieces;
}

// Finds whether points are inside a mesh, and the outward direction of its surface at points on the surface.
class Inside {
public:
    explicit Inside(const Mesh& mesh) : mesh_(mesh), tree_(faces(mesh).begin(), faces(mesh).end(), mesh), side_(tree_) {
        tree_.build();
    }
    CGAL::Bounded_side operator()(const Kernel::Point_3& at) const { return side_(at); }
    Kernel::Vector_3 way_out_at(const Kernel::Point_3& on_surface) const {
        const auto face = tree_.any_intersected_primitive(on_surface);
        return face ? normal_of(mesh_, *face) : Kernel::Vector_3(CGAL::NULL_VECTOR);
    }
    static std::array<Kernel::Point_3, 3> corners_of(const Mesh& mesh, Mesh::Face_index face) {
        const Mesh::Halfedge_index h = mesh.halfedge(face);
        return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)), mesh.point(mesh.target(mesh.next(h)))};
    }
    static Kernel::Vector_3 normal_of(const Mesh& mesh, Mesh::Face_index face) {
        const auto [a, b, c] = corners_of(mesh, face);
        return CGAL::cross_product(b - a, c - a);
    }

private:
    using Side = CGAL::Side_of_triangle_mesh<Mesh, Kernel>;
    const Mesh& mesh_;
    Side::AABB_tree tree_;
    Side side_;
};

struct ExactSoup {
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> triangles;
};

// Combines two meshes. CGAL only splits both along the lines where they intersect; this function then chooses the faces
// to keep. CGAL's own choice requires a result that is a manifold, so it refuses solids that merely touch. Moreover,
// version 5.5 may never end on some of these solids.
ExactSoup combined(const Mesh& a, const Mesh& b, ExactCut kind, ExactLimits& limits, const std::stop_token& stop) {
    constexpr std::size_t kStepsForPlace = 10;
    Mesh first = a, second = b;
    Counter counter;
    counter.limits = &limits;
    counter.stop = stop;
    pmp::corefine(first, second, CGAL::parameters::visitor(counter));
    const Inside in_first(a), in_second(b);
    ExactSoup soup;
    std::map<Kernel::Point_3, std::size_t> numbers;
    const auto keep = [&](const Mesh& mesh, Mesh::Face_index face, bool turned) {
        std::vector<std::size_t> triangle;
        for (const Kernel::Point_3& p : Inside::corners_of(mesh, face)) {
            const auto [found, is_new] = numbers.try_emplace(p, soup.points.size());
            if (is_new) soup.points.push_back(p);
            triangle.push_back(found->second);
        }
        if (turned) std::swap(triangle[1], triangle[2]);
        soup.triangles.push_back(std::move(triangle));
    };
    const auto place_of = [&](const Mesh& mesh, Mesh::Face_index face) {
        count(limits, kStepsForPlace, stop);
        const auto [p, q, r] = Inside::corners_of(mesh, face);
        return CGAL::centroid(p, q, r);
    };
    for (const Mesh::Face_index face : first.faces()) {
        const Kernel::Point_3 at = place_of(first, face);
        const CGAL::Bounded_side side = in_second(at);
        const CGAL::Bounded_side wanted = kind == ExactCut::TakeAway ? CGAL::ON_UNBOUNDED_SIDE : CGAL::ON_BOUNDED_SIDE;
        if (side == CGAL::ON_BOUNDARY) {
            const bool alike = Inside::normal_of(first, face) * in_second.way_out_at(at) > 0;
            if (alike == (kind == ExactCut::KeepWithin)) keep(first, face, false);
        } else if (side == wanted) {
            keep(first, face, false);
        }
    }
    for (const Mesh::Face_index face : second.faces())
        if (in_first(place_of(second, face)) == CGAL::ON_BOUNDED_SIDE) keep(second, face, kind == ExactCut::TakeAway);
    return soup;
}

Mesh mesh_of(ExactSoup soup) {
    Mesh mesh;
    pmp::orient_polygon_soup(soup.points, soup.triangles);  // splits edges at which more than two triangles meet
    pmp::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
    return mesh;
}

// Returns true for a film thinner than a flush contact. Such a film remains if two faces were meant to be in the same
// plane but differ in their last digits.
bool is_film(const ConvexSolid& solid) {
    double largest_m2 = 0.0;
    for (const Polygon& face : solid.faces) largest_m2 = std::max(largest_m2, area_m2(face.points_m));
    return mass_properties(solid).volume_m3 < kFlush_m * largest_m2;
}

// Rounds the exact coordinates to double and turns the result into a body.
Body body_of(const ExactSoup& soup, ExactLimits& limits, const std::stop_token& stop) {
    std::vector<Vec3> points;
    for (const Kernel::Point_3& p : soup.points)
        points.emplace_back(CGAL::to_double(CGAL::exact(p.x())), CGAL::to_double(CGAL::exact(p.y())),
                            CGAL::to_double(CGAL::exact(p.z())));
    std::vector<MeshCorners> triangles;
    for (const std::vector<std::size_t>& triangle : soup.triangles)
        triangles.push_back({static_cast<std::uint32_t>(triangle[0]), static_cast<std::uint32_t>(triangle[1]),
                             static_cast<std::uint32_t>(triangle[2])});
    if (triangles.empty()) return {};
    std::vector<std::uint32_t> all(triangles.size());
    for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
    FillLimits fill_limits;
    fill_limits.most_triangles = limits.most_triangles;
    std::size_t looks = std::min<std::size_t>(limits.looks_left, 20'000'000);
    limits.looks_left -= looks;
    fill_limits.looks_left = &looks;
    std::optional<std::vector<ConvexSolid>> solids = solids_within(points, triangles, all, fill_limits, stop);
    limits.looks_left += looks;
    Body body;
    if (solids) {
        std::erase_if(*solids, is_film);
        body.solids = std::move(*solids);
        return body;
    }
    for (const MeshCorners& corners : triangles) {
        Polygon sheet{{points[corners[0]], points[corners[1]], points[corners[2]]}};
        if (area_m2(sheet.points_m) > 1e-10) body.sheets.push_back(std::move(sheet));
    }
    return body;
}

Body cut(const Body& body, const std::vector<Piece>& by, ExactCut kind, ExactLimits& limits,
         const std::stop_token& stop) {
    Body result;
    const auto cut_piece = [&](const std::vector<Polygon>& polygons, const Aabb& box, Body whole) {
        std::vector<const Piece*> near;
        for (const Piece& other : by)
            if (overlap(other.box, box)) near.push_back(&other);
        if (near.empty()) return kind == ExactCut::TakeAway ? result.add(std::move(whole)) : void();
        const Piece piece = piece_of(polygons, limits, stop);
        Mesh left = piece.mesh;
        ExactSoup soup;
        for (const Piece* const other : near) {
            count_pairs(piece.boxes, other->boxes, limits, stop);
            soup = combined(left, other->mesh, kind, limits, stop);
            if (kind == ExactCut::KeepWithin) result.add(body_of(soup, limits, stop));
            else if (soup.triangles.empty()) return;
            else if (other != near.back()) left = mesh_of(soup);
        }
        if (kind == ExactCut::TakeAway) result.add(body_of(soup, limits, stop));
    };
    for (const ConvexSolid& solid : body.solids) cut_piece(solid.faces, solid.bounds_m, {{solid}, {}});
    if (!body.sheets.empty()) {
        Aabb box;
        for (const Polygon& sheet : body.sheets) box.include(bounds_of(sheet));
        cut_piece(body.sheets, box, {{}, body.sheets});
    }
    return result;
}

}  // namespace

std::optional<Body> cut_exactly(const Body& body, const Body& by, ExactCut kind, ExactLimits& limits,
                                const std::stop_token& stop) {
    const QuietChecks quiet;
    try {
        return cut(body, pieces_of(by, limits, stop), kind, limits, stop);
    } catch (const Refused&) {
        return std::nullopt;
    } catch (const std::logic_error&) {  // a check of CGAL failed, for example because the result is not a surface
        return std::nullopt;
    }
}

}  // namespace handrail::ifc
