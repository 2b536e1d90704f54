// Merges what two sessions have added to one world, entry by entry: their common base, the content here, and what the
// other session has written since. No addition or change is lost. If both changed the same entry, both versions stay
// and the caller gets its name. Pure functions over plain values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"

namespace handrail::core {

struct MergedEntries {
    std::vector<SideEntry> entries;  // those here in their order, then those that only the other session has
    // Names of entries that both changed, or that one changed and the other deleted.
    std::vector<std::string> conflicts;
    std::vector<std::string> twice;  // names that both sessions gave to new entries
    bool differs = false;            // from the content here
};

// What two equal entries mean that both sessions have added.
enum class Alike : std::uint8_t {
    OneThing,  // a door or the name of a room
    // Marks: two people may stand at one spot, and their marks have the same name until they change it.
    TwoThings
};

// Entries have no identifier. A changed entry counts as the same one if it has kept its place, its stops or its name.
// If `base` has equal entries and each session changed one, they count as different ones. Cost: the product of the
// numbers of entries that differ from `base`.
MergedEntries merge_entries(const std::vector<SideEntry>& base, const std::vector<SideEntry>& here,
                            const std::vector<SideEntry>& other, Alike alike);

// Merges a table key by key. If both sessions changed a key, the value here stays.
struct MergedTable {
    SideEntry table;
    std::vector<std::string> conflicts;  // keys
    bool differs = false;
};
MergedTable merge_table(const SideEntry& base, const SideEntry& here, const SideEntry& other);

// Equality as in files: two NaN values are equal.
bool same(const SideValue& a, const SideValue& b);
bool same(const SideEntry& a, const SideEntry& b);

}  // namespace handrail::core
