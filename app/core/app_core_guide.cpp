// AppCore's part on marks, landmarks, the beacon and the list of what can be found: what the commands do, what is said, and what is heard when. Being led
// stands in app_core_lead.cpp. App thread only.
#include <algorithm>
#include <cmath>

#include "app/core/app_core.h"
#include "app/core/hand_way.h"
#include "audio-cues/plan/speakable.h"
#include "worlds/base/language.h"
#include "worlds/navigation/way_place.h"

namespace handrail {
namespace {

constexpr double kMarkNear_hand_m = 0.008, kMarkNear_body_m = 1.0;
constexpr double kLandmarkNear_m = 1.5;  // from the body
constexpr double kFarther = 1.5;         // what was near is far again from so many times the distance on
constexpr double kStorey_m = 1.5;
constexpr double kWaist_m = 1.0;
constexpr double kLookRange_m = 30.0;
constexpr double kLookEvery_s = 0.1;                                           // along a way, for what stands between and shut doors
constexpr double kOverSteps_m = 0.35, kNarrow_m = 0.2, kNarrowHeight_m = 1.2;  // of a body that is looked ahead with along a way, stairs too
constexpr double kBackOnWay_m = 1.0;                                           // ahead, for one who is off it
constexpr double kHardlyLonger = 1.25, kAllowance_m = 1.0;                     // a way beside the straight line: the thing itself leads there
constexpr double kPast = 0.1;                                                  // as little nearer or farther is neither
constexpr double kPitch = 0.5;                                                 // a fifth higher straight to it
constexpr double kBody_m_per_hand_m = 60.0;                                    // a body is as near as a hand would be at the scale of a room

Aabb point_box(const Vec3& p) { return {p, p}; }

std::string along_way_words(const SoughtWay& way, const DistanceWords& how) {
    return phrase("lead.along_way", {{"distance", distance_words(way.left_m(), how)}});
}

bool is_surface(FeatureKind kind) {
    return kind == FeatureKind::Wall || kind == FeatureKind::Floor || kind == FeatureKind::Ceiling || kind == FeatureKind::Slope;
}

}  // namespace

// ---- what there is ----

// What was added to the world that is entered; returns what is wrong with marks.
std::vector<Error> AppCore::take_additions() {
    if (side_file_next_) side_file_ = std::move(*std::exchange(side_file_next_, std::nullopt));
    else side_file_ = SideFile();
    const std::uint32_t number = guiding_.last_number;
    const std::uint32_t buttons = guiding_.buttons;
    guiding_ = {};
    guiding_.last_number = number;  // the servo knows the old ones
    guiding_.buttons = buttons;
    std::vector<Error> faults;
    guiding_.marks = read_marks(side_file_, faults);
    check_marks(*scene_, side_file_, guiding_.marks);
    return faults;
}

void AppCore::tell_additions(const std::vector<Error>& mark_faults, double now_s) {
    for (const std::string& news : side_file_.news()) say(news, SpeechClass::Answer, now_s);
    if (!mark_faults.empty()) say(unreadable_words("marks.unreadable", mark_faults), SpeechClass::Answer, now_s);
    if (std::string unfit = unfit_sentence(guiding_.marks); !unfit.empty()) say(std::move(unfit), SpeechClass::Answer, now_s);
    enter_ways(now_s);
}

Vec3 AppCore::finding_place_m() const { return hand_.present && tool_.ticks > 0 ? tool_.proxy_m : feet_m() + Vec3(0.0, 0.0, kWaist_m); }

std::string AppCore::where_words(const Aabb& box) const {
    const Vec3 way = nearest_place(box, feet_m() + Vec3(0.0, 0.0, kWaist_m)) - feet_m();
    const double level_m = std::hypot(way.x, way.y);
    const std::string distance = distance_words(level_m, distances()), direction = relative_words(std::atan2(way.x, way.y), heading_rad_);
    return phrase("guide.where", {{"distance", distance},
                                  {"far", level_m >= 0.5 * settings_.walk.step_length_m ? "yes" : "no"},
                                  {"direction", direction},
                                  {"storey", way.z > kStorey_m + kWaist_m ? "above"
                                             : way.z < -kStorey_m         ? "below"
                                                                          : "this"}});
}

std::vector<Goal> AppCore::goals() const {
    std::vector<Goal> all;
    for (const Mark& mark : guiding_.marks) all.push_back({mark.name, point_box(mark.place_m), kNoFeature});
    for (NamedThing& thing : named_things(*scene_)) all.push_back({sentence_case(speakable(thing.name)), thing.bounds_m, thing.feature});
    const Vec3 here = feet_m() + Vec3(0.0, 0.0, kWaist_m);
    std::stable_sort(all.begin(), all.end(), [&](const Goal& a, const Goal& b) {
        return glm::length(nearest_place(a.box_m, here) - here) < glm::length(nearest_place(b.box_m, here) - here);
    });
    return all;
}

// ---- marks ----

void AppCore::save_additions(double now_s) {
    if (const auto saved = side_file_.save(); !saved) say(phrase("guide.not_kept", {{"why", saved.error().sentence()}}), SpeechClass::Alarm, now_s);
}

void AppCore::drop_mark(bool by_button, double now_s) {
    Vec3 place = feet_m();
    if (hand_.present && tool_.ticks > 0) {
        if (tool_.fault == Fault::Unplugged || tool_.workspace_jump != pose_.jump) return answer(phrase("guide.hand_unknown"), now_s);
        place = tool_.proxy_m;
    }
    Mark mark = new_mark(*scene_, side_file_, guiding_.marks, place);
    const std::string name = mark.name;
    guiding_.marks.push_back(std::move(mark));
    guiding_.mark_near.resize(guiding_.marks.size() - 1, false);
    guiding_.mark_near.push_back(true);
    write_marks(side_file_, guiding_.marks);
    save_additions(now_s);
    play_at(SoundKind::Mark, place, now_s);
    if (by_button || !settings_.marks.ask_name) return answer(phrase("marks.set", {{"name", name}}), now_s);
    TextSpec question;
    question.question = phrase("marks.set_and_ask", {{"name", name}});
    question.text = name;
    question.done = [this, name](std::string typed) { rename_mark(name, typed, last_tick_s_); };
    ask_text(std::move(question), now_s);
}

void AppCore::rename_mark(const std::string& name, const std::string& typed, double now_s) {
    const auto mark = std::find_if(guiding_.marks.begin(), guiding_.marks.end(), [&](const Mark& m) { return m.name == name; });
    const auto good = good_name(typed);
    if (!good) return answer(good.error().message, now_s);
    if (mark == guiding_.marks.end()) return;
    mark->name = *good;
    write_marks(side_file_, guiding_.marks);
    save_additions(now_s);
    answer(*good, now_s);
}

void AppCore::delete_mark(std::size_t which, double now_s) {
    if (which >= guiding_.marks.size()) return;
    const std::string name = guiding_.marks[which].name;
    guiding_.marks.erase(guiding_.marks.begin() + static_cast<std::ptrdiff_t>(which));
    guiding_.mark_near.assign(guiding_.marks.size(), true);
    write_marks(side_file_, guiding_.marks);
    save_additions(now_s);
    answer(phrase("marks.deleted", {{"name", name}}), now_s);
}

std::vector<ListItem> AppCore::mark_items() const {
    std::vector<ListItem> items;
    for (const Mark& mark : guiding_.marks) {
        const std::string where = where_words(point_box(mark.place_m));
        items.push_back({mark.name, mark.fits ? where : phrase("marks.may_not_fit", {{"where", where}})});
    }
    return items;
}

void AppCore::open_delete_marks(double now_s) {
    if (guiding_.marks.empty()) return answer(phrase("desk.no_marks", {{"key", keys_.keys_of(Command::DropMark)}}), now_s);
    ListSpec list;
    list.title = phrase("marks.delete_which");
    list.items = mark_items();
    list.chosen = [this](std::size_t i) { delete_mark(i, last_tick_s_); };
    open_list(std::move(list), now_s);
}

// Marks, the beacon, and how much help being led gives.
void AppCore::open_marks(double now_s) {
    ListSpec list;
    list.title = phrase("marks.title");
    list.items.push_back({phrase("guide.beacon"), guiding_.beacon.on() ? guiding_.beacon.name() : phrase("setting_value.off")});
    const auto help = [this] { return phrase("guide.percent", {{"percent", std::lround(100.0 * guiding_.laps.strength())}}); };
    list.items.push_back({phrase("guide.help"), help(), true});
    for (ListItem& item : mark_items()) list.items.push_back(std::move(item));
    list.adjusted = [this, help](std::size_t, int by) {
        guiding_.laps.change(by);
        return help();
    };
    list.chosen = [this](std::size_t i) {
        if (i == 0) mute_beacon(last_tick_s_);
        else if (i == 1) take_me(last_tick_s_);
        else if (i - 2 < guiding_.marks.size()) open_tools({guiding_.marks[i - 2].name, point_box(guiding_.marks[i - 2].place_m), kNoFeature}, last_tick_s_);
    };
    open_list(std::move(list), now_s);
}

// ---- finding ----

// Everything that has a name, the nearest first, and then the ways to find it.
void AppCore::open_find(double now_s) {
    const std::vector<Goal> all = goals();
    ListSpec list;
    list.title = phrase("guide.find");
    for (const Goal& goal : all) list.items.push_back({goal.name, where_words(goal.box_m)});
    list.chosen = [this, all](std::size_t i) { open_tools(all[i], last_tick_s_); };
    open_list(std::move(list), now_s);
}

void AppCore::open_tools(const Goal& goal, double now_s) {
    guiding_.goal = goal;
    ListSpec list;
    list.title = goal.name;
    for (const char* way : {"guide.beacon", "guide.take_me", "guide.warmer", "guide.lines"}) list.items.push_back({phrase(way), ""});
    list.items.push_back({phrase("guide.where_is_it"), where_words(goal.box_m)});
    list.chosen = [this, goal](std::size_t i) {
        if (i == 0) set_beacon(goal, last_tick_s_);
        if (i == 1) {
            run_.reset();
            const Vec3 from = hand_may_be_led() && force_may_guide() ? finding_place_m() : feet_m();
            if (rooms_known()) note_planned(stop_at_goal(goal, from), from);
            lead_to(goal, {}, last_tick_s_);
        }
        if (i == 2) seek_warmer(goal, last_tick_s_);
        if (i == 3) cross_lines(goal, last_tick_s_);
        if (i == 4) answer(joined(goal.name, where_words(goal.box_m)), last_tick_s_);
    };
    open_list(std::move(list), now_s);
}

void AppCore::start_beacon(const Goal& goal) {
    guiding_.beacon.set(goal.name, goal.box_m, goal.feature);
    guiding_.beacon_along = {};
    guiding_.doors_told.clear();
}

void AppCore::set_beacon(const Goal& goal, double now_s) {
    guiding_.goal = goal;
    start_beacon(goal);
    const std::string how = sought_words(guiding_.beacon_along, guiding_.beacon, false, now_s);
    answer(phrase("guide.beacon_on", {{"name", goal.name}, {"where", where_words(goal.box_m)}}) + (how.empty() ? how : ". " + how), now_s);
}

// What the hand touches, else what is straight ahead, else to be chosen.
void AppCore::beacon_here(double now_s) {
    FeatureId id = kNoFeature;
    Vec3 place{0.0};
    if (hand_.present && tool_.contacts.count > 0) {
        id = tool_.contacts.contacts[tool_.contacts.strongest].feature;
        place = tool_.proxy_m;
    } else if (const auto seen = look(*body_world_, feet_m(), kWaist_m, heading_rad_, kLookRange_m)) {
        id = seen->feature;
        place = seen->point_m;
    }
    const Feature* feature = scene_->find(id);
    if (!feature || feature->name.empty()) return open_find(now_s);
    const std::string name = spoken_name(*feature);
    const bool whole = !is_surface(feature->kind) && !feature->bounds_m.empty();
    set_beacon({sentence_case(speakable(name)), whole ? feature->bounds_m : point_box(place), id}, now_s);
}

void AppCore::mute_beacon(double now_s) {
    if (guiding_.beacon.on()) {
        guiding_.beacon.clear();
        return answer(phrase("guide.beacon_off"), now_s);
    }
    if (guiding_.goal) return set_beacon(*guiding_.goal, now_s);
    answer(phrase("guide.no_beacon", {{"key", keys_.keys_of(Command::SetBeacon)}}), now_s);
}

void AppCore::seek_warmer(const Goal& goal, double now_s) {
    guiding_.goal = goal;
    if (guiding_.warmer.on() && guiding_.warmer.name() == goal.name) {
        guiding_.warmer.clear();
        return answer(phrase("guide.warmer_off"), now_s);
    }
    guiding_.warmer.set(goal.name, goal.box_m, goal.feature);
    guiding_.warmer_along = {};
    guiding_.doors_told.clear();
    const std::string how = sought_words(guiding_.warmer_along, guiding_.warmer, hand_seeks(), now_s);
    answer(phrase("guide.warmer_on", {{"name", goal.name}}) + (how.empty() ? how : ". " + how), now_s);
}

// ---- along the way ----

// From where one is; again to the same place beside the thing, which saves looking for one.
void AppCore::plan_sought(AlongWay& along, const Sought& sought, bool hand, double now_s) {
    SoughtWay& way = along.way;
    along.planned_in = scene_;
    along.jump = pose_.jump;
    if (hand) {
        const HandLead lead = hand_lead({sought.name(), sought.thing_m(), sought.feature()}, GuidancePath::kMostPoints);
        if (!lead.reaches || lead.points_m.size() < 2) return way.no_way(now_s);
        return way.plan(lead.points_m, {}, 0.0, finding_place_m(), now_s);
    }
    Navigation& navigation = rooms_->navigation();
    Route route;
    if (way.known()) route = navigation.plan(feet_m(), way.points_m().back());
    if (!route.reaches) route = walk_to_thing(navigation, *body_world_, feet_m(), sought.thing_m(), sought.feature());
    if (!route.reaches) return way.no_way(now_s);
    const Vec3 end = route.points_m.back();
    way.plan(route.points_m, route.passages, glm::length(nearest_place(sought.thing_m(), end + Vec3(0.0, 0.0, kWaist_m)) - end - Vec3(0.0, 0.0, kWaist_m)),
             feet_m(), now_s);
}

// Follows it, and plans it where that is due. True: it is known and wished for.
bool AppCore::keep_way(AlongWay& along, const Sought& sought, bool hand, double now_s) {
    if (!settings_.guidance.along_way) return false;
    SoughtWay& way = along.way;
    const Vec3 at = hand ? finding_place_m() : feet_m(), up(0.0, 0.0, hand ? 0.0 : kWaist_m);
    way.follow(at, hand ? 1.0 : kHeightCountsForWalkers, [&](const Vec3& place) { return free_line(*body_world_, at + up, place + up, sought.feature()); });
    const bool changed = along.planned_in != scene_ || (hand && along.jump != pose_.jump);
    if (way.wants_plan(changed, now_s) && rooms_known()) plan_sought(along, sought, hand, now_s);
    return way.known();
}

// Nothing stands between, and the way is hardly longer than the straight line: not one to the floor above that is seen over the banister.
bool AppCore::straight_before(const SoughtWay& way, const Sought& sought, bool hand) const {
    const Vec3 from = hand ? finding_place_m() : feet_m() + Vec3(0.0, 0.0, kWaist_m), place = place_on(sought.thing_m(), from);
    return way.left_m() <= kHardlyLonger * glm::length(place - from) + kAllowance_m && free_line(*body_world_, from, place, sought.feature()) &&
           (hand || body_gets_to(sought));
}

// Whether it leads along the way or straight, and why; nothing where both are the same.
std::string AppCore::sought_words(AlongWay& along, const Sought& sought, bool hand, double now_s) {
    const SoughtWay& way = along.way;
    if (keep_way(along, sought, hand, now_s)) return straight_before(way, sought, hand) ? std::string() : along_way_words(way, distances());
    const Vec3 from = hand ? finding_place_m() : feet_m() + Vec3(0.0, 0.0, kWaist_m);
    if (free_line(*body_world_, from, place_on(sought.thing_m(), from), sought.feature())) return {};
    if (!settings_.guidance.along_way) return phrase("lead.straight");
    return way.tried() ? phrase("lead.no_way") : why_no_way() + " " + phrase("lead.straight");
}

// Who walks straight to its middle comes to it, and not against the side of a doorway through which it is seen.
bool AppCore::body_gets_to(const Sought& sought) const {
    const Vec3 over(0.0, 0.0, kOverSteps_m), middle = sought.thing_m().centre_m();
    const TraceHit met = body_world_->trace(feet_m() + over, Vec3(middle.x, middle.y, feet_m().z) + over, BodyShape{kNarrow_m, kNarrowHeight_m});
    if (!met.hit || met.feature == sought.feature()) return true;
    return glm::length(nearest_place(sought.thing_m(), met.end_m) - met.end_m) <= Beacon::kArrived_m;
}

// Where the beacon calls from as long as one has to go there first; none: from the thing.
std::optional<Vec3> AppCore::beacon_turning(double now_s) {
    Guiding& g = guiding_;
    const bool tried = g.beacon_along.way.tried();
    if (!keep_way(g.beacon_along, g.beacon, false, now_s)) return std::nullopt;
    if (!tried && !straight_before(g.beacon_along.way, g.beacon, false)) say(along_way_words(g.beacon_along.way, distances()), SpeechClass::Answer, now_s);
    const Vec3 up(0.0, 0.0, kWaist_m);
    if (now_s - g.beacon_along.looked_s >= kLookEvery_s) {
        g.beacon_along.looked_s = now_s;
        tell_shut_doors_ahead(g.beacon_along.way, now_s);
        g.turning_first = g.beacon_along.way.left_m() > Beacon::kArrived_m && !straight_before(g.beacon_along.way, g.beacon, false);
        // Whoever has come off the way a little is led back onto it, round what stands between.
        const Vec3 turning = g.beacon_along.way.next_turning_m(), over(0.0, 0.0, kOverSteps_m);
        const TraceHit met = body_world_->trace(feet_m() + over, turning + over, BodyShape{kNarrow_m, kNarrowHeight_m});
        const Feature* thing = met.hit ? scene_->find(met.feature) : nullptr;
        g.turning_m = met.hit && !(thing && thing->kind == FeatureKind::Door) ? g.beacon_along.way.ahead_m(kBackOnWay_m) : turning;
    }
    if (!g.turning_first) return std::nullopt;
    return g.turning_m + up;
}

void AppCore::play_beacon(double now_s) {
    Guiding& g = guiding_;
    const Listener ears = listener();
    const auto way_db = [&](const Vec3& place) { return muffling_db(*body_world_, ears.ears_m, place); };
    Beacon::Beat beat = g.beacon.tick(feet_m(), ears, way_db, !tuning_.panic, now_s, beacon_turning(now_s));
    if (beat.sound) cue(std::move(*beat.sound));
    if (!beat.arrived) return;
    if (follow_name_ == g.beacon.name() && !run_) follower_.stop();  // told once
    play(SoundKind::Arrived, now_s);
    say(phrase("lead.here", {{"goal", g.beacon.name()}}), SpeechClass::Answer, now_s);
}

void AppCore::play_warmer(double now_s) {
    Guiding& g = guiding_;
    const bool hand = hand_seeks(), tried = g.warmer_along.way.tried();
    const Vec3 place = finding_place_m(), thing = nearest_place(g.warmer.thing_m(), place);
    const bool known = keep_way(g.warmer_along, g.warmer, hand, now_s);
    if (known && !tried) say(along_way_words(g.warmer_along.way, distances()), SpeechClass::Answer, now_s);
    const double straight_m = glm::length(thing - place), per_m = hand ? scale() : kBody_m_per_hand_m;
    // What is beyond a wall is not found by coming near.
    bool found = straight_m <= (hand ? Warmer::kFound_hand_m * per_m : Beacon::kArrived_m) &&
                 (!known || (!hand && g.warmer_along.way.left_m() <= Beacon::kArrived_m) ||
                  free_line(*body_world_, place, place_on(g.warmer.thing_m(), place), g.warmer.feature()));
    if (hand && tool_.contacts.count > 0 && g.warmer.feature())
        found = found || tool_.contacts.contacts[tool_.contacts.strongest].feature == g.warmer.feature();
    if (known && hand) tell_shut_doors(now_s);
    if (known && !hand && now_s - g.warmer_along.looked_s >= kLookEvery_s) {
        g.warmer_along.looked_s = now_s;
        tell_shut_doors_ahead(g.warmer_along.way, now_s);
    }
    const double left_m = known ? std::max(straight_m, g.warmer_along.way.told_m()) : straight_m;
    const Warmer::Beat beat = g.warmer.tick(left_m / per_m, place / per_m, found, !tuning_.panic, now_s);
    if (beat.sound) {
        CueRequest tick = sound_at(beat.nearer < -kPast ? SoundKind::Colder : SoundKind::Warmer, listener().ears_m, now_s);
        tick.pitch = 1.0 + kPitch * beat.nearer;
        cue(std::move(tick));
    }
    if (!beat.found) return;
    play(SoundKind::Arrived, now_s);
    say(phrase("lead.here", {{"goal", g.warmer.name()}}), SpeechClass::Answer, now_s);
}

// ---- every tick ----

// A mark, landmark or clue makes its sound when hand or body comes near; marks are named.
void AppCore::notice_marks(double now_s) {
    Guiding& g = guiding_;
    const bool tell = !std::exchange(g.first_look, false);
    const Vec3 waist = feet_m() + Vec3(0.0, 0.0, kWaist_m);
    // Level distance of a place that is on this storey and in no other room; else far.
    const auto body_to_m = [&](const Aabb& box, double range_m) {
        const Vec3 place = nearest_place(box, waist);
        const Vec3 way = place - waist;
        const double level_m = std::hypot(way.x, way.y);
        if (level_m > range_m || std::abs(way.z) > kStorey_m) return 1e9;
        return muffling_db(*body_world_, waist, place) >= kDoorMuffles_db ? 1e9 : level_m;
    };
    const bool hand = hand_.present && tool_.ticks > 0 && tool_.workspace_jump == pose_.jump;
    g.mark_near.resize(g.marks.size(), false);
    for (std::size_t i = 0; i < g.marks.size(); ++i) {
        const Vec3& place = g.marks[i].place_m;
        const double more = g.mark_near[i] ? kFarther : 1.0;
        const double hand_m = hand ? glm::length(tool_.proxy_m - place) / scale() : 1e9;
        const bool near = hand_m <= more * kMarkNear_hand_m || body_to_m(point_box(place), more * kMarkNear_body_m) <= more * kMarkNear_body_m;
        if (near && !g.mark_near[i] && tell && !tuning_.panic) {
            play_at(SoundKind::Mark, place, now_s);
            say(g.marks[i].name, SpeechClass::Contact, now_s);
        }
        g.mark_near[i] = near;
    }
    const auto sound_of = [](const Feature& feature) { return feature.landmark ? SoundKind::Landmark : SoundKind::Clue; };
    std::vector<FeatureId> near_now;
    for (std::uint32_t i = 0; i < scene_->features.size(); ++i) {
        const Feature& feature = scene_->features[i];
        if ((!feature.landmark && !feature.clue) || feature.bounds_m.empty()) continue;
        const FeatureId id{i};
        const bool was = std::find(g.landmarks_near.begin(), g.landmarks_near.end(), id) != g.landmarks_near.end();
        const double range_m = (was ? kFarther : 1.0) * kLandmarkNear_m;
        if (body_to_m(feature.bounds_m, range_m) > range_m) continue;
        near_now.push_back(id);
        if (!was && tell && !tuning_.panic) play_at(sound_of(feature), nearest_place(feature.bounds_m, waist), now_s);
    }
    g.landmarks_near = std::move(near_now);
    const FeatureId touched = hand && tool_.contacts.count > 0 ? tool_.contacts.contacts[tool_.contacts.strongest].feature : kNoFeature;
    if (touched != g.touched && touched) {
        const Feature* feature = scene_->find(touched);
        if (feature && (feature->landmark || feature->clue) && !tuning_.panic) play_at(sound_of(*feature), tool_.proxy_m, now_s);
    }
    if (touched || tool_.contacts.count == 0) g.touched = touched;
}

void AppCore::tick_guiding(double now_s) {
    Guiding& g = guiding_;
    const std::uint32_t pressed = tool_.buttons & ~std::exchange(g.buttons, tool_.buttons);
    const int button = settings_.marks.button;
    if (button > 0 && (pressed & (1U << (button - 1))) != 0 && (tuning_.workspace.grab_buttons & (1U << (button - 1))) == 0 &&
        !(button == 1 && settings_.haptic.button_to_feel))
        drop_mark(true, now_s);
    follow_guidance(now_s);
    notice_marks(now_s);
    if (g.beacon.on()) play_beacon(now_s);
    if (g.warmer.on()) play_warmer(now_s);
}

void AppCore::act_guiding(Command command, double now_s) {
    switch (command) {
        case Command::DropMark:
            return drop_mark(false, now_s);
        case Command::DeleteMark:
            return open_delete_marks(now_s);
        case Command::Marks:
            return open_marks(now_s);
        case Command::SetBeacon:
            return beacon_here(now_s);
        case Command::MuteBeacon:
            return mute_beacon(now_s);
        case Command::TakeMe:
            return take_me(now_s);
        case Command::Find:
            return open_find(now_s);
        default:
            return toggle_lines(now_s);
    }
}

void AppCore::play_at(SoundKind kind, const Vec3& place_m, double now_s) {
    CueRequest sound;
    sound.kind = CueRequestKind::Play;
    sound.sound = kind;
    sound.time_s = now_s;
    sound.position_m = place_m;
    cue(std::move(sound));
}

}  // namespace handrail
