#include "app/core/kept/side_merge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>

#include "worlds/base/text.h"

namespace handrail::core {
namespace {

using At = std::optional<std::size_t>;

bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// Returns true if both entries have the same value for `key`, so that they are versions of one entry. The caller tries
// the most reliable key first.
bool same_thing(const SideEntry& a, const SideEntry& b, const char* key) {
    const auto in_a = a.find(key), in_b = b.find(key);
    return in_a != a.end() && in_b != b.end() && same(in_a->second, in_b->second);
}

// Returns, for each entry of `base`, its index in `now`, or no value if the entry was deleted. `added` receives the
// indices of the entries of `now` that are not in `base`.
std::vector<At> places_of(const std::vector<SideEntry>& base, const std::vector<SideEntry>& now,
                          std::vector<std::size_t>& added) {
    std::vector<At> places(base.size());
    std::vector<bool> used(now.size(), false);
    const auto match = [&](const auto& fits) {
        for (std::size_t b = 0; b < base.size(); ++b) {
            if (places[b]) continue;
            // The search starts at the same index, because an unchanged file has the same order.
            for (std::size_t i = 0; i < now.size(); ++i) {
                const std::size_t at = (b + i) % now.size();
                if (used[at] || !fits(base[b], now[at])) continue;
                places[b] = at;
                used[at] = true;
                break;
            }
        }
    };
    match([](const SideEntry& a, const SideEntry& b) { return same(a, b); });
    for (const char* key : {"place_m", "stop", "name"})
        match([&](const SideEntry& a, const SideEntry& b) { return same_thing(a, b, key); });
    for (std::size_t i = 0; i < now.size(); ++i)
        if (!used[i]) added.push_back(i);
    return places;
}

}  // namespace

bool same(const SideValue& a, const SideValue& b) {
    if (a.index() != b.index()) return false;
    if (const auto* number = std::get_if<double>(&a)) return same_number(*number, std::get<double>(b));
    if (const auto* numbers = std::get_if<std::vector<double>>(&a)) {
        const auto& others = std::get<std::vector<double>>(b);
        return std::equal(numbers->begin(), numbers->end(), others.begin(), others.end(), same_number);
    }
    if (const auto* tables = std::get_if<std::vector<SideTable>>(&a)) {
        const auto& others = std::get<std::vector<SideTable>>(b);
        return std::equal(tables->begin(), tables->end(), others.begin(), others.end(),
                          [](const SideTable& x, const SideTable& y) { return same(x.entry, y.entry); });
    }
    return a == b;
}

bool same(const SideEntry& a, const SideEntry& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& x, const auto& y) { return x.first == y.first && same(x.second, y.second); });
}

MergedEntries merge_entries(const std::vector<SideEntry>& base, const std::vector<SideEntry>& here,
                            const std::vector<SideEntry>& other, Alike alike) {
    MergedEntries merged;
    std::vector<std::size_t> new_here, new_there;
    const std::vector<At> in_here = places_of(base, here, new_here), in_other = places_of(base, other, new_there);
    std::vector<At> base_of(here.size());
    for (std::size_t b = 0; b < base.size(); ++b)
        if (in_here[b]) base_of[*in_here[b]] = b;
    const auto conflict = [&](const SideEntry& entry) { merged.conflicts.push_back(text_of(entry, "name")); };

    // `base` may contain equal entries. Suppose both sessions changed one of two equal entries and neither changed the
    // other. Then assume that each session meant a different one: the unchanged twin stands for the entry that the
    // other session changed.
    const auto kept_here = [&](std::size_t b) { return in_here[b] && same(base[b], here[*in_here[b]]); };
    const auto kept_there = [&](std::size_t b) { return in_other[b] && same(base[b], other[*in_other[b]]); };
    std::vector<bool> stands_for_another(base.size(), false), each_its_own(base.size(), false);
    for (std::size_t b = 0; b < base.size(); ++b) {
        if (kept_here(b) || kept_there(b) || (!in_here[b] && !in_other[b])) continue;
        for (std::size_t twin = 0; twin < base.size() && !each_its_own[b]; ++twin)
            if (!stands_for_another[twin] && kept_here(twin) && kept_there(twin) && same(base[b], base[twin]))
                stands_for_another[twin] = each_its_own[b] = true;
    }

    for (std::size_t i = 0; i < here.size(); ++i) {
        const SideEntry& mine = here[i];
        if (!base_of[i]) {  // This session added the entry. The other session may have added an equal one.
            if (alike == Alike::OneThing)
                std::erase_if(new_there, [&, found = false](std::size_t at) mutable {
                    return !found && (found = same(other[at], mine));
                });
            merged.entries.push_back(mine);
            continue;
        }
        if (stands_for_another[*base_of[i]]) {
            merged.differs = true;
            continue;
        }
        const SideEntry& before = base[*base_of[i]];
        const bool changed = !same(before, mine), own = each_its_own[*base_of[i]];
        if (!in_other[*base_of[i]]) {
            if (changed) merged.entries.push_back(mine);
            if (changed && !own) conflict(mine);
            merged.differs |= !changed;
            continue;
        }
        const SideEntry& theirs = other[*in_other[*base_of[i]]];
        if (!changed || (same(mine, theirs) && !own)) {
            merged.differs |= !same(mine, theirs);
            merged.entries.push_back(theirs);
        } else if (same(before, theirs)) {
            merged.entries.push_back(mine);
        } else {
            merged.entries.push_back(mine);
            merged.entries.push_back(theirs);
            merged.differs = true;
            if (!own) conflict(mine);
        }
    }
    for (std::size_t b = 0; b < base.size(); ++b) {
        if (in_here[b] || !in_other[b] || same(base[b], other[*in_other[b]])) continue;
        // This session deleted the entry, and the other session changed it.
        merged.entries.push_back(other[*in_other[b]]);
        merged.differs = true;
        if (!each_its_own[b]) conflict(other[*in_other[b]]);
    }
    std::set<std::string> names;
    for (const std::size_t i : new_here) names.insert(lower_ascii(text_of(here[i], "name")));
    for (const std::size_t i : new_there) {
        const std::string name = text_of(other[i], "name");
        if (!name.empty() && names.contains(lower_ascii(name))) merged.twice.push_back(name);
        merged.entries.push_back(other[i]);
        merged.differs = true;
    }
    return merged;
}

MergedTable merge_table(const SideEntry& base, const SideEntry& here, const SideEntry& other) {
    MergedTable merged;
    std::set<std::string> keys;
    for (const SideEntry* one : {&base, &here, &other})
        for (const auto& [key, value] : *one) keys.insert(key);
    const auto value_in = [](const SideEntry& entry, const std::string& key) {
        const auto found = entry.find(key);
        return found == entry.end() ? nullptr : &found->second;
    };
    const auto alike = [](const SideValue* a, const SideValue* b) { return a && b ? same(*a, *b) : a == b; };
    for (const std::string& key : keys) {
        const SideValue *before = value_in(base, key), *mine = value_in(here, key), *theirs = value_in(other, key);
        const bool changed = !alike(before, mine);
        if (changed && !alike(before, theirs) && !alike(mine, theirs)) merged.conflicts.push_back(key);
        const SideValue* stays = changed ? mine : theirs;
        merged.differs |= !alike(stays, mine);
        if (stays) merged.table.emplace(key, *stays);
    }
    return merged;
}

}  // namespace handrail::core
