#include "haptic/compile/simplify_mesh.h"

// Disables the warnings that OpenMesh's headers trigger.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wextra"
#pragma GCC diagnostic ignored "-Wall"
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>
#pragma GCC diagnostic pop

#include <algorithm>
#include <cmath>

#include "worlds/base/contract.h"
#include "worlds/geometry/bvh.h"
#include "worlds/geometry/closest_point.h"

namespace handrail::compile {
namespace {

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

// Ends the edge collapses when another thread requests a stop.
class StopObserver final : public OpenMesh::Decimater::Observer {
public:
    explicit StopObserver(const std::stop_token& stop) : Observer(kCollapses), stop_(stop) {}
    void notify(std::size_t /*collapses*/) override {}
    bool abort() const override { return stop_.stop_requested(); }

private:
    static constexpr std::size_t kCollapses = 64;  // collapses between two checks for a stop request
    const std::stop_token& stop_;
};

SimplifiedMesh collapsed(const TriangleMesh& mesh, const std::vector<bool>& fixed, double bound_m,
                         const std::stop_token& stop) {
    // Disables OpenMesh's error stream, on which it prints a message for each triangle that does not fit its half-edge
    // structure. The result already contains this information. The stream is never enabled again, because all threads
    // share it.
    [[maybe_unused]] static const bool kQuiet = (omerr().disable(), true);
    HalfEdgeMesh half;
    half.request_vertex_status();
    half.request_edge_status();
    half.request_halfedge_status();
    half.request_face_status();
    half.request_face_normals();
    std::vector<HalfEdgeMesh::VertexHandle> points;
    points.reserve(mesh.points_m.size());
    for (const Vec3& p : mesh.points_m) points.push_back(half.add_vertex({p.x, p.y, p.z}));
    SimplifiedMesh out;
    std::vector<bool> locked = fixed;
    locked.resize(points.size(), false);
    for (const Corners& c : mesh.triangles) {
        const bool three = c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
        if (three && half.add_face(points[c[0]], points[c[1]], points[c[2]]).is_valid()) continue;
        for (const std::uint32_t corner : c) locked[corner] = true;
        out.mesh.triangles.push_back(c);
    }
    for (std::size_t i = 0; i < points.size(); ++i)
        if (locked[i]) half.status(points[i]).set_locked(true);
    half.update_face_normals();
    OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater(half);
    OpenMesh::Decimater::ModHausdorffT<HalfEdgeMesh>::Handle hausdorff;
    OpenMesh::Decimater::ModNormalFlippingT<HalfEdgeMesh>::Handle flipping;
    OpenMesh::Decimater::ModQuadricT<HalfEdgeMesh>::Handle quadric;
    decimater.add(quadric);
    decimater.add(hausdorff);
    decimater.add(flipping);
    decimater.module(quadric).unset_max_err();
    decimater.module(hausdorff).set_tolerance(bound_m);
    decimater.module(flipping).set_max_normal_deviation(60.0);
    StopObserver observer(stop);
    decimater.set_observer(&observer);
    if (decimater.initialize()) decimater.decimate();

    // Points keep their indices. Removed points stay in the list but no triangle uses them.
    out.mesh.points_m = mesh.points_m;
    for (const auto face : half.faces()) {  // skips the deleted faces
        Corners c{};
        std::size_t k = 0;
        for (const auto vertex : half.fv_range(face)) c[k++] = static_cast<std::uint32_t>(vertex.idx());
        out.mesh.triangles.push_back(c);
    }
    return out;
}

}  // namespace

double measured_distance(const TriangleMesh& a, const TriangleMesh& b, double spacing_m, const std::stop_token& stop) {
    contract_pre(spacing_m > 0.0);
    constexpr double kMostSteps = 2000.0;
    std::vector<TriangleShape> shapes;
    std::vector<Aabb> boxes;
    for (const Corners& t : b.triangles) {
        shapes.push_back(make_triangle(b.points_m[t[0]], b.points_m[t[1]], b.points_m[t[2]]));
        Aabb& box = boxes.emplace_back();
        for (const std::uint32_t corner : t) box.include(b.points_m[corner]);
    }
    const Bvh bvh(boxes);
    double farthest = 0.0;
    std::uint32_t last = 0;  // index of the nearest triangle of b; the next sample of a is probably near it too
    for (const Corners& t : a.triangles) {
        if (stop.stop_requested()) return farthest;
        const Vec3 p = a.points_m[t[0]], q = a.points_m[t[1]], r = a.points_m[t[2]];
        const double longest = std::max({glm::length(q - p), glm::length(r - q), glm::length(p - r)});
        const int steps = static_cast<int>(std::clamp(std::ceil(longest / spacing_m), 1.0, kMostSteps));
        for (int i = 0; i <= steps; ++i)
            for (int k = 0; i + k <= steps; ++k) {
                const Vec3 at =
                    p + (q - p) * (static_cast<double>(i) / steps) + (r - p) * (static_cast<double>(k) / steps);
                double nearest = closest_point(shapes[last], at).distance_m;
                if (nearest <= farthest) continue;
                bvh.within(at, nearest, [&](std::uint32_t item, double& reach) {
                    const double distance = closest_point(shapes[item], at).distance_m;
                    if (distance >= nearest) return;
                    nearest = reach = distance;
                    last = item;
                });
                farthest = std::max(farthest, nearest);
            }
    }
    return farthest;
}

SimplifiedMesh simplify_mesh(const TriangleMesh& mesh, const std::vector<bool>& fixed, double bound_m,
                             const std::stop_token& stop) {
    contract_pre(fixed.empty() || fixed.size() == mesh.points_m.size());
    contract_pre(bound_m >= 0.0);
    SimplifiedMesh as_it_was{mesh, 0.0, bound_m};
    if (mesh.triangles.empty()) return as_it_was;
    constexpr int kTries = 6;
    constexpr double kMostSamples = 2e6;
    double area = 0.0;
    for (const Corners& t : mesh.triangles)
        area += 0.5 * glm::length(glm::cross(mesh.points_m[t[1]] - mesh.points_m[t[0]],
                                             mesh.points_m[t[2]] - mesh.points_m[t[0]]));
    const double spacing_m = std::max(bound_m, std::sqrt(area / kMostSamples));
    double allowed = bound_m;
    for (int i = 0; i < kTries;
         // Collapses are checked only at corners, but faces may be up to a third farther from the original. If that
         // exceeds the bound, the next attempt allows three quarters of the distance.
         ++i, allowed *= 0.75) {
        SimplifiedMesh coarse = collapsed(mesh, fixed, allowed, stop);
        if (stop.stop_requested()) return as_it_was;
        if (coarse.mesh.triangles.size() >= mesh.triangles.size() || coarse.mesh.triangles.empty()) return as_it_was;
        coarse.spacing_m = spacing_m;
        coarse.measured_m = std::max(measured_distance(coarse.mesh, mesh, coarse.spacing_m, stop),
                                     measured_distance(mesh, coarse.mesh, coarse.spacing_m, stop));
        if (stop.stop_requested()) return as_it_was;
        if (coarse.measured_m <= bound_m) return coarse;
    }
    return as_it_was;
}

}  // namespace handrail::compile
