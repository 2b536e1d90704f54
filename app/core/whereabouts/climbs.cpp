#include "app/core/whereabouts/climbs.h"

#include <cmath>

#include "app/core/context/context_words.h"
#include "app/core/world/questions.h"
#include "app/core/world/surroundings.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kOneFloor_m = 0.5;
// If the person is farther than this from an end of the stairs, they have left that end.
constexpr double kWalkedAway_m = 1.5;
// A door or button that the person faces is used instead if it is nearer than this.
constexpr double kToWhatIsFaced_m = 1.2;

}  // namespace

std::optional<Climbs::End> Climbs::end_here(double within_m, const navigation::RoutePassage* only) const {
    if (!rooms_.found()) return std::nullopt;
    const navigation::WalkSpace& space = rooms_.space();
    const Vec3& feet_m = context_.avatar.feet_m();
    std::optional<End> nearest;
    for (std::uint32_t i = 0; i < space.links.size(); ++i) {
        const navigation::WalkLink& link = space.links[i];
        if (link.kind != navigation::PassageKind::Climb) continue;
        for (const bool foot : {true, false}) {
            const Vec3 here_m = space.place_m(foot ? link.from : link.to);
            const double far_m = std::hypot(here_m.x - feet_m.x, here_m.y - feet_m.y);
            const Vec3 there_m = space.place_m(foot ? link.to : link.from);
            if (std::abs(here_m.z - feet_m.z) > kOneFloor_m || far_m > within_m) continue;
            if (only && (link.feature != only->feature || (there_m.z > here_m.z) != (only->rise_m > 0.0))) continue;
            within_m = far_m;
            nearest = End{i, here_m, there_m, link.feature};
        }
    }
    return nearest;
}

// Returns true if the hand touches something else that the Use key operates. Also returns true if something else is
// straight ahead, unless the route uses the stairs (`wanted`).
bool Climbs::something_else(bool wanted) const {
    if (context_.hands.tool.touches() && mover_of(context_.world, context_.hands.tool.touched()) >= 0) return true;
    if (wanted) return false;
    const auto seen = look(*context_.world.solids, context_.avatar.feet_m(), kLookHeight_m, context_.avatar.heading_rad,
                           kToWhatIsFaced_m);
    return seen && mover_of(context_.world, seen->feature) >= 0;
}

bool Climbs::act(Command command, double now_s) {
    if (command != Command::Use) return false;
    const std::optional<navigation::RoutePassage> wanted = on_way ? on_way() : std::nullopt;
    std::optional<End> end = wanted ? end_here(kWalkedAway_m, &*wanted) : std::nullopt;
    if (!end) end = end_here(kAtEnd_m);
    if (!end || something_else(wanted.has_value())) return false;
    announced_ = end->link;
    context_.session_requests.place(end->there_m, context_.avatar.heading_rad, now_s);
    context_.play(cues::SoundKind::FrameSwitch, now_s);
    rooms_.notice(now_s, true);
    const double rise_m = end->there_m.z - end->here_m.z;
    context_.answer(phrase(rise_m > 0.0 ? "climbs.up" : "climbs.down", {{"metres", std::abs(rise_m)}}) + " " +
                        queries_.where_am_i(),
                    now_s);
    return true;
}

void Climbs::tick(double now_s) {
    if (announced_) {
        const std::optional<End> still = end_here(kWalkedAway_m);
        if (still && still->link == *announced_) return;
        announced_.reset();
    }
    const std::optional<End> end = end_here(kAtEnd_m);
    if (!end) return;
    announced_ = end->link;
    const std::string what =
        passage_name(context_, navigation::PassageKind::Climb, end->feature, end->there_m.z - end->here_m.z);
    context_.say(phrase("climbs.here", {{"stairs", sentence_case(what)}, {"key", context_.keys.keys_of(Command::Use)}}),
                 cues::SpeechClass::Contact, now_s);
}

}  // namespace handrail::core
