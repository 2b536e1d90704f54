#include "app/core/learning/diary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr const char* kDiaryList = "diary";
constexpr double kLongest_s = 1e7;

int percent_of(const SideEntry& entry, const char* key) {
    return static_cast<int>(std::clamp(number_of(entry, key, 0.0), 0.0, 100.0));
}

Result<DiaryEntry> visit_from(const SideEntry& entry) {
    const auto room = good_name(text_of(entry, "room"));
    const double spent_s = number_of(entry, "spent_s", -1.0);
    if (!room || spent_s < 0.0 || spent_s > kLongest_s) return fail(phrase("diary.no_entry"));
    return DiaryEntry{text_of(entry, "day"),
                      *room,
                      spent_s,
                      percent_of(entry, "walls_percent"),
                      percent_of(entry, "floor_percent"),
                      without(entry, {"name", "day", "room", "spent_s", "walls_percent", "floor_percent"})};
}

SideEntry visit_entry(const DiaryEntry& visit) {
    SideEntry entry = visit.kept;
    // Two sessions recognise the same entry by its name.
    entry["name"] = visit.day + " " + visit.room;
    entry["day"] = visit.day;
    entry["room"] = visit.room;
    entry["spent_s"] = std::round(visit.spent_s);
    entry["walls_percent"] = std::int64_t{visit.walls_percent};
    entry["floor_percent"] = std::int64_t{visit.floor_percent};
    return entry;
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

}  // namespace

std::vector<DiaryEntry> read_diary(const SideFile& file) {
    std::vector<Error> faults;
    return read_list(file, kDiaryList, visit_from, faults);
}

std::vector<DiaryEntry> diary_in(const std::string& side_file) {
    std::vector<DiaryEntry> diary;
    for (const SideEntry& entry : SideFile::entries_of_text(side_file, kDiaryList))
        if (auto visit = visit_from(entry)) diary.push_back(std::move(*visit));
    return diary;
}

void write_diary(SideFile& file, const std::vector<DiaryEntry>& diary) {
    write_list(file, kDiaryList, diary, visit_entry, visit_from);
}

void add_visit(std::vector<DiaryEntry>& diary, const DiaryEntry& visit) {
    const auto same = std::find_if(diary.begin(), diary.end(), [&](const DiaryEntry& other) {
        return other.day == visit.day && other.room == visit.room;
    });
    if (same == diary.end()) return diary.push_back(visit);
    same->spent_s += visit.spent_s;
    same->walls_percent = visit.walls_percent;
    same->floor_percent = visit.floor_percent;
}

std::string diary_csv(const std::string& world, const std::vector<DiaryEntry>& diary) {
    std::string out;
    for (const DiaryEntry& visit : diary)
        out += fmt::format("{},{},{},{:.0f},{},{}\r\n", quoted(world), visit.day, quoted(visit.room), visit.spent_s,
                           visit.walls_percent, visit.floor_percent);
    return out;
}

}  // namespace handrail::core
