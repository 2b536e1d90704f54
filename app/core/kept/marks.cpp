#include "app/core/kept/marks.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "worlds/base/language.h"
#include "worlds/geometry/closest_point.h"
#include "worlds/scene/outer_ground.h"

namespace handrail::core {
namespace {

constexpr const char* kMarkTable = "mark";

Result<Mark> mark_from(const SideEntry& entry) {
    return named_place_of(entry, "marks.entry_name", "marks.entry_place").map([&](NamedPlace named) {
        return Mark{.name = std::move(named.name),
                    .place_m = named.place_m,
                    .near = text_of(entry, "near"),
                    .near_m = number_of(entry, "near_m", 0.0),
                    .world = text_of(entry, "world"),
                    .kept = without(entry, {"name", "place_m", "near", "near_m", "world"})};
    });
}

SideEntry mark_entry(const Mark& mark) {
    SideEntry entry = mark.kept;
    entry["name"] = mark.name;
    put_place(entry, mark.place_m);
    if (!mark.near.empty()) entry["near"] = mark.near;
    if (!mark.near.empty()) entry["near_m"] = mark.near_m;
    if (!mark.world.empty()) entry["world"] = mark.world;
    return entry;
}

// Returns the spoken name of the thing with the stored name.
std::string spoken_thing(const Scene& scene, const std::string& stored) {
    const auto feature =
        std::find_if(scene.features.begin(), scene.features.end(), [&](const Feature& f) { return f.name == stored; });
    return feature == scene.features.end() ? std::string() : spoken_name(*feature);
}

// Returns true for "Mark 3" and "Mark 3, near radiator", but not for "Mark 30", if `mark` is "Mark 3".
bool is_called(std::string_view name, std::string_view mark) {
    return name.starts_with(mark) &&
           (name.size() == mark.size() || !std::isalnum(static_cast<unsigned char>(name[mark.size()])));
}

}  // namespace

bool is_thing(const Feature& feature) {
    if (is_outer_ground(feature)) return false;
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

std::vector<Mark> read_marks(const SideFile& file, std::vector<Error>& faults) {
    return read_list(file, kMarkTable, mark_from, faults);
}

void write_marks(SideFile& file, const std::vector<Mark>& marks) {
    write_list(file, kMarkTable, marks, mark_entry, mark_from);
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
        return std::any_of(marks.begin(), marks.end(), [&](const Mark& mark) { return is_called(mark.name, name); });
    };
    std::string name;
    std::size_t number = 1;
    // n marks take at most n numbers, so the bound is never too small. Without the bound, the loop would never end if
    // the language's text has no place for the number.
    do name = phrase("marks.name", {{"number", number}});
    while (taken(name) && ++number <= marks.size() + 1);
    const std::string thing = spoken_thing(scene, near.name),
                      whole = phrase("marks.name_near", {{"mark", name}, {"thing", thing}});
    // If the name would be too long, the name of the thing is omitted. Cutting the whole name could split a character.
    if (whole.size() <= kLongestName_bytes && good_name(thing)) name = whole;
    return {.name = std::move(name),
            .place_m = place_m,
            .near = near.name,
            .near_m = near.distance_m,
            .world = file.world_checksum(),
            .kept = {}};
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
    std::vector<std::string> unfit;
    for (const Mark& mark : marks)
        if (!mark.fits) unfit.push_back(mark.name);
    return unfit_words("marks.unfit", unfit, marks.size());
}

}  // namespace handrail::core
