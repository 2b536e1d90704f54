// AppCore's part on what moves by itself: using doors and buttons, carrying the body on lifts, teleporters. App thread only.
#include <algorithm>
#include <cmath>

#include "app/core/app_core.h"
#include "worlds/base/language.h"
#include "worlds/geometry/closest_point.h"
#include "worlds/scene/models.h"

namespace handrail {
namespace {

constexpr double kReach_m = 1.2;           // from the middle of the body to what it uses
constexpr double kBounced_hand_m = 0.015;  // off a door that it has just met, while one hears which it is
constexpr double kShut = 0.5;              // a door that has come less of its way is shut
constexpr double kCloseToLift_m = 0.05;    // soles above the lift that carries them

Aabb box_of(const Scene& scene, FeatureId feature) { return scene.features[feature.value].bounds_m; }

// Borders do not count, as they do in clip.h: who stands beside a lift and on its level is not in its way.
bool overlap(const Aabb& a, const Aabb& b) {
    return a.min_m.x < b.max_m.x && b.min_m.x < a.max_m.x && a.min_m.y < b.max_m.y && b.min_m.y < a.max_m.y && a.min_m.z < b.max_m.z && b.min_m.z < a.max_m.z;
}

}  // namespace

// What moves, or at least sets others going: a button may be too flat to be pressed in.
bool AppCore::usable(std::size_t mover) const { return thing_of_mover_[mover] >= 0 || !scene_->movers[mover].sets_going.empty(); }

// A door that neither a hand nor coming near opens: its button does, or some place that one walks into.
bool AppCore::locked(std::uint32_t mover) const {
    const Mover& door = scene_->movers[mover];
    return scene_->features[door.feature.value].kind == FeatureKind::Door && !door.by_hand && door.approach_m.empty();
}

bool AppCore::shut(std::uint32_t mover) const { return movers_.away(mover) < kShut; }

// "locked"; empty where nothing keeps it shut, or it stands open by now.
std::string AppCore::lock_words(FeatureId door) const {
    const int found = mover_of(door);
    const auto mover = static_cast<std::uint32_t>(found);
    if (found < 0 || !locked(mover) || !shut(mover)) return {};
    return phrase(button_of(mover) ? "rooms.locked" : "questions.opened_from_elsewhere");
}

// By hand or by walking against it.
void AppCore::press_mover(std::uint32_t mover, bool back_again, double now_s) {
    if (back_again) movers_.set_going(mover);
    else movers_.call(mover);
    if (thing_of_mover_[mover] >= 0) return;  // its way is told as it goes
    const Feature& feature = scene_->features[scene_->movers[mover].feature.value];
    CueRequest sound;
    sound.kind = CueRequestKind::Play;
    sound.sound = SoundKind::DoorMoves;
    sound.time_s = now_s;
    sound.position_m = feature.bounds_m.centre_m();
    cue(std::move(sound));
    say(phrase("movers.pressed", {{"name", sentence_case(spoken_name(feature))}}), SpeechClass::Contact, now_s);
}

int AppCore::mover_of(FeatureId feature) const {
    for (std::size_t i = 0; i < scene_->movers.size(); ++i)
        if (feature && scene_->movers[i].feature == feature && usable(i)) return static_cast<int>(i);
    return -1;
}

// What the hand touches counts first, then a shut door that was told on a way that is gone and from which the hand has hardly come away, then what stands
// straight ahead, then the nearest.
void AppCore::use(double now_s) {
    int chosen = -1;
    if (tool_.contacts.count > 0) chosen = mover_of(tool_.contacts.contacts[tool_.contacts.strongest].feature);
    if (chosen < 0 && !guiding_.doors_told.empty()) {
        const FeatureId told = guiding_.doors_told.back();
        const Aabb door = box_of(*scene_, told);
        const double hand_reach_m = kBounced_hand_m * scale();
        if (distance_squared(door, feet_m() + Vec3(0.0, 0.0, kLookHeight_m)) < kReach_m * kReach_m ||
            (hand_seeks() && distance_squared(door, tool_.proxy_m) < hand_reach_m * hand_reach_m))
            chosen = mover_of(told);
        if (chosen >= 0 && movers_.away(static_cast<std::uint32_t>(chosen)) > 0.0) chosen = -1;
    }
    if (chosen < 0)
        if (const auto seen = look(*body_world_, feet_m(), kLookHeight_m, heading_rad_, kReach_m)) chosen = mover_of(seen->feature);
    if (chosen < 0) {
        double nearest_m = kReach_m;
        const Vec3 middle = feet_m() + Vec3(0.0, 0.0, kLookHeight_m);
        for (std::size_t i = 0; i < scene_->movers.size(); ++i) {
            if (!usable(i)) continue;
            const double distance_m = std::sqrt(distance_squared(box_of(*scene_, scene_->movers[i].feature), middle));
            if (distance_m < nearest_m) {
                nearest_m = distance_m;
                chosen = static_cast<int>(i);
            }
        }
    }
    if (chosen < 0) return answer(phrase("movers.none_in_reach"), now_s);
    const auto mover = static_cast<std::uint32_t>(chosen);
    if (!scene_->movers[mover].by_hand) return answer(shut_door_words(mover), now_s);
    press_mover(mover, true, now_s);
}

// What opens it and is pressed by hand: the one nearest to the body.
std::optional<FeatureId> AppCore::button_of(std::uint32_t mover) const {
    std::optional<FeatureId> button;
    double nearest_m = 1e9;
    for (const Mover& other : scene_->movers) {
        const auto opens = [&](std::uint32_t set_going) { return scene_->movers[set_going].group == scene_->movers[mover].group; };
        if (!other.by_hand || std::none_of(other.sets_going.begin(), other.sets_going.end(), opens)) continue;
        const double distance_m = std::sqrt(distance_squared(box_of(*scene_, other.feature), feet_m() + Vec3(0.0, 0.0, kLookHeight_m)));
        if (distance_m >= nearest_m) continue;
        nearest_m = distance_m;
        button = other.feature;
    }
    return button;
}

// What opens it: the key, or the button that is nearest to the body, with where that is.
std::string AppCore::shut_door_words(std::uint32_t mover) const {
    const Mover& door = scene_->movers[mover];
    const std::string name = sentence_case(name_of(door.feature));
    if (door.by_hand) return phrase("lead.door_shut", {{"door", name}, {"key", keys_.keys_of(Command::Use)}});
    if (!door.approach_m.empty()) return phrase("movers.opens_by_itself", {{"name", name}});
    const std::optional<FeatureId> button = button_of(mover);
    if (!button) return phrase("movers.opened_from_elsewhere", {{"name", name}});
    return phrase("movers.opened_by_button", {{"name", name}, {"button", sentence_case(name_of(*button))}, {"where", where_words(box_of(*scene_, *button))}});
}

void AppCore::meet_switch(FeatureId volume, double now_s) {
    for (const Switch& act : scene_->switches) {
        if (act.volume != volume || std::find(used_switches_.begin(), used_switches_.end(), volume) != used_switches_.end()) continue;
        if (act.once) used_switches_.push_back(volume);
        for (const std::uint32_t mover : act.sets_going) movers_.call(mover);
        if (!act.leads_elsewhere) continue;
        place(act.feet_m, act.heading_rad, now_s);
        play(SoundKind::FrameSwitch, now_s);
        answer(phrase("movers.elsewhere") + " " + where_am_i(), now_s);
        return;
    }
}

void AppCore::play_movers(double now_s, double dt_s) {
    if (movers_.size() == 0) return;
    const BodyShape body = walker_->shape();
    Aabb stand;
    stand.include(feet_m() - Vec3(body.radius_m, body.radius_m, 0.0));
    stand.include(feet_m() + Vec3(body.radius_m, body.radius_m, body.height_m));
    for (std::uint32_t i = 0; i < movers_.size(); ++i)
        if (!scene_->movers[i].approach_m.empty() && thing_of_mover_[i] >= 0 && overlap(scene_->movers[i].approach_m, stand)) movers_.call(i);
    if (!movers_.any_moving() && !movers_.any_waiting()) return;

    const auto thing = [&](std::uint32_t mover) { return static_cast<std::size_t>(thing_of_mover_[mover]); };
    const auto in_the_way = [&](std::uint32_t mover, const Placement& at) {
        if (thing_of_mover_[mover] < 0 || scene_->movers[mover].feature == ground_) return false;
        return overlap(placed_bounds(scene_->placed[thing(mover)].model->bounds_m, at), stand);
    };
    std::vector<Placement> before;
    for (std::uint32_t i = 0; i < movers_.size(); ++i) before.push_back(movers_.at(i));
    std::vector<MoverEvent> events;
    movers_.tick(dt_s, in_the_way, events);
    for (std::uint32_t i = 0; i < movers_.size(); ++i) {
        if (thing_of_mover_[i] < 0) continue;
        const Placement at = movers_.at(i);
        if (at == before[i]) continue;
        things_.put(thing(i), at);
        // Who stands on it goes along; what pushes up from below lifts.
        if (scene_->movers[i].feature != ground_ || !walker_->state().on_ground) continue;
        WalkerState stood = walker_->state();
        stood.feet_m += at.position_m - before[i].position_m;
        walker_->resume(stood);
    }
    for (const MoverEvent& event : events) {
        const Mover& mover = scene_->movers[event.mover];
        const Feature& feature = scene_->features[mover.feature.value];
        if (thing_of_mover_[event.mover] < 0) continue;
        if (event.kind == MoverEvent::Kind::Arrives) movers_arrived_ = true;
        const Vec3 middle = feature.bounds_m.centre_m();
        const double distance_m = glm::length(middle - feet_m());
        // One leaf speaks for a group, and only what is near is told in words; a locked door, which waited for its button, from anywhere.
        const bool first =
            std::none_of(scene_->movers.begin(), scene_->movers.begin() + event.mover, [&](const Mover& other) { return other.group == mover.group; });
        if (!first) continue;
        CueRequest sound;
        sound.kind = CueRequestKind::Play;
        sound.sound = event.kind == MoverEvent::Kind::Leaves && !event.at_rest ? SoundKind::DoorMoves : SoundKind::DoorShuts;
        sound.time_s = now_s;
        sound.position_m = middle;
        sound.material = scene_->material(feature.material).sound;
        if (event.kind == MoverEvent::Kind::Leaves || (event.kind == MoverEvent::Kind::Arrives && event.at_rest)) {
            const bool speaks = distance_m < 10.0 || locked(event.mover);
            if (event.kind == MoverEvent::Kind::Leaves && event.at_rest) continue;  // it shuts: heard when it is shut
            cue(std::move(sound));
            if (!speaks) continue;
            const std::string name = sentence_case(spoken_name(feature));
            const bool opens = feature.kind == FeatureKind::Door, button = feature.kind == FeatureKind::Button;
            // What a button has brought about is an answer: as the name of what is met it would replace "button pressed", or be replaced by it.
            const SpeechClass as = locked(event.mover) ? SpeechClass::Answer : SpeechClass::Contact;
            if (event.kind == MoverEvent::Kind::Leaves)
                say(phrase(opens ? "movers.opens" : button ? "movers.pressed" : "movers.moves", {{"name", name}}), as, now_s);
            else say(phrase(opens ? "movers.is_shut" : button ? "movers.is_out_again" : "movers.is_back", {{"name", name}}), SpeechClass::Ambient, now_s);
        } else if (event.kind == MoverEvent::Kind::TurnsBack) {
            say(phrase("movers.met_you", {{"name", sentence_case(spoken_name(feature))}}), SpeechClass::Contact, now_s);
        } else if (feature.kind == FeatureKind::Lift) {
            say(phrase("movers.stops", {{"name", sentence_case(spoken_name(feature))}}), SpeechClass::Contact, now_s);
        }
    }
}

}  // namespace handrail
