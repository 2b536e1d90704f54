#include "worlds/readers/mesh_bodies.h"

#include <algorithm>

#include "worlds/geometry/box_index.h"
#include "worlds/geometry/clip.h"

namespace handrail::readers {
namespace {

constexpr double kBarelyIn_m = 1e-4;
constexpr std::size_t kMostBodySolids = 20'000;
// Greatest number of triangles tested to find which shells are inside which.
constexpr std::size_t kMostLooks = 50'000'000;
// Greatest number of faces tested to fill bodies, which takes some seconds.
constexpr std::size_t kMostFilling = 1'000'000'000;

struct ShellPlace {
    std::size_t piece = 0;
    MeshShell shell;
    bool is_body = false;
    // For a shell that faces inwards: index of the shell of its body. If it belongs to no body, its own index.
    std::size_t hollow_of = 0;
};

class BodySorter {
public:
    BodySorter(std::span<const MeshPiece> meshes, const std::stop_token& stop) : meshes_(meshes), stop_(stop) {
        for (std::size_t i = 0; i < meshes.size() && !stop.stop_requested(); ++i)
            for (MeshShell& shell : shells_of(meshes[i].points_m, meshes[i].triangles)) {
                boxes_.push_back(shell.box);
                shells_.push_back({i, std::move(shell), false, shells_.size()});
            }
    }

    MeshBodies sort() {
        const BoxIndex index(boxes_);
        for (ShellPlace& place : shells_) place.is_body = place.shell.closed && place.shell.volume_m3 > 0.0;
        find_hollows(index);
        for (std::size_t s = 0; s < shells_.size() && !stop_.stop_requested(); ++s)
            if (shells_[s].is_body && holds_others(s, index)) holders_.push_back(s);
        for (const std::size_t s : holders_) shells_[s].is_body = false;
        MeshBodies made;
        made.rest.resize(meshes_.size());
        std::size_t solids = 0;
        for (std::size_t s = 0; s < shells_.size() && !stop_.stop_requested(); ++s) {
            const ShellPlace& place = shells_[s];
            const bool in_a_body = place.hollow_of != s && shells_[place.hollow_of].is_body;
            if (in_a_body || (place.is_body && add_body(s, solids, made))) continue;
            std::vector<std::uint32_t>& rest = made.rest[place.piece];
            rest.insert(rest.end(), place.shell.triangles.begin(), place.shell.triangles.end());
        }
        for (std::vector<std::uint32_t>& rest : made.rest) std::sort(rest.begin(), rest.end());
        return made;
    }

private:
    bool lies_in(const Aabb& inner, const Aabb& outer) const {
        const Aabb reach = grown(outer, kBarelyIn_m);
        return glm::all(glm::greaterThanEqual(inner.min_m, reach.min_m)) &&
               glm::all(glm::lessThanEqual(inner.max_m, reach.max_m));
    }

    // True if the place at_m is inside the shell `s`. Always false after kMostLooks triangles have been tested.
    bool around(std::size_t s, const Vec3& at_m) {
        const ShellPlace& place = shells_[s];
        looks_ += place.shell.triangles.size();
        if (looks_ > kMostLooks) return false;
        const MeshPiece& mesh = meshes_[place.piece];
        return times_around(mesh.points_m, mesh.triangles, place.shell.triangles, at_m) > 0;
    }
    Vec3 a_corner(std::size_t s) const {
        const MeshPiece& mesh = meshes_[shells_[s].piece];
        return mesh.points_m[mesh.triangles[shells_[s].shell.triangles.front()][0]];
    }

    // Assigns each closed shell that faces inwards to the smallest shell of its mesh that surrounds it.
    void find_hollows(const BoxIndex& index) {
        hollows_.resize(shells_.size());
        for (std::size_t s = 0; s < shells_.size() && !stop_.stop_requested(); ++s) {
            if (!shells_[s].shell.closed || shells_[s].shell.volume_m3 >= 0.0) continue;
            index.find(boxes_[s], near_);
            for (const std::uint32_t other : near_) {
                if (!shells_[other].is_body || shells_[other].piece != shells_[s].piece ||
                    !lies_in(boxes_[s], boxes_[other]) || shells_[other].shell.volume_m3 <= -shells_[s].shell.volume_m3)
                    continue;
                const std::size_t best = shells_[s].hollow_of;
                if (best != s && shells_[best].shell.volume_m3 <= shells_[other].shell.volume_m3) continue;
                if (around(other, a_corner(s))) shells_[s].hollow_of = other;
            }
            if (shells_[s].hollow_of != s) hollows_[shells_[s].hollow_of].push_back(s);
        }
    }

    // True if the shell contains another shell: the box of the other shell is within its box, and the middle of that
    // box is inside the shell.
    bool holds_others(std::size_t s, const BoxIndex& index) {
        index.find(boxes_[s], near_);
        const std::vector<std::uint32_t> near = near_;
        for (const std::uint32_t other : near) {
            if (other == s || shells_[other].hollow_of == s || !lies_in(boxes_[other], boxes_[s])) continue;
            const Vec3 middle = boxes_[other].centre_m();
            if (!around(s, middle)) continue;
            if (std::none_of(hollows_[s].begin(), hollows_[s].end(), [&](std::size_t hollow) {
                    const MeshPiece& mesh = meshes_[shells_[hollow].piece];
                    return times_around(mesh.points_m, mesh.triangles, shells_[hollow].shell.triangles, middle) < 0;
                }))
                return true;
        }
        return false;
    }

    // Adds the shell as a body. Returns false if the shell turns out not to be a body.
    bool add_body(std::size_t s, std::size_t& solids, MeshBodies& made) {
        const ShellPlace& place = shells_[s];
        const MeshPiece& mesh = meshes_[place.piece];
        MeshBody body{place.piece, place.shell.triangles, boxes_[s], {}};
        for (const std::size_t hollow : hollows_[s])
            body.triangles.insert(body.triangles.end(), shells_[hollow].shell.triangles.begin(),
                                  shells_[hollow].shell.triangles.end());
        FillLimits limits;
        limits.looks_left = &filling_left_;
        limits.most_solids = std::min(limits.most_solids, kMostBodySolids - std::min(solids, kMostBodySolids));
        if (auto filled = solids_within(mesh.points_m, mesh.triangles, body.triangles, limits, stop_))
            body.solids = std::move(*filled);
        // If the mesh is a single convex shell, it may be a room to stand in, so it is not a body.
        const bool alone = shells_.size() == 1;
        if (alone && (body.solids.size() == 1 || (body.solids.empty() && goes_out_all_round(s)))) return false;
        const Vec3 size = boxes_[s].size_m();
        // The piece is a sheet that the file gives twice, once for each side.
        if (std::min({size.x, size.y, size.z}) < kBarelyIn_m) return false;
        solids += body.solids.size();
        made.bodies.push_back(std::move(body));
        return true;
    }

    // True if the shell is convex, that is, if all corners are behind all faces. The test is used for shells with too
    // many faces to be filled. Tests at most 1000 faces.
    bool goes_out_all_round(std::size_t s) const {
        const MeshPiece& mesh = meshes_[shells_[s].piece];
        const std::vector<std::uint32_t>& all = shells_[s].shell.triangles;
        const Vec3 size = boxes_[s].size_m();
        const double slack_m = 1e-3 * std::max({size.x, size.y, size.z});
        for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / 1000) {
            const auto& [a, b, c] = mesh.triangles[all[i]];
            const Vec3 area = glm::cross(mesh.points_m[b] - mesh.points_m[a], mesh.points_m[c] - mesh.points_m[a]);
            const double length = glm::length(area);
            if (!(length > 1e-12)) continue;
            for (const std::uint32_t t : all)
                for (const std::uint32_t corner : mesh.triangles[t])
                    if (glm::dot(area / length, mesh.points_m[corner] - mesh.points_m[a]) > slack_m) return false;
        }
        return true;
    }

    std::span<const MeshPiece> meshes_;
    std::stop_token stop_;
    std::vector<ShellPlace> shells_;
    std::vector<Aabb> boxes_;
    std::vector<std::vector<std::size_t>> hollows_;  // indexed by shell: the shells of its hollows
    std::vector<std::size_t> holders_;
    std::vector<std::uint32_t> near_;
    std::size_t looks_ = 0, filling_left_ = kMostFilling;
};

}  // namespace

MeshBodies mesh_bodies(std::span<const MeshPiece> meshes, const std::stop_token& stop) {
    return BodySorter(meshes, stop).sort();
}

}  // namespace handrail::readers
