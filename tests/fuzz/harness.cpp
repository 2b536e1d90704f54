#include "tests/fuzz/harness.h"

#include "worlds/base/text.h"

namespace handrail::fuzz {
namespace {

constexpr Harness kHarnesses[] = {
    {"map", map_fault, 4000},
    {"obj", obj_fault, 8000},
    {"gltf", gltf_fault, 4000},
    {"ply", ply_fault, 8000},
    {"stl", stl_fault, 8000},
    {"ifc", ifc_fault, 2000},
    {"osm", osm_fault, 800},
    {"imdf", imdf_fault, 2000},
    {"rooms", rooms_fault, 1500},
    {"kept", kept_fault, 2000},
    {"picture", picture_fault, 4000},
    {"settings", settings_fault, 600},
    {"side_file", side_file_fault, 400},
    {"learner", learner_fault, 2000},
    {"recording", recording_fault, 2000},
    {"scenario", scenario_fault, 2000},
    {"lesson", lesson_fault, 2000},
    {"toml_answer", toml_answer_fault, 8000},
    {"language", language_fault, 600},
    {"path", path_fault, 8000},
    {"falcon", falcon_fault, 8000},
    {"boot_image", boot_image_fault, 8000},
    {"hid", hid_fault, 8000},
    {"haply", haply_fault, 8000},
};

}  // namespace

std::span<const Harness> harnesses() { return kHarnesses; }

std::string words_fault(std::string_view words) {
    if (words.empty()) return "nothing is said";
    if (!is_utf8(words)) return "what is said is no UTF-8";
    for (const char c : words)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            return "what is said holds a control character: " + std::string(words);
    return {};
}

}  // namespace handrail::fuzz
