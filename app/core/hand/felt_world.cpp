#include "app/core/hand/felt_world.h"

#include <algorithm>
#include <utility>

#include "app/core/context/workspace_scale.h"
#include "haptic/render/validate_scene.h"
#include "worlds/base/contract.h"

namespace handrail::core {

bool FeltOrder::same_as(const FeltOrder& other) const {
    const auto options_of = [](const FeltOrder& order) { return order.simplify.value_or(compile::SimplifyOptions{}); };
    const compile::SimplifyOptions mine = options_of(*this), others = options_of(other);
    return edit == other.edit && simplify.has_value() == other.simplify.has_value() &&
           mine.world_m_per_hand_m == others.world_m_per_hand_m && mine.openings_m == others.openings_m &&
           mine.kept_m == others.kept_m && world_m_per_hand_m == other.world_m_per_hand_m &&
           proxy_diameter_hand_m == other.proxy_diameter_hand_m &&
           edge_rounding_hand_mm == other.edge_rounding_hand_mm &&
           mesh_tolerance_hand_mm == other.mesh_tolerance_hand_mm;
}

double felt_rounding_m(double edge_rounding_hand_mm, double world_m_per_hand_m, double proxy_radius_m) {
    return std::min(compile::edge_rounding_m(edge_rounding_hand_mm, world_m_per_hand_m), proxy_radius_m);
}

compile::OwnRounding felt_own_rounding(const Scene& scene, double edge_rounding_hand_mm, double world_m_per_hand_m,
                                       double proxy_radius_m) {
    if (edge_rounding_hand_mm <= 0.0 || !compile::has_own_rounding(scene)) return {};
    return {world_m_per_hand_m, proxy_radius_m};
}

FeltWorld make_felt(const FeltOrder& order, const FeltWorld& before, const std::stop_token& stop) {
    FeltWorld felt;
    felt.portals = order.portals;
    if (order.simplify) felt.plan = compile::plan_simplification(*order.scene, *order.simplify, stop);
    if (stop.stop_requested()) return felt;
    const double radius_m =
        proxy_radius_m(*order.scene, order.proxy_diameter_hand_m, order.world_m_per_hand_m, felt.plan);
    felt.rounding_m = felt_rounding_m(order.edge_rounding_hand_mm, order.world_m_per_hand_m, radius_m);
    if (compile::has_dense_mesh(*order.scene))
        felt.mesh_tolerance_m = order.mesh_tolerance_hand_mm * 1e-3 * order.world_m_per_hand_m;
    felt.own_rounding =
        felt_own_rounding(*order.scene, order.edge_rounding_hand_mm, order.world_m_per_hand_m, radius_m);
    if (felt.plan == before.plan && felt.rounding_m == before.rounding_m && felt.own_rounding == before.own_rounding &&
        felt.mesh_tolerance_m == before.mesh_tolerance_m)
        return felt;
    compile::CompileOptions options = compile::exploring(felt.rounding_m, order.world, felt.mesh_tolerance_m);
    options.own_rounding = felt.own_rounding;
    options.stop = stop;
    compile::CompileReport report;
    felt.haptic = felt.plan.changes_nothing()
                      ? compile::compile_haptic(*order.scene, options, &report)
                      : compile::compile_haptic(compile::simplified(*order.scene, felt.plan), options, &report);
    felt.coarser = std::move(report.coarser);
    if (felt.haptic) contract_valid(validate(*felt.haptic));
    return felt;
}

}  // namespace handrail::core
