#include "app/core/context/kinds_first.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

using Kinds = std::vector<std::vector<std::string>>;

struct Kind {
    std::string name;
    std::vector<std::size_t> items;  // indices in the whole list
};

// Returns the kinds at `depth`, ordered by their first items.
std::vector<Kind> kinds_at(const Kinds& kinds, std::size_t depth) {
    std::vector<Kind> found;
    std::map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (kinds[i].size() <= depth) continue;
        const auto [at, fresh] = known.try_emplace(kinds[i][depth], found.size());
        if (fresh) found.push_back({kinds[i][depth], {}});
        found[at->second].items.push_back(i);
    }
    return found;
}

std::string entries(std::size_t count) { return phrase("kinds.entries", {{"n", count}}); }

// Returns a list of the items of one kind. Choosing one does what choosing it in the whole list would do.
std::pair<ListSpec, Kinds> part_of(const ListSpec& whole, const Kinds& kinds, const Kind& kind) {
    ListSpec part;
    part.title = kind.name;
    part.stays_open = whole.stays_open;
    Kinds finer;
    for (const std::size_t i : kind.items) {
        part.items.push_back(whole.items[i]);
        finer.push_back(kinds[i]);
    }
    part.chosen = [chosen = whole.chosen, items = kind.items](std::size_t at) {
        if (chosen) chosen(items[at]);
    };
    return {std::move(part), std::move(finer)};
}

void open(const SessionContext& context, ListSpec list, const Kinds& kinds, std::size_t depth, double now_s) {
    std::vector<Kind> groups;
    std::size_t deepest = 0;
    for (const std::vector<std::string>& of_item : kinds) deepest = std::max(deepest, of_item.size());
    while (depth < deepest && (groups = kinds_at(kinds, depth)).size() < 2) ++depth;
    if (list.items.size() <= kMostEntries || groups.size() < 2) return context.open_list(std::move(list), now_s);
    const auto whole = std::make_shared<const ListSpec>(std::move(list));
    ListSpec first;
    first.title = whole->title;
    first.stays_open = true;
    std::vector<std::size_t> in_front;
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kinds[i].size() <= depth && !whole->items[i].adjustable) {
            in_front.push_back(i);
            first.items.push_back(whole->items[i]);
        }
    for (const Kind& kind : groups) first.items.push_back({kind.name, entries(kind.items.size())});
    first.items.push_back({phrase("kinds.everything"), entries(whole->items.size())});
    first.hidden = whole->items;
    first.left = whole->left;
    first.chosen = [&context, whole, kinds, groups, in_front, depth, shown = first.items.size()](std::size_t at) {
        const double then_s = context.tick_s;
        const std::size_t group = at - in_front.size();
        if (at >= in_front.size() && group < groups.size()) {
            auto [part, finer] = part_of(*whole, kinds, groups[group]);
            return open(context, std::move(part), finer, depth + 1, then_s);
        }
        if (at + 1 == shown) return context.open_list(*whole, then_s);
        if (!whole->stays_open) context.lists.dialogue.close_all();
        if (whole->chosen) whole->chosen(at < in_front.size() ? in_front[at] : at - shown);
    };
    context.open_list(std::move(first), now_s);
}

}  // namespace

void open_kinds_first(const SessionContext& context, ListSpec list, const std::vector<std::vector<std::string>>& kinds,
                      double now_s) {
    contract_pre(kinds.size() == list.items.size());
    open(context, std::move(list), kinds, 0, now_s);
}

}  // namespace handrail::core
