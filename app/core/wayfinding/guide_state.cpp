// The part of Guide that answers what guides the person at present, and ends it by its kind. Use it on the app thread
// only.
#include "app/core/context/context_words.h"
#include "app/core/wayfinding/guide.h"
#include "worlds/base/language.h"

namespace handrail::core {

std::string Guide::end(Guidance what) {
    switch (what) {
        case Guidance::Route: {
            const bool hand = hand_.at_work();
            if (!on_route()) return phrase("way.none");
            leave_route();
            return phrase(hand ? "lead.let_go" : "lead.stopped");
        }
        case Guidance::Beacon:
            if (!beacon().on()) return phrase("answer.beacon_is_off");
            seek_.silence_beacon();
            return phrase("guide.beacon_off");
        case Guidance::Warmer:
            if (!seek_.warmer().on()) return phrase("answer.warmer_is_off");
            seek_.silence_warmer();
            return phrase("guide.warmer_off");
        case Guidance::Lines:
            break;
    }
    if (!hand_.lines_at_work()) return phrase("answer.no_lines");
    hand_.end();
    return phrase("lead.lines_off");
}

std::string Guide::state_words(Guidance of, double now_s) {
    if (of == Guidance::Beacon)
        return beacon().on() ? beacon_words(now_s)
                             : phrase("guide.no_beacon", {{"key", context_.keys.keys_of(Command::SetBeacon)}});
    if (ear_.following()) return phrase("answer.route_to", {{"goal", ear_.name()}, {"distance", ear_.left_words()}});
    if (leads_hand() && goal_) return phrase("answer.hand_to", {{"goal", goal_->name}});
    return phrase("way.none");
}

// The beacon must be on.
std::string Guide::beacon_words(double now_s) {
    const std::string how = seek_.beacon_words(now_s);
    const Goal goal{beacon().name(), beacon().thing_m(), beacon().feature()};
    const std::string where = where_words(context_, announced_box(rooms_, goal));
    return phrase("guide.beacon_on", {{"name", goal.name}, {"where", where}}) + (how.empty() ? how : ". " + how);
}

}  // namespace handrail::core
