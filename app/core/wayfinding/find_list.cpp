#include "app/core/wayfinding/find_list.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <utility>

#include "app/core/context/context_words.h"
#include "app/core/context/kinds_first.h"
#include "app/core/whereabouts/room_things.h"
#include "app/core/world/body_heights.h"
#include "app/core/world/surroundings.h"
#include "worlds/base/language.h"
#include "worlds/navigation/foot_distances.h"

namespace handrail::core {
namespace {

constexpr std::array kKinds{"guide.everything", "guide.only_doors", "guide.only_landmarks", "guide.only_things",
                            "guide.only_marks"};
static_assert(kKinds.size() == kFindKinds);

bool is_of(const SessionContext& context, const Goal& goal, FindKind kind) {
    const Feature* feature = context.world.scene->find(goal.feature);
    switch (kind) {
        case FindKind::Everything:
            return true;
        case FindKind::Marks:
            return feature == nullptr;
        case FindKind::Doors:
            return feature && feature->kind == FeatureKind::Door;
        case FindKind::Landmarks:
            return feature && (feature->landmark || feature->clue);
        case FindKind::Things:
            return feature && feature->kind != FeatureKind::Door;
    }
    return false;
}

ListItem item_of(const SessionContext& context, const Rooms& rooms, const FindGroup& group) {
    const std::string nearest = find_words(context, rooms, group.found.front());
    if (group.found.size() == 1) return {group.name, nearest};
    return {group.name, phrase("guide.several", {{"count", group.found.size()}, {"nearest", nearest}})};
}

// Returns the goal with its room. A doorway of the present room is treated as part of that room, whichever room
// contains the door.
Found place(const Rooms& rooms, std::uint32_t here, const navigation::FootDistances& on_foot, Goal goal) {
    const std::uint32_t room = room_of(rooms, goal.box_m);
    Found found{std::move(goal), room, {}};
    const Goal& is = found.goal;
    if (found.room == navigation::kNothing || here == navigation::kNothing || found.room == here) {
        found.room = navigation::kNothing;
        return found;
    }
    const navigation::RoomGraph& graph = rooms.graph();
    for (std::uint32_t p = 0; is.feature && p < graph.portals.size(); ++p) {
        const navigation::Portal& portal = graph.portals[p];
        if (portal.kind != navigation::PassageKind::Door || portal.feature != is.feature) continue;
        if (portal.rooms[0] != here && portal.rooms[1] != here) found.on_foot_m = on_foot.to_portal(p);
        return found;
    }
    const Vec3 middle = is.box_m.centre_m();
    found.on_foot_m = on_foot.to(found.room, {middle.x, middle.y, is.box_m.min_m.z});
    return found;
}

struct Open {
    std::vector<FindGroup> groups;
    int kind = 0;
};

std::vector<ListItem> items_of(const SessionContext& context, const Rooms& rooms, const Open& open) {
    std::vector<ListItem> items;
    for (const FindGroup& group : open.groups) items.push_back(item_of(context, rooms, group));
    // A longer list begins with its kinds, so it needs no line to narrow it.
    if (open.groups.size() <= kMostEntries)
        items.push_back({phrase("guide.kind"), phrase(kKinds[static_cast<std::size_t>(open.kind)]), true});
    return items;
}

}  // namespace

std::vector<FindGroup> find_groups(const SessionContext& context, const Rooms& rooms, FindKind kind) {
    const Vec3& feet_m = context.avatar.feet_m();
    const Vec3 waist_m = feet_m + Vec3(0.0, 0.0, kWaist_m);
    std::vector<std::pair<double, Found>> all;
    const std::uint32_t here =
        rooms.found() ? navigation::room_at(rooms.graph(), rooms.space(), feet_m) : navigation::kNothing;
    std::optional<navigation::FootDistances> on_foot;
    if (rooms.found()) on_foot.emplace(rooms.graph(), here, feet_m);
    for (Goal& goal : goals(context)) {
        if (!is_of(context, goal, kind)) continue;
        Found found =
            on_foot ? place(rooms, here, *on_foot, std::move(goal)) : Found{std::move(goal), navigation::kNothing, {}};
        const double straight_m = glm::length(nearest_place(found.goal.box_m, waist_m) - waist_m);
        all.emplace_back(std::max(straight_m, found.on_foot_m.value_or(straight_m)), std::move(found));
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<FindGroup> groups;
    std::map<std::string, std::size_t> known;
    for (auto& [far_m, found] : all) {
        const auto [at, fresh] = known.try_emplace(found.goal.name, groups.size());
        if (fresh) groups.push_back({found.goal.name, {}});
        groups[at->second].found.push_back(std::move(found));
    }
    return groups;
}

std::string find_words(const SessionContext& context, const Rooms& rooms, const Found& found) {
    const Aabb box_m = announced_box(rooms, found.goal);
    std::string where =
        found.on_foot_m ? where_words_on_foot(context, box_m, *found.on_foot_m) : where_words(context, box_m);
    if (found.room == navigation::kNothing || found.room >= rooms.graph().rooms.size()) return where;
    const std::string name = sentence_case(rooms.graph().rooms[found.room].name);
    return name == found.goal.name ? where : joined(where, name);
}

void open_find_list(const SessionContext& context, const Rooms& rooms,
                    std::function<void(const Goal& goal, double now_s)> chosen, double now_s) {
    const auto open = std::make_shared<Open>();
    open->groups = find_groups(context, rooms, FindKind::Everything);
    ListSpec list;
    list.title = phrase("guide.find");
    list.items = items_of(context, rooms, *open);
    list.stays_open = true;
    list.adjusted = [&context, &rooms, open](std::size_t, int by) {
        // Switch to the next kind for which there is at least one goal.
        for (int i = 0; i < kFindKinds; ++i) {
            open->kind = (open->kind + by + kFindKinds) % kFindKinds;
            open->groups = find_groups(context, rooms, static_cast<FindKind>(open->kind));
            if (!open->groups.empty()) break;
        }
        context.lists.dialogue.change_items(items_of(context, rooms, *open));
        return phrase(kKinds[static_cast<std::size_t>(open->kind)]);
    };
    list.chosen = [&context, &rooms, open, chosen = std::move(chosen)](std::size_t at) {
        const double then_s = context.tick_s;
        if (at >= open->groups.size()) return context.answer(phrase("guide.kind_how"), then_s);
        const FindGroup group = open->groups[at];
        if (group.found.size() == 1) {
            context.lists.dialogue.close_all();
            return chosen(group.found.front().goal, then_s);
        }
        ListSpec several;
        several.title = phrase("guide.which", {{"name", group.name}});
        for (const Found& found : group.found)
            several.items.push_back({found.goal.name, find_words(context, rooms, found)});
        several.chosen = [&context, group, chosen](std::size_t one) { chosen(group.found[one].goal, context.tick_s); };
        context.open_list(std::move(several), then_s);
    };
    std::vector<std::vector<std::string>> kinds(list.items.size());
    for (std::size_t i = 0; i < open->groups.size(); ++i) {
        const Goal& goal = open->groups[i].found.front().goal;
        for (const FindKind kind : {FindKind::Marks, FindKind::Doors, FindKind::Landmarks, FindKind::Things})
            if (kinds[i].empty() && is_of(context, goal, kind))
                kinds[i].push_back(sentence_case(phrase(kKinds[static_cast<std::size_t>(kind)])));
    }
    open_kinds_first(context, std::move(list), kinds, now_s);
}

}  // namespace handrail::core
