// Converts between the fields in a line of events.jsonl and plain values. Private to this folder, so that JSON stays
// inside it.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "worlds/base/vec.h"

namespace handrail::record {

using Json = nlohmann::ordered_json;

// Of SpeechClass, in its order.
inline constexpr std::array<const char*, 6> kClassWords = {"alarm",    "warning", "answer",
                                                           "guidance", "contact", "ambient"};

inline Json json_of_vec(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }
// Throws Json::exception if it is not an array of three numbers.
inline Vec3 vec_of(const Json& json) {
    return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}
// Throws Json::exception unless it is a whole number that fits. The library's get<int>() converts any number, and
// converting one that does not fit is undefined.
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
// One line without its line break; invalid UTF-8 is replaced.
inline std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace handrail::record
