#include "app/core/learning/route_memory.h"

#include <algorithm>
#include <map>

#include "app/core/learning/learnt_file.h"
#include "app/core/whereabouts/room_things.h"
#include "worlds/base/language.h"
#include "worlds/base/overloaded.h"

namespace handrail::core {
namespace {

constexpr std::size_t kMostPoints = 100'000;  // largest number of points, enough for 25 km
constexpr std::size_t kMostAnnounced = 2;

SideEntry* entry_of(std::vector<SideEntry>& ways, const std::string& goal) {
    const auto own =
        std::find_if(ways.begin(), ways.end(), [&](const SideEntry& way) { return text_of(way, "name") == goal; });
    return own == ways.end() ? nullptr : &*own;
}

std::vector<SideTable> turns_of(const SideEntry& way) {
    const auto turns = way.find("turn");
    const auto* tables = turns == way.end() ? nullptr : std::get_if<std::vector<SideTable>>(&turns->second);
    return tables ? *tables : std::vector<SideTable>();
}

}  // namespace

void RouteMemory::see(const SessionEvent& event) {
    std::visit(Overloaded{[&](const Led& led) {
                              // The guidance was only announced again, so no new walk begins.
                              if (led.goal == going_.goal && !going_.arrived) return;
                              going_ = {led.goal, {}, true, false};
                          },
                          [&](const Arrived& arrived) { going_.arrived |= arrived.goal == going_.goal; },
                          [&](const Teleported&) { going_ = {}; }, [](const auto&) {}},
               event.what);
}

void RouteMemory::tick(double now_s) {
    if (going_.goal.empty()) return;
    if (!remembers(context_.additions)) return void(going_ = {});
    if (std::exchange(going_.to_announce, false)) announce(now_s);
    const Vec3& feet_m = context_.avatar.feet_m();
    if (going_.walk.empty() || glm::length(feet_m - going_.walk.back().place_m) >= results::kPointSpacing_m)
        if (going_.walk.size() < kMostPoints) going_.walk.push_back({now_s, feet_m, false});
    if (going_.arrived) look_back(now_s);
}

void RouteMemory::announce(double now_s) {
    std::vector<SideEntry> ways = context_.additions.entries("learnt_way");
    const SideEntry* own = entry_of(ways, going_.goal);
    if (!own) return;
    std::vector<SideTable> turns = turns_of(*own);
    const auto errors = [](const SideTable& turn) {
        return number_of(turn.entry, "early", 0.0) + number_of(turn.entry, "missed", 0.0);
    };
    std::stable_sort(turns.begin(), turns.end(),
                     [&](const SideTable& a, const SideTable& b) { return errors(a) > errors(b); });
    if (turns.size() > kMostAnnounced) turns.resize(kMostAnnounced);
    for (const SideTable& turn : turns) {
        const std::string at = text_of(turn.entry, "at");
        const auto early = static_cast<int>(std::clamp(number_of(turn.entry, "early", 0.0), 0.0, 1e3)),
                   missed = static_cast<int>(std::clamp(number_of(turn.entry, "missed", 0.0), 0.0, 1e3));
        if (at.empty()) continue;
        if (early > 0)
            context_.say(phrase("learning.turned_early", {{"times", early}, {"place", at}}), cues::SpeechClass::Answer,
                         now_s);
        if (missed > 0)
            context_.say(phrase("learning.turned_late", {{"times", missed}, {"place", at}}), cues::SpeechClass::Answer,
                         now_s);
    }
}

void RouteMemory::look_back(double now_s) {
    const Going went = std::exchange(going_, {});
    if (!rooms_.found() || went.walk.size() < 2) return;
    const navigation::Route right = rooms_.navigation().plan(went.walk.front().place_m, went.walk.back().place_m);
    if (!right.reaches) return;
    const results::TurnsMet met = results::turns_met(right.points_m, went.walk);
    std::vector<SideEntry> ways = context_.additions.entries("learnt_way");
    SideEntry* own = entry_of(ways, went.goal);
    if (!own && met.early + met.missed == 0) return;
    if (!own) own = &ways.emplace_back(SideEntry{{"name", went.goal}});
    std::vector<SideTable> turns = turns_of(*own);
    if (met.early + met.missed == 0) turns.clear();
    const auto count = [&](const Vec3& at_m, const char* how) {
        const std::uint32_t room = room_of(rooms_, Aabb{at_m, at_m});
        if (room == navigation::kNothing) return;
        const std::string& name = rooms_.graph().rooms[room].name;
        auto turn = std::find_if(turns.begin(), turns.end(),
                                 [&](const SideTable& one) { return text_of(one.entry, "at") == name; });
        if (turn == turns.end()) turn = turns.insert(turn, SideTable{SideEntry{{"at", name}}});
        turn->entry[how] = static_cast<std::int64_t>(number_of(turn->entry, how, 0.0)) + std::int64_t{1};
    };
    for (const Vec3& at_m : met.early_m) count(at_m, "early");
    for (const Vec3& at_m : met.missed_m) count(at_m, "missed");
    (*own)["walked"] = static_cast<std::int64_t>(number_of(*own, "walked", 0.0)) + std::int64_t{1};
    if (turns.empty()) own->erase("turn");
    else (*own)["turn"] = std::move(turns);
    context_.additions.set_entries("learnt_way", ways);
    context_.session_requests.save_additions(now_s);
}

}  // namespace handrail::core
