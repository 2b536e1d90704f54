// The part of Session for the window: it collects everything that a picture of the present moment shows. Use it on the
// app thread only.
#include <algorithm>
#include <cmath>

#include "app/core/session/session.h"
#include "audio-cues/plan/cue_planner.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

// Returns the names of everything that the hand touches, or that it touches nothing.
std::string touched_words(const Scene& scene, const servo::ToolState& tool) {
    constexpr int kNameAndMaterial = 2;
    std::vector<FeatureId> touched{tool.touched()};
    for (std::size_t i = 0; i < tool.contacts.count; ++i) touched.push_back(tool.contacts.contacts[i].feature);
    std::string words;
    for (auto at = touched.begin(); at != touched.end(); ++at) {
        const std::string name = cues::describe_feature(scene, *at, kNameAndMaterial);
        if (!name.empty() && std::find(touched.begin(), at, *at) == at) words += (words.empty() ? "" : "; ") + name;
    }
    return words.empty() ? phrase("window.free") : words;
}

// Returns where the hand is as seen from the walker, what it touches, the force on it, and whether there is force.
std::string hand_words(const SessionState& state, const servo::ToolState& tool, bool forces_on) {
    const Vec3 to = tool.proxy_m - state.avatar.feet_m();
    const double away_m = glm::length(Vec2(to.x, to.y));
    std::string where = phrase("window.hand_here");
    if (constexpr double kHere_m = 0.4; away_m > kHere_m)
        where =
            phrase("window.hand_there", {{"metres", away_m},
                                         {"direction", direction_words(std::atan2(to.x, to.y), state.avatar.heading_rad,
                                                                       state.person.settings.speech.directions)}});
    return phrase("window.hand", {{"where", where},
                                  {"what", touched_words(*state.world.scene, tool)},
                                  {"newtons", glm::length(tool.force_n)},
                                  {"simulated", state.hands.right.simulated ? "yes" : "no"},
                                  {"forces", forces_on && tool.fault == servo::Fault::None ? "on" : "off"}});
}

// The part of a route on one storey.
struct StoreyRoute {
    std::vector<Vec3> points_m;
    double leaves_by_m = 0.0;  // height by which the route goes up, or if negative down, from the last point; 0: none
};

// Returns the part of a route near this height, up to where the route goes to another storey.
StoreyRoute on_storey(const std::vector<Vec3>& route_m, double floor_m) {
    constexpr double kMost_m = 1.5;  // farther up or down counts as another storey
    StoreyRoute part;
    const auto off_m = [&](std::size_t i) { return route_m[i].z - floor_m; };
    const auto place_at = [&](std::size_t i, double at_off_m) {  // on the line from point i - 1 to point i
        return glm::mix(route_m[i - 1], route_m[i], (at_off_m - off_m(i - 1)) / (off_m(i) - off_m(i - 1)));
    };
    for (std::size_t i = 0; i < route_m.size(); ++i) {
        const bool here = std::abs(off_m(i)) <= kMost_m;
        if (here && part.points_m.empty() && i > 0)
            part.points_m.push_back(place_at(i, std::copysign(kMost_m, off_m(i - 1))));
        if (here) part.points_m.push_back(route_m[i]);
        if (here || part.points_m.empty()) continue;
        part.leaves_by_m = off_m(i);
        part.points_m.push_back(place_at(i, std::copysign(kMost_m, off_m(i))));
        break;
    }
    return part;
}

}  // namespace

ViewState Session::view(const servo::ToolState& tool) {
    const Arrivals::Turn looks(state_.context.arrivals, true);
    ViewState view;
    view.scene = state_.world.scene;
    view.pictures = shown_.pictures;
    view.display = state_.person.settings.display;
    view.dialogue = state_.lists.dialogue.view();
    view.moved = bodies_.moved();
    view.feet_m = feet_m();
    view.camera_m = labyrinth_.camera_m();
    view.eyes_m = view.feet_m + Vec3(0.0, 0.0, state_.avatar.walker->size().eye_height_m);
    view.heading_rad = state_.avatar.heading_rad;
    view.tilt_rad = walk_.walking.tilt_rad();
    view.forces_on = state_.hands.tuning.forces_on && state_.hands.tuning.focused && !state_.hands.tuning.panic;
    view.show_hand = state_.hands.right.present;
    view.proxy_m = tool.proxy_m;
    view.proxy_radius_m = tool.proxy_radius_m;
    view.touching = tool.touches() || tool.holds != render::kNoBody;
    view.force_n = tool.force_n;
    view.north_up = state_.person.settings.workspace.frame == settings::FrameChoice::Map;
    view.plan_scale = state_.hands.named_scale;
    if (!view.scene) return view;
    view.texts.title = phrase("window.title", {{"world", spoken_name(*view.scene)},
                                               {"lesson", learn_.teaching.exercise.title()},
                                               {"in_lesson", learn_.teaching.exercise.under_way() ? "yes" : "no"}});
    if (view.show_hand) {
        // A report of the servo may still belong to the previous world.
        if (tool.ticks > 0 && tool.scene_world == state_.world.felt) shown_.hand_path.add(tool.proxy_m);
        view.texts.hand = hand_words(state_, tool, view.forces_on);
    }
    view.texts.task = task_words();
    view.path_m = walk_.walking.path_m();
    view.hand_path_m = shown_.hand_path.points_m();
    // The last planned route may be an old one while only the beacon sounds.
    const std::string goal = guide_.route_name();
    if (!goal.empty() || guide_.leads_hand()) {
        StoreyRoute part = on_storey(guide_.way_m(), view.feet_m.z);
        if (!goal.empty() && !part.points_m.empty())
            view.guidance.goal =
                DrawnPlace{part.leaves_by_m == 0.0
                               ? sentence_case(goal)
                               : phrase("window.goal_elsewhere",
                                        {{"goal", sentence_case(goal)}, {"up", part.leaves_by_m > 0.0 ? "yes" : "no"}}),
                           part.points_m.back()};
        view.guidance.route_m = std::move(part.points_m);
    }
    if (guide_.beacon().on())
        view.guidance.beacon = DrawnPlace{guide_.beacon().name(), guide_.beacon().thing_m().centre_m()};
    for (const Mark& mark : state_.world.marks) view.guidance.marks.push_back({mark.name, mark.place_m});
    if (shown_.pictures != Pictures::FirstPerson) {
        view.rooms = where_.rooms.drawing();
        view.visited = where_.rooms.visited();
        view.room = where_.rooms.here();
    }
    return view;
}

// Returns what a lesson asks the person to do, and the present leg of the route.
std::string Session::task_words() const {
    std::string words = learn_.teaching.exercise.task();
    if (words.empty()) words = lesson_session_.instruction();
    if (!guide_.route_name().empty() && !state_.cues.last_leg().empty())
        words += (words.empty() ? "" : " ") + phrase("window.leg", {{"leg", state_.cues.last_leg()}});
    return words;
}

}  // namespace handrail::core
