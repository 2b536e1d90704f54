// How things are called and where they are, in the person's own words: what several features tell alike. Functions of
// what the context holds; app thread.
#pragma once

#include <string>

#include "app/core/context/session_context.h"
#include "app/core/dialogue/words.h"
#include "worlds/navigation/route.h"

namespace handrail {

// World metres per hand metre.
double scale(const SessionContext& context);
// Which way the hand's "ahead" looks in the world.
double workspace_heading_rad(const SessionContext& context);
// As the person has set them.
DistanceWords distances(const Settings& settings);
DistanceWords distances(const SessionContext& context);
// "9 steps at 1 o'clock", as seen by a body that has turned to where it is turning.
std::string where_words(const SessionContext& context, double distance_m, double bearing_rad);
// Of a thing, with its storey.
std::string where_words(const SessionContext& context, const Aabb& box_m);
// The same of what is in another room: its distance is that of the way there on foot.
std::string where_words_on_foot(const SessionContext& context, const Aabb& box_m, double on_foot_m);
// "one storey above": of a floor there; empty on this one.
std::string storey_words(const SessionContext& context, double floor_z_m);
// "9 steps away", "close by".
std::string how_far_words(const SessionContext& context, double way_m);
// Which hand there is, in words: "Novint Falcon, reach 4 centimetres, up to 3 newtons", or that there is none, or one
// of the keys alone.
std::string hand_words(const HandsState& hands);
std::string name_of(const SessionContext& context, FeatureId feature);
// Of the hand, or of the body where there is none.
Vec3 finding_place_m(const SessionContext& context);
// "locked"; empty where nothing keeps that door shut, or it stands open by now.
std::string lock_words(const SessionContext& context, FeatureId door);
std::string passage_name(const Scene& scene, PassageKind kind, FeatureId feature, double rise_m);
std::string passage_name(const SessionContext& context, PassageKind kind, FeatureId feature, double rise_m);
// With what is in the way there by now: "Door, locked".
std::string passage_now(const SessionContext& context, PassageKind kind, FeatureId feature, double rise_m);

}  // namespace handrail
