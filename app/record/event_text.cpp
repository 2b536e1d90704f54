#include <cmath>

#include "app/record/input_text.h"
#include "app/record/json_fields.h"
#include "worlds/base/overloaded.h"

namespace handrail::record {
namespace {

constexpr std::array<const char*, 3> kVisitedBy = {"hand", "asking", "facing"};
constexpr std::array<const char*, 4> kRequests = {"done", "more_help", "less_help", "leave"};
constexpr std::array<const char*, 4> kLedBy = {"hand", "lines", "ear", "beacon"};

const char* word_of(core::LedBy by) { return kLedBy.at(static_cast<std::size_t>(by)); }

Json of_feature(const char* is, FeatureId feature, const Scene* scene) {
    Json json{{"is", is}, {"feature", feature.value}};
    if (scene && feature.value < scene->features.size()) json["thing"] = scene->features[feature.value].name;
    return json;
}

}  // namespace

std::string event_line(const core::SessionEvent& event, const Scene* scene, double begun_s) {
    Json line{{"t", std::llround((event.time_s - begun_s) * 1e3)}};
    line.update(std::visit(
        Overloaded{
            [&](const core::Touched& e) {
                Json json = of_feature("contact", e.feature, scene);
                json["hand"] = e.left ? 1 : 0;
                json["at_m"] = json_of_vec(e.at_m);
                json["force_mn"] = std::llround(e.force_n * 1e3);
                return json;
            },
            [](const core::RoomEntered& e) {
                return Json{{"is", "room_entered"}, {"room", e.room}, {"name", e.name}};
            },
            [&](const core::ThingVisited& e) {
                Json json = of_feature("thing_visited", e.feature, scene);
                json["by"] = kVisitedBy.at(static_cast<std::size_t>(e.by));
                return json;
            },
            [](const core::Answered& e) {
                return Json{{"is", "answered"}, {"question", e.question}, {"text", e.text}};
            },
            [&](const core::WallDone& e) {
                Json json = of_feature("wall_done", e.feature, scene);
                json["room"] = e.room;
                return json;
            },
            [](const core::LessonRequested& e) {
                return Json{{"is", "lesson_wished"}, {"wish", kRequests.at(static_cast<std::size_t>(e.request))}};
            },
            [](const core::HelpRequested& e) {
                return Json{{"is", "help_asked"}, {"command", std::string(core::info(e.command).word)}};
            },
            [&](const core::DoorUsed& e) { return of_feature("door_used", e.feature, scene); },
            [](const core::Teleported& e) {
                return Json{{"is", "teleported"}, {"feet_m", json_of_vec(e.feet_m)}, {"heading_rad", e.heading_rad}};
            },
            [](const core::Led& e) {
                return Json{{"is", "led"}, {"goal", e.goal}, {"by", word_of(e.by)}};
            },
            [](const core::Leading& e) {
                return Json{{"is", "leading"}, {"on", e.on}};
            },
            [](const core::ListShown& e) {
                return Json{{"is", "list_shown"}, {"open", e.open}};
            },
            [](const core::LeftRoute& e) {
                return Json{{"is", "left_route"}, {"goal", e.goal}, {"by", word_of(e.by)}};
            },
            [](const core::StopPassed& e) {
                return Json{{"is", "stop_passed"}, {"stop", e.stop}, {"by", word_of(e.by)}};
            },
            [](const core::Arrived& e) {
                return Json{{"is", "arrived"}, {"goal", e.goal}, {"by", word_of(e.by)}, {"to_nearest", e.to_nearest}};
            },
        },
        event.what));
    return line_of(line);
}

}  // namespace handrail::record
