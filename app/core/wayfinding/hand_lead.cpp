#include "app/core/wayfinding/hand_lead.h"

#include <algorithm>
#include <span>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/words.h"
#include "app/core/wayfinding/sought_route.h"
#include "worlds/base/language.h"
#include "worlds/navigation/route_place.h"

namespace handrail::core {
namespace {

constexpr double kAnnounced_s = 1.0;  // time from the announcement to the first force
// At this distance from the path, the hand has strayed. Each time it strays is one error.
constexpr double kStray_hand_m = 0.008;
constexpr double kLeft_hand_m = 0.020;  // at this distance, an unguided hand is off the path
constexpr double kLeft_s = 1.0;         // the hand has left the path once it has been kLeft_hand_m away for this long
// If the person walked or moved the workspace within this time, the hand was not pulled away by the person.
constexpr double kMovedLately_s = 0.5;
constexpr double kRests_s = 0.3;  // after this time at rest, a new path is planned
// If a path leads out of reach, the workspace moves along it. kCarryFrom and kCarryTo are the shares of the reach at
// which that begins and stops, and kCarry_hand_m_per_s is its speed.
constexpr double kCarryFrom = 0.55, kCarryTo = 0.45;
constexpr double kCarry_hand_m_per_s = 0.03, kCarryAhead_hand_m = 0.005;

std::span<const Vec3> points_of(const servo::GuidancePath& path) { return std::span(path.points_m).first(path.count); }

std::span<const render::Contact> contacts_of(const servo::ToolState& tool) {
    return std::span(tool.contacts.contacts).first(tool.contacts.count);
}

servo::GuidancePath pull_along(std::span<const Vec3> points_m) {
    servo::GuidancePath path;
    path.count = static_cast<std::uint32_t>(points_m.size());
    std::copy(points_m.begin(), points_m.end(), path.points_m.begin());
    return path;
}

servo::GuidancePath lines_along(std::span<const Vec3> points_m) {
    servo::GuidancePath path;
    path.kind = servo::GuidanceKind::PathLines;
    for (std::size_t i = 0; i + 1 < points_m.size(); ++i)
        for (const Vec3& end : {points_m[i], points_m[i + 1]}) path.points_m[path.count++] = end;
    return path;
}

bool are_lines(servo::GuidanceKind kind) {
    return kind == servo::GuidanceKind::CrossLines || kind == servo::GuidanceKind::PathLines;
}

}  // namespace

void HandLead::enter_world() {
    led_ = {};
    grooves_.enter_world();
}

bool HandLead::may_lead() const {
    return context_.hands.right.present && !context_.hands.keys_alone && context_.settings.guidance.pull;
}

std::string HandLead::why_no_force() const {
    const HandsState& hands = context_.hands;
    if (hands.tuning.panic || !hands.tuning.forces_on) return phrase("lead.forces_off");
    if (hands.tool.fault != servo::Fault::None) return servo::fault_sentence(hands.tool.fault);
    if (!hands.tuning.focused) return servo::fault_sentence(servo::Fault::FocusLost);
    if (hands.tool.pause != servo::Fault::None) return servo::fault_sentence(hands.tool.pause);
    if (hands.tool.ticks == 0 || hands.tool.waiting_for_hand) return phrase("lead.hand_waits");
    return {};
}

bool HandLead::lines_at_work() const {
    return (led_.acts && are_lines(led_.path.kind)) || (led_.announced && are_lines(led_.announced->kind));
}

void HandLead::pull(const HandRoute& way, double strength, std::string words, double now_s) {
    servo::GuidancePath path = pull_along(way.points_m);
    path.strength = strength;
    announce(path, std::move(words), now_s);
    led_.to_nearest = !way.reaches;
}

void HandLead::lines(const HandRoute& way, std::string words, double now_s) {
    servo::GuidancePath path = lines_along(way.points_m);
    path.strength = context_.settings.guidance.strength;
    announce(path, std::move(words), now_s);
}

void HandLead::cross_lines(const Vec3& at_m, std::string words, double now_s) {
    servo::GuidancePath path;
    path.kind = servo::GuidanceKind::CrossLines;
    path.strength = context_.settings.guidance.strength;
    path.points_m[0] = at_m;
    path.count = 1;
    announce(path, std::move(words), now_s);
}

void HandLead::end() {
    led_.announced.reset();
    led_.path.number = 0;
    led_.acts = false;
    led_.left = false;
}

void HandLead::announce(servo::GuidancePath path, std::string words, double now_s) {
    end();  // Only one kind of guidance acts at a time, so the previous one ends.
    path.number = ++last_number_;
    led_.announced = path;
    led_.starts_s = now_s + kAnnounced_s;
    led_.errors = 0;
    led_.stray = false;
    led_.to_nearest = false;
    led_.jump = context_.hands.pose.jump;
    led_.feet_before_m = context_.avatar.feet_m();
    led_.moved_s = led_.off_since_s = -1e9;
    doors_.forget_announced();
    led_.planned_in = context_.world.scene;
    context_.play(cues::SoundKind::GuideStart, now_s);
    context_.answer(std::move(words), now_s);
}

void HandLead::publish(servo::GuidancePath path) {
    path.number = ++last_number_;
    led_.path = path;
}

// Continues the present guidance along another path. Strength and number of errors stay the same.
void HandLead::go_on_along(servo::GuidancePath path) {
    path.strength = led_.path.strength;
    publish(path);
}

// Returns true once the hand touches any part of the goal.
bool HandLead::hand_at(const std::optional<Goal>& goal) const {
    if (!goal || !goal->feature) return false;
    const auto contacts = contacts_of(context_.hands.tool);
    return std::any_of(contacts.begin(), contacts.end(),
                       [&](const render::Contact& contact) { return contact.feature == goal->feature; });
}

// ---- every tick ----

bool HandLead::wants_new_path(const std::optional<Goal>& goal, double now_s) {
    if (led_.path.kind != servo::GuidanceKind::Pull &&
        !(led_.announced && led_.announced->kind == servo::GuidanceKind::Pull))
        return false;
    const servo::ToolState& tool = context_.hands.tool;
    const Vec3& feet_m = context_.avatar.feet_m();
    if (tool.workspace_motion == servo::WorkspaceMotion::Grabbed || feet_m != led_.feet_before_m) led_.moved_s = now_s;
    // If a moving door leaf pushes the hand, the person has not pulled the hand away.
    const auto contacts = contacts_of(tool);
    if (context_.world.movers.any_moving() &&
        std::any_of(contacts.begin(), contacts.end(),
                    [&](const render::Contact& contact) { return mover_of(context_.world, contact.feature) >= 0; }))
        led_.moved_s = now_s;
    led_.feet_before_m = feet_m;
    if (!at_work()) return false;
    if (std::exchange(led_.jump, context_.hands.pose.jump) != context_.hands.pose.jump) {
        end();
        led_.left = true;
        led_.moved_s = now_s;
    }
    if (context_.hands.tuning.panic) led_.left = false;
    return led_.left && now_s - led_.moved_s >= kRests_s && goal;
}

std::optional<HandLead::Arrival> HandLead::tick(const std::optional<Goal>& goal, double now_s) {
    if (led_.announced && now_s >= led_.starts_s) {
        led_.path = *led_.announced;
        if (led_.path.kind == servo::GuidanceKind::Pull)
            // The hand may have moved since the announcement, so the path begins at its present place.
            led_.path.points_m[0] = finding_place_m(context_);
        led_.announced.reset();
        led_.acts = true;
        led_.lines_laid_s = now_s;
        if (led_.path.kind == servo::GuidanceKind::PathLines) led_.off_since_s = now_s;
    }
    if (!at_work()) lay_grooves(now_s);
    if (!led_.acts) return std::nullopt;
    if (plans_.by_hand()) plans_.pass(finding_place_m(context_));
    const servo::ToolState& tool = context_.hands.tool;
    const servo::GuidanceState felt = tool.guidance;
    // The servo has not received this path yet, so its report is about an older path.
    if (felt.number != led_.path.number) return std::nullopt;
    const bool pull = led_.path.kind == servo::GuidanceKind::Pull, acts = felt.phase == servo::GuidancePhase::Acts;
    bool arrived = felt.phase == servo::GuidancePhase::Arrived;
    if (led_.path.kind == servo::GuidanceKind::CrossLines && acts) return std::nullopt;
    if (led_.path.kind == servo::GuidanceKind::PathLines) {
        // If a jump of the workspace ended the lines, they are set again from the new place of the hand.
        if (acts || force_may_act()) {
            arrived = acts && (hand_at(goal) || glm::length(tool.hip_m - points_of(led_.path).back()) <=
                                                    servo::Guidance::kArrived_m * scale(context_));
            if (!arrived) {
                watch_lines(goal, now_s);
                return std::nullopt;
            }
        }
    } else if (acts) {
        arrived = hand_at(goal);
        if (!arrived) {
            watch_path(goal, now_s);
            return std::nullopt;
        }
    }
    if (pull && felt.phase == servo::GuidancePhase::LetGo && now_s - led_.moved_s < kMovedLately_s) {
        end();
        led_.left = true;
        return std::nullopt;
    }
    end();
    if (arrived) {
        context_.play(cues::SoundKind::Arrived, now_s);
        return Arrival{pull, led_.to_nearest};
    }
    context_.play(cues::SoundKind::GuideStop, now_s);
    context_.answer(felt.phase == servo::GuidancePhase::LetGo ? phrase("lead.let_go") : no_longer_words(), now_s);
    return std::nullopt;
}

// Says that the servo has ended the guidance, and why. If the cause is already over, says that the force was off for a
// moment.
std::string HandLead::no_longer_words() const {
    std::string why = why_no_force();
    if (why.empty()) why = phrase("lead.force_was_off", {{"key", context_.keys.keys_of(Command::TakeMe)}});
    return phrase("lead.no_longer") + " " + why;
}

// While the hand is pulled, announces doors on the path and checks how far the hand is from the path.
void HandLead::watch_path(const std::optional<Goal>& goal, double now_s) {
    doors_.announce_touched(now_s);
    if (goal && led_.planned_in != context_.world.scene) {
        // Something has moved since the path was planned, such as a door leaf. So the same guidance silently continues
        // along a new path.
        led_.planned_in = context_.world.scene;
        const HandRoute way = plans_.for_hand(*goal, servo::GuidancePath::kMostPoints);
        if (!way.points_m.empty()) go_on_along(pull_along(way.points_m));
        return;
    }
    const double off_m =
        navigation::nearest_on_path(points_of(led_.path), context_.hands.tool.hip_m).distance_m / scale(context_);
    if (off_m > kStray_hand_m && !std::exchange(led_.stray, true)) ++led_.errors;
    if (off_m < 0.5 * kStray_hand_m) led_.stray = false;
    if (off_m <= kLeft_hand_m) led_.off_since_s = now_s;
    const bool moved = off_m > kStray_hand_m && now_s - led_.moved_s < kMovedLately_s;
    const bool strayed = led_.off_since_s >= 0.0 && now_s - led_.off_since_s > kLeft_s;
    if (!moved && !strayed) return;
    end();
    led_.left = true;
}

// Leaves the lines in place until the hand has left them or something has moved.
void HandLead::watch_lines(const std::optional<Goal>& goal, double now_s) {
    doors_.announce_touched(now_s);
    const servo::ToolState& tool = context_.hands.tool;
    if (navigation::nearest_on_path(points_of(led_.path), tool.hip_m).distance_m <= kLeft_hand_m * scale(context_))
        led_.off_since_s = now_s;
    const bool ended = tool.guidance.phase != servo::GuidancePhase::Acts;
    if ((ended || led_.planned_in != context_.world.scene || now_s - led_.off_since_s > kLeft_s) &&
        now_s - led_.lines_laid_s > SoughtRoute::kAgain_s && goal)
        lay_lines(*goal, now_s);
}

// Silently sets the lines again, from the place of the hand. If no path leads from there, the old lines stay.
void HandLead::lay_lines(const Goal& goal, double now_s) {
    led_.lines_laid_s = now_s;
    led_.planned_in = context_.world.scene;
    led_.off_since_s = now_s;
    const HandRoute way = plans_.for_hand(goal, kMostLinePoints);
    if (!way.reaches || way.points_m.size() < 2) return;
    go_on_along(lines_along(way.points_m));
}

void HandLead::lay_grooves(double now_s) {
    if (grooves_.wanted() && force_may_act()) {
        if (const auto path = grooves_.lay(led_.path, now_s)) publish(*path);
    } else if (led_.path.kind == servo::GuidanceKind::Grooves) {
        led_.path.number = 0;
    }
}

Vec3 HandLead::carry() {
    const HandsState& hands = context_.hands;
    const servo::ToolState& tool = hands.tool;
    const auto way = points_of(led_.path);
    // If the guidance consists of lines, the workspace moves only while the hand is on the lines and leans along them.
    const bool lines = led_.path.kind == servo::GuidanceKind::PathLines;
    const bool led = led_.acts && (lines || led_.path.kind == servo::GuidanceKind::Pull) && led_.path.strength > 0.0 &&
                     tool.guidance.number == led_.path.number && tool.guidance.phase == servo::GuidancePhase::Acts &&
                     tool.workspace_jump == hands.pose.jump && !hands.at_desk() &&
                     (!lines || navigation::nearest_on_path(way, tool.hip_m).distance_m <=
                                    servo::Guidance::kGrooveHalfWidth_m * scale(context_));
    Vec3 push(0.0);
    bool carries = false;
    if (led) {
        const double ahead_m = kCarryAhead_hand_m * scale(context_);
        const Vec3 ahead =
            navigation::place_along(way, navigation::nearest_on_path(way, tool.hip_m).along_m + ahead_m) - tool.hip_m;
        if (const double length_m = glm::length(ahead); length_m > 1e-6) {
            push = servo::frame_of(hands.pose.origin_m, hands.pose.heading_rad).turn_to_device(ahead / length_m);
            carries = glm::dot(tool.hand_m, push) >
                      (led_.carries ? kCarryTo : kCarryFrom) * hands.right.spec.workspace_radius_m;
        }
    }
    led_.carries = carries;
    led_.carried = led_.carried || carries;
    return carries ? push * kCarry_hand_m_per_s : Vec3(0.0);
}

}  // namespace handrail::core
