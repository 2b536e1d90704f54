// AppCore's part on being led: by the hand along the planned way, by words and following without a device, and the lines through a thing. What is said, when
// force may act, and what happens when the way is left. App thread only.
#include <algorithm>
#include <cmath>

#include "app/core/app_core.h"
#include "app/core/hand_way.h"
#include "worlds/base/language.h"
#include "worlds/navigation/way_place.h"

namespace handrail {
namespace {

constexpr double kAnnounced_s = 1.0;     // between telling that the hand will be led and the first force
constexpr double kStray_hand_m = 0.008;  // off the way
constexpr double kLeft_hand_m = 0.020;   // a hand on its own has left the way
constexpr double kLeft_s = 1.0;          // when it is so far off for so long
constexpr double kMovedLately_s = 0.5;   // who walks or moves the workspace does not hold against the pull
constexpr double kRests_s = 0.3;         // afterwards a new way is planned
constexpr double kWaist_m = 1.0;
constexpr double kLowest_m = 0.3, kHighest_m = 1.6;  // of a led hand over the floor: over door sills, under lintels
constexpr double kGroovesAgain_s = 1.0;              // grooves that ended are laid again no sooner
constexpr double kDoorAhead_m = 1.0;                 // along the way, to a door that is told: within reach
// Where the way leads out of reach the workspace goes on along it: from so much of the reach on, back to so much of it, and so fast.
constexpr double kCarryFrom = 0.55, kCarryTo = 0.45;
constexpr double kCarry_hand_m_per_s = 0.03, kCarryAhead_hand_m = 0.005;

// Two sentences, one after the other; either may be empty.
std::string beside(const std::string& first, const std::string& then) { return first.empty() || then.empty() ? first + then : first + " " + then; }

std::span<const Vec3> points_of(const GuidancePath& path) { return std::span(path.points_m).first(path.count); }

GuidancePath pull_along(std::span<const Vec3> points_m) {
    GuidancePath path;
    path.count = static_cast<std::uint32_t>(points_m.size());
    std::copy(points_m.begin(), points_m.end(), path.points_m.begin());
    return path;
}

constexpr std::size_t kMostLinePoints = GuidancePath::kMostPoints / 2 + 1;

GuidancePath lines_along(std::span<const Vec3> points_m) {
    GuidancePath path;
    path.kind = GuidanceKind::WayLines;
    for (std::size_t i = 0; i + 1 < points_m.size(); ++i)
        for (const Vec3& end : {points_m[i], points_m[i + 1]}) path.points_m[path.count++] = end;
    return path;
}

// What acts goes on along another path.
void go_on_along(GuidancePath path, Guiding& g) {
    path.strength = g.path.strength;
    path.number = ++g.last_number;
    g.path = path;
}

bool are_lines(GuidanceKind kind) { return kind == GuidanceKind::CrossLines || kind == GuidanceKind::WayLines; }

}  // namespace

// Nothing pulls any more; what is felt fades.
void AppCore::end_guidance() {
    guiding_.announced.reset();
    guiding_.path.number = 0;
    guiding_.acts = false;
    guiding_.left = false;
}

bool AppCore::force_may_guide() const { return tuning_.forces_on && !tuning_.panic && tuning_.focused && tool_.fault == Fault::None && tool_.ticks > 0; }

// A hand that is only simulated for want of a device is led by ear.
bool AppCore::hand_may_be_led() const { return hand_.present && !keys_alone_ && settings_.guidance.pull; }

void AppCore::announce(GuidancePath path, std::string words, double now_s) {
    end_guidance();  // one at a time
    path.number = ++guiding_.last_number;
    guiding_.announced = path;
    guiding_.starts_s = now_s + kAnnounced_s;
    guiding_.errors = 0;
    guiding_.stray = false;
    guiding_.to_nearest = false;
    guiding_.jump = pose_.jump;
    guiding_.feet_before_m = feet_m();
    guiding_.moved_s = guiding_.off_since_s = -1e9;
    guiding_.doors_told.clear();
    guiding_.planned_in = scene_;
    play(SoundKind::GuideStart, now_s);
    answer(std::move(words), now_s);
}

void AppCore::take_me(double now_s) {
    if (guiding_.acts || guiding_.announced || guiding_.left) {
        end_guidance();
        play(SoundKind::GuideStop, now_s);
        return answer(phrase("lead.let_go"), now_s);
    }
    if (!hand_may_be_led() && follower_.following()) {
        follower_.stop();
        run_.reset();
        guiding_.beacon.clear();
        return answer(phrase("lead.stopped"), now_s);
    }
    if (!hand_may_be_led() && guiding_.beacon.on()) return mute_beacon(now_s);
    if (!guiding_.goal) return open_find(now_s);
    lead_to(*guiding_.goal, {}, now_s);
}

std::string AppCore::why_no_way() const {
    return rooms_ && rooms_beside_ && !rooms_->ready() ? phrase("lead.ways_not_yet") : phrase("lead.stands_between");
}

// Straight to the thing where the ball passes, else along the planned way; where none is known, straight as long as nothing stands between.
AppCore::HandLead AppCore::hand_lead(const Goal& goal, std::size_t most_points) {
    HandLead lead;
    const Vec3 from = finding_place_m(), on = place_on(goal.box_m, from);
    const std::vector<Vec3> straight{from, nearest_place(goal.box_m, from)};
    const bool along_kept = runs_to(goal.name) && run_->by_hand;  // the way that was kept, and not the nearest one
    const bool stops_first = along_kept && run_->next < run_->goal();
    if (!stops_first && ball_passes(*body_world_, from, on, goal.feature)) {
        lead.points_m = straight;
        return lead;
    }
    Route route;
    if (rooms_known()) route = along_kept ? way_on(from) : walk_to_thing(rooms_->navigation(), *body_world_, from, goal.box_m, goal.feature);
    if (!stops_first && (!route.reaches || !hand_can_follow(route)) && free_line(*body_world_, from, on, goal.feature)) {
        lead.points_m = straight;
        return lead;
    }
    if (!rooms_known()) lead.problem = why_no_way();
    else if (route.points_m.empty()) lead.problem = phrase("lead.no_start");
    else if (!hand_can_follow(route)) lead.problem = phrase("lead.not_for_hands");
    know_way(route.points_m);
    if (!lead.problem.empty()) return lead;
    lead.reaches = route.reaches;
    lead.short_of_m = route.short_of_m;
    for (const RoutePassage& passage : route.passages)
        if (passage.kind == PassageKind::Door || passage.kind == PassageKind::Stairs)
            lead.passes.push_back(passage_name(passage.kind, passage.feature, passage.rise_m));
    const double height_m = std::clamp(settings_.workspace.hand_height_m, kLowest_m, kHighest_m);
    lead.points_m = hand_way(route, from, height_m, *body_world_, goal.box_m, goal.feature, most_points);
    return lead;
}

// By the hand where there is one, else by ear. `first` is said before all else.
void AppCore::lead_to(const Goal& goal, const std::string& first, double now_s) {
    guiding_.goal = goal;
    if (!hand_may_be_led()) return lead_by_ear(goal, first, now_s);
    if (!force_may_guide()) return lead_by_ear(goal, beside(first, phrase("lead.forces_off")), now_s);
    const HandLead lead = hand_lead(goal, GuidancePath::kMostPoints);
    if (lead.points_m.empty()) return lead_by_ear(goal, beside(first, lead.problem), now_s);
    GuidancePath path = pull_along(lead.points_m);
    Laps& laps = guiding_.laps;
    laps.begin(fmt::format("{} {}", goal.name, goal.feature.value));  // ten windows have one name
    path.strength = laps.strength() * settings_.guidance.strength;
    const std::string where = where_words(goal.box_m);
    std::string words = first;
    if (!lead.reaches) words = beside(words, phrase("lead.to_nearest", {{"goal", goal.name}, {"short_of", distance_words(lead.short_of_m, distances())}}));
    else if (laps.strength() == 0.0) words = beside(words, phrase("lead.alone", {{"goal", goal.name}, {"where", where}}));
    else words = beside(words, phrase("lead.taking", {{"goal", goal.name}, {"where", where}}));
    if (!lead.passes.empty()) words = beside(words, phrase("lead.by_way_of", {{"passages", fmt::format("{}", fmt::join(lead.passes, ", "))}}));
    if (laps.strength() == 1.0) words = beside(words, phrase("lead.hold_to_end"));
    else if (laps.strength() > 0.0) words = beside(words, phrase("lead.help", {{"percent", std::lround(100.0 * laps.strength())}}));
    announce(path, std::move(words), now_s);
    guiding_.to_nearest = !lead.reaches;
}

// The way in words and along it, as to a room; the beacon calls from the thing where nothing stands between.
void AppCore::lead_by_ear(const Goal& goal, const std::string& first, double now_s) {
    end_guidance();
    follower_.stop();
    guiding_.beacon.clear();
    if (runs_to(goal.name) && run_->by_hand) {
        run_->by_hand = false;
        return go_on_way(first, now_s);
    }
    const Vec3 waist = feet_m() + Vec3(0.0, 0.0, kWaist_m);
    const bool in_sight = free_line(*body_world_, waist, place_on(goal.box_m, waist), goal.feature);
    Route route;
    if (rooms_known()) route = walk_to_thing(rooms_->navigation(), *body_world_, feet_m(), goal.box_m, goal.feature);
    const bool straight = route.reaches && route.points_m.size() <= 2;
    if (in_sight || route.points_m.empty()) start_beacon(goal);
    if (route.points_m.empty() || (in_sight && straight))
        return answer(beside(first, phrase("lead.follow_beacon", {{"goal", goal.name}, {"where", where_words(goal.box_m)}})), now_s);
    follow_route(std::move(route), goal.name, first, now_s);
}

// Lines from the hand along its way to the thing; where there is none or it is not wished for, three planes through the thing, on which the hand likes to rest.
void AppCore::cross_lines(const Goal& goal, double now_s) {
    guiding_.goal = goal;
    if (!hand_.present) return answer(phrase("lead.lines_need_device"), now_s);
    if (!force_may_guide()) return answer(phrase("lead.forces_off"), now_s);
    std::string why = phrase("lead.straight");
    if (settings_.guidance.along_way) {
        const HandLead lead = hand_lead(goal, kMostLinePoints);
        if (lead.reaches && lead.points_m.size() >= 2) {
            GuidancePath path = lines_along(lead.points_m);
            path.strength = settings_.guidance.strength;
            std::string words = phrase("lead.lines_along", {{"goal", goal.name}, {"where", where_words(goal.box_m)}});
            if (!lead.passes.empty()) words = beside(words, phrase("lead.by_way_of", {{"passages", fmt::format("{}", fmt::join(lead.passes, ", "))}}));
            return announce(path, std::move(words), now_s);
        }
        why = beside(lead.problem, phrase(lead.reaches ? "lead.straight" : "lead.no_way"));
    }
    GuidancePath path;
    path.kind = GuidanceKind::CrossLines;
    path.strength = settings_.guidance.strength;
    path.points_m[0] = goal.box_m.centre_m();
    path.count = 1;
    announce(path, beside(phrase("lead.lines", {{"goal", goal.name}}), why), now_s);
}

// They act, or have been told.
bool AppCore::lines_wished() const {
    return (guiding_.acts && are_lines(guiding_.path.kind)) || (guiding_.announced && are_lines(guiding_.announced->kind));
}

void AppCore::toggle_lines(double now_s) {
    if (lines_wished()) {
        end_guidance();
        play(SoundKind::GuideStop, now_s);
        return answer(phrase("lead.lines_off"), now_s);
    }
    if (!guiding_.goal) return open_find(now_s);
    cross_lines(*guiding_.goal, now_s);
}

// ---- every tick ----

// A shut door across the way is told once, with the key that opens it; again once it has been open.
void AppCore::tell_shut_door(FeatureId feature, double now_s) {
    const int mover = mover_of(feature);
    if (mover < 0 || scene_->features[feature.value].kind != FeatureKind::Door) return;
    std::vector<FeatureId>& told = guiding_.doors_told;
    const auto before = std::find(told.begin(), told.end(), feature);
    if (!shut(static_cast<std::uint32_t>(mover))) {
        if (before != told.end()) told.erase(before);
        return;
    }
    if (before != told.end()) return;
    told.push_back(feature);
    say(shut_door_words(static_cast<std::uint32_t>(mover)), SpeechClass::Answer, now_s);
}

void AppCore::tell_shut_doors(double now_s) {
    for (std::uint8_t i = 0; i < tool_.contacts.count; ++i) tell_shut_door(tool_.contacts.contacts[i].feature, now_s);
}

// Those that the body comes to.
void AppCore::tell_shut_doors_ahead(const SoughtWay& way, double now_s) {
    const Vec3 up(0.0, 0.0, kWaist_m);
    for (const Crossing& crossing : body_world_->crossings(feet_m() + up, way.ahead_m(kDoorAhead_m) + up)) tell_shut_door(crossing.feature, now_s);
}

// True once the hand touches what it is led to, wherever on it.
bool AppCore::hand_at_goal() const {
    if (!guiding_.goal || !guiding_.goal->feature) return false;
    const auto contacts = std::span(tool_.contacts.contacts).first(tool_.contacts.count);
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) { return contact.feature == guiding_.goal->feature; });
}

// Who walks, turns or moves the workspace has not pulled the hand out of the lead: a new way is told once all is at rest.
void AppCore::notice_left_way(double now_s) {
    Guiding& g = guiding_;
    if (tool_.workspace_motion == WorkspaceMotion::Grabbed || feet_m() != g.feet_before_m) g.moved_s = now_s;
    // The leaf of a door takes the hand along.
    const auto contacts = std::span(tool_.contacts.contacts).first(tool_.contacts.count);
    if (movers_.any_moving() && std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) { return mover_of(contact.feature) >= 0; }))
        g.moved_s = now_s;
    g.feet_before_m = feet_m();
    if (!g.acts && !g.announced && !g.left) return;
    if (std::exchange(g.jump, pose_.jump) != pose_.jump) {
        end_guidance();
        g.left = true;
        g.moved_s = now_s;
    }
    if (tuning_.panic) g.left = false;
    if (!g.left || now_s - g.moved_s < kRests_s || !g.goal) return;
    const int errors = g.errors;
    lead_to(*g.goal, phrase("lead.left_way"), now_s);
    g.errors = errors + 1;
}

void AppCore::follow_guidance(double now_s) {
    Guiding& g = guiding_;
    if (g.path.kind == GuidanceKind::Pull || (g.announced && g.announced->kind == GuidanceKind::Pull)) notice_left_way(now_s);
    if (g.announced && now_s >= g.starts_s) {
        g.path = *g.announced;
        if (g.path.kind == GuidanceKind::Pull) g.path.points_m[0] = finding_place_m();  // where it has come to meanwhile
        g.announced.reset();
        g.acts = true;
        g.lines_laid_s = now_s;
        if (g.path.kind == GuidanceKind::WayLines) g.off_since_s = now_s;
    }
    if (!g.acts && !g.announced && !g.left) lay_grooves(now_s);
    if (!g.acts) return;
    if (run_ && run_->by_hand) pass_stops();
    if (tool_.guidance.number != g.path.number) return;  // the servo has not seen it yet
    const bool pull = g.path.kind == GuidanceKind::Pull;
    bool arrived = tool_.guidance.phase == GuidancePhase::Arrived;
    if (g.path.kind == GuidanceKind::CrossLines && tool_.guidance.phase == GuidancePhase::Acts) return;
    if (g.path.kind == GuidanceKind::WayLines) {
        // Those that a jump of the workspace ended are laid from where the hand is then.
        const bool acts = tool_.guidance.phase == GuidancePhase::Acts;
        if (acts || force_may_guide()) {
            arrived = acts && (hand_at_goal() || glm::length(tool_.hip_m - points_of(g.path).back()) <= Guidance::kArrived_m * scale());
            if (!arrived) return watch_lines(now_s);
        }
    } else if (tool_.guidance.phase == GuidancePhase::Acts) {
        arrived = hand_at_goal();
        if (!arrived) return watch_way(now_s);
    }
    if (pull && tool_.guidance.phase == GuidancePhase::LetGo && now_s - g.moved_s < kMovedLately_s) {
        end_guidance();
        g.left = true;
        return;
    }
    const bool to_nearest = g.to_nearest;
    end_guidance();
    if (arrived) {
        if (pull) g.laps.finish(g.errors, settings_.guidance.fades);
        play(SoundKind::Arrived, now_s);
        const std::string name = g.goal ? g.goal->name : std::string();
        if (to_nearest) run_.reset();
        if (runs_to(name) && run_->by_hand && next_stop(phrase("ways.reached", {{"stop", name}}), now_s)) return;
        return answer(to_nearest ? phrase("lead.nearest_place", {{"goal", name}}) : phrase("lead.here", {{"goal", name}}), now_s);
    }
    play(SoundKind::GuideStop, now_s);
    answer(tool_.guidance.phase == GuidancePhase::LetGo ? phrase("lead.let_go") : phrase("lead.no_longer"), now_s);
}

// Something stands elsewhere than when the way was planned, such as the leaf of a door: the same lead goes on along a new way, without a word.
void AppCore::renew_way() {
    Guiding& g = guiding_;
    g.planned_in = scene_;
    const HandLead lead = hand_lead(*g.goal, GuidancePath::kMostPoints);
    if (lead.points_m.empty()) return;
    go_on_along(pull_along(lead.points_m), g);
}

// Anew from where the hand is, without a word; where no way leads from there those that lie stay.
void AppCore::lay_lines(double now_s) {
    Guiding& g = guiding_;
    g.lines_laid_s = now_s;
    g.planned_in = scene_;
    g.off_since_s = now_s;
    const HandLead lead = hand_lead(*g.goal, kMostLinePoints);
    if (!lead.reaches || lead.points_m.size() < 2) return;
    go_on_along(lines_along(lead.points_m), g);
}

// Lines lie where they are until the hand has left them, or something stands elsewhere.
void AppCore::watch_lines(double now_s) {
    Guiding& g = guiding_;
    tell_shut_doors(now_s);
    if (nearest_on_way(points_of(g.path), tool_.hip_m).distance_m <= kLeft_hand_m * scale()) g.off_since_s = now_s;
    const bool ended = tool_.guidance.phase != GuidancePhase::Acts;
    if ((ended || g.planned_in != scene_ || now_s - g.off_since_s > kLeft_s) && now_s - g.lines_laid_s > SoughtWay::kAgain_s && g.goal) lay_lines(now_s);
}

// The way planned last, along which a groove runs.
void AppCore::know_way(std::vector<Vec3> soles_m) {
    guiding_.grooves_changed = guiding_.grooves_changed || guiding_.way_m != soles_m;
    guiding_.way_m = std::move(soles_m);
}

// Grooves lie while they are wished for and nothing else acts; they are laid anew for another way, another scale, and a hand that has gone far.
void AppCore::lay_grooves(double now_s) {
    Guiding& g = guiding_;
    const bool lie = g.path.number != 0 && g.path.kind == GuidanceKind::Grooves;
    if (!settings_.guidance.grooves || !hand_.present || keys_alone_ || !force_may_guide() || at_desk()) {
        if (lie) g.path.number = 0;
        return;
    }
    if (!rooms_known()) return;
    if (!std::exchange(g.doorways_known, true)) g.doorways = grooves_through_doorways(rooms_->graph(), rooms_->navigation().space());
    if (lie && tool_.guidance.number == g.path.number && tool_.guidance.phase != GuidancePhase::Acts && now_s - g.grooves_ended_s > kGroovesAgain_s) {
        g.grooves_ended_s = now_s;  // a jump of the workspace, or force that might not act
        g.grooves_changed = true;
    }
    const Vec3 here = finding_place_m();
    if (lie && !g.grooves_changed && g.grooves_scale == scale() && glm::length(here - g.grooves_near_m) <= g.grooves_good_within_m) return;
    Grooves grooves = nearest_grooves(g.way_m, g.doorways, here, tuning_.touch.radius_m);
    g.grooves_changed = false;
    g.grooves_near_m = here;
    g.grooves_good_within_m = grooves.good_within_m;
    g.grooves_scale = scale();
    g.path = grooves.path;
    g.path.strength = settings_.guidance.strength;
    g.path.number = ++g.last_number;
}

// While it pulls: doors across the way, and how far off it the hand is.
void AppCore::watch_way(double now_s) {
    Guiding& g = guiding_;
    tell_shut_doors(now_s);
    if (g.goal && g.planned_in != scene_) return renew_way();
    const double off_m = nearest_on_way(points_of(g.path), tool_.hip_m).distance_m / scale();
    if (off_m > kStray_hand_m && !std::exchange(g.stray, true)) ++g.errors;
    if (off_m < 0.5 * kStray_hand_m) g.stray = false;
    if (off_m <= kLeft_hand_m) g.off_since_s = now_s;
    const bool moved = off_m > kStray_hand_m && now_s - g.moved_s < kMovedLately_s;
    const bool strayed = g.off_since_s >= 0.0 && now_s - g.off_since_s > kLeft_s;
    if (!moved && !strayed) return;
    end_guidance();
    g.left = true;
}

// Where the way leads out of the hand's reach, the workspace goes on along it, as under the keys that push it. Hand metres a second, device frame.
Vec3 AppCore::carry_workspace() {
    Guiding& g = guiding_;
    const auto way = points_of(g.path);
    const bool lines = g.path.kind == GuidanceKind::WayLines;  // a hand that is on them and leans along them
    const bool led = g.acts && (lines || g.path.kind == GuidanceKind::Pull) && g.path.strength > 0.0 && tool_.guidance.number == g.path.number &&
                     tool_.guidance.phase == GuidancePhase::Acts && tool_.workspace_jump == pose_.jump && !at_desk() &&
                     (!lines || nearest_on_way(way, tool_.hip_m).distance_m <= Guidance::kGrooveHalfWidth_m * scale());
    Vec3 push(0.0);
    bool carries = false;
    if (led) {
        const Vec3 ahead = place_along(way, nearest_on_way(way, tool_.hip_m).along_m + kCarryAhead_hand_m * scale()) - tool_.hip_m;
        if (const double length_m = glm::length(ahead); length_m > 1e-6) {
            push = frame_of(pose_.origin_m, pose_.heading_rad).turn_to_device(ahead / length_m);
            carries = glm::dot(tool_.hand_m, push) > (g.carries ? kCarryTo : kCarryFrom) * hand_.spec.workspace_radius_m;
        }
    }
    g.carries = carries;
    g.carried = g.carried || carries;
    return carries ? push * kCarry_hand_m_per_s : Vec3(0.0);
}

}  // namespace handrail
