#include "haptic/compile/compile_effects.h"

#include <algorithm>
#include <array>

#include "worlds/base/overloaded.h"

namespace handrail::compile {
namespace {

Aabb bounds_of(const Effect& effect) {
    return std::visit(Overloaded{[](const ConvexSolid& solid) { return solid.bounds_m; },
                                 [](const EffectBall& ball) {
                                     return Aabb{ball.centre_m - ball.radius_m, ball.centre_m + ball.radius_m};
                                 },
                                 [](const EffectCapsule& capsule) {
                                     return Aabb{glm::min(capsule.a_m, capsule.b_m) - capsule.radius_m,
                                                 glm::max(capsule.a_m, capsule.b_m) + capsule.radius_m};
                                 }},
                      effect.where);
}

render::EffectRegion region_of(const Effect& effect) {
    return std::visit(
        Overloaded{
            [](const ConvexSolid& solid) -> render::EffectRegion {
                const bool box =
                    solid.planes.size() == 6 &&
                    std::all_of(solid.planes.begin(), solid.planes.end(), [](const Plane& p) {
                        return std::max({std::abs(p.normal.x), std::abs(p.normal.y), std::abs(p.normal.z)}) == 1.0;
                    });
                if (box) return solid.bounds_m;
                return render::ConvexRegion{solid.planes};
            },
            [](const EffectBall& ball) -> render::EffectRegion {
                return render::SphereRegion{ball.centre_m, ball.radius_m};
            },
            [](const EffectCapsule& capsule) -> render::EffectRegion {
                return render::CapsuleRegion{capsule.a_m, capsule.b_m, capsule.radius_m};
            }},
        effect.where);
}

std::vector<render::MagnetTarget> targets_of(const Effect& effect, const Scene& scene) {
    if (const auto* capsule = std::get_if<EffectCapsule>(&effect.where); capsule && effect.pull == MagnetPull::Line)
        return {{0.5 * (capsule->a_m + capsule->b_m), 0.5 * (capsule->b_m - capsule->a_m)}};
    const Feature* thing = effect.pull == MagnetPull::Object ? scene.find(effect.belongs_to) : nullptr;
    const Aabb box = thing && !thing->bounds_m.empty() ? thing->bounds_m : bounds_of(effect);
    const Vec3 middle = box.centre_m();
    std::array<Vec3, 3> half{};  // half axes, the longest first
    std::array<int, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return box.size_m()[a] > box.size_m()[b]; });
    for (std::size_t i = 0; i < 3; ++i) half[i][order[i]] = 0.5 * box.size_m()[order[i]];
    switch (effect.pull) {
        case MagnetPull::Point:
            break;
        case MagnetPull::Line:
            return {{middle, half[0]}};
        case MagnetPull::Surface:
            return {{middle, half[0], half[1]}};
        case MagnetPull::Object: {
            std::vector<render::MagnetTarget> faces;
            for (std::size_t out = 0; out < 3; ++out)
                for (const double side : {-1.0, 1.0})
                    faces.push_back({middle + half[out] * side, half[(out + 1) % 3], half[(out + 2) % 3]});
            return faces;
        }
    }
    return {{middle}};
}

render::EffectLaw law_of(const Effect& effect, const Scene& scene) {
    const Vec3 middle = bounds_of(effect).centre_m();
    switch (effect.kind) {
        case EffectKind::Magnet:
            return render::MagnetLaw{targets_of(effect, scene), effect.strength_n, effect.width_hand_m};
        case EffectKind::Detent:
            return render::DetentLaw{middle, effect.direction, effect.strength_n, effect.width_hand_m};
        case EffectKind::Button:
            return render::ButtonLaw{middle, effect.direction, effect.strength_n, effect.width_hand_m};
        case EffectKind::FlyPaper:
            return render::FlyPaperLaw{effect.strength_n};
        case EffectKind::Inertia:
            return render::InertiaLaw{effect.mass_kg};
        case EffectKind::Force:
            return render::ForceLaw{effect.direction, effect.strength_n};
        case EffectKind::Vibration:
            break;
    }
    return render::VibrationLaw{effect.direction, effect.strength_n, effect.frequency_hz};
}

// Converts the effect from world coordinates to the frame of a body with the pose `frame`.
void bring_into(render::EffectVolume& effect, const PlacedFrame& frame) {
    const auto plane = [&](const Vec3& normal, double offset_m) {
        return Plane{frame.turned_back(normal), (offset_m - glm::dot(normal, frame.position_m)) / frame.scale};
    };
    effect.region =
        std::visit(Overloaded{[&](const Aabb& box) -> render::EffectRegion {
                                  render::ConvexRegion region;
                                  for (int axis = 0; axis < 3; ++axis) {
                                      Vec3 normal(0.0);
                                      normal[axis] = 1.0;
                                      region.planes.push_back(plane(normal, box.max_m[axis]));
                                      region.planes.push_back(plane(-normal, -box.min_m[axis]));
                                  }
                                  return region;
                              },
                              [&](const render::SphereRegion& ball) -> render::EffectRegion {
                                  return render::SphereRegion{frame.to_own(ball.centre_m), ball.radius_m / frame.scale};
                              },
                              [&](const render::CapsuleRegion& capsule) -> render::EffectRegion {
                                  return render::CapsuleRegion{frame.to_own(capsule.a_m), frame.to_own(capsule.b_m),
                                                               capsule.radius_m / frame.scale};
                              },
                              [&](const render::ConvexRegion& convex) -> render::EffectRegion {
                                  render::ConvexRegion region;
                                  for (const Plane& p : convex.planes)
                                      region.planes.push_back(plane(p.normal, p.offset_m));
                                  return region;
                              }},
                   effect.region);
    std::visit(
        Overloaded{[&](render::MagnetLaw& law) {
                       for (render::MagnetTarget& target : law.targets) {
                           target.centre_m = frame.to_own(target.centre_m);
                           target.half_u_m = frame.turned_back(target.half_u_m) / frame.scale;
                           target.half_v_m = frame.turned_back(target.half_v_m) / frame.scale;
                       }
                   },
                   [&](render::DetentLaw& law) {
                       law.origin_m = frame.to_own(law.origin_m);
                       law.direction = frame.turned_back(law.direction);
                   },
                   [&](render::ButtonLaw& law) {
                       law.origin_m = frame.to_own(law.origin_m);
                       law.direction = frame.turned_back(law.direction);
                   },
                   [&](render::ForceLaw& law) { law.direction = frame.turned_back(law.direction); },
                   [&](render::VibrationLaw& law) { law.direction = frame.turned_back(law.direction); }, [](auto&) {}},
        effect.law);
}

}  // namespace

void add_effects(render::HapticSceneBuilder& builder, const Scene& scene) {
    for (const Effect& effect : scene.effects) {
        render::EffectVolume volume;
        volume.feature = effect.belongs_to;
        volume.region = region_of(effect);
        volume.edge_hand_m = effect.edge_hand_m;
        volume.law = law_of(effect, scene);
        if (effect.belongs_to) {
            if (const auto body = builder.body_of(effect.belongs_to)) {
                volume.body = body->first;
                bring_into(volume, PlacedFrame(body->second));
            }
        }
        builder.add_effect(std::move(volume));
    }
}

}  // namespace handrail::compile
