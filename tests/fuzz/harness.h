// Makes every parser of the program a function that takes bytes. The parsers are the rows of one table, which the
// mutation test and the endless fuzzer share. A new reader needs a row here and a folder tests/fuzz/inputs/NAME with:
// - seeds/: small valid inputs
// - words.dict: strings worth inserting, in libFuzzer's format
// - regressions/: inputs that once failed, if there are any
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace handrail::fuzz {

struct Harness {
    std::string_view name;
    // Parses the bytes and describes what is wrong with the result. Returns an empty string if the result is complete,
    // or if the parser refused the bytes with a message. Crashes, hangs and findings of the sanitizers end the process
    // and need no description.
    std::string (*fault)(std::string_view bytes);
    int rounds;  // rounds of the mutation test; all parsers together take a good second
};

std::span<const Harness> harnesses();

// Functions of the table's rows. Each is named after the format that it reads.
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

// Describes what is wrong with `words`, a text that the program announces: it is empty, or contains a byte that is not
// text or a character that no voice speaks. Returns an empty string if nothing is wrong.
std::string words_fault(std::string_view words);

}  // namespace handrail::fuzz
