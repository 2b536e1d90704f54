// What two sessions have added to one world, put together: a merge by entry of what both began with, what is here and
// what the other has written since. Nothing that somebody added or changed is lost; where both changed the same, both
// stay, and the caller is told the name. Pure functions over plain values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"

namespace handrail {

struct MergedEntries {
    std::vector<SideEntry> entries;      // those here in their order, then what only the other has
    std::vector<std::string> conflicts;  // names of what both changed, or one changed and the other deleted
    std::vector<std::string> twice;      // names that both gave to something new
    bool differs = false;                // from what is here
};

// What two entries mean that both sessions have added and that are alike.
enum class Alike : std::uint8_t {
    OneThing,  // a door or the name of a room
    TwoThings  // marks: two people may stand at one spot, and their marks have one name until they give them others
};

// Entries have no number of their own: one that is no longer as it was counts as the same one, changed, if it has kept
// its place, its stops or its name. Of alike entries each session has changed its own. Cost: the product of the counts
// of entries that differ from `base`.
MergedEntries merge_entries(const std::vector<SideEntry>& base, const std::vector<SideEntry>& here,
                            const std::vector<SideEntry>& other, Alike alike);

// The same for a table, key by key; where both changed one, what is here stays.
struct MergedTable {
    SideEntry table;
    std::vector<std::string> conflicts;  // keys
    bool differs = false;
};
MergedTable merge_table(const SideEntry& base, const SideEntry& here, const SideEntry& other);

// As files have them: numbers that are not a number are alike.
bool same(const SideValue& a, const SideValue& b);
bool same(const SideEntry& a, const SideEntry& b);

}  // namespace handrail
