#include "app/core/wayfinding/floor_grooves.h"

#include <utility>

#include "app/core/context/context_words.h"

namespace handrail::core {
namespace {

constexpr double kAgain_s = 1.0;  // if grooves end twice within this time, no new grooves are made

}  // namespace

FloorGrooves::FloorGrooves(const SessionContext& context, Rooms& rooms, const RoutePlans& plans)
    : SessionPart(context), rooms_(rooms), plans_(plans) {}

void FloorGrooves::enter_world() { laid_ = {}; }

bool FloorGrooves::wanted() const {
    const HandsState& hands = context_.hands;
    return context_.settings.guidance.grooves && hands.right.present && !hands.keys_alone && !hands.at_desk();
}

std::optional<servo::GuidancePath> FloorGrooves::lay(const servo::GuidancePath& path, double now_s) {
    if (!rooms_.known()) return std::nullopt;
    if (!std::exchange(laid_.doorways_known, true))
        laid_.doorways = grooves_through_doorways(rooms_.graph(), rooms_.space());
    const servo::GuidanceState& felt = context_.hands.tool.guidance;
    const bool lie = path.number != 0 && path.kind == servo::GuidanceKind::Grooves;
    if (lie && felt.number == path.number && felt.phase != servo::GuidancePhase::Acts &&
        now_s - laid_.ended_s > kAgain_s) {
        // The servo ended the grooves at a jump of the workspace, or because force was forbidden.
        laid_.ended_s = now_s;
        laid_.ended = true;
    }
    const Vec3 here = finding_place_m(context_);
    if (lie && !laid_.ended && laid_.way == plans_.changes() && laid_.scale == scale(context_) &&
        glm::length(here - laid_.near_m) <= laid_.good_within_m)
        return std::nullopt;
    Grooves grooves = nearest_grooves(plans_.last_m(), laid_.doorways, here, context_.hands.tuning.touch.radius_m);
    laid_.ended = false;
    laid_.way = plans_.changes();
    laid_.near_m = here;
    laid_.good_within_m = grooves.good_within_m;
    laid_.scale = scale(context_);
    grooves.path.strength = context_.settings.guidance.strength;
    return grooves.path;
}

}  // namespace handrail::core
