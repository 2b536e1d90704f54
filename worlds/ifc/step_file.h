// Reads STEP files (ISO 10303-21): the header, and an index of numbered instances made in one pass over the bytes. An
// instance's values are parsed only when they are requested. The reader accepts any bytes, never recurses, and rejects
// damaged files with one sentence. Immutable after reading, so any thread may use it. Source: ISO 10303-21:2016,
// clauses 5 to 8.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::ifc {

// One value of an instance. `$` and `*` are Nothing. A typed value such as IFCLABEL('x') is the value inside.
struct StepValue {
    enum class Kind : std::uint8_t { Nothing, Number, Text, Word, Reference, List };
    Kind kind = Kind::Nothing;
    double number = 0.0;           // for Number
    std::uint64_t reference = 0;   // for Reference
    std::string_view text;         // Text: raw, as between the apostrophes; Word: .T. without its dots
    std::string_view type;         // name of a typed value, else empty
    std::vector<StepValue> items;  // for List
};

struct StepInstance {
    std::uint64_t id = 0;
    std::string_view name;    // upper case as the standard requires, "IFCWALL"; empty if the instance has several names
    std::string_view values;  // between the outer brackets; the whole record if there are several names
    int line = 0;
};

class StepFile {
public:
    static constexpr int kDeepest = 32;  // depth of nested lists

    // Views point into `bytes`, which must outlive the file. Fails if the file is not STEP, is cut short or is damaged.
    static Result<StepFile> read(std::string_view bytes, const std::string& file_name,
                                 const std::stop_token& stop = {});

    const std::string& file_name() const { return file_name_; }
    const std::string& schema() const { return schema_; }                      // as in the header, such as "IFC2X3"
    const std::vector<StepInstance>& instances() const { return instances_; }  // in file order
    const StepInstance* find(std::uint64_t id) const;
    // The values of an instance of this file with one name. The list ends at the first damaged value.
    std::vector<StepValue> values_of(const StepInstance& instance) const;

private:
    std::string file_name_, schema_;
    std::vector<StepInstance> instances_;
    std::unordered_map<std::uint64_t, std::uint32_t> place_of_;
};

// Decodes a string of the file as UTF-8: doubled apostrophes, doubled backslashes, \S\, \P.\, \X\hh, \X2\...\X0\ and
// \X4\...\X0\. A byte above 127 that is not UTF-8 is read as Latin-1.
std::string decoded(std::string_view raw);

}  // namespace handrail::ifc
