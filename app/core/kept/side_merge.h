// Merges what two sessions have added to a world, entry by entry. The input is the common base of both sessions, the
// content of this session ("here"), and what the other session has written since. No addition or change is lost. If
// both sessions changed the same entry, both versions stay and the caller receives the entry's name. Pure functions
// over plain values.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"

namespace handrail::core {

struct MergedEntries {
    // The entries of this session in their order, then those that only the other session has.
    std::vector<SideEntry> entries;
    // Names of entries that both sessions changed, or that one session changed and the other deleted.
    std::vector<std::string> conflicts;
    std::vector<std::string> twice;  // names that both sessions gave to new entries
    bool differs = false;            // true: the result differs from the content of this session
};

// How to treat equal entries that both sessions have added.
enum class Alike : std::uint8_t {
    OneThing,  // they are the same thing, as for a door or the name of a room
    // They are two things, as for marks. Two people may stand at the same spot, and their marks have the same name
    // until they change it.
    TwoThings
};

// Entries have no identifier, so a changed entry is recognised if it has kept its place, its stops or its name. If
// `base` has two equal entries and each session changed one of them, they are treated as different entries. The cost is
// the product of the numbers of entries that differ from `base`.
MergedEntries merge_entries(const std::vector<SideEntry>& base, const std::vector<SideEntry>& here,
                            const std::vector<SideEntry>& other, Alike alike);

// Merges a table key by key. If both sessions changed a key, the value of this session stays.
struct MergedTable {
    SideEntry table;
    std::vector<std::string> conflicts;  // keys that both sessions changed
    bool differs = false;
};
MergedTable merge_table(const SideEntry& base, const SideEntry& here, const SideEntry& other);

// Return true if the values or entries are equal as in a file, where two NaN values are equal.
bool same(const SideValue& a, const SideValue& b);
bool same(const SideEntry& a, const SideEntry& b);

}  // namespace handrail::core
