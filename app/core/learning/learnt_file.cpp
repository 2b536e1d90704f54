#include "app/core/learning/learnt_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "worlds/base/contract.h"
#include "worlds/base/language.h"

namespace handrail::core {
namespace {

constexpr double kStepCell_m = 0.1, kOneFloor_m = 0.4;
constexpr double kPlane_m = 0.02, kHeight_m = 0.25, kFacing_deg = 2.0, kLongest_m = 1.0;
// Each touch is a row of five numbers: the direction that the wall faces in degrees, the distance of its plane from the
// origin, the position along it, the height, and the reach.
constexpr std::size_t kTouchNumbers = 5;
constexpr double kFarthest_m = 1e5;  // no coordinate in a world is larger than this

double rounded(double value, double steps_per_unit) { return std::round(value * steps_per_unit) / steps_per_unit; }
double millimetres(double metres) { return rounded(metres, 1e3); }

// Returns the numbers of `key` if they form rows of `each` numbers, and an empty list if `key` is missing. Returns no
// value if the numbers do not form such rows.
std::optional<std::vector<double>> rows_of(const SideEntry& entry, const char* key, std::size_t each) {
    const auto found = entry.find(key);
    if (found == entry.end()) return std::vector<double>();
    const auto* numbers = std::get_if<std::vector<double>>(&found->second);
    if (!numbers || numbers->size() % each != 0) return std::nullopt;
    for (const double number : *numbers)
        if (!(std::abs(number) < kFarthest_m)) return std::nullopt;
    return *numbers;
}

bool is_time(double seconds) { return seconds >= 0.0 && seconds < 1e9; }

struct WallPlane {
    Vec3 normal, along;
};
WallPlane plane_of(double facing_deg) {
    const double angle = facing_deg * kPi / 180.0;
    const Vec3 normal(std::cos(angle), std::sin(angle), 0.0);
    return {normal, {-normal.y, normal.x, 0.0}};
}

}  // namespace

bool remembers(const SideFile& file) { return !file.entries("learnt").empty(); }

void set_remembers(SideFile& file, bool on) {
    if (on == remembers(file)) return;
    if (on) return file.set_entries("learnt", {{{"name", std::string("all")}}});
    for (const char* list : {"learnt", "learnt_room", "learnt_way", "diary"})
        if (!file.entries(list).empty()) file.set_entries(list, {});
}

Result<KeptLearning> read_learnt(const SideFile& file) {
    KeptLearning kept;
    for (const char* list : {"learnt", "learnt_room"})
        if (const auto fault = file.fault_of_list(list)) return tl::unexpected(*fault);
    const std::vector<SideEntry> all = file.entries("learnt"), rooms = file.entries("learnt_room");
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto steps = rows_of(all[i], "steps_m", 3), touches = rows_of(all[i], "touches", kTouchNumbers);
        const double sessions = number_of(all[i], "sessions", 0.0), spent_s = number_of(all[i], "spent_s", 0.0);
        if (!steps || !touches || !(sessions >= 0.0 && sessions < 1e6) || !is_time(spent_s))
            return tl::unexpected(file.fault_in("learnt", i, phrase("learning.no_memory")));
        kept.sessions += static_cast<int>(sessions);
        kept.spent_s += spent_s;
        for (std::size_t at = 0; at < steps->size(); at += 3)
            kept.steps_m.emplace_back((*steps)[at], (*steps)[at + 1], (*steps)[at + 2]);
        for (std::size_t at = 0; at < touches->size(); at += kTouchNumbers) {
            const WallPlane plane = plane_of((*touches)[at]);
            Vec3 point = plane.normal * (*touches)[at + 1] + plane.along * (*touches)[at + 2];
            point.z = (*touches)[at + 3];
            kept.touches.push_back({point, plane.normal, std::abs((*touches)[at + 4])});
        }
    }
    for (std::size_t i = 0; i < rooms.size(); ++i) {
        KeptRoom room{text_of(rooms[i], "name"), number_of(rooms[i], "spent_s", 0.0), place_of(rooms[i]), false, 0};
        const double lanes = number_of(rooms[i], "lanes", 0.0);
        if (room.name.empty() || !is_time(room.spent_s) || !(lanes >= 0.0 && lanes < 1e6))
            return tl::unexpected(file.fault_in("learnt_room", i, phrase("learning.no_memory")));
        room.lanes_announced = static_cast<int>(lanes);
        const auto walls = rooms[i].find("walls_done");
        if (const bool* done = walls == rooms[i].end() ? nullptr : std::get_if<bool>(&walls->second))
            room.walls_done = *done;
        kept.rooms.push_back(std::move(room));
    }
    return kept;
}

void write_learnt(SideFile& file, const KeptLearning& kept) {
    std::vector<SideEntry> all = file.entries("learnt");
    contract_pre(!all.empty());
    SideEntry& entry = all.front();
    std::vector<double> steps, touches;
    for (const Vec3& step : kept.steps_m)
        for (const double number : {step.x, step.y, step.z}) steps.push_back(millimetres(number));
    for (const TouchNote& note : kept.touches) {
        const double facing_deg = rounded(std::atan2(note.normal.y, note.normal.x) * 180.0 / kPi, 1.0);
        const WallPlane plane = plane_of(facing_deg);
        for (const double number :
             {facing_deg, millimetres(glm::dot(plane.normal, note.point_m)),
              millimetres(glm::dot(plane.along, note.point_m)), millimetres(note.point_m.z), millimetres(note.reach_m)})
            touches.push_back(number);
    }
    entry["sessions"] = static_cast<std::int64_t>(kept.sessions);
    entry["spent_s"] = rounded(kept.spent_s, 10.0);
    for (auto& [key, numbers] : {std::pair{"steps_m", &steps}, std::pair{"touches", &touches}})
        // Remove the empty list, because TOML does not show that it is a list of numbers.
        if (numbers->empty()) entry.erase(key);
        else entry[key] = std::move(*numbers);
    // Two sessions that ran at the same time may have made two entries. The first entry now contains both, so the other
    // one is removed.
    all.resize(1);
    file.set_entries("learnt", all);
    std::vector<SideEntry> rooms = file.entries("learnt_room");
    for (const KeptRoom& room : kept.rooms) {
        auto own = std::find_if(rooms.begin(), rooms.end(),
                                [&](const SideEntry& one) { return text_of(one, "name") == room.name; });
        if (own == rooms.end()) own = rooms.insert(own, SideEntry{{"name", room.name}});
        (*own)["spent_s"] = rounded(room.spent_s, 10.0);
        (*own)["walls_done"] = room.walls_done;
        (*own)["lanes"] = static_cast<std::int64_t>(room.lanes_announced);
        if (room.base_m) put_place(*own, *room.base_m);
    }
    file.set_entries("learnt_room", rooms);
}

void thin_out(const LearningNotes& notes, KeptLearning& kept) {
    kept.steps_m.clear();
    kept.touches.clear();
    std::set<std::tuple<long, long, long>> cells;
    for (const Vec3& step : notes.steps_m()) {
        const auto x = std::lround(std::floor(step.x / kStepCell_m + 1e-6)),
                   y = std::lround(std::floor(step.y / kStepCell_m + 1e-6));
        if (!cells.emplace(x, y, std::lround(step.z / kOneFloor_m)).second) continue;
        kept.steps_m.emplace_back((static_cast<double>(x) + 0.5) * kStepCell_m,
                                  (static_cast<double>(y) + 0.5) * kStepCell_m, millimetres(step.z));
    }
    // Stretches along each wall, grouped by the plane of the wall and by height.
    std::map<std::array<long, 3>, std::vector<std::pair<double, double>>> stretches;
    for (const TouchNote& note : notes.touches()) {
        const long facing = std::lround(std::atan2(note.normal.y, note.normal.x) * 180.0 / kPi / kFacing_deg);
        const WallPlane plane = plane_of(static_cast<double>(facing) * kFacing_deg);
        const double along = glm::dot(plane.along, note.point_m);
        stretches[{facing, std::lround(glm::dot(plane.normal, note.point_m) / kPlane_m),
                   std::lround(note.point_m.z / kHeight_m)}]
            .emplace_back(along - note.reach_m, along + note.reach_m);
    }
    for (auto& stretch : stretches) {
        const auto& key = stretch.first;
        auto& all = stretch.second;
        const WallPlane plane = plane_of(static_cast<double>(key[0]) * kFacing_deg);
        const auto keep = [&](double from, double to) {
            const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / kLongest_m - 1e-3)));
            for (int i = 0; i < pieces; ++i) {
                const double half = 0.5 * (to - from) / pieces;
                Vec3 point =
                    plane.normal * (static_cast<double>(key[1]) * kPlane_m) + plane.along * (from + (2 * i + 1) * half);
                point.z = static_cast<double>(key[2]) * kHeight_m;
                kept.touches.push_back({point, plane.normal, half});
            }
        };
        std::sort(all.begin(), all.end());
        double from = all.front().first, to = all.front().second;
        for (const auto& [begin, end] : all) {
            if (begin > to + 1e-3) {
                keep(from, to);
                from = begin;
            }
            to = begin > to + 1e-3 ? end : std::max(to, end);
        }
        keep(from, to);
    }
}

}  // namespace handrail::core
