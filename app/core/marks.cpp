#include "app/core/marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/core/words.h"
#include "worlds/geometry/closest_point.h"

namespace handrail {
namespace {

constexpr const char* kList = "mark";
constexpr std::size_t kMostTold = 5;

bool reads(const SideEntry& entry) { return good_name(text_of(entry, "name")).has_value() && !numbers_of(entry, "place_m", 3).empty(); }

}  // namespace

bool is_thing(const Feature& feature) {
    switch (feature.kind) {
        case FeatureKind::Object:
        case FeatureKind::Door:
        case FeatureKind::Button:
        case FeatureKind::Lift:
        case FeatureKind::Mover:
        case FeatureKind::Liquid:
            return true;
        default:
            return feature.landmark || feature.clue;
    }
}

std::vector<Mark> read_marks(const SideFile& file, int& unreadable) {
    std::vector<Mark> marks;
    unreadable = 0;
    for (const SideEntry& entry : file.entries(kList)) {
        if (!reads(entry)) {
            ++unreadable;
            continue;
        }
        const std::vector<double> place = numbers_of(entry, "place_m", 3);
        Mark mark{.name = *good_name(text_of(entry, "name")),
                  .place_m = Vec3(place[0], place[1], place[2]),
                  .near = text_of(entry, "near"),
                  .near_m = number_of(entry, "near_m", 0.0),
                  .world = text_of(entry, "world"),
                  .kept = entry};
        for (const char* known : {"name", "place_m", "near", "near_m", "world"}) mark.kept.erase(known);
        marks.push_back(std::move(mark));
    }
    return marks;
}

void write_marks(SideFile& file, const std::vector<Mark>& marks) {
    std::vector<SideEntry> entries;
    for (const Mark& mark : marks) {
        SideEntry entry = mark.kept;
        entry["name"] = mark.name;
        entry["place_m"] = std::vector<double>{mark.place_m.x, mark.place_m.y, mark.place_m.z};
        if (!mark.near.empty()) entry["near"] = mark.near;
        if (!mark.near.empty()) entry["near_m"] = mark.near_m;
        if (!mark.world.empty()) entry["world"] = mark.world;
        entries.push_back(std::move(entry));
    }
    for (const SideEntry& entry : file.entries(kList))
        if (!reads(entry)) entries.push_back(entry);
    file.set_entries(kList, entries);
}

NearThing nearest_thing(const Scene& scene, const Vec3& place_m) {
    NearThing best;
    for (const bool things : {true, false}) {
        best.distance_m = kNearMark_m;
        for (const Feature& feature : scene.features) {
            const bool wanted = things ? is_thing(feature) : feature.kind == FeatureKind::Wall;
            if (!wanted || feature.name.empty() || feature.bounds_m.empty()) continue;
            const double distance_m = std::sqrt(distance_squared(feature.bounds_m, place_m));
            if (distance_m < best.distance_m) best = {feature.name, distance_m};
        }
        if (!best.name.empty()) return best;
    }
    return {};
}

Mark new_mark(const Scene& scene, const SideFile& file, const std::vector<Mark>& marks, const Vec3& place_m) {
    const NearThing near = nearest_thing(scene, place_m);
    const auto taken = [&](const std::string& name) {
        return std::any_of(marks.begin(), marks.end(), [&](const Mark& mark) { return mark.name == name || mark.name.starts_with(name + ","); });
    };
    int number = 1;
    while (taken(fmt::format("Mark {}", number))) ++number;
    std::string name = fmt::format("Mark {}", number);
    // A long name of a thing is left out rather than cut in the middle of a letter.
    if (!near.name.empty() && name.size() + near.name.size() + 7 <= kLongestName_bytes && good_name(near.name)) name += ", near " + near.name;
    return {.name = std::move(name), .place_m = place_m, .near = near.name, .near_m = near.distance_m, .world = file.world_checksum(), .kept = {}};
}

void check_marks(const Scene& scene, const SideFile& file, std::vector<Mark>& marks) {
    for (Mark& mark : marks) {
        mark.fits = true;
        if (mark.world == file.world_checksum() || mark.near.empty()) continue;
        mark.fits = std::any_of(scene.features.begin(), scene.features.end(), [&](const Feature& feature) {
            return feature.name == mark.near && !feature.bounds_m.empty() &&
                   std::abs(std::sqrt(distance_squared(feature.bounds_m, mark.place_m)) - mark.near_m) <= kMarkMoved_m;
        });
    }
}

std::string unfit_sentence(const std::vector<Mark>& marks) {
    std::vector<std::string> names;
    for (const Mark& mark : marks)
        if (!mark.fits) names.push_back(mark.name);
    if (names.empty()) return {};
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), kMostTold); ++i) list += (i == 0 ? "" : "; ") + names[i];
    if (names.size() > kMostTold) list += fmt::format("; and {} more", names.size() - kMostTold);
    return fmt::format("This world has changed since you set marks. {} of {} no longer {}: {}.", names.size(), marks.size(), names.size() == 1 ? "fits" : "fit",
                       list);
}

}  // namespace handrail
