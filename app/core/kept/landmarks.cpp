#include "app/core/kept/landmarks.h"

#include <algorithm>

namespace handrail::core {
namespace {

constexpr const char* kList = "landmark";

Result<LandmarkGiven> landmark_from(const SideEntry& entry) {
    Result<NamedPlace> named = named_place_of(entry, "landmarks.no_name", "landmarks.no_place");
    if (!named) return tl::unexpected(named.error());
    return LandmarkGiven{std::move(named->name), named->place_m, without(entry, {"name", "place_m"})};
}

SideEntry entry_of(const LandmarkGiven& landmark) {
    SideEntry entry = landmark.kept;
    entry["name"] = landmark.name;
    put_place(entry, landmark.at_m);
    return entry;
}

}  // namespace

std::vector<LandmarkGiven> read_landmarks(const SideFile& file, std::vector<Error>& faults) {
    return read_list(file, kList, landmark_from, faults);
}

void keep_landmark(SideFile& file, const Feature& feature) {
    std::vector<Error> faults;
    std::vector<LandmarkGiven> all = read_landmarks(file, faults);
    all.push_back({feature.name, feature.bounds_m.centre_m()});
    write_list(file, kList, all, entry_of, landmark_from);
}

std::shared_ptr<const Scene> with_landmarks(std::shared_ptr<const Scene> scene,
                                            const std::vector<LandmarkGiven>& landmarks) {
    std::vector<std::size_t> marked;
    for (const LandmarkGiven& landmark : landmarks) {
        const auto thing = std::find_if(scene->features.begin(), scene->features.end(), [&](const Feature& feature) {
            return feature.name == landmark.name && !feature.bounds_m.empty() &&
                   glm::length(feature.bounds_m.centre_m() - landmark.at_m) <= kLandmarkMoved_m;
        });
        if (thing != scene->features.end() && !thing->landmark)
            marked.push_back(static_cast<std::size_t>(thing - scene->features.begin()));
    }
    if (marked.empty()) return scene;
    auto changed = std::make_shared<Scene>(*scene);
    for (const std::size_t feature : marked) changed->features[feature].landmark = true;
    return changed;
}

}  // namespace handrail::core
