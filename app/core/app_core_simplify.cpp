// AppCore's part on what is too small to feel at a scale: what is changed for the hand, how that is told, and the list of it. App thread only.
#include <algorithm>
#include <cmath>

#include "app/core/app_core.h"
#include "haptic/render/free_place.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail {

// What the scale asks for. Openings without a door are known from the rooms; a body fits through each, so a scale at which the body's own width can be felt
// does not ask for them.
Simplification AppCore::plan_touch() {
    planned_portals_.clear();
    openings_awaited_ = false;
    if (!hand_.present || !settings_.haptic.simplify) return {};
    SimplifyOptions options;
    options.world_m_per_hand_m = scale();
    for (const Mark& mark : guiding_.marks) options.kept_m.push_back(mark.place_m);
    if (kLeastGap_hand_m * scale() > 2.0 * settings_.walk.body_radius_m) {
        openings_awaited_ = rooms_beside_ && rooms_ && !rooms_->done();
        if (!openings_awaited_ && rooms_known()) {
            const std::vector<Portal>& portals = rooms_->graph().portals;
            for (std::uint32_t p = 0; p < portals.size(); ++p)
                if (portals[p].kind == PassageKind::Opening) {
                    planned_portals_.push_back(p);
                    options.openings_m.push_back(portals[p].place_m);
                }
        }
    }
    return plan_simplification(*scene_, options);
}

// The rooms have been found since: their openings are widened too.
void AppCore::notice_openings(double now_s) {
    if (!openings_awaited_ || !rooms_->done()) return;
    retune();
    if (!adapt_touch(now_s)) return;
    if (const Vec3 out = tool_.ticks > 0 ? out_of_solids_m(tool_.proxy_m) : Vec3(0.0); out != Vec3(0.0)) {
        hand_shift_m_ += out;
        publish_pose(now_s, PoseChange::Moved);
    }
    if (std::string news = simplified_news(); !news.empty()) say(std::move(news), SpeechClass::Ambient, now_s);
}

// How far the workspace has to go so that a hand there is in nothing solid.
Vec3 AppCore::out_of_solids_m(const Vec3& hand_m) const {
    const auto poses = std::span(things_.frame().poses).first(things_.frame().count);
    const double clearance = 1.2 * tuning_.touch.radius_m;
    if (surrounding_of(*haptic_scene_, poses, hand_m, clearance).distance_m > 0.0) return Vec3(0.0);
    const auto free = nearest_free_place(*haptic_scene_, poses, hand_m, clearance, farthest_m());
    return free ? *free - hand_m : Vec3(0.0);
}

// "Simplified: 3 doorways widened, 12 small things left out."; empty where nothing is.
std::string AppCore::simplified_sentence() const {
    std::string list;
    const auto add = [&](const char* key, std::size_t count) {
        if (count == 0) return;
        const std::string part = phrase(key, {{"count", count}});
        list = list.empty() ? part : joined(list, part);
    };
    add("simplify.widened", compiled_plan_.widened());
    add("simplify.narrow", compiled_plan_.staying_narrow());
    add("simplify.left_out", compiled_plan_.left_out.size());
    return list.empty() ? list : phrase("simplify.sentence", {{"what", list}});
}

// The sentence where it is not the one that was said last; empty else.
std::string AppCore::simplified_news() {
    std::string sentence = simplified_sentence();
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
    const auto metres = [](double width_m) { return phrase("words.metres", {{"metres", std::round(width_m * 10.0) / 10.0}}); };
    for (const NarrowOpening& opening : compiled_plan_.openings) {
        const FeatureId door = opening.doors.empty() ? kNoFeature : opening.doors.front();
        std::string name = sentence_case(door ? spoken_name(scene_->features[door.value]) : phrase("rooms.opening"));
        if (opening.place >= 0 && rooms_known()) {
            const RoomGraph& graph = rooms_->graph();
            const Portal& portal = graph.portals[planned_portals_[static_cast<std::size_t>(opening.place)]];
            name = phrase("simplify.opening_between", {{"one", graph.rooms[portal.rooms[0]].name}, {"other", graph.rooms[portal.rooms[1]].name}});
        }
        const std::string truly = metres(opening.width_m()), felt = metres(opening.felt_width_m());
        const std::string what = opening.widened() ? phrase("simplify.felt_wider", {{"felt", felt}, {"truly", truly}, {"enough", opening.stays_narrow() ? "no" : "yes"}})
                                                   : phrase("simplify.stays_narrow", {{"truly", truly}});
        const Vec3 middle = opening.middle_m();
        add(std::move(name), door ? scene_->features[door.value].bounds_m : Aabb{middle, middle}, door, what);
    }
    for (const FeatureId id : compiled_plan_.left_out) add(sentence_case(spoken_name(scene_->features[id.value])), scene_->features[id.value].bounds_m, id, phrase("simplify.is_left_out"));
    if (goals.empty()) return answer(phrase("simplify.nothing"), now_s);
    list.chosen = [this, goals](std::size_t i) { open_tools(goals[i], last_tick_s_); };
    open_list(std::move(list), now_s);
}

}  // namespace handrail
