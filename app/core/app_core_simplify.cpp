// AppCore's part on what is too small to feel at a scale: what is changed for the hand, how that is told, and the list of it. App thread only.
#include <algorithm>

#include "app/core/app_core.h"
#include "haptic/render/free_place.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {

// What the scale asks for.
Simplification AppCore::plan_touch() {
    planned_portals_ = {};
    openings_awaited_ = false;
    if (!hand_.present || !settings_.haptic.simplify) return {};
    SimplifyOptions options;
    options.world_m_per_hand_m = scale();
    for (const Mark& mark : guiding_.marks) options.kept_m.push_back(mark.place_m);
    if (asks_for_openings(scale(), settings_.walk.body_radius_m)) {
        openings_awaited_ = rooms_beside_ && rooms_ && !rooms_->done();
        // Not rooms_known(): on entering a world its movers are not known yet, nor where their leaves stand.
        if (!openings_awaited_ && rooms_ && rooms_->ready() && rooms_->found()) planned_portals_ = open_portals(rooms_->graph());
        options.openings_m = planned_portals_.places_m;
    }
    return plan_simplification(*scene_, options);
}

// The rooms have been found since: their openings are widened too.
void AppCore::notice_openings(double now_s) {
    if (!openings_awaited_ || !rooms_->done()) return;
    retune();
    if (!adapt_touch(now_s)) return;
    if (const Vec3 out = tool_.ticks > 0 ? out_of_solids_m(tool_.proxy_m, left_tool_.proxy_m) : Vec3(0.0); out != Vec3(0.0)) {
        hand_shift_m_ += out;
        publish_pose(now_s, PoseChange::Moved);
    }
    if (std::string news = simplified_news(); !news.empty()) say(std::move(news), SpeechClass::Ambient, now_s);
}

// How far the workspace has to go so that the ball fits where the hand is: it may have grown with the scale, and walls may be back.
Vec3 AppCore::out_of_solids_m(const Vec3& hand_m) const {
    constexpr double kTouching = 0.999;  // of the radius: a ball that rests against something fits
    const auto poses = std::span(things_.frame().poses).first(things_.frame().count);
    const double radius_m = tuning_.touch.radius_m;
    const double room_m = surrounding_of(*haptic_scene_, poses, hand_m, radius_m).distance_m;
    if (room_m >= kTouching * radius_m) return Vec3(0.0);
    const auto free = nearest_free_place(*haptic_scene_, poses, hand_m, (room_m > 0.0 ? 1.0 : 1.2) * radius_m, farthest_m());
    return free ? *free - hand_m : Vec3(0.0);
}

// Likewise for each hand that is there. Both are in the one workspace, so what frees one may press the other: they take turns, and where that leads to no
// place for both, the right hand's counts and the left one goes through what it is in until it is out.
Vec3 AppCore::out_of_solids_m(const Vec3& right_m, const Vec3& left_m) const {
    constexpr int kTurns = 6;
    const Vec3 alone_m = out_of_solids_m(right_m);
    if (!two_hands() || left_tool_.ticks == 0) return alone_m;
    Vec3 both_m = alone_m;
    for (int turn = 0; turn < kTurns; ++turn) {
        const Vec3 more_m = out_of_solids_m((turn % 2 == 0 ? left_m : right_m) + both_m);
        if (more_m == Vec3(0.0)) return both_m;
        both_m += more_m;
    }
    return alone_m;
}

// Likewise for the hands where they are in a workspace with this middle.
Vec3 AppCore::hands_out_of_solids_m(const Vec3& origin_m) const {
    const WorkspaceFrame frame = frame_of(origin_m, workspace_heading_rad());
    return out_of_solids_m(frame.to_world(tool_.hand_m, scale()), frame.to_world(left_tool_.hand_m, scale()));
}

// The sentence where it is not the one that was said last; empty else.
std::string AppCore::simplified_news() {
    std::string sentence = simplified_sentence(compiled_plan_);
    if (sentence == std::exchange(simplified_told_, sentence)) return {};
    return sentence.empty() ? phrase("simplify.nothing") : sentence;
}

void AppCore::list_simplified(double now_s) {
    if (!hand_.present) return answer(phrase("session.no_hand"), now_s);
    if (!settings_.haptic.simplify) return answer(phrase("simplify.off"), now_s);
    ListSpec list;
    list.title = phrase("simplify.title");
    std::vector<Goal> goals;
    const auto add = [&](std::string name, const Aabb& box, FeatureId feature, const std::string& what) {
        list.items.push_back({name, joined(what, where_words(box))});
        goals.push_back({std::move(name), box, feature});
    };
    const RoomGraph* rooms = rooms_known() ? &rooms_->graph() : nullptr;
    for (const NarrowOpening& opening : compiled_plan_.openings) {
        const FeatureId door = opening.doors.empty() ? kNoFeature : opening.doors.front();
        const Vec3 middle = opening.middle_m();
        add(opening_name(*scene_, opening, rooms, planned_portals_), door ? scene_->features[door.value].bounds_m : Aabb{middle, middle}, door,
            opening_words(opening));
    }
    for (const FeatureId id : compiled_plan_.left_out) add(sentence_case(spoken_name(scene_->features[id.value])), scene_->features[id.value].bounds_m, id, phrase("simplify.is_left_out"));
    if (goals.empty()) return answer(phrase("simplify.nothing"), now_s);
    list.chosen = [this, goals](std::size_t i) { open_tools(goals[i], last_tick_s_); };
    open_list(std::move(list), now_s);
}

}  // namespace handrail
