// STEP files (ISO 10303-21): the header and an index of numbered instances, made in one pass over the bytes; what
// stands between an instance's brackets is parsed when it is asked for. Takes any bytes, never recurses, and refuses
// what is damaged in one sentence. Immutable after reading; any thread. Source: ISO 10303-21:2016, clauses 5 to 8.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "worlds/base/result.h"

namespace handrail {

// One value of an instance: `$` and `*` are Nothing, a typed value such as IFCLABEL('x') is the value within.
struct StepValue {
    enum class Kind : std::uint8_t { Nothing, Number, Text, Word, Reference, List };
    Kind kind = Kind::Nothing;
    double number = 0.0;           // Number
    std::uint64_t reference = 0;   // Reference
    std::string_view text;         // Text: as between the apostrophes; Word: .T. without its dots
    std::string_view type;         // of a typed value, else empty
    std::vector<StepValue> items;  // List
};

struct StepInstance {
    std::uint64_t id = 0;
    std::string_view
        name;  // upper case as the standard wants it: "IFCWALL"; empty: an instance of several names at once
    std::string_view values;  // between the outer brackets, or all of them where it has several names
    int line = 0;
};

class StepFile {
public:
    static constexpr int kDeepest = 32;  // lists within lists

    // Views point into `bytes`, which must outlive the file. Fails for what is no STEP file, cut short or damaged.
    static Result<StepFile> read(std::string_view bytes, const std::string& file_name,
                                 const std::stop_token& stop = {});

    const std::string& file_name() const { return file_name_; }
    const std::string& schema() const { return schema_; }                      // "IFC2X3", as the header has it
    const std::vector<StepInstance>& instances() const { return instances_; }  // in file order
    const StepInstance* find(std::uint64_t id) const;
    // Of an instance of this file with one name. What is damaged there ends the list.
    std::vector<StepValue> values_of(const StepInstance& instance) const;

private:
    std::string file_name_, schema_;
    std::vector<StepInstance> instances_;
    std::unordered_map<std::uint64_t, std::uint32_t> place_of_;
};

// What a string of the file says, as UTF-8: doubled apostrophes, \\, \S\, \P.\, \X\hh, \X2\...\X0\ and
// \X4\...\X0\ decoded; a byte above 127 that makes no UTF-8 is taken as Latin-1.
std::string decoded(std::string_view raw);

}  // namespace handrail
