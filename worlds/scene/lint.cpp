#include "worlds/scene/lint.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "worlds/base/language.h"

namespace handrail {
namespace {

double ratio(double a, double b) {
    const double low = std::min(a, b), high = std::max(a, b);
    return low > 0.0 ? high / low : high > 0.0 ? 1e9 : 1.0;
}

bool reaches(double a, double b, double least) { return ratio(a, b) >= least * (1.0 - 1e-9); }

bool textures_differ(const Finish& a, const Finish& b) {
    if (a.picture != b.picture) return true;
    const bool a_wave = a.wave.depth_hand_m > 0.0 && a.wave.shape != WaveShape::Level,
               b_wave = b.wave.depth_hand_m > 0.0 && b.wave.shape != WaveShape::Level;
    if (a_wave != b_wave) return true;
    return a_wave && reaches(a.wave.period_hand_m, b.wave.period_hand_m, kPeriodApart);
}

// Suggests a change that makes the two materials differ: a still softer surface for the softer one, or more friction
// for the rougher one.
std::string advice(const Finish& a, const Finish& b) {
    const Finish& soft = a.stiffness_fraction <= b.stiffness_fraction ? a : b;
    const Finish& hard = a.stiffness_fraction <= b.stiffness_fraction ? b : a;
    const Finish& slippery = a.friction_mu <= b.friction_mu ? a : b;
    const Finish& rough = a.friction_mu <= b.friction_mu ? b : a;
    const double softer = std::floor(hard.stiffness_fraction / kStiffnessApart * 100.0) / 100.0;
    const double rougher = std::ceil(slippery.friction_mu * kFrictionApart * 100.0) / 100.0;
    return phrase("lint.advice", {{"soft", spoken_material(soft.name)},
                                  {"stiffness", softer},
                                  {"rough", spoken_material(rough.name)},
                                  {"friction", rougher}});
}

// Returns the boxes of the visible surfaces of each material.
std::vector<std::vector<Aabb>> visible(const Scene& scene) {
    std::vector<std::vector<Aabb>> boxes(scene.materials.size());
    for (const SurfacePolygon& surface : scene.surfaces) {
        if (surface.role != SolidRole::Solid && surface.role != SolidRole::Mover) continue;
        Aabb box;
        for (const Vec3& p : surface.polygon.points_m) box.include(p);
        boxes[surface.material].push_back(box);
    }
    for (const MeshTriangle& t : scene.triangles) {
        Aabb box;
        for (const Vec3& p : {t.a_m, t.b_m, t.c_m}) box.include(p);
        boxes[t.material].push_back(box);
    }
    return boxes;
}

// Returns the materials that have a name and are used in this scene.
std::vector<std::size_t> named(const Scene& scene, const std::vector<std::vector<Aabb>>& boxes) {
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (!boxes[i].empty() && !scene.materials[i].name.empty()) used.push_back(i);
    return used;
}

double distance_in_plan(const Aabb& box, const Vec3& p) {
    const Vec3 d = glm::max(glm::max(box.min_m - p, p - box.max_m), Vec3(0.0));
    return std::sqrt(d.x * d.x + d.y * d.y);
}

}  // namespace

Finish finish_of(const MaterialSpec& spec) {
    return {std::string(spec.name), spec.stiffness_fraction, spec.friction_mu, spec.wave, nullptr};
}

Finish finish_of(const Material& material) {
    Finish finish;
    if (const MaterialSpec* spec = find_material(material.name)) finish = finish_of(*spec);
    finish.name = material.name;
    finish.stiffness_fraction = material.stiffness_fraction.value_or(finish.stiffness_fraction);
    finish.friction_mu = material.friction_mu.value_or(finish.friction_mu);
    finish.wave = material.wave.value_or(finish.wave);
    if (material.picture) finish.picture = material.picture->heights.get();
    return finish;
}

bool are_distinguishable(const Finish& a, const Finish& b) {
    return reaches(a.stiffness_fraction, b.stiffness_fraction, kStiffnessApart) ||
           reaches(a.friction_mu, b.friction_mu, kFrictionApart) || textures_differ(a, b);
}

std::string crowded_view(const Scene& scene) {
    const std::vector<std::vector<Aabb>> boxes = visible(scene);
    const std::vector<std::size_t> used = named(scene, boxes);
    // Examines the view around the middle of each surface of a named material, and reports the view with the most
    // materials.
    std::set<std::string> most;
    Vec3 where(0.0);
    for (const std::size_t centre : used)
        for (const Aabb& box : boxes[centre]) {
            std::set<std::string> names;
            for (const std::size_t i : used)
                if (!names.contains(scene.materials[i].name) &&
                    std::any_of(boxes[i].begin(), boxes[i].end(), [&](const Aabb& near) {
                        return distance_in_plan(near, box.centre_m()) <= 0.5 * kView_m;
                    }))
                    names.insert(scene.materials[i].name);
            if (names.size() <= most.size()) continue;
            most = names;
            where = box.centre_m();
        }
    if (most.size() <= kMostMaterialsInView) return {};
    std::string list;
    for (const std::string& name : most) {
        const std::string material = spoken_material(name);
        list = list.empty() ? material : phrase("words.joined", {{"one", list}, {"other", material}});
    }
    return phrase("lint.crowded", {{"count", most.size()},
                                   {"east", where.x},
                                   {"north", where.y},
                                   {"materials", list},
                                   {"most", kMostMaterialsInView}});
}

std::vector<AlikeMaterials> alike_materials(const Scene& scene) {
    std::vector<AlikeMaterials> alike;
    const std::vector<std::vector<Aabb>> boxes = visible(scene);
    const std::vector<std::size_t> used = named(scene, boxes);
    std::set<std::string> reported;
    for (std::size_t a = 0; a < used.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const Finish one = finish_of(scene.materials[used[b]]), other = finish_of(scene.materials[used[a]]);
            if (one.name == other.name || are_distinguishable(one, other)) continue;
            if (!reported.insert(one.name < other.name ? one.name + "/" + other.name : other.name + "/" + one.name)
                     .second)
                continue;
            alike.push_back({one.name, other.name,
                             phrase("lint.alike", {{"one", capitalised(spoken_material(one.name))},
                                                   {"other", spoken_material(other.name)},
                                                   {"stiffness", one.stiffness_fraction},
                                                   {"other_stiffness", other.stiffness_fraction},
                                                   {"friction", one.friction_mu},
                                                   {"other_friction", other.friction_mu},
                                                   {"advice", advice(one, other)}})});
        }
    return alike;
}

LintReport lint_materials(const Scene& scene) {
    LintReport report;
    for (AlikeMaterials& pair : alike_materials(scene)) report.problems.push_back(std::move(pair.sentence));
    if (std::string crowded = crowded_view(scene); !crowded.empty()) report.warnings.push_back(std::move(crowded));
    for (const FreeBody& body : scene.bodies)
        if (!body.gives_way_to_walkers())
            report.warnings.push_back(
                phrase("lint.heavy", {{"name", spoken_name(scene.features[body.feature.value])},
                                      {"mass", body.mass_kg},
                                      {"most", FreeBody::kWalkersPush_n / (9.81 * body.friction_static)}}));
    return report;
}

}  // namespace handrail
