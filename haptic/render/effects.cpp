// Contains the laws of the effects, written in hand metres. Each is either a potential U with its slope, or an inner
// point p with F = K (p - x) that moves only along F.
#include "haptic/render/effects.h"

#include <cmath>

#include "haptic/render/tick_math.h"
#include "worlds/base/overloaded.h"

namespace handrail::render {
namespace {

constexpr double kFlyPaper_n_per_m = 400.0;
constexpr double kFlyPaperRelease_s = 0.030;
// Distance between the hand and the held point at which fly paper holds the hand again after the hand tore free.
constexpr double kFlyPaperStuck_hand_m = 0.2e-3;
constexpr double kInertia_n_per_m = 300.0;
// With this step, K T^2 is a seventh of the smallest mass, so the integration is stable.
constexpr double kInertiaLongestStep_s = 5e-3;
constexpr double kForceRamp_s = 0.100;
constexpr double kVibrationRamp_s = 0.010;
// Share of the device's stiffness that effects may use near a wall. The wall's own stiffness is added to theirs.
constexpr double kNextToObstacle = 0.6;

// A potential energy and its slope over hand travel.
struct Potential {
    double energy_j = 0.0;
    Vec3 slope_n{0.0};
};

// The weight of a position in a region, from 0 at the border to 1 at the depth `edge_m`, and the slope of the weight
// over world metres. Each side of the region contributes its own factor, so there is no crease where two sides are
// equally near.
struct Inside {
    double weight = 1.0;
    Vec3 slope_per_m{0.0};

    void side(double depth_m, const Vec3& inward, double edge_m) noexcept {
        if (depth_m >= edge_m) return;
        if (!(depth_m > 0.0)) {
            weight = 0.0;
            slope_per_m = Vec3(0.0);
            return;
        }
        const double u = depth_m / edge_m, s = smooth_step(u);
        slope_per_m = slope_per_m * s + inward * (weight * smooth_step_slope(u) / edge_m);
        weight *= s;
    }
    void ball(const Vec3& from_centre_m, double radius_m, double edge_m) noexcept {
        const double distance = length_of(from_centre_m);
        side(radius_m - distance, distance > 0.0 ? from_centre_m * (-1.0 / distance) : Vec3(0.0), edge_m);
    }
};

Inside inside_of(const EffectRegion& region, const Vec3& at_m, double edge_m) noexcept {
    Inside in;
    if (const auto* box = std::get_if<Aabb>(&region)) {
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 inward(0.0);
            inward[axis] = 1.0;
            in.side(at_m[axis] - box->min_m[axis], inward, edge_m);
            in.side(box->max_m[axis] - at_m[axis], -inward, edge_m);
        }
    } else if (const auto* ball = std::get_if<SphereRegion>(&region)) {
        in.ball(at_m - ball->centre_m, ball->radius_m, edge_m);
    } else if (const auto* capsule = std::get_if<CapsuleRegion>(&region)) {
        const Vec3 along = capsule->b_m - capsule->a_m;
        const double length2 = glm::dot(along, along);
        const double share = length2 > 0.0 ? std::clamp(glm::dot(at_m - capsule->a_m, along) / length2, 0.0, 1.0) : 0.0;
        in.ball(at_m - (capsule->a_m + along * share), capsule->radius_m, edge_m);
    } else if (const auto* convex = std::get_if<ConvexRegion>(&region)) {
        for (const Plane& plane : convex->planes) in.side(-signed_distance(plane, at_m), -plane.normal, edge_m);
    }
    return in;
}

// ---- lengths of the laws, reduced in small regions; hand metres ----

double magnet_width(const MagnetLaw& law, double room) noexcept { return std::min(law.width_hand_m, 0.4 * room); }
double detent_pitch(const DetentLaw& law, double room) noexcept { return std::min(law.pitch_hand_m, 2.0 * room); }
double button_half_travel(const ButtonLaw& law, double room) noexcept {
    return std::min(0.5 * law.travel_hand_m, 0.35 * room);
}

// Least ratio of a magnet's force to its width. A magnet whose width is reduced also gets weaker, so that its stiffness
// never exceeds its bound.
constexpr double kLeastMagnet_n_per_m = 200.0;
double magnet_steepness(const MagnetLaw& law) noexcept {
    return std::max(std::abs(law.force_n) / law.width_hand_m, kLeastMagnet_n_per_m);
}

// Returns the width of the edge over which a law fades. The edge is so wide that the fading pushes no harder than the
// law itself.
double edge_hand_m(const EffectVolume& effect, double room) noexcept {
    const double wanted =
        std::visit(Overloaded{[&](const MagnetLaw& law) { return 2.5 * magnet_width(law, room); },
                              [&](const DetentLaw& law) { return detent_pitch(law, room); },
                              [&](const ButtonLaw& law) { return 1.5 * button_half_travel(law, room); },
                              [](const auto&) { return 0.0; }},
                   effect.law);
    return std::min(std::max(effect.edge_hand_m, wanted), room);
}

// ---- potentials ----

Vec3 nearest_of(const MagnetTarget& target, const Vec3& at_m) noexcept {
    Vec3 nearest = target.centre_m;
    for (const Vec3* half : {&target.half_u_m, &target.half_v_m}) {
        const double length2 = glm::dot(*half, *half);
        if (length2 > 0.0) nearest += *half * std::clamp(glm::dot(at_m - target.centre_m, *half) / length2, -1.0, 1.0);
    }
    return nearest;
}

Potential magnet(const MagnetLaw& law, const Vec3& at_m, double scale, double room) noexcept {
    const double width = magnet_width(law, room);
    const double force = std::min(std::abs(law.force_n), magnet_steepness(law) * width);
    // Two potentials are blended if they differ by less than `blend`. The force then changes its direction over about
    // one width.
    const double blend = force * width;
    constexpr double kRootE = 1.64872127070012815;  // the constant exp(1/2)
    Potential lowest;
    bool first = true;
    for (const MagnetTarget& target : law.targets) {
        const Vec3 away = (at_m - nearest_of(target, at_m)) / scale;
        const double bell = kRootE * exp_minus(0.5 * glm::dot(away, away) / (width * width));
        const Potential one{-force * width * bell, away * (force / width * bell)};
        if (first) {
            lowest = one;
            first = false;
            continue;
        }
        // The minimum of the two potentials, with a rounded corner: min - (k - |a - b|)^2 / 4k.
        const double lead = std::clamp((one.energy_j - lowest.energy_j) / blend, -1.0, 1.0);
        const double share = 0.5 * (1.0 - lead);  // weight of `one`
        const double dip = 0.25 * blend * (1.0 - std::abs(lead)) * (1.0 - std::abs(lead));
        lowest.energy_j = std::min(lowest.energy_j, one.energy_j) - dip;
        lowest.slope_n += (one.slope_n - lowest.slope_n) * share;
    }
    if (law.force_n < 0.0) return {-lowest.energy_j, -lowest.slope_n};
    return lowest;
}

Potential detent(const DetentLaw& law, const Vec3& at_m, double scale, double room) noexcept {
    const double pitch = detent_pitch(law, room), force = law.force_n * (pitch / law.pitch_hand_m);
    const SineCosine turn = sine_of_turns(glm::dot(at_m - law.origin_m, law.direction) / (scale * pitch));
    return {-force * pitch / (2.0 * kPi) * turn.cosine, law.direction * (force * turn.sine)};
}

// The button's potential, with x = s / q: U = U0 (x^2 - 1)^2 up to x = 2 / sqrt 3, where the force is F0 again. From
// there the force fades to zero within one q.
Potential button(const ButtonLaw& law, const Vec3& at_m, double scale, double room) noexcept {
    constexpr double kFrom = 1.15470053837925153;    // the constant 2 / sqrt 3
    constexpr double kDepth = 0.649519052838328987;  // 3 sqrt 3 / 8: the ratio U0 / (F0 q)
    const double q = button_half_travel(law, room), force = law.force_n * (2.0 * q / law.travel_hand_m);
    const double x = glm::dot(at_m - law.origin_m, law.direction) / (scale * q), size = std::abs(x);
    // Value of the formula far outside. It is subtracted from the energy, so that U is 0 there.
    const double top = kDepth * (kFrom * kFrom - 1.0) * (kFrom * kFrom - 1.0) + 0.5;
    double energy = 0.0, slope = 0.0;  // energy in units of F0 q, slope in units of F0
    if (size < kFrom) {
        energy = kDepth * (x * x - 1.0) * (x * x - 1.0) - top;
        slope = 4.0 * kDepth * x * (x * x - 1.0);
    } else if (size < kFrom + 1.0) {
        const double u = size - kFrom;
        energy = u - smooth_step_area(u) - 0.5;
        slope = (1.0 - smooth_step(u)) * (x < 0.0 ? -1.0 : 1.0);
    }
    return {force * q * energy, law.direction * (force * slope)};
}

// Returns the force of a law that fades at its region's border: the negative slope of weight times potential.
Vec3 faded(const Potential& potential, const Inside& in, double scale) noexcept {
    return potential.slope_n * -in.weight - in.slope_per_m * (scale * potential.energy_j);
}

BodyPose pose_of(const HapticScene& scene, const HandMotion& hand, std::uint32_t body) noexcept {
    if (hand.bodies && hand.bodies->know(body)) return hand.bodies->at(body);
    return {scene.bodies[body].start, scene.bodies[body].present};
}

}  // namespace

// ---- derived values of regions and laws ----

Aabb bounds_of(const EffectRegion& region) {
    Aabb bounds;
    const auto ball = [&bounds](const Vec3& centre_m, double radius_m) {
        bounds.include(centre_m - radius_m);
        bounds.include(centre_m + radius_m);
    };
    if (const auto* box = std::get_if<Aabb>(&region)) return *box;
    if (const auto* sphere = std::get_if<SphereRegion>(&region)) ball(sphere->centre_m, sphere->radius_m);
    if (const auto* capsule = std::get_if<CapsuleRegion>(&region)) {
        ball(capsule->a_m, capsule->radius_m);
        ball(capsule->b_m, capsule->radius_m);
    }
    if (const auto* convex = std::get_if<ConvexRegion>(&region)) {
        // Finds the corners of the region: points where three planes meet and that no other plane cuts off.
        const std::vector<Plane>& planes = convex->planes;
        double farthest = 1.0;
        for (const Plane& plane : planes) farthest = std::max(farthest, std::abs(plane.offset_m));
        for (std::size_t i = 0; i < planes.size(); ++i)
            for (std::size_t j = i + 1; j < planes.size(); ++j)
                for (std::size_t k = j + 1; k < planes.size(); ++k) {
                    const Vec3 &a = planes[i].normal, &b = planes[j].normal, &c = planes[k].normal;
                    const double det = glm::dot(a, glm::cross(b, c));
                    if (std::abs(det) < 1e-9) continue;
                    const Vec3 corner = (glm::cross(b, c) * planes[i].offset_m + glm::cross(c, a) * planes[j].offset_m +
                                         glm::cross(a, b) * planes[k].offset_m) /
                                        det;
                    const bool kept = std::all_of(planes.begin(), planes.end(), [&](const Plane& p) {
                        return signed_distance(p, corner) <= 1e-9 * farthest;
                    });
                    if (kept) bounds.include(corner);
                }
    }
    return bounds;
}

double inner_radius_m(const EffectRegion& region) {
    if (const auto* box = std::get_if<Aabb>(&region))
        return 0.5 * std::min({box->size_m().x, box->size_m().y, box->size_m().z});
    if (const auto* sphere = std::get_if<SphereRegion>(&region)) return sphere->radius_m;
    if (const auto* capsule = std::get_if<CapsuleRegion>(&region)) return capsule->radius_m;
    // Finds a centre by the subgradient method: starts in the middle of the bounds and moves away from the nearest
    // plane, by ever smaller steps.
    const auto& planes = std::get<ConvexRegion>(region).planes;
    const Aabb bounds = bounds_of(region);
    if (bounds.empty() || planes.empty()) return 0.0;
    Vec3 at = bounds.centre_m();
    double best = 0.0, step = 0.5 * length_of(bounds.size_m());
    for (int round = 0; round < 400; ++round, step *= 0.98) {
        const auto nearest = std::max_element(planes.begin(), planes.end(), [&](const Plane& a, const Plane& b) {
            return signed_distance(a, at) < signed_distance(b, at);
        });
        best = std::max(best, -signed_distance(*nearest, at));
        at -= nearest->normal * step;
    }
    return best;
}

double stiffness_bound_n_per_m(const EffectLaw& law) {
    return std::visit(
        Overloaded{[](const MagnetLaw& l) { return 3.0 * magnet_steepness(l); },
                   [](const DetentLaw& l) { return 6.6 * l.force_n / l.pitch_hand_m; },
                   [](const ButtonLaw& l) { return 7.8 * l.force_n / (0.5 * l.travel_hand_m); },
                   [](const FlyPaperLaw&) { return kFlyPaper_n_per_m; },
                   [](const InertiaLaw&) { return kInertia_n_per_m; }, [](const ForceLaw&) { return 0.0; },
                   [](const VibrationLaw&) { return 0.0; }, [](const CustomLaw& l) { return l.stiffness_n_per_m; }},
        law);
}

bool is_sound(const EffectVolume& effect) {
    const auto within = [](double value, double least, double most) { return value >= least && value <= most; };
    const auto unit = [](const Vec3& v) { return is_finite(v) && std::abs(glm::dot(v, v) - 1.0) < 1e-9; };
    const Aabb bounds = bounds_of(effect.region);
    if (bounds.empty() || !is_finite(bounds.min_m) || !is_finite(bounds.max_m)) return false;
    const double inner = inner_radius_m(effect.region);
    if (!(inner > 0.0) || !std::isfinite(inner) || !within(effect.edge_hand_m, 1e-3, 1.0)) return false;
    if (const auto* convex = std::get_if<ConvexRegion>(&effect.region)) {
        // The region is unbounded if it extends without end from some corner, because the normals of the planes leave a
        // direction free.
        Vec3 low(0.0), high(0.0);
        for (const Plane& plane : convex->planes) {
            if (!unit(plane.normal) || !std::isfinite(plane.offset_m)) return false;
            low = glm::min(low, plane.normal);
            high = glm::max(high, plane.normal);
        }
        for (int axis = 0; axis < 3; ++axis)
            if (!(low[axis] < 0.0 && high[axis] > 0.0)) return false;
    }
    return std::visit(
        Overloaded{
            [&](const MagnetLaw& l) {
                const bool placed = std::all_of(l.targets.begin(), l.targets.end(), [](const MagnetTarget& t) {
                    return is_finite(t.centre_m) && is_finite(t.half_u_m) && is_finite(t.half_v_m);
                });
                return placed && !l.targets.empty() && within(std::abs(l.force_n), 0.0, kLargestEffect_n) &&
                       within(l.width_hand_m, 1e-3, 1.0);
            },
            [&](const DetentLaw& l) {
                return is_finite(l.origin_m) && unit(l.direction) && within(l.force_n, 0.0, kLargestEffect_n) &&
                       within(l.pitch_hand_m, 2e-3, 1.0);
            },
            [&](const ButtonLaw& l) {
                return is_finite(l.origin_m) && unit(l.direction) && within(l.force_n, 0.0, kLargestEffect_n) &&
                       within(l.travel_hand_m, 2e-3, 1.0);
            },
            [&](const FlyPaperLaw& l) { return within(l.break_n, 0.0, kLargestEffect_n); },
            [&](const InertiaLaw& l) { return within(l.mass_kg, 0.05, 0.3) && within(l.damping_ns_per_m, 0.0, 5.0); },
            [&](const ForceLaw& l) { return unit(l.direction) && within(l.force_n, 0.0, 2.0); },
            [&](const VibrationLaw& l) {
                return unit(l.direction) && within(l.amplitude_n, 0.0, 0.5) && within(l.frequency_hz, 20.0, 250.0);
            },
            [&](const CustomLaw& l) { return l.force_n != nullptr && within(l.stiffness_n_per_m, 0.0, 1e4); }},
        effect.law);
}

// ---- computing a tick ----

void EffectState::reset() noexcept {
    used_ = 0;
    truncated_ = false;
}

EffectState::Slot& EffectState::slot_of(std::uint32_t effect) noexcept {
    for (std::size_t i = 0; i < used_; ++i)
        if (slots_[i].effect == effect) return slots_[i];
    Slot& fresh = slots_[used_++];
    fresh = Slot{};
    fresh.effect = effect;
    return fresh;
}

Vec3 EffectState::one_force(const EffectVolume& effect, Slot& slot, const Vec3& at_m, const HandMotion& hand) noexcept {
    const double room = effect.inner_radius_m / hand.scale;
    const Inside in = inside_of(effect.region, at_m, edge_hand_m(effect, room) * hand.scale);
    const double budget = hand.stiffest_n_per_m * (effect.by_obstacle ? kNextToObstacle : 1.0);
    const double share = effect.crowd_stiffness_n_per_m > budget ? budget / effect.crowd_stiffness_n_per_m : 1.0;
    if (hand.held) slot.time_s += hand.dt_s;
    else slot.time_s = 0.0;

    // When the hand enters the region, the inner point starts at the hand.
    const Vec3 step_m = slot.fresh ? Vec3(0.0) : hand.step_m;
    slot.fresh = false;
    return std::visit(
        Overloaded{
            [&](const MagnetLaw& law) { return faded(magnet(law, at_m, hand.scale, room), in, hand.scale) * share; },
            [&](const DetentLaw& law) { return faded(detent(law, at_m, hand.scale, room), in, hand.scale) * share; },
            [&](const ButtonLaw& law) { return faded(button(law, at_m, hand.scale, room), in, hand.scale) * share; },
            [&](const FlyPaperLaw& law) {
                const double stiffness = kFlyPaper_n_per_m * share;
                const double breaks_m = law.break_n / stiffness;
                const Vec3 stretched = slot.offset_hand_m - step_m;
                if (length_of(stretched) > breaks_m) slot.slipping = true;
                slot.offset_hand_m = shortened(stretched, in.weight * breaks_m);
                if (slot.slipping) {
                    slot.offset_hand_m *= exp_minus(hand.dt_s / kFlyPaperRelease_s);
                    slot.slipping = length_of(slot.offset_hand_m) >= kFlyPaperStuck_hand_m;
                }
                return slot.offset_hand_m * stiffness;
            },
            [&](const InertiaLaw& law) {
                const double stiffness = kInertia_n_per_m * share;
                slot.offset_hand_m = shortened(slot.offset_hand_m - step_m, in.weight * kLargestEffect_n / stiffness);
                const Vec3 force = slot.offset_hand_m * stiffness;
                // The force is computed before the mass moves. In the opposite order, the law would give energy.
                const double dt = std::min(hand.dt_s, kInertiaLongestStep_s);
                slot.speed_hand_m_per_s +=
                    (force + slot.speed_hand_m_per_s * law.damping_ns_per_m) * (-dt / law.mass_kg);
                slot.offset_hand_m += slot.speed_hand_m_per_s * dt;
                return force;
            },
            [&](const ForceLaw& law) {
                return law.direction * (law.force_n * in.weight * smooth_step(slot.time_s / kForceRamp_s));
            },
            [&](const VibrationLaw& law) {
                slot.turns += law.frequency_hz * hand.dt_s;
                slot.turns -= std::floor(slot.turns);
                return law.direction * (law.amplitude_n * in.weight * smooth_step(slot.time_s / kVibrationRamp_s) *
                                        sine_of_turns(slot.turns).sine);
            },
            [&](const CustomLaw& law) {
                const EffectPoint point{at_m, hand.scale, in.weight, step_m / hand.dt_s, slot.time_s, hand.dt_s};
                const Vec3 force = law.force_n(point, law.data.get());
                return is_finite(force) ? shortened(force, kLargestEffect_n) * (in.weight * share) : Vec3(0.0);
            }},
        effect.law);
}

Vec3 EffectState::force_n(const HapticScene& scene, const HandMotion& hand) noexcept {
    truncated_ = false;
    if (scene.effects.empty()) return Vec3(0.0);
    if (world_ != scene.world || effects_ != scene.effects.size()) {
        reset();
        world_ = scene.world;
        effects_ = scene.effects.size();
    }
    const Vec3 at = hand.goal_m - scene.origin_m;

    // Finds the effects whose region contains the hand, in the order of the table.
    std::array<std::uint32_t, kMostActive> active;
    std::size_t count = 0;
    const auto meet = [&](std::uint32_t item, const Vec3& place_m) {
        if (!(inside_of(scene.effects[item].region, place_m, 1e-300).weight > 0.0)) return;
        std::size_t place = count;
        if (count == kMostActive) {
            truncated_ = true;
            if (active[--place] < item) return;
        } else {
            ++count;
        }
        for (; place > 0 && active[place - 1] > item; --place) active[place] = active[place - 1];
        active[place] = item;
    };
    scene.effect_bvh.within(at, 0.0, [&](std::uint32_t item, double&) { meet(item, at); });
    for (const std::uint32_t item : scene.hanging_effects) {
        const BodyPose pose = pose_of(scene, hand, scene.effects[item].body);
        if (pose.present) meet(item, PlacedFrame(pose.at).to_own(hand.goal_m));
    }

    // Drops the slots of all other effects, so that no state is kept for an effect that the hand has left.
    for (std::size_t i = used_; i-- > 0;)
        if (std::find(active.begin(), active.begin() + count, slots_[i].effect) == active.begin() + count)
            slots_[i] = slots_[--used_];

    Vec3 sum(0.0);
    for (std::size_t i = 0; i < count; ++i) {
        const EffectVolume& effect = scene.effects[active[i]];
        Slot& slot = slot_of(active[i]);
        if (effect.body == EffectVolume::kNoBody) {
            sum += one_force(effect, slot, at, hand);
            continue;
        }
        // Converts the hand's motion to the frame of the body. A moving body that carries its effect past a still hand
        // thus feels the same as a still effect that the hand passes.
        const PlacedFrame frame(pose_of(scene, hand, effect.body).at);
        HandMotion seen = hand;
        const Vec3 place_m = frame.to_own(hand.goal_m);
        seen.scale = hand.scale / frame.scale;
        seen.step_m = (place_m - slot.last_m) / seen.scale;
        slot.last_m = place_m;
        sum += frame.turned(one_force(effect, slot, place_m, seen));
    }
    return sum;
}

}  // namespace handrail::render
