#include "app/core/hand/workspace.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/context/workspace_commands.h"
#include "app/core/world/questions.h"
#include "haptic/render/free_place.h"
#include "worlds/base/contract.h"
#include "worlds/base/human_measures.h"
#include "worlds/base/language.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {
namespace {

constexpr double kHandKeySpeed_m_per_s = 0.06;
constexpr double kPushSpeed_hand_m_per_s = 0.03;  // speed of the workspace while a key pushes it
constexpr double kPushTap_s = 0.2;
constexpr double kLowestLook_m = 0.2;

// If the walker does not see the hand and has moved on by kWalkedOn_m, the hand is left behind. If that lasts for
// kLeftBehind_s, the workspace is moved to the walker.
constexpr double kWalkedOn_m = 0.05;
constexpr double kLeftBehind_s = 0.5;

// Returns the direction in the device frame in which the keys push the workspace. `sign` combines two opposite keys.
template <class Sign>
Vec3 workspace_keys(Sign sign) {
    return {sign(Command::WorkspaceRight, Command::WorkspaceLeft),
            sign(Command::WorkspaceForward, Command::WorkspaceBack),
            sign(Command::WorkspaceUp, Command::WorkspaceDown)};
}

template <class Sign>
Vec3 hand_keys(Sign sign) {
    return {sign(Command::HandRight, Command::HandLeft), sign(Command::HandForward, Command::HandBack),
            sign(Command::HandUp, Command::HandDown)};
}

// Returns a function to use as `sign`, for which only the key `tapped` is down.
auto tap_of(Command tapped) {
    return [tapped](Command plus, Command minus) { return tapped == plus ? 1.0 : tapped == minus ? -1.0 : 0.0; };
}

}  // namespace

bool Workspace::act(Command command, double now_s) {
    // Without a hand, there is no workspace to change. The frame may still be switched, because the frame also affects
    // words. The simulated hand may still be moved.
    if (!hands_.right.present && lays_workspace(command)) {
        context_.answer(phrase("session.no_hand"), now_s);
        return true;
    }
    if (pushes_workspace(command)) {
        push_tap_ = workspace_keys(tap_of(command));
        push_until_s_ = now_s + kPushTap_s;
        return true;
    }
    const double turn_deg = context_.settings.walk.turn_deg;
    switch (command) {
        case Command::SwitchFrame:
            switch_frame(now_s);
            return true;
        case Command::ScaleBuilding:
        case Command::ScaleFloor:
        case Command::ScaleRoom:
        case Command::ScaleDetail:
            zoom(static_cast<NamedScale>(static_cast<int>(command) - static_cast<int>(Command::ScaleBuilding)), now_s);
            return true;
        case Command::WorkspaceTurnLeft:
            turn(-turn_deg, now_s);
            return true;
        case Command::WorkspaceTurnRight:
            turn(turn_deg, now_s);
            return true;
        case Command::WorkspaceCentre:
            publish(now_s, PoseChange::Placed);
            context_.answer(phrase("session.workspace_back"), now_s);
            return true;
        case Command::Grab: {
            bool& grabs = hands_.tuning.workspace.grab_key;
            grabs = !grabs;
            if (grabs) context_.answer(phrase("session.grabbed"), now_s);
            return true;
        }
        case Command::HandCentre:
            hand_target_m_ = Vec3(0.0);
            return true;
        case Command::HandForward:
        case Command::HandBack:
        case Command::HandLeft:
        case Command::HandRight:
        case Command::HandUp:
        case Command::HandDown:
            move_hand(hand_keys(tap_of(command)) * kHandTap_m);
            return true;
        default:
            return false;
    }
}

servo::WorkspacePose Workspace::pose_next_to(const Vec3& others_shift_m) const {
    servo::WorkspacePose pose = hands_.pose;
    pose.origin_m += others_shift_m;
    return pose;
}

// Returns the middle of the workspace before any shift.
Vec3 Workspace::origin_m() const {
    const settings::Settings::Workspace& workspace = context_.settings.workspace;
    const Aabb& bounds_m = context_.world.building_m;
    Vec3 origin = workspace.follows_walk ? context_.avatar.feet_m() : anchor_feet_m_;
    if (hands_.named_scale == NamedScale::Building && !bounds_m.empty()) {
        const Vec3 centre = bounds_m.centre_m();
        origin = Vec3(centre.x, centre.y, origin.z);
    } else if (!hands_.keys_alone) {
        // If there is no device, the simulated hand is at the walker. If it were farther ahead, it would reach through
        // the wall along which the person walks.
        origin += forward_of_heading(workspace_heading_rad(context_)) * (workspace.offset_ahead_m * scale(context_));
    }
    return origin + Vec3(0.0, 0.0, workspace.hand_height_m + workspace.offset_up_m * scale(context_));
}

void Workspace::publish(double now_s, PoseChange change) {
    if (change == PoseChange::Moved) shift_m_ += shift_by_hand_m();
    if (change == PoseChange::Placed) {
        anchor_feet_m_ = seen_from_m_ = context_.avatar.feet_m();
        hands_.left_behind = false;
        shift_m_ = shift_to_walker_m();
    }
    hands_.pose.heading_rad = workspace_heading_rad(context_);
    hands_.pose.origin_m = origin_m() + shift_m_;
    hands_.pose.time_s = now_s;
    if (change == PoseChange::Walked) return;
    ++hands_.pose.jump;
    let_go();
}

void Workspace::take_hand() {
    hand_target_m_ = Vec3(0.0);
    shift_m_ = Vec3(0.0);
}

void Workspace::take_settings(double now_s) {
    touch_.retune();
    touch_.adapt();
    publish(now_s, PoseChange::Moved);
}

void Workspace::switch_frame(double now_s) {
    const bool to_walk = context_.settings.workspace.frame == settings::FrameChoice::Map;
    context_.set("workspace.frame", to_walk ? "walk" : "map", now_s);
    context_.play(cues::SoundKind::FrameSwitch, now_s);
    context_.answer(phrase(to_walk ? "session.frame_walk" : "session.frame_map"), now_s);
}

void Workspace::change_under_hand(const std::function<bool()>& change, double now_s) {
    const bool known = hands_.tool.ticks > 0 && hands_.tool.workspace_jump == hands_.pose.jump;
    const Vec3 place_m = hands_.tool.proxy_m;
    const bool keeps_place = change() && known;
    touch_.retune();
    touch_.adapt();
    const auto hand_m = [&](const Vec3& origin_m) {
        return servo::frame_of(origin_m, workspace_heading_rad(context_)).to_world(hands_.tool.hand_m, scale(context_));
    };
    Vec3 shift{0.0};
    if (keeps_place) shift = place_m - hand_m(origin_m());
    shift += hands_out_of_solids_m(origin_m() + shift);
    shift_m_ = shift - shift_by_hand_m();
    publish(now_s, PoseChange::Moved);
}

void Workspace::zoom(NamedScale scale_name, double now_s) {
    change_under_hand(
        [&] {
            hands_.named_scale = scale_name;
            // Only the scale Building moves the workspace to another place, which is the middle of the building.
            return scale_name != NamedScale::Building;
        },
        now_s);
    scale_requested_s_ = now_s;
    context_.answer(
        scale_sentence(scale_name, scale(context_), hands_.right.spec.workspace_radius_m, distances(context_)), now_s);
}

void Workspace::turn(double by_deg, double now_s) {
    const double turned_rad = wrap_angle(radians_from_degrees(context_.settings.workspace.turn_deg + by_deg));
    const double turned_deg = std::round(degrees_from_radians(turned_rad) * 1e6) / 1e6;
    context_.set("workspace.turn_deg", fmt::format("{}", turned_deg), now_s);
    context_.play(cues::SoundKind::TurnTick, now_s);
    context_.answer(turned_deg == 0.0
                        ? phrase("session.workspace_straight")
                        : phrase(turned_deg > 0.0 ? "session.workspace_turned_right" : "session.workspace_turned_left",
                                 {{"degrees", std::abs(turned_deg)}}),
                    now_s);
}

Vec3 Workspace::push_way(double now_s) const {
    const Vec3 way = workspace_keys([this](Command plus, Command minus) { return keys_.sign(plus, minus); });
    return way == Vec3(0.0) && now_s < push_until_s_ ? push_tap_ : way;
}

void Workspace::push(const Vec3& carried_hand_m_per_s, double now_s) {
    const Vec3 way = push_way(now_s);
    hands_.tuning.workspace.push_hand_m_per_s = way == Vec3(0.0) ? carried_hand_m_per_s : way * kPushSpeed_hand_m_per_s;
}

void Workspace::announce_motion(double now_s) {
    const servo::WorkspaceMotion now = hands_.tool.workspace_motion != servo::WorkspaceMotion::Still
                                           ? hands_.tool.workspace_motion
                                           : hands_.left_tool.workspace_motion;
    const servo::WorkspaceMotion before = std::exchange(motion_announced_, now);
    if (before != motion_announced_ && motion_announced_ == servo::WorkspaceMotion::Still &&
        !(rests_silently && rests_silently()))
        context_.say(
            words(),
            before == servo::WorkspaceMotion::Scrolled ? cues::SpeechClass::Ambient : cues::SpeechClass::Answer, now_s);
    if (std::exchange(limit_announced_, hands_.tool.workspace_at_limit || hands_.left_tool.workspace_at_limit) ||
        !limit_announced_)
        return;
    context_.play(cues::SoundKind::Denied, now_s);
    context_.say(phrase("session.world_ends"), cues::SpeechClass::Ambient, now_s);
}

// Describes the position of the workspace relative to the walker.
std::string Workspace::words() const {
    const settings::Settings& settings = context_.settings;
    const Vec3 from_walker = shift_m_ + shift_by_hand_m() + origin_m() - context_.avatar.feet_m();
    const Vec3 level(from_walker.x, from_walker.y, 0.0);
    const double up_m =
        from_walker.z - settings.workspace.hand_height_m - settings.workspace.offset_up_m * scale(context_);
    const double away_m = glm::length(level);
    const std::string place = place_words(away_m, std::atan2(level.x, level.y), context_.avatar.heading_rad,
                                          settings.speech.directions, distances(context_));
    std::string text = away_m < 0.5 * settings.walk.step_length_m ? phrase("session.workspace_round_you")
                                                                  : phrase("session.workspace_at", {{"place", place}});
    if (std::abs(up_m) < 0.25) return text;
    return joined(text, phrase(up_m > 0.0 ? "session.up" : "session.down",
                               {{"distance", distance_words(std::abs(up_m), {false, 1.0})}}));
}

void Workspace::take_touch(bool rooms_known, bool quietly, double now_s) {
    touch_.widen_openings(rooms_known);
    if (!touch_.take_made(now_s)) return;
    bring_hands_out(now_s);
    if (quietly) return;
    const std::optional<double> requested_s = std::exchange(scale_requested_s_, std::nullopt);
    std::string news = touch_.news();
    if (news.empty()) return;
    if (requested_s) context_.answer(std::move(news), *requested_s);
    else context_.say(std::move(news), cues::SpeechClass::Ambient, now_s);
}

// Moves the hands out of solids that have appeared at the places of the hands.
void Workspace::bring_hands_out(double now_s) {
    if (hands_.tool.ticks == 0) return;
    const Vec3 out = touch_.out_of_solids_m(hands_.tool.proxy_m, hands_.left_tool.proxy_m);
    if (out == Vec3(0.0)) return;
    shift_m_ += out;
    publish(now_s, PoseChange::Moved);
}

bool Workspace::goes_with_walker() const {
    return hands_.known() && context_.settings.workspace.follows_walk && hands_.named_scale != NamedScale::Building &&
           !hands_.at_desk();
}

// Returns true if the walker sees this place from the height of the place itself or from eye height, which is above
// most furniture. A proxy partly inside a solid is also visible, because a doorway may be rendered wider than it is.
bool Workspace::walker_sees(const Vec3& place_m) const {
    const Vec3 feet = context_.avatar.feet_m();
    const WalkerSize& body = context_.avatar.walker->size();
    for (const double height_m : {std::clamp(place_m.z - feet.z, kLowestLook_m, body.height_m), kLookHeight_m}) {
        const Vec3 eye = feet + Vec3(0.0, 0.0, height_m);
        const TraceHit hit = context_.world.solids->trace(eye, place_m, WalkerShape{}, true);
        if (!hit.hit || glm::length(place_m - hit.end_m) <= hands_.tuning.touch.radius_m) return true;
    }
    return in_room_of_walker && in_room_of_walker(place_m);
}

Vec3 Workspace::hand_in_m(const Vec3& origin_m) const {
    return servo::frame_of(origin_m, workspace_heading_rad(context_)).to_world(hands_.tool.hand_m, scale(context_));
}

// Returns the vector to the walker from where the hand would be without shifts. Returns zero if the walker sees that
// place.
Vec3 Workspace::shift_to_walker_m() const {
    if (!goes_with_walker()) return Vec3(0.0);
    const Vec3 hand = hand_in_m(origin_m()), feet = context_.avatar.feet_m();
    if (walker_sees(hand)) return Vec3(0.0);
    const double most_m = context_.avatar.walker->size().height_m - hands_.tuning.touch.radius_m;
    return Vec3(feet.x, feet.y, feet.z + std::clamp(hand.z - feet.z, kLowestLook_m, most_m)) - hand;
}

std::string Workspace::bring_to_walker(double now_s) {
    publish(now_s, PoseChange::Placed);
    context_.play(cues::SoundKind::FrameSwitch, now_s);
    return phrase("session.hand_with_you");
}

void Workspace::stay_with_walker(double now_s) {
    if (!goes_with_walker()) {
        hands_.left_behind = false;
        return;
    }
    // The servo has not yet carried out the jump, so the reported position of the hand is the old one.
    if (hands_.tool.workspace_jump != hands_.pose.jump) return;
    const Vec3 feet = context_.avatar.feet_m();
    if (walker_sees(hands_.tool.proxy_m)) {
        seen_from_m_ = feet;
        hands_.left_behind = false;
        return;
    }
    if (!hands_.left_behind) {
        if (glm::length(feet - seen_from_m_) < kWalkedOn_m) return;
        hands_.left_behind = true;
        left_behind_s_ = now_s;
    }
    if (now_s - left_behind_s_ >= kLeftBehind_s)
        context_.say(bring_to_walker(now_s), cues::SpeechClass::Contact, now_s);
}

// Returns how far the hands must move out of solids if the workspace has the middle `origin_m`.
Vec3 Workspace::hands_out_of_solids_m(const Vec3& origin_m) const {
    const servo::WorkspaceFrame frame = servo::frame_of(origin_m, workspace_heading_rad(context_));
    return touch_.out_of_solids_m(frame.to_world(hands_.tool.hand_m, scale(context_)),
                                  frame.to_world(hands_.left_tool.hand_m, scale(context_)));
}

std::string Workspace::bring_out(const Vec3& middle_was_m, bool with_walker, double now_s) {
    if (!hands_.right.present) return {};
    if (hands_.left_behind) return bring_to_walker(now_s);
    const double clearance_m = 1.2 * hands_.tuning.touch.radius_m;
    const auto poses = context_.world.things.frame().poses();
    const Vec3 hand = hands_.tool.hip_m + (middle_m() - middle_was_m);
    const render::Surrounding around = render::surrounding_of(*touch_.felt(), poses, hand, clearance_m);
    if (around.distance_m > 0.0 && (with_walker || !hands_.tool.contacts.ghosted)) return {};
    const auto free = render::nearest_free_place(*touch_.felt(), poses, hand, clearance_m, touch_.farthest_m());
    if (!free) return phrase("session.no_place_for_hand");
    const std::string how_far = how_far_words(context_, glm::length(*free - hand));
    shift_m_ += *free - hand;
    publish(now_s, PoseChange::Moved);
    return around.feature
               ? phrase("session.hand_out_of", {{"what", name_of(context_, around.feature)}, {"distance", how_far}})
               : phrase("session.hand_out", {{"distance", how_far}});
}

void Workspace::move_hand(const Vec3& by_device_m) {
    contract_pre(is_finite(by_device_m));
    if (!is_finite(by_device_m)) return;
    hand_target_m_ += by_device_m;
    const double reach = hands_.right.present ? hands_.right.spec.workspace_radius_m : 0.0;
    const double length = glm::length(hand_target_m_);
    if (length > reach) hand_target_m_ *= reach / length;
}

void Workspace::move_hand_by_keys(double dt_s) {
    const Vec3 way = hand_keys([this](Command plus, Command minus) { return keys_.sign(plus, minus); });
    if (way != Vec3(0.0)) move_hand(way * (kHandKeySpeed_m_per_s * dt_s));
}

}  // namespace handrail::core
