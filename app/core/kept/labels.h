// Stores the labels that a person has given to things: a name, a kind and a material. The scene then has them instead
// of those in the world's file. They are in the list `landmark` of the side file, because the first labels were
// landmarks; an entry without a `kind` is one. Pure functions over plain values, unless a function says otherwise. Call
// them on the app thread. Any thread may call kept_labels.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/kept/side_file.h"
#include "worlds/scene/scene.h"

namespace handrail::core {

enum class LabelKind : std::uint8_t { Thing, Landmark, Clue };
LabelKind kind_of(const Feature& feature);
// Returns "thing", "landmark" or "clue", as in side files.
std::string kind_word(LabelKind kind);

// A label belongs to the thing with the stored name whose middle has moved by no more than this distance.
inline constexpr double kLabelMoved_m = 0.5;
struct Label {
    std::string thing;  // name of the thing in the world's file
    Vec3 at_m{0.0};     // middle of the thing
    LabelKind kind = LabelKind::Landmark;
    std::string called;    // the name that the person gave; empty: that of the file
    std::string material;  // name in the material library; empty: the material of the file
    SideEntry kept = {};   // keys of the side file that this version does not know
};

// Returns the labels in the order of the file. Entries without a valid name or a place stay in the file but are not
// returned. `faults` receives an error for each of them.
std::vector<Label> read_labels(const SideFile& file, std::vector<Error>& faults);
// Reads the labels of a world from its side file and changes nothing. Any thread may call it. SideFile::peek explains
// the parameters.
std::vector<Label> kept_labels(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                               bool shipped, const settings::TomlReader& toml = settings::toml_of);
// Returns the labels that are in the text of a side file.
std::vector<Label> labels_in(const std::string& side_file);

// Returns the label of this thing, or an empty label for it if it has none.
Label label_of(const SideFile& file, const Feature& feature);
// keep_label() replaces the label of the same thing, or adds it. drop_label() removes it. Both change only the memory,
// and the owner saves `file` later.
void keep_label(SideFile& file, const Label& label);
void drop_label(SideFile& file, const Label& label);

// Returns the scene with these labels. A scene that has them already stays the same. Labels whose things no longer
// exist are ignored.
Scene with_labels(Scene scene, const std::vector<Label>& labels);
// Returns true if with_labels() would change the scene.
bool changes(const Scene& scene, const std::vector<Label>& labels);

}  // namespace handrail::core
