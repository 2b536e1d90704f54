// Names and places in the person's own words, as several features need them. Functions of what the context contains;
// app thread.
#pragma once

#include <string>

#include "app/core/context/session_context.h"
#include "app/core/dialogue/words.h"
#include "worlds/navigation/route.h"

namespace handrail::core {

// World metres per hand metre.
double scale(const SessionContext& context);
// The world direction of the hand's "ahead".
double workspace_heading_rad(const SessionContext& context);
// Distances in words, as the person has set them.
DistanceWords distances(const settings::Settings& settings);
DistanceWords distances(const SessionContext& context);
// "9 steps at 1 o'clock", relative to the direction that the walker faces once it has finished turning.
std::string where_words(const SessionContext& context, double distance_m, double bearing_rad);
// Where a thing is, with its storey.
std::string where_words(const SessionContext& context, const Aabb& box_m);
// The same for a thing in another room: the distance is the length of the route on foot.
std::string where_words_on_foot(const SessionContext& context, const Aabb& box_m, double on_foot_m);
// "one storey above" for a floor at this height; empty on this storey.
std::string storey_words(const SessionContext& context, double floor_z_m);
// "9 steps away", "close by".
std::string how_far_words(const SessionContext& context, double way_m);
// Which hand there is: "Novint Falcon, reach 4 centimetres, up to 3 newtons", or that there is none, or only a
// simulated one moved by keys.
std::string hand_words(const HandsState& hands);
std::string name_of(const SessionContext& context, FeatureId feature);
// The place of the hand, or of the walker if there is no hand.
Vec3 finding_place_m(const SessionContext& context);
// "locked"; empty if nothing keeps that door shut, or it is open now.
std::string lock_words(const SessionContext& context, FeatureId door);
std::string passage_name(const Scene& scene, navigation::PassageKind kind, FeatureId feature, double rise_m);
std::string passage_name(const SessionContext& context, navigation::PassageKind kind, FeatureId feature, double rise_m);
// The name with what blocks the passage now: "Door, locked".
std::string passage_now(const SessionContext& context, navigation::PassageKind kind, FeatureId feature, double rise_m);

}  // namespace handrail::core
