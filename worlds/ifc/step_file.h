// Reads STEP files (ISO 10303-21): the header, and an index of the numbered instances. It makes the index in one pass
// over the bytes. The values of an instance are parsed only when they are requested. The reader accepts any bytes,
// never recurses, and rejects damaged files with one sentence. A StepFile never changes after reading, so any thread
// may use it. Source: ISO 10303-21:2016, clauses 5 to 8.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::ifc {

// One value of an instance. `$` and `*` become Nothing. A typed value such as IFCLABEL('x') becomes the value within
// it.
struct StepValue {
    enum class Kind : std::uint8_t { Nothing, Number, Text, Word, Reference, List };
    Kind kind = Kind::Nothing;
    double number = 0.0;          // the value if kind is Number
    std::uint64_t reference = 0;  // the number of the instance if kind is Reference
    // For Text: the raw text between the apostrophes. For Word: the word of .T. without its dots.
    std::string_view text;
    std::string_view type;         // type name of a typed value; else empty
    std::vector<StepValue> items;  // the values if kind is List
};

struct StepInstance {
    std::uint64_t id = 0;
    // Class in upper case, as the standard requires: "IFCWALL"; empty if the instance has several names.
    std::string_view name;
    std::string_view values;  // the text between the outer brackets; the whole record if the instance has several names
    int line = 0;
};

class StepFile {
public:
    static constexpr int kDeepest = 32;  // greatest depth of nested lists

    // Reads a file. The views in the StepFile point into `bytes`, so `bytes` must outlive the StepFile. Fails if the
    // file is not STEP, is cut short or is damaged.
    static Result<StepFile> read(std::string_view bytes, const std::string& file_name,
                                 const std::stop_token& stop = {});

    const std::string& file_name() const { return file_name_; }
    const std::string& schema() const { return schema_; }  // version of IFC, as the header states it: "IFC2X3"
    const std::vector<StepInstance>& instances() const { return instances_; }  // returns all instances in file order
    const StepInstance* find(std::uint64_t id) const;
    // Returns the values of an instance that has one name. The list ends at the first damaged value.
    std::vector<StepValue> values_of(const StepInstance& instance) const;

private:
    std::string file_name_, schema_;
    std::vector<StepInstance> instances_;
    std::unordered_map<std::uint64_t, std::uint32_t> place_of_;
};

// Decodes a string of the file to UTF-8, including doubled apostrophes, doubled backslashes, \S\, \P.\, \X\hh,
// \X2\...\X0\ and \X4\...\X0\. A byte above 127 that is not UTF-8 is read as Latin-1.
std::string decoded(std::string_view raw);

}  // namespace handrail::ifc
