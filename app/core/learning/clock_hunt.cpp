#include "app/core/learning/clock_hunt.h"

#include <cmath>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/dialogue/words.h"
#include "app/core/learning/time_words.h"
#include "app/core/wayfinding/leg.h"
#include "audio-cues/plan/sound_table.h"
#include "worlds/base/language.h"
#include "worlds/scene/surfaces.h"

namespace handrail::core {
namespace {

constexpr double kHide_m = 6.0;  // least distance on foot from the walker to the hidden clock
// World metres; if the hand is within this distance of the clock, it has found the clock.
constexpr double kHandFinds_m = 0.4;
const Vec3 kAbove_m(0.0, 0.0, 1.0);  // offset of the clock from the floor

}  // namespace

ClockHunt::ClockHunt(const SessionContext& context, Rooms& rooms, Soundscape& soundscape)
    : SessionPart(context), rooms_(rooms), soundscape_(soundscape) {}

void ClockHunt::enter_world() {
    hidden_.reset();
    soundscape_.add({});
}

void ClockHunt::begin_awaited(double now_s) {
    if (std::exchange(awaits_, false)) hide(now_s);
}

bool ClockHunt::act(Command command, double now_s) {
    if (command != Command::Hunt) return false;
    if (hidden_) {
        ++hidden_->hints;
        context_.answer(hint_words(), now_s);
    } else {
        hide(now_s);
    }
    return true;
}

void ClockHunt::hide(double now_s) {
    // Doors are treated as open, because the person can open them. So they are removed from this copy of the world.
    Scene open = *context_.world.scene;
    std::erase_if(open.placed, [&](const PlacedModel& thing) {
        const Feature* feature = context_.world.scene->find(thing.feature);
        return feature && feature->kind == FeatureKind::Door;
    });
    auto world = std::make_unique<WalkerWorld>(*context_.world.solids, std::make_shared<const Scene>(std::move(open)));
    HuntGround ground(*world, context_.avatar.feet_m(), context_.avatar.walker->size());
    if (ground.size() < 30) return context_.answer(phrase("hunt.no_space"), now_s);
    const Vec3 clock = ground.hiding_place(static_cast<std::uint64_t>(now_s * 1e3) + 7919U * ++hunts_, kHide_m);
    ground.aim(clock);
    hidden_.emplace(Hidden{std::move(ground), std::move(world), clock, now_s, 0});
    soundscape_.add({{cues::SoundKind::HiddenClock, clock + kAbove_m}});
    context_.play(cues::SoundKind::Arrived, now_s);
    context_.answer(phrase("hunt.begun", {{"key", context_.keys.keys_of(Command::Hunt)}}), now_s);
}

std::string ClockHunt::hint_words() const {
    const Vec3& feet_m = context_.avatar.feet_m();
    // If the routes of this world are known, they give the distance, because a route can begin anywhere. Otherwise the
    // grid of the hunt gives it.
    std::optional<double> way;
    std::optional<Vec3> next;
    if (rooms_.found())
        if (const auto leg = next_leg(rooms_.navigation().plan(feet_m, hidden_->clock_m), feet_m,
                                      0.5 * context_.settings.walk.step_length_m);
            leg && leg->route.reaches)
            way = leg->route.length_m, next = leg->to_m;
    if (!way)
        way = hidden_->ground.way_m(feet_m),
        next = hidden_->ground.next_m(*hidden_->open_world, feet_m, context_.avatar.walker->size());
    if (!way || !next) {
        const Vec3 to = hidden_->clock_m - feet_m;
        return phrase("hunt.straight",
                      {{"where", where_words(context_, std::hypot(to.x, to.y), std::atan2(to.x, to.y))}});
    }
    const Vec3 to = *next - feet_m;
    const double bearing = std::atan2(to.x, to.y), straight_m = std::hypot(to.x, to.y);
    std::string text = phrase("hunt.go", {{"where", where_words(context_, straight_m, bearing)},
                                          {"distance", distance_words(*way, distances(context_))}});
    const TraceHit hit = context_.world.solids->trace(feet_m + kAbove_m, *next + kAbove_m, WalkerShape{}, true);
    if (hit.hit)
        if (const Feature* feature = context_.world.scene->find(hit.feature);
            feature && feature->kind == FeatureKind::Door)
            text = phrase("hunt.open", {{"door", spoken_name(*feature)}}) + " " + text;
    return text;
}

void ClockHunt::tick(double now_s) {
    if (!hidden_) return;
    const bool reached = context_.hands.tool.ticks > 0 && context_.hands.right.present &&
                         glm::length(context_.hands.tool.proxy_m - (hidden_->clock_m + kAbove_m)) < kHandFinds_m;
    if (!reached && !finds(*context_.world.solids, context_.avatar.feet_m(), hidden_->clock_m)) return;
    const double took_s = now_s - hidden_->began_s;
    const int hints = hidden_->hints;
    hidden_.reset();
    soundscape_.add({});
    context_.play(cues::SoundKind::Arrived, now_s);
    std::string text = phrase("hunt.found", {{"time", time_words(took_s)}, {"hints", hints}});
    text += " " + best_.finish(context_.world.scene->name, took_s);
    context_.answer(text, now_s);
}

}  // namespace handrail::core
