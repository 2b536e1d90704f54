#include "app/core/wayfinding/find_list.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <utility>

#include "app/core/context/telling.h"
#include "app/core/whereabouts/room_things.h"
#include "worlds/base/language.h"

namespace handrail {
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
    const std::string nearest = find_words(context, rooms, group.goals.front());
    if (group.goals.size() == 1) return {group.name, nearest};
    return {group.name, phrase("guide.several", {{"count", group.goals.size()}, {"nearest", nearest}})};
}

struct Open {
    std::vector<FindGroup> groups;
    int kind = 0;
};

std::vector<ListItem> items_of(const SessionContext& context, const Rooms& rooms, const Open& open) {
    std::vector<ListItem> items;
    for (const FindGroup& group : open.groups) items.push_back(item_of(context, rooms, group));
    items.push_back({phrase("guide.kind"), phrase(kKinds[static_cast<std::size_t>(open.kind)]), true});
    return items;
}

}  // namespace

std::vector<FindGroup> find_groups(const SessionContext& context, FindKind kind) {
    std::vector<FindGroup> groups;
    std::map<std::string, std::size_t> known;
    for (Goal& goal : goals(context)) {
        if (!is_of(context, goal, kind)) continue;
        const auto [at, fresh] = known.try_emplace(goal.name, groups.size());
        if (fresh) groups.push_back({goal.name, {}});
        groups[at->second].goals.push_back(std::move(goal));
    }
    return groups;
}

std::string find_words(const SessionContext& context, const Rooms& rooms, const Goal& goal) {
    std::string where = where_words(context, told_box(rooms, goal));
    if (!rooms.found()) return where;
    const std::uint32_t room = room_of(rooms, goal.box_m);
    if (room == kNothing || room == room_at(rooms.graph(), rooms.space(), context.body.feet_m())) return where;
    const std::string name = sentence_case(rooms.graph().rooms[room].name);
    return name == goal.name ? where : joined(where, name);
}

void open_find_list(const SessionContext& context, const Rooms& rooms,
                    std::function<void(const Goal& goal, double now_s)> chosen, double now_s) {
    const auto open = std::make_shared<Open>();
    open->groups = find_groups(context, FindKind::Everything);
    ListSpec list;
    list.title = phrase("guide.find");
    list.items = items_of(context, rooms, *open);
    list.stays_open = true;
    list.adjusted = [&context, &rooms, open](std::size_t, int by) {
        // On to the next kind of which there is something.
        for (int i = 0; i < kFindKinds; ++i) {
            open->kind = (open->kind + by + kFindKinds) % kFindKinds;
            open->groups = find_groups(context, static_cast<FindKind>(open->kind));
            if (!open->groups.empty()) break;
        }
        context.lists.dialogue.change_items(items_of(context, rooms, *open));
        return phrase(kKinds[static_cast<std::size_t>(open->kind)]);
    };
    list.chosen = [&context, &rooms, open, chosen = std::move(chosen)](std::size_t at) {
        const double then_s = context.tick_s;
        if (at >= open->groups.size()) return context.answer(phrase("guide.kind_how"), then_s);
        const FindGroup group = open->groups[at];
        if (group.goals.size() == 1) {
            context.lists.dialogue.close_all();
            return chosen(group.goals.front(), then_s);
        }
        ListSpec several;
        several.title = phrase("guide.which", {{"name", group.name}});
        for (const Goal& goal : group.goals) several.items.push_back({goal.name, find_words(context, rooms, goal)});
        several.chosen = [&context, group, chosen](std::size_t one) { chosen(group.goals[one], context.tick_s); };
        context.open_list(std::move(several), then_s);
    };
    context.open_list(std::move(list), now_s);
}

}  // namespace handrail
