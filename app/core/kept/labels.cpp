#include "app/core/kept/labels.h"

#include <algorithm>
#include <array>

#include "worlds/scene/surface_material.h"

namespace handrail::core {
namespace {

constexpr const char* kLabelList = "landmark";
constexpr std::array kKinds{"thing", "landmark", "clue"};

LabelKind kind_named(const std::string& word) {
    const auto found = std::find(kKinds.begin(), kKinds.end(), word);
    return found == kKinds.end() ? LabelKind::Landmark : static_cast<LabelKind>(found - kKinds.begin());
}

// Returns the material with this name, or an empty text if the library has none.
std::string known_material(const std::string& name) {
    const MaterialSpec* spec = find_material(name);
    return spec ? std::string(spec->name) : std::string();
}

Result<Label> label_from(const SideEntry& entry) {
    Result<NamedPlace> named = named_place_of(entry, "landmarks.no_name", "landmarks.no_place");
    if (!named) return tl::unexpected(named.error());
    return Label{std::move(named->name),
                 named->place_m,
                 kind_named(text_of(entry, "kind")),
                 good_name(text_of(entry, "called")).value_or(""),
                 known_material(text_of(entry, "material")),
                 without(entry, {"name", "place_m", "kind", "called", "material"})};
}

SideEntry label_entry(const Label& label) {
    SideEntry entry = label.kept;
    entry["name"] = label.thing;
    put_place(entry, label.at_m);
    if (label.kind != LabelKind::Landmark) entry["kind"] = kind_word(label.kind);
    if (!label.called.empty()) entry["called"] = label.called;
    if (!label.material.empty()) entry["material"] = label.material;
    return entry;
}

std::vector<Label> labels_of(const std::vector<SideEntry>& entries) {
    std::vector<Label> labels;
    for (const SideEntry& entry : entries)
        if (auto label = label_from(entry)) labels.push_back(std::move(*label));
    return labels;
}

bool belongs_to(const Label& label, const Feature& feature) {
    return !feature.bounds_m.empty() && glm::length(feature.bounds_m.centre_m() - label.at_m) <= kLabelMoved_m &&
           (feature.name == label.thing || (!label.called.empty() && feature.name == label.called));
}

// Returns the thing nearest to the place of the label, or kNoFeature.
FeatureId thing_of(const Scene& scene, const Label& label) {
    FeatureId nearest = kNoFeature;
    double least_m = 0.0;
    for (std::uint32_t i = 0; i < scene.features.size(); ++i) {
        if (!belongs_to(label, scene.features[i])) continue;
        const double off_m = glm::length(scene.features[i].bounds_m.centre_m() - label.at_m);
        if (nearest && off_m >= least_m) continue;
        nearest = FeatureId{i};
        least_m = off_m;
    }
    return nearest;
}

bool has(const Scene& scene, const Feature& feature, const Label& label) {
    return kind_of(feature) == label.kind && (label.called.empty() || feature.name == label.called) &&
           (label.material.empty() || scene.material(feature.material).name == label.material);
}

}  // namespace

std::string kind_word(LabelKind kind) { return kKinds.at(static_cast<std::size_t>(kind)); }

LabelKind kind_of(const Feature& feature) {
    return feature.landmark ? LabelKind::Landmark : feature.clue ? LabelKind::Clue : LabelKind::Thing;
}

std::vector<Label> read_labels(const SideFile& file, std::vector<Error>& faults) {
    return read_list(file, kLabelList, label_from, faults);
}

std::vector<Label> kept_labels(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                               bool shipped, const settings::TomlReader& toml) {
    return labels_of(SideFile::peek_entries(world, data_folder, shipped, kLabelList, toml));
}

std::vector<Label> labels_in(const std::string& side_file) {
    return labels_of(SideFile::entries_of_text(side_file, kLabelList));
}

Label label_of(const SideFile& file, const Feature& feature) {
    std::vector<Error> faults;
    for (Label& label : read_labels(file, faults))
        if (belongs_to(label, feature)) return std::move(label);
    return {feature.name, feature.bounds_m.centre_m(), kind_of(feature), {}, {}};
}

void keep_label(SideFile& file, const Label& label) {
    std::vector<Error> faults;
    std::vector<Label> all = read_labels(file, faults);
    const auto same = [&](const Label& other) { return other.thing == label.thing && other.at_m == label.at_m; };
    const auto found = std::find_if(all.begin(), all.end(), same);
    if (found == all.end()) all.push_back(label);
    else *found = label;
    write_list(file, kLabelList, all, label_entry, label_from);
}

void drop_label(SideFile& file, const Label& label) {
    std::vector<Error> faults;
    std::vector<Label> all = read_labels(file, faults);
    std::erase_if(all, [&](const Label& other) { return other.thing == label.thing && other.at_m == label.at_m; });
    write_list(file, kLabelList, all, label_entry, label_from);
}

bool changes(const Scene& scene, const std::vector<Label>& labels) {
    return std::any_of(labels.begin(), labels.end(), [&](const Label& label) {
        const Feature* feature = scene.find(thing_of(scene, label));
        return feature && !has(scene, *feature, label);
    });
}

Scene with_labels(Scene scene, const std::vector<Label>& labels) {
    for (const Label& label : labels) {
        const FeatureId id = thing_of(scene, label);
        if (!id) continue;
        Feature& feature = scene.features[id.value];
        feature.landmark = label.kind == LabelKind::Landmark;
        feature.clue = label.kind == LabelKind::Clue;
        if (!label.called.empty() && feature.name != label.called) {
            feature.name = label.called;
            feature.name_in.clear();
            feature.made_name = false;
        }
        if (!label.material.empty()) give_material(scene, id, *find_material(label.material));
    }
    return scene;
}

}  // namespace handrail::core
