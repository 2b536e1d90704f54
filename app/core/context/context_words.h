// Puts names and places into words, according to the person's settings. Several features share these functions of the
// context. Call them on the app thread only.
#pragma once

#include <string>

#include "app/core/context/session_context.h"
#include "app/core/dialogue/words.h"
#include "worlds/navigation/route.h"

namespace handrail::core {

// Returns the scale in world metres per hand metre.
double scale(const SessionContext& context);
// Returns the direction in the world that the hand feels as "ahead".
double workspace_heading_rad(const SessionContext& context);
// Returns how distances are put into words, according to the person's settings.
DistanceWords distances(const settings::Settings& settings);
DistanceWords distances(const SessionContext& context);
// Returns "9 steps at 1 o'clock". The direction is relative to the heading of the walker at the end of the present
// turn.
std::string where_words(const SessionContext& context, double distance_m, double bearing_rad);
// Returns the place of a thing in words, with its storey.
std::string where_words(const SessionContext& context, const Aabb& box_m);
// Returns the place of a thing in another room, with its storey. The distance is the length of the route on foot.
std::string where_words_on_foot(const SessionContext& context, const Aabb& box_m, double on_foot_m);
// Returns "one storey above" for a floor at this height, or an empty text if the floor is on the walker's storey.
std::string storey_words(const SessionContext& context, double floor_z_m);
// Returns "9 steps away" or "close by" for a route of this length.
std::string how_far_words(const SessionContext& context, double way_m);
// Describes the hand: "Novint Falcon, reach 4 centimetres, up to 3 newtons". Otherwise says that there is no hand, or
// only a simulated one moved by keys.
std::string hand_words(const HandsState& hands);
std::string name_of(const SessionContext& context, FeatureId feature);
// Returns the position of the hand, or of the walker if there is no hand.
Vec3 finding_place_m(const SessionContext& context);
// Returns "locked", or that the door is opened from elsewhere. The text is empty if nothing keeps the door shut, or if
// the door is open now.
std::string lock_words(const SessionContext& context, FeatureId door);
std::string passage_name(const Scene& scene, navigation::PassageKind kind, FeatureId feature, double rise_m);
std::string passage_name(const SessionContext& context, navigation::PassageKind kind, FeatureId feature, double rise_m);
// Returns the name of the passage with what blocks it at present: "Door, locked".
std::string passage_now(const SessionContext& context, navigation::PassageKind kind, FeatureId feature, double rise_m);
// Returns true if the passage is a shut door that the person can open. A route goes on behind it, so the directions say
// that it is shut.
bool must_be_opened(const SessionContext& context, navigation::PassageKind kind, FeatureId feature);

}  // namespace handrail::core
