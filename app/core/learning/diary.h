// Stores a diary: which rooms a person visited on which day, for how long, and what they had learnt by then. It is kept
// only with the person's progress (learnt_file.h), so only if the person wants to be remembered, and is deleted with
// it. It is the list `diary` of the side file. Pure functions for the app thread.
#pragma once

#include <string>
#include <vector>

#include "app/core/kept/side_file.h"

namespace handrail::core {

// One room on one day.
struct DiaryEntry {
    std::string day;  // in UTC, such as "2026-12-01"; empty: not known
    std::string room;
    double spent_s = 0.0;
    int walls_percent = 0, floor_percent = 0;  // share of the room that was known at the end of that day
    SideEntry kept = {};                       // keys of the side file that this version does not know
};

// Returns the diary in the order of the file, the oldest day first. Entries that cannot be read stay in the file but
// are not returned.
std::vector<DiaryEntry> read_diary(const SideFile& file);
std::vector<DiaryEntry> diary_in(const std::string& side_file);
void write_diary(SideFile& file, const std::vector<DiaryEntry>& diary);
// Adds a visit to an earlier diary: to the entry of the same room and day, if there is one.
void add_visit(std::vector<DiaryEntry>& diary, const DiaryEntry& visit);

// Returns the lines of a CSV table, without a head: world, day, room, seconds, walls_percent, floor_percent.
std::string diary_csv(const std::string& world, const std::vector<DiaryEntry>& diary);

}  // namespace handrail::core
