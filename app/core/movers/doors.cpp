#include "app/core/movers/doors.h"

#include <algorithm>
#include <cmath>

#include "app/core/context/context_words.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/leaf_reach.h"
#include "app/core/world/questions.h"
#include "worlds/base/contract.h"
#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"
#include "worlds/geometry/closest_point.h"
#include "worlds/scene/models.h"
#include "worlds/scene/stated_building.h"

namespace handrail::core {
namespace {

// Hand metres. While the name of a door is being announced, the hand may bounce off by this distance and still operate
// the door.
constexpr double kBounced_hand_m = 0.015;
// A walker farther than this from the bounding box of a thing cannot stand on the thing.
constexpr double kNearThing_m = 0.1;
// If a door shuts within this distance of the walker, the person may be about to pass it, so its announcement is a
// warning.
constexpr double kNextToOne_m = 3.0;
constexpr double kCeiling = -0.7;  // a surface is overhead if the z component of its normal is smaller than this

Aabb box_of(const Scene& scene, FeatureId feature) { return scene.features[feature.value].bounds_m; }

Aabb walker_box(const Vec3& feet_m, const WalkerShape& body) {
    Aabb box;
    box.include(feet_m - Vec3(body.radius_m, body.radius_m, 0.0));
    box.include(feet_m + Vec3(body.radius_m, body.radius_m, body.height_m));
    return box;
}

Aabb grown(Aabb box, double by_m) {
    box.min_m -= Vec3(by_m);
    box.max_m += Vec3(by_m);
    return box;
}

// Returns how a walker stands on `thing`. If the walker does not stand on it, returns Riding::Not.
Riding rides(const PlacedModel& thing, const Placement& at, const Vec3& feet_m, const WalkerShape& body) {
    if (!boxes_meet(grown(placed_bounds(thing.model->bounds_m, at), kNearThing_m), walker_box(feet_m, body)))
        return Riding::Not;
    return riding(thing.model, at, feet_m, body);
}

// Returns true if a door leaf may pass through the walker. A leaf that opens never blocks a walker. A leaf that shuts
// is blocked only by a walker that stands where the leaf comes to rest. Any other walker in its path is treated as
// stepping aside.
bool passes_walker(const Feature& feature, const PlacedModel& leaf, const std::optional<Placement>& comes_to_rest,
                   const Vec3& feet_m, const WalkerShape& body) {
    if (feature.kind != FeatureKind::Door) return false;
    return !comes_to_rest ||
           !boxes_meet(placed_bounds(leaf.model->bounds_m, *comes_to_rest), walker_box(feet_m, body)) ||
           !meets_walker(leaf.model, *comes_to_rest, feet_m, body);
}

// Returns true for a hinged leaf that is opened by hand.
bool swings_by_hand(const Scene& scene, const Mover& mover) {
    return mover.by_hand && mover.swing_rad != 0.0 && scene.features[mover.feature.value].kind == FeatureKind::Door;
}

// Returns true if two things may pass through each other. These are the leaves of one door, things for which the author
// of the world permits it, a lift and its own doors, and two hinged doors. In narrow corridors, the leaf of one door
// may touch the open leaf of another. A real person who opens the door would move both.
bool let_through(const Scene& scene, std::uint32_t a, std::uint32_t b) {
    const Mover &one = scene.movers[a], &other = scene.movers[b];
    if (swings_by_hand(scene, one) && swings_by_hand(scene, other)) return true;
    return one.group == other.group || (one.passes != kNoMover && one.passes == other.passes) || one.lift == b ||
           other.lift == a;
}

// Returns the name of the storey that is level with the lift's floor when the lift is at the height `z_m`. `thing` is
// the index of the lift among the placed things. The name is empty if the file names no storey at that height.
std::string storey_words(const Scene& scene, int thing, double z_m) {
    constexpr double kLevel_m = 0.1;
    if (!scene.stated || thing < 0) return {};
    const double floor_m = z_m + scene.placed[static_cast<std::size_t>(thing)].model->bounds_m.max_m.z;
    for (const StatedStorey& storey : scene.stated->storeys)
        if (std::abs(storey.floor_m - floor_m) < kLevel_m) return one_line(storey.name);
    return {};
}

// Returns the announcement that a mover has stopped. The announcement contains the storey if the file names it.
// Otherwise it says "at the top" or "at the bottom" if the ends of the path differ by a metre or more in height. For a
// horizontal mover, it says only that the mover has stopped.
std::string stops_words(const Mover& mover, const std::string& storey, double z_m, const std::string& name) {
    if (!storey.empty()) return phrase("movers.stops_at", {{"name", name}, {"storey", storey}});
    const double low_m = mover.pivot_m.z + std::min(0.0, mover.slide_m.z), way_m = std::abs(mover.slide_m.z);
    if (way_m < 1.0) return phrase("movers.stops", {{"name", name}});
    return phrase(z_m > low_m + 0.5 * way_m ? "movers.stops_above" : "movers.stops_below", {{"name", name}});
}

}  // namespace

Doors::Doors(const SessionContext& context, WorldState& world, WalkerState& avatar)
    : SessionPart(context), world_(world), avatar_(avatar) {}

bool Doors::act(Command command, double now_s) {
    if (command != Command::Use) return false;
    use(now_s);
    return true;
}

void Doors::press(std::uint32_t mover, bool back_again, double now_s) {
    contract_pre(mover < world_.movers.size());
    context_.events.report(DoorUsed{world_.scene->movers[mover].feature}, now_s);
    if (blocked(mover)) return context_.answer(shut_words(mover), now_s);
    const bool lift_comes = world_.movers.lift_is_away(mover);
    if (back_again) world_.movers.set_going(mover);
    else world_.movers.call(mover);
    shut_by_person_ = world_.movers.goes_shut(mover) ? world_.scene->movers[mover].feature : kNoFeature;
    const Feature& feature = world_.scene->features[world_.scene->movers[mover].feature.value];
    if (lift_comes) {
        const Feature& lift =
            world_.scene->features[world_.scene->movers[world_.scene->movers[mover].lift].feature.value];
        return context_.say(phrase("movers.called", {{"name", sentence_case(spoken_name(lift))}}),
                            cues::SpeechClass::Contact, now_s);
    }
    if (!world_.scene->movers[mover].halts.empty())
        if (const std::string storey =
                storey_words(*world_.scene, world_.thing_of_mover[mover], world_.movers.at_goal(mover).position_m.z);
            !storey.empty())
            return context_.say(
                phrase("movers.rides_to", {{"name", sentence_case(spoken_name(feature))}, {"storey", storey}}),
                cues::SpeechClass::Contact, now_s);
    // A placed thing is announced while it moves, so this announcement is not needed.
    if (world_.thing_of_mover[mover] >= 0) return;
    cues::CueRequest sound;
    sound.kind = cues::CueRequestKind::Play;
    sound.sound = cues::SoundKind::DoorMoves;
    sound.time_s = now_s;
    sound.position_m = feature.bounds_m.centre_m();
    context_.cues.cue(std::move(sound));
    context_.say(phrase("movers.pressed", {{"name", sentence_case(spoken_name(feature))}}), cues::SpeechClass::Contact,
                 now_s);
}

// Returns the lift on which the walker stands, or -1.
int Doors::lift_under_walker() const {
    for (std::uint32_t i = 0; i < world_.movers.size(); ++i) {
        const Mover& mover = world_.scene->movers[i];
        if (world_.thing_of_mover[i] < 0 || !mover.by_hand ||
            world_.scene->features[mover.feature.value].kind != FeatureKind::Lift)
            continue;
        const auto thing = static_cast<std::size_t>(world_.thing_of_mover[i]);
        if (rides(world_.scene->placed[thing], world_.things.at(thing), avatar_.feet_m(), avatar_.walker->shape()) ==
            Riding::ByMiddle)
            return static_cast<int>(i);
    }
    return -1;
}

bool Doors::ride_to(double floor_m, const std::string& storey, double now_s) {
    constexpr double kSameFloor_m = 0.3;
    contract_pre(std::isfinite(floor_m));
    const int lift = lift_under_walker();
    if (lift < 0) return false;
    const auto mover = static_cast<std::uint32_t>(lift);
    const Mover& is = world_.scene->movers[mover];
    const double top_m =
        world_.scene->placed[static_cast<std::size_t>(world_.thing_of_mover[mover])].model->bounds_m.max_m.z;
    const auto there = [&](const Placement& at) { return std::abs(at.position_m.z + top_m - floor_m) < kSameFloor_m; };
    const std::vector<double> ends{0.0, 1.0};
    const std::vector<double>& stops = is.halts.empty() ? ends : is.halts;
    const auto stop = std::find_if(stops.begin(), stops.end(), [&](double part) { return there(is.at(part)); });
    if (stop == stops.end() || (there(world_.movers.at(mover)) && there(world_.movers.at_goal(mover)))) return false;
    context_.events.report(DoorUsed{is.feature}, now_s);
    if (blocked(mover)) {
        context_.answer(shut_words(mover), now_s);
        return true;
    }
    world_.movers.ride(mover, *stop);
    context_.answer(
        phrase("movers.rides",
               {{"name", sentence_case(spoken_name(world_.scene->features[is.feature.value]))}, {"storey", storey}}),
        now_s);
    return true;
}

// Returns the nearest open leaf that the walker touches, among doors that are shut by hand, or -1.
int Doors::leaf_at_walker() const {
    constexpr double kTouches_m = 0.06;
    int nearest = -1;
    double nearest_m = avatar_.walker->size().radius_m + kTouches_m;
    for (std::uint32_t i = 0; i < world_.movers.size(); ++i) {
        if (world_.thing_of_mover[i] < 0 || !usable(world_, i) || shut(world_, i) ||
            !swings_by_hand(*world_.scene, world_.scene->movers[i]))
            continue;
        const Aabb& own = world_.scene->placed[static_cast<std::size_t>(world_.thing_of_mover[i])].model->bounds_m;
        const Vec3 body = PlacedFrame(world_.movers.at(i)).to_own(avatar_.feet_m() + Vec3(0.0, 0.0, kLookHeight_m));
        const Vec3 inside = glm::clamp(body, own.min_m, own.max_m);
        if (const double far_m = glm::length(body - inside); far_m < nearest_m) {
            nearest_m = far_m;
            nearest = static_cast<int>(i);
        }
    }
    return nearest;
}

// Returns the door that the announced directions name, if one of its leaves is within reach of the walker, or -1.
int Doors::door_of_leg() const {
    const FeatureId door = of_leg ? of_leg() : kNoFeature;
    const int chosen = door ? mover_of(world_, door) : -1;
    return chosen >= 0 && leaf_in_reach(world_, static_cast<std::uint32_t>(chosen), avatar_.feet_m()) ? chosen : -1;
}

// Operates one thing, which it chooses in this order:
// 1. what the hand touches;
// 2. the lift on which the walker stands;
// 3. the door that the announced directions tell the person to open or to shut, if the walker is close to it;
// 4. a shut door that was announced on an earlier route, if the walker or the hand is still close to it;
// 5. what is straight ahead;
// 6. an open leaf that the walker touches, because it is in the way;
// 7. the nearest of all.
void Doors::use(double now_s) {
    int chosen = -1;
    if (context_.hands.answers() && context_.hands.tool.touches())
        chosen = mover_of(world_, context_.hands.tool.touched());
    if (chosen < 0) chosen = lift_under_walker();
    if (chosen < 0) chosen = door_of_leg();
    if (chosen < 0 && !announced_.empty()) {
        const FeatureId announced = announced_.back();
        const Aabb door = box_of(*world_.scene, announced);
        const double hand_reach_m = kBounced_hand_m * scale(context_);
        if (distance_squared(door, avatar_.feet_m() + Vec3(0.0, 0.0, kLookHeight_m)) < kArmsReach_m * kArmsReach_m ||
            (context_.hands.answers() &&
             distance_squared(door, context_.hands.tool.proxy_m) < hand_reach_m * hand_reach_m))
            chosen = mover_of(world_, announced);
        if (chosen >= 0 && world_.movers.away(static_cast<std::uint32_t>(chosen)) > 0.0) chosen = -1;
    }
    if (chosen < 0)
        if (const auto seen = look(*world_.solids, avatar_.feet_m(), kLookHeight_m, avatar_.heading_rad, kArmsReach_m))
            chosen = mover_of(world_, seen->feature);
    if (chosen < 0) chosen = leaf_at_walker();
    if (chosen < 0) {
        double nearest_m = kArmsReach_m;
        const Vec3 middle = avatar_.feet_m() + Vec3(0.0, 0.0, kLookHeight_m);
        for (std::size_t i = 0; i < world_.scene->movers.size(); ++i) {
            if (!usable(world_, i)) continue;
            const double distance_m =
                std::sqrt(distance_squared(box_of(*world_.scene, world_.scene->movers[i].feature), middle));
            if (distance_m < nearest_m) {
                nearest_m = distance_m;
                chosen = static_cast<int>(i);
            }
        }
    }
    if (chosen < 0) return context_.answer(phrase("movers.none_in_reach"), now_s);
    const auto mover = static_cast<std::uint32_t>(chosen);
    if (!world_.scene->movers[mover].by_hand) return context_.answer(shut_words(mover), now_s);
    press(mover, true, now_s);
}

bool Doors::block(FeatureId feature, bool blocked) {
    const int mover = mover_of(world_, feature);
    if (mover < 0) return false;
    std::erase(announced_, feature);
    world_.movers.hold_shut(static_cast<std::uint32_t>(mover), blocked);
    return true;
}

// Describes how the door can be opened: the key to press, or the place of the button nearest to the walker.
std::string Doors::shut_words(std::uint32_t mover) const {
    const Mover& door = world_.scene->movers[mover];
    const std::string name = sentence_case(name_of(context_, door.feature));
    if (blocked(mover))
        return phrase("movers.blocked",
                      {{"name", sentence_case(spoken_name(world_.scene->features[door.feature.value]))}});
    if (door.by_hand) return phrase("lead.door_shut", {{"door", name}, {"key", context_.keys.keys_of(Command::Use)}});
    if (!door.approach_m.empty()) return phrase("movers.opens_by_itself", {{"name", name}});
    const std::optional<FeatureId> button = button_of(world_, mover, avatar_.feet_m() + Vec3(0.0, 0.0, kLookHeight_m));
    if (!button) return phrase("movers.opened_from_elsewhere", {{"name", name}});
    return phrase("movers.opened_by_button", {{"name", name},
                                              {"button", sentence_case(name_of(context_, *button))},
                                              {"where", where_words(context_, box_of(*world_.scene, *button))}});
}

// Returns what a thing would meet if it moved from `from` to `to`. If it meets nothing, this function makes the
// movement, and a walker on the thing moves with it.
Meeting Doors::meet(std::uint32_t mover, const Placement& from, const Placement& to) {
    if (world_.thing_of_mover[mover] < 0) return Meeting::None;
    const auto thing = [&](std::uint32_t i) { return static_cast<std::size_t>(world_.thing_of_mover[i]); };
    const PlacedModel& own = world_.scene->placed[thing(mover)];
    const bool door = world_.scene->features[own.feature.value].kind == FeatureKind::Door;
    const bool goes_shut = door ? world_.movers.goes_shut(mover) : world_.movers.goes_to_rest(mover);
    const WalkerShape body = avatar_.walker->shape();
    const Aabb there = placed_bounds(own.model->bounds_m, to);

    const Riding ride = avatar_.walker->state().on_ground ? rides(own, from, avatar_.feet_m(), body) : Riding::Not;
    const Vec3 way = carried(avatar_.feet_m(), from, to) - avatar_.feet_m();
    const bool goes_along = ride == Riding::ByMiddle || (ride == Riding::ByRim && way.z > 0.0);
    Vec3 feet = avatar_.feet_m();
    const auto place_walker = [&] {
        WalkerMotion stood = avatar_.walker->state();
        stood.feet_m = feet;
        avatar_.walker->resume(stood);
    };
    if (goes_along) {
        const auto index = static_cast<std::int32_t>(thing(mover));
        if (way.z < 0.0) {
            // A walker with one foot on the floor next to the thing would be left behind. So the walker is moved
            // completely onto the thing.
            const Vec3 onto = onto_thing(placed_bounds(own.model->bounds_m, from), feet, body.radius_m);
            feet = world_.solids->trace(feet, feet + onto, body, false, index).end_m;
        }
        // A walker on the threshold of a lift would hit the lintel, and steps in.
        const Vec3 stands = feet;
        const auto goes = [&](const Vec3& to_m) {
            const Vec3 in = world_.solids->trace(stands, to_m, body, false, index).end_m;
            const TraceHit hit = world_.solids->trace(in, in + way, body, false, index);
            feet = hit.end_m;
            return !hit.hit || hit.normal.z >= kCeiling;
        };
        if (!(door ? goes(feet) : step_in(feet, placed_bounds(own.model->bounds_m, from), goes))) return Meeting::Body;
    } else if (!passes_walker(world_.scene->features[own.feature.value], own,
                              goes_shut ? std::optional(world_.movers.at_goal(mover)) : std::nullopt, feet, body) &&
               boxes_meet(there, walker_box(feet, body)) && meets_walker(own.model, to, feet, body)) {
        // A thing that already overlaps the walker may move away from the walker. A thing that shuts may never move
        // against a walker, but who stands in the doorway of a lift that is about to go steps in.
        const bool lift_leaves = door && goes_shut && world_.movers.lift_is_away(mover);
        const std::uint32_t lift = world_.scene->movers[mover].lift;
        const auto clear = [&](const Vec3& to_m) {
            feet = world_.solids->trace(avatar_.feet_m(), to_m, body).end_m;
            return !meets_walker(own.model, to, feet, body);
        };
        const auto in_lift = [&](const PlacedModel& cabin) {
            return cabin.feature == avatar_.ground &&
                   step_in(feet, placed_bounds(cabin.model->bounds_m, world_.movers.at(lift)), clear);
        };
        if (lift_leaves && world_.thing_of_mover[lift] >= 0 && in_lift(world_.scene->placed[thing(lift)]))
            place_walker();
        else if (goes_shut || !meets_walker(own.model, from, avatar_.feet_m(), body)) return Meeting::Body;
    }

    for (std::uint32_t other = 0; other < world_.movers.size(); ++other) {
        if (other == mover || world_.thing_of_mover[other] < 0 || let_through(*world_.scene, mover, other)) continue;
        const PlacedModel& its = world_.scene->placed[thing(other)];
        const Placement at = world_.movers.at(other);
        if (!boxes_meet(there, placed_bounds(its.model->bounds_m, at)) || !things_meet(*own.model, to, *its.model, at))
            continue;
        if (!things_meet(*own.model, from, *its.model, at)) return Meeting::Mover;
    }

    if (goes_along) {
        place_walker();
        if (!(from.rotation == to.rotation)) {
            const Vec3 ahead =
                PlacedFrame(to).turned(PlacedFrame(from).turned_back(forward_of_heading(avatar_.heading_rad)));
            const double turned = wrap_angle(std::atan2(ahead.x, ahead.y) - avatar_.heading_rad);
            avatar_.heading_rad = wrap_angle(avatar_.heading_rad + turned);
            avatar_.heading_goal_rad = wrap_angle(avatar_.heading_goal_rad + turned);
        }
    }
    return Meeting::None;
}

void Doors::tick(double now_s, double dt_s) {
    contract_pre(std::isfinite(now_s) && dt_s >= 0.0);
    if (world_.movers.size() == 0) return;
    const Aabb stand = walker_box(avatar_.feet_m(), avatar_.walker->shape());
    for (std::uint32_t i = 0; i < world_.movers.size(); ++i) {
        if (world_.scene->movers[i].approach_m.empty() || world_.thing_of_mover[i] < 0) continue;
        const auto thing = static_cast<std::size_t>(world_.thing_of_mover[i]);
        if (boxes_meet(world_.scene->movers[i].approach_m, stand)) world_.movers.come_near(i);
        else if (rides(world_.scene->placed[thing], world_.things.at(thing), avatar_.feet_m(),
                       avatar_.walker->shape()) == Riding::Not)
            world_.movers.leave_alone(i);
    }
    if (!world_.movers.any_moving() && !world_.movers.any_waiting() && !world_.movers.any_endless()) return;

    std::vector<MoverEvent> events;
    world_.movers.tick(
        dt_s, [this](std::uint32_t mover, const Placement& from, const Placement& to) { return meet(mover, from, to); },
        events);
    for (std::uint32_t i = 0; i < world_.movers.size(); ++i)
        if (world_.thing_of_mover[i] >= 0)
            world_.things.put(static_cast<std::size_t>(world_.thing_of_mover[i]), world_.movers.at(i));
    announce(events, now_s);
}

void Doors::announce(std::span<const MoverEvent> events, double now_s) {
    for (const MoverEvent& event : events) {
        const Mover& mover = world_.scene->movers[event.mover];
        const Feature& feature = world_.scene->features[mover.feature.value];
        if (world_.thing_of_mover[event.mover] < 0) continue;
        const Aabb box = placed_bounds(
            world_.scene->placed[static_cast<std::size_t>(world_.thing_of_mover[event.mover])].model->bounds_m,
            world_.movers.at(event.mover));
        if (mover.endless()) {
            announce_endless(event, box, now_s);
            continue;
        }
        if (event.kind == MoverEvent::Kind::Arrives) arrived_ = true;
        const Vec3 middle = feature.bounds_m.centre_m();
        const double distance_m = glm::length(middle - avatar_.feet_m());
        // Only one leaf of a group is announced, and only if it is near. If a locked door waited for its button, it is
        // announced at any distance.
        const bool first = std::none_of(world_.scene->movers.begin(), world_.scene->movers.begin() + event.mover,
                                        [&](const Mover& other) { return other.group == mover.group; });
        if (!first) continue;
        const bool opens = feature.kind == FeatureKind::Door, button = feature.kind == FeatureKind::Button;
        // The world's file describes every door as shut. So "shut" means the position in the file, even if the door
        // rests open.
        const bool at_shut = opens ? event.at_rest != mover.rests_far : event.at_rest;
        cues::CueRequest sound;
        sound.kind = cues::CueRequestKind::Play;
        sound.sound = event.kind == MoverEvent::Kind::Leaves && !at_shut ? cues::SoundKind::DoorMoves
                                                                         : cues::SoundKind::DoorShuts;
        sound.time_s = now_s;
        sound.position_m = middle;
        sound.material = world_.scene->material(feature.material).sound;
        if (event.kind == MoverEvent::Kind::Leaves || (event.kind == MoverEvent::Kind::Arrives && at_shut)) {
            const bool speaks = distance_m < 10.0 || locked(world_, event.mover);
            // The door begins to shut. Its sound comes when it is shut.
            if (event.kind == MoverEvent::Kind::Leaves && at_shut) continue;
            context_.cues.cue(std::move(sound));
            if (!speaks) continue;
            const std::string name = sentence_case(spoken_name(feature));
            // The effect of a button is announced in the class Answer. If it were in the class Contact, this
            // announcement and "button pressed" would replace each other.
            const cues::SpeechClass as =
                locked(world_, event.mover) ? cues::SpeechClass::Answer : cues::SpeechClass::Contact;
            if (event.kind == MoverEvent::Kind::Leaves)
                context_.say(phrase(opens    ? "movers.opens"
                                    : button ? "movers.pressed"
                                             : "movers.moves",
                                    {{"name", name}}),
                             as, now_s);
            else
                context_.say(
                    phrase(opens    ? "movers.is_shut"
                           : button ? "movers.is_out_again"
                                    : "movers.is_back",
                           {{"name", name}}),
                    opens && distance_m < kNextToOne_m ? cues::SpeechClass::Warning : cues::SpeechClass::Ambient,
                    now_s);
        } else if (event.kind == MoverEvent::Kind::TurnsBack) {
            const bool opens_again = opens && !at_shut;
            context_.say(phrase(opens_again ? "movers.met_you" : "movers.met_you_goes_back",
                                {{"name", sentence_case(spoken_name(feature))}}),
                         cues::SpeechClass::Contact, now_s);
        } else if (feature.kind == FeatureKind::Lift) {
            const double z_m = world_.movers.at(event.mover).position_m.z;
            const std::string storey = storey_words(*world_.scene, world_.thing_of_mover[event.mover], z_m);
            context_.say(stops_words(mover, storey, z_m, sentence_case(spoken_name(feature))),
                         cues::SpeechClass::Contact, now_s);
        }
    }
}

// Announces a train or a turning part, which passes again and again. It makes a sound each time, but it is announced
// only if the walker stands on it or in its path.
void Doors::announce_endless(const MoverEvent& event, const Aabb& box_m, double now_s) {
    const Feature& feature = world_.scene->features[world_.scene->movers[event.mover].feature.value];
    const std::string name = sentence_case(spoken_name(feature));
    if (event.kind == MoverEvent::Kind::Waits)
        return context_.say(phrase("movers.met_you_waits", {{"name", name}}), cues::SpeechClass::Contact, now_s);
    cues::CueRequest sound =
        sound_at(event.kind == MoverEvent::Kind::Leaves ? cues::SoundKind::DoorMoves : cues::SoundKind::DoorShuts,
                 box_m.centre_m(), now_s);
    sound.material = world_.scene->material(feature.material).sound;
    context_.cues.cue(std::move(sound));
    if (world_.scene->movers[event.mover].feature == avatar_.ground)
        context_.say(phrase(event.kind == MoverEvent::Kind::Leaves ? "movers.moves" : "movers.stops", {{"name", name}}),
                     cues::SpeechClass::Contact, now_s);
}

void Doors::announce_shut(FeatureId feature, double now_s) {
    const int mover = mover_of(world_, feature);
    if (mover < 0 || world_.scene->features[feature.value].kind != FeatureKind::Door) return;
    const auto before = std::find(announced_.begin(), announced_.end(), feature);
    if (!shut(world_, static_cast<std::uint32_t>(mover))) {
        if (before != announced_.end()) announced_.erase(before);
        return;
    }
    if (before != announced_.end() || feature == shut_by_person_) return;
    announced_.push_back(feature);
    context_.say(shut_words(static_cast<std::uint32_t>(mover)), cues::SpeechClass::Answer, now_s);
}

void Doors::announce_touched(double now_s) {
    for (std::uint8_t i = 0; i < context_.hands.tool.contacts.count; ++i)
        announce_shut(context_.hands.tool.contacts.contacts[i].feature, now_s);
}

void Doors::announce_ahead(const Vec3& ahead_m, double now_s) {
    const Vec3 up(0.0, 0.0, kWaist_m);
    for (const Crossing& crossing : world_.solids->crossings(avatar_.feet_m() + up, ahead_m + up))
        announce_shut(crossing.feature, now_s);
}

}  // namespace handrail::core
