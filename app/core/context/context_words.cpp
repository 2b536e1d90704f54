#include "app/core/context/context_words.h"

#include <algorithm>
#include <cmath>

#include "app/core/dialogue/brief_words.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/questions.h"
#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {
namespace {

constexpr double kUnderfoot_m = 0.1;

// Returns "two storeys above" for a thing, or an empty text if the thing is on the walker's storey. `rise_m` is the
// height of its lowest part above the feet, `nearest_m` the height of the part nearest to the waist.
std::string storey_words(double rise_m, double nearest_m) {
    if (nearest_m <= kAboveOrBelow_m + kWaist_m && nearest_m >= -kAboveOrBelow_m) return {};
    const auto storeys = static_cast<int>(std::floor((rise_m + 0.5) / kUsualStorey_m));
    return nearest_m > 0.0 ? phrase("guide.storeys_above", {{"storeys", std::max(1, storeys)}})
                           : phrase("guide.storeys_below", {{"storeys", std::max(1, -storeys)}});
}

// Returns the place in short words as for exits. If the person does not want rounded values, returns exact words in
// degrees.
std::string spoken_place(const SessionContext& context, double distance_m, double bearing_rad) {
    const auto words = context.settings.speech.rounded ? brief_place_words : place_words;
    return words(distance_m, bearing_rad, context.avatar.heading_goal_rad, context.settings.speech.directions,
                 distances(context));
}

}  // namespace

double scale(const SessionContext& context) {
    if (!context.hands.named_scale) return context.settings.workspace.scale;
    return world_m_per_hand_m(*context.hands.named_scale, context.world.building_m,
                              context.hands.right.spec.workspace_radius_m);
}

DistanceWords distances(const SessionContext& context) { return distances(context.settings); }

DistanceWords distances(const settings::Settings& settings) {
    return {settings.speech.distances_in_steps, settings.walk.step_length_m, settings.speech.rounded};
}

double workspace_heading_rad(const SessionContext& context) {
    const double frame =
        context.settings.workspace.frame == settings::FrameChoice::Walk ? context.avatar.heading_rad : 0.0;
    return frame + radians_from_degrees(context.settings.workspace.turn_deg);
}

std::string where_words(const SessionContext& context, double distance_m, double bearing_rad) {
    return place_words(distance_m, bearing_rad, context.avatar.heading_goal_rad, context.settings.speech.directions,
                       distances(context));
}

std::string where_words(const SessionContext& context, const Aabb& box) {
    const Vec3 way = nearest_place(box, context.avatar.feet_m() + Vec3(0.0, 0.0, kWaist_m)) - context.avatar.feet_m();
    const double level_m = std::hypot(way.x, way.y);
    // For a thing at the feet, only the distance is announced, because a direction would mean nothing.
    const std::string where = level_m < kUnderfoot_m ? distance_words(level_m, distances(context))
                                                     : spoken_place(context, level_m, std::atan2(way.x, way.y));
    return joined(where, storey_words(box.min_m.z - context.avatar.feet_m().z, way.z));
}

std::string where_words_on_foot(const SessionContext& context, const Aabb& box, double on_foot_m) {
    const Vec3 way = nearest_place(box, context.avatar.feet_m() + Vec3(0.0, 0.0, kWaist_m)) - context.avatar.feet_m();
    const std::string far = phrase("place.on_foot", {{"distance", distance_words(on_foot_m, distances(context))}});
    const std::string where =
        joined(far, brief_direction_words(std::atan2(way.x, way.y), context.avatar.heading_goal_rad,
                                          context.settings.speech.directions));
    return joined(where, storey_words(box.min_m.z - context.avatar.feet_m().z, way.z));
}

std::string storey_words(const SessionContext& context, double floor_z_m) {
    const double rise_m = floor_z_m - context.avatar.feet_m().z;
    return storey_words(rise_m, rise_m);
}

std::string hand_words(const HandsState& hands) {
    if (!hands.right.present) return phrase("devices.none");
    const device::DeviceSpec& spec = hands.right.spec;
    return phrase(
        hands.keys_alone ? "devices.keys_alone" : "devices.hand",
        {{"device", spec.spoken_name()}, {"reach", 100.0 * spec.workspace_radius_m}, {"force", spec.peak_force_n}});
}

std::string how_far_words(const SessionContext& context, double way_m) {
    const std::string words = distance_words(way_m, distances(context));
    return is_close_by(way_m, distances(context)) ? words : phrase("session.away", {{"distance", words}});
}

std::string name_of(const SessionContext& context, FeatureId feature) {
    const std::string name = spoken_name(*context.world.scene, feature);
    return name.empty() ? spoken_kind("wall") : name;
}

Vec3 finding_place_m(const SessionContext& context) {
    return context.hands.answers() ? context.hands.tool.proxy_m : context.avatar.feet_m() + Vec3(0.0, 0.0, kWaist_m);
}

std::string lock_words(const SessionContext& context, FeatureId door) {
    const int found = mover_of(context.world, door);
    const auto mover = static_cast<std::uint32_t>(found);
    if (found < 0 || !locked(context.world, mover) || !shut(context.world, mover)) return {};
    return phrase(button_of(context.world, mover, context.avatar.feet_m() + Vec3(0.0, 0.0, kLookHeight_m))
                      ? "rooms.locked"
                      : "questions.opened_from_elsewhere");
}

std::string passage_name(const SessionContext& context, navigation::PassageKind kind, FeatureId feature,
                         double rise_m) {
    return passage_name(*context.world.scene, kind, feature, rise_m);
}

std::string passage_name(const Scene& scene, navigation::PassageKind kind, FeatureId feature, double rise_m) {
    const auto rising = [rise_m](const std::string& passage) {
        if (rise_m == 0.0) return passage;
        return phrase(rise_m > 0.0 ? "rooms.passage_up" : "rooms.passage_down",
                      {{"passage", passage}, {"metres", std::abs(rise_m)}});
    };
    const Feature* found = scene.find(feature);
    const std::string name = found ? spoken_name(*found) : std::string();
    switch (kind) {
        case navigation::PassageKind::Door:
            return name.empty() ? phrase("rooms.door") : name;
        case navigation::PassageKind::Stairs:
            return rising(name.empty() || (found && found->kind != FeatureKind::Object) ? phrase("rooms.stairs")
                                                                                        : name);
        case navigation::PassageKind::Climb:
            return phrase("rooms.climb",
                          {{"stairs", passage_name(scene, navigation::PassageKind::Stairs, feature, rise_m)}});
        case navigation::PassageKind::Lift:
            return rising(name.empty() ? phrase("rooms.lift") : name);
        case navigation::PassageKind::Drop:
            return rise_m == 0.0 ? phrase("rooms.edge_to_step_down") : rising(phrase("rooms.edge"));
        case navigation::PassageKind::Teleporter:
            return name.empty() ? phrase("rooms.teleporter") : name;
        case navigation::PassageKind::Opening:
            break;
    }
    return phrase("rooms.opening");
}

std::string passage_now(const SessionContext& context, navigation::PassageKind kind, FeatureId feature, double rise_m) {
    return joined(passage_name(context, kind, feature, rise_m), lock_words(context, feature));
}

bool must_be_opened(const SessionContext& context, navigation::PassageKind kind, FeatureId feature) {
    const int found = kind == navigation::PassageKind::Door ? mover_of(context.world, feature) : -1;
    if (found < 0) return false;
    const auto mover = static_cast<std::uint32_t>(found);
    return context.world.scene->movers[mover].by_hand && shut(context.world, mover) && !locked(context.world, mover);
}

}  // namespace handrail::core
