// Converts the inputs and events of a session to lines of JSON, and inputs back. Pure functions; app thread.
#pragma once

#include <cstdint>
#include <string>

#include "app/core/context/session_event.h"
#include "app/core/session/session_input.h"
#include "worlds/base/result.h"

namespace handrail::record {

// Returns the line for an input. Times are on the session's clock; "t" is written in whole milliseconds since
// `begun_s`.
std::string input_line(const core::SessionInput& input, double now_s, std::uint64_t frame, double begun_s);
// Returns the line for an event. If a feature has a name in `scene`, the line contains the name next to the feature's
// number. If `scene` is null, the line contains no names.
std::string event_line(const core::SessionEvent& event, const Scene* scene, double begun_s);

// Returns the settings that differ from the defaults, as JSON.
std::string settings_text(const settings::Settings& settings);
// Reads settings written by settings_text. Fails with a sentence that names the key.
Result<settings::Settings> read_settings_text(const std::string& json);

// The data that a recording contains about a world. They suffice to read the world again when the session is computed
// again.
struct RecordedWorld {
    core::WorldRequest request;
    std::string checksum;  // checksum of the bytes of the world's file; empty if unknown
    bool has_additions = false;
    std::string additions;  // text of the side file with the person's additions; empty if there was none
};
struct RecordedInput {
    std::uint64_t frame = 0;  // index of the frame before which the input arrived, counted from 0
    double now_s = 0.0;
    core::SessionInput input;  // the input; in a WorldEntered, the world itself is missing
    RecordedWorld world;       // filled in only for a WorldEntered
};
// Reads one line that input_line wrote. Fails for any other line.
Result<RecordedInput> read_input_line(const std::string& line);
// Returns true if `is`, the field "is" of a line, names an input.
bool is_input(const std::string& is);

}  // namespace handrail::record
