#include "app/core/learning/relations.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/words.h"
#include "app/core/whereabouts/room_things.h"
#include "worlds/base/language.h"
#include "worlds/scene/outer_ground.h"

namespace handrail::core {
namespace {

constexpr std::size_t kMostQuestions = 3;
constexpr double kNearest_m = 1.5, kOff_rad = kPi / 6.0;

bool is_thing(FeatureKind kind) {
    return kind == FeatureKind::Object || kind == FeatureKind::Door || kind == FeatureKind::Button ||
           kind == FeatureKind::Lift;
}

}  // namespace

std::string side_words(Quarter side) {
    static_assert(Quarter::Ahead < Quarter::Right && Quarter::Right < Quarter::Behind &&
                  Quarter::Behind < Quarter::Left);
    constexpr std::array kSides{"learning.side_ahead", "learning.side_right", "learning.side_behind",
                                "learning.side_left"};
    return phrase(kSides.at(static_cast<std::size_t>(side)));
}

std::vector<RelationQuestion> relation_questions(const SessionContext& context, const Rooms& rooms, std::uint32_t room,
                                                 const Vec3& base_m) {
    std::vector<RelationQuestion> questions;
    const Scene& scene = *context.world.scene;
    for (std::uint32_t i = 0; i < scene.features.size() && questions.size() < kMostQuestions; ++i) {
        const Feature& feature = scene.features[i];
        if (feature.name.empty() || !is_thing(feature.kind) || is_outer_ground(feature) || feature.bounds_m.empty())
            continue;
        const Vec3 to = feature.bounds_m.centre_m() - base_m;
        const double distance_m = std::hypot(to.x, to.y);
        if (distance_m < kNearest_m) continue;
        const double bearing = std::atan2(to.x, to.y);  // angle of the thing clockwise from north, seen from the base
        const auto quarter = std::lround(bearing / (0.5 * kPi));
        if (std::abs(bearing - static_cast<double>(quarter) * 0.5 * kPi) > kOff_rad) continue;
        if (room_of(rooms, feature.bounds_m) != room) continue;
        const std::string name = sentence_case(name_of(context, FeatureId{i}));
        // If two things have the same name, a question about them would be ambiguous.
        const auto alike = [&](const Feature& other) { return &other != &feature && other.name == feature.name; };
        if (std::any_of(scene.features.begin(), scene.features.end(), alike)) continue;
        questions.push_back({name, static_cast<Quarter>((quarter + 4) % 4), distance_m});
    }
    return questions;
}

}  // namespace handrail::core
