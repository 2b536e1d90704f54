// Every parser of the program as one function over bytes: the rows of one table, which the mutation test and the
// endless fuzzer share. A new reader is a row here and a folder tests/fuzz/inputs/NAME with seeds/ (small good inputs),
// words.dict (what is worth putting in, as libFuzzer writes it) and, once something was found, regressions/ (what
// failed).
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace handrail::fuzz {

struct Harness {
    std::string_view name;
    // What is wrong with how the bytes were taken; empty where they became something whole or were refused in words. A
    // crash, a hang and what the sanitizers see need no telling.
    std::string (*fault)(std::string_view bytes);
    int rounds;  // of the mutation test, for a good second in all
};

std::span<const Harness> harnesses();

// The rows, by what they read.
std::string map_fault(std::string_view bytes);
std::string obj_fault(std::string_view bytes);
std::string gltf_fault(std::string_view bytes);
std::string ply_fault(std::string_view bytes);
std::string stl_fault(std::string_view bytes);
std::string ifc_fault(std::string_view bytes);
std::string osm_fault(std::string_view bytes);
std::string imdf_fault(std::string_view bytes);
std::string rooms_fault(std::string_view bytes);
std::string kept_fault(std::string_view bytes);
std::string picture_fault(std::string_view bytes);
std::string settings_fault(std::string_view bytes);
std::string side_file_fault(std::string_view bytes);
std::string learner_fault(std::string_view bytes);
std::string recording_fault(std::string_view bytes);
std::string scenario_fault(std::string_view bytes);
std::string lesson_fault(std::string_view bytes);
std::string toml_answer_fault(std::string_view bytes);
std::string language_fault(std::string_view bytes);
std::string path_fault(std::string_view bytes);
std::string falcon_fault(std::string_view bytes);
std::string boot_image_fault(std::string_view bytes);
std::string hid_fault(std::string_view bytes);
std::string haply_fault(std::string_view bytes);

// What is wrong with words that a person is to hear: none, a byte that is no text, a character that no voice says.
std::string words_fault(std::string_view words);

}  // namespace handrail::fuzz
