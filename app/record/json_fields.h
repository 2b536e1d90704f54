// Converts between plain values and the fields of lines in events.jsonl. Private to this folder, so that no other
// folder uses JSON for recordings.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "worlds/base/vec.h"

namespace handrail::record {

using Json = nlohmann::ordered_json;

// The words for the values of SpeechClass, in the order of the enumeration.
inline constexpr std::array<const char*, 6> kClassWords = {"alarm",    "warning", "answer",
                                                           "guidance", "contact", "ambient"};

inline Json json_of_vec(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }
// Reads a vector. Throws Json::exception if `json` is not an array of three numbers.
inline Vec3 vec_of(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}
// Reads a whole number. Throws Json::exception unless `json` is a whole number that fits into `Whole`. The library's
// get<int>() converts any number, and the result is undefined if the number does not fit.
template <class Whole>
Whole whole_of(const Json& json) {
    if (json.is_number_unsigned()) {
        if (const auto number = json.get<std::uint64_t>(); std::in_range<Whole>(number))
            return static_cast<Whole>(number);
    } else if (json.is_number_integer()) {
        if (const auto number = json.get<std::int64_t>(); std::in_range<Whole>(number))
            return static_cast<Whole>(number);
    }
    throw Json::out_of_range::create(401, "range", &json);
}
// Returns the JSON as one line, without a line break at the end. Replaces invalid UTF-8.
inline std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace handrail::record
