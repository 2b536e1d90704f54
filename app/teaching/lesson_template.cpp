// Makes a lesson of three sessions from a draft; see lesson_file.h.
#include <algorithm>

#include "app/teaching/lesson_file.h"

namespace handrail::teaching {
namespace {

LessonPlace place_of(const core::LessonDraft::Place& from) {
    LessonPlace place;
    place.name = from.name;
    place.thing = from.thing;
    if (from.thing.empty()) place.room = from.room;
    place.place_m = from.place_m;  // the position distinguishes several objects or rooms of the same name
    return place;
}

TaughtStep step_of(StepKind kind) {
    TaughtStep step;
    step.kind = kind;
    return step;
}

}  // namespace

std::string named_from(const std::filesystem::path& folder, const std::filesystem::path& world) {
    std::error_code ec;
    const auto real = [&](const std::filesystem::path& path) {
        return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ec), ec);
    };
    const std::filesystem::path way = real(world).lexically_relative(real(folder));
    return (way.empty() ? world.filename() : way).string();
}

LessonFile three_sessions(const core::LessonDraft& draft, const std::filesystem::path& world) {
    constexpr int kMinutes = 15;
    LessonFile lesson;
    lesson.title.text = draft.title;
    lesson.world = world;
    lesson.world_name = world.filename().string();
    lesson.world_checksum = draft.world_checksum;
    lesson.base_feet_m = draft.base_feet_m;
    lesson.base_heading_rad = draft.base_heading_rad;
    for (const core::LessonDraft::Place& landmark : draft.landmarks) {
        const auto named = [&](const LessonPlace& place) { return place.name == landmark.name; };
        if (std::none_of(lesson.landmarks.begin(), lesson.landmarks.end(), named))
            lesson.landmarks.push_back(place_of(landmark));
    }
    LessonRoute route;
    route.name = draft.title;
    for (const core::LessonDraft::Place& stop : draft.stops) route.stops.push_back(place_of(stop));
    lesson.routes.push_back(route);

    TaughtSession first{phrase("prepare.first"), kMinutes, false, {}, {}, 0};
    if (!draft.base_room.empty()) {
        TaughtStep learn = step_of(StepKind::Learn);
        learn.room = draft.base_room;
        first.steps.push_back(learn);
    }
    TaughtStep point = step_of(StepKind::Point);
    point.from = "base";
    point.to = draft.requested;
    first.steps.push_back(point);

    TaughtSession second{phrase("prepare.second"), kMinutes, false, {}, {}, 0};
    TaughtStep go = step_of(StepKind::Go);
    go.route = route.name;
    go.help_percent = {100, 60, 30, 0};
    second.steps.push_back(go);

    TaughtSession third{phrase("prepare.third"), kMinutes, false, {}, {}, 0};
    go.help_percent = {0};
    third.steps.push_back(go);
    TaughtStep distance = step_of(StepKind::Distance);
    distance.from = "base";
    distance.to = draft.requested;
    third.steps.push_back(distance);
    if (draft.on_route.size() > 1) {
        TaughtStep order = step_of(StepKind::Order);
        order.to = draft.on_route;
        order.say.text = phrase("prepare.order");
        third.steps.push_back(order);
    }
    for (const std::string& question : draft.questions) {
        TaughtStep ask = step_of(StepKind::Question);
        ask.say.text = question;
        third.steps.push_back(ask);
    }
    TaughtStep sure = step_of(StepKind::Question);
    sure.say.text = phrase("prepare.how_sure");
    sure.scale = {1, 7};
    third.steps.push_back(sure);
    lesson.sessions = {first, second, third};
    return lesson;
}

}  // namespace handrail::teaching
