#include "app/core/walking/paces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/core/context/context_words.h"
#include "worlds/base/language.h"
#include "worlds/base/typist.h"

namespace handrail::core {
namespace {

constexpr double kMostTaps = 8.0;
constexpr double kShoulder_m = 0.08;  // length of the examined space in front of a shoulder; also its width

// Returns 1 if only the right shoulder has met something, -1 if only the left shoulder has. In both cases the middle of
// the body would have passed. Otherwise returns 0.
int shoulder_met(const SessionContext& context, double way_rad) {
    const WalkerWorld& solids = *context.world.solids;
    const WalkerSize& size = context.avatar.walker->size();
    const Vec3 feet = context.avatar.feet_m() + Vec3(0.0, 0.0, size.step_up_m);
    const WalkerShape part{kShoulder_m / 2.0, size.height_m - size.step_up_m};
    const Vec3 ahead = forward_of_heading(way_rad) * (size.radius_m + kShoulder_m);
    const auto meets = [&](double side_m) {
        const Vec3 from = feet + right_of_heading(way_rad) * side_m;
        return solids.trace(from, from + ahead, part).hit;
    };
    if (meets(0.0)) return 0;
    const double out_m = size.radius_m - kShoulder_m / 2.0;
    const bool left = meets(-out_m), right = meets(out_m);
    return left == right ? 0 : right ? 1 : -1;
}

std::string state_words(const SessionContext& context, FeatureId feature) {
    const Feature* found = context.world.scene->find(feature);
    if (!found || found->kind != FeatureKind::Door) return {};
    if (std::string lock = lock_words(context, feature); !lock.empty()) return lock;
    const int mover = mover_of(context.world, feature);
    if (mover < 0) return {};
    // The leaf of an open door may also block the walker, so the state of the door is announced.
    return phrase(shut(context.world, static_cast<std::uint32_t>(mover)) ? "questions.shut" : "questions.open");
}

}  // namespace

double more_to_go_m(double left_m, double step_m, int times) {
    const double most_m = std::max(kMostTaps, static_cast<double>(times)) * step_m;
    return std::min(left_m + times * step_m, std::max(left_m, most_m));
}

std::string met_words(const SessionContext& context, const TraceHit& met, double way_rad) {
    const int verbosity = context.settings.speech.verbosity;
    if (verbosity <= 0) return {};
    const Feature* feature = context.world.scene->find(met.feature);
    std::string name = verbosity == 1 && feature ? spoken_name(*feature) : std::string();
    if (name.empty()) name = name_of(context, met.feature);
    std::string text = joined(name, state_words(context, met.feature));
    const std::size_t eighth = nearest_eighth(way_rad - context.avatar.heading_rad);
    constexpr std::array kSides{"",
                                "direction.right",
                                "direction.right",
                                "direction.behind",
                                "direction.behind",
                                "direction.behind",
                                "direction.left",
                                "direction.left"};
    const std::string side = kSides[eighth];
    if (!side.empty()) text = joined(text, phrase(side));
    const int shoulder = eighth == 0 ? shoulder_met(context, way_rad) : 0;
    if (shoulder != 0) text = joined(text, phrase(shoulder > 0 ? "walking.right_shoulder" : "walking.left_shoulder"));
    return text;
}

std::string blocked_words(const std::string& met) { return phrase("walking.blocked", {{"what", sentence_case(met)}}); }

bool announces_steps(const SessionContext& context) {
    return spoken_to() != ActsBy::WindowKeys && context.settings.speech.verbosity > 0;
}

std::string Paces::take(const SessionContext& context) {
    const auto steps = static_cast<int>(std::lround(walked_m_ / context.settings.walk.step_length_m));
    begin();
    return steps > 0 ? phrase("words.steps", {{"steps", steps}}) : std::string();
}

std::string Paces::take_blocked(const SessionContext& context, const std::string& met) {
    const std::string steps = take(context);
    if (!announces_steps(context) || met.empty()) return sentence_case(met);
    if (steps.empty()) return blocked_words(met);
    return phrase("walking.steps_then", {{"steps", steps}, {"what", met}});
}

}  // namespace handrail::core
