// Converts all inputs and events of a session to lines of JSON and back. Pure functions; app thread.
#pragma once

#include <cstdint>
#include <string>

#include "app/core/context/session_event.h"
#include "app/core/session/session_input.h"
#include "worlds/base/result.h"

namespace handrail::record {

// Times are in the session's clock. "t" is written in whole milliseconds since `begun_s`.
std::string input_line(const core::SessionInput& input, double now_s, std::uint64_t frame, double begun_s);
// If a feature has a name in `scene`, the name is written next to its number. Null: no feature has a name.
std::string event_line(const core::SessionEvent& event, const Scene* scene, double begun_s);

// The settings that differ from the defaults, as JSON.
std::string settings_text(const settings::Settings& settings);
// Fails with a sentence that names the key.
Result<settings::Settings> read_settings_text(const std::string& json);

// A world as a recording names it, so that it can be read again for computing the session again.
struct RecordedWorld {
    core::WorldRequest request;
    std::string checksum;  // of the file's bytes; empty if unknown
    bool has_additions = false;
    std::string additions;  // text of its side file; empty if there was none
};
struct RecordedInput {
    std::uint64_t frame = 0;  // number of the frame that it came before, counted from 0
    double now_s = 0.0;
    core::SessionInput input;  // a WorldEntered lacks its world
    RecordedWorld world;       // only for a WorldEntered
};
// Reads one line written by input_line. Fails if it is anything else.
Result<RecordedInput> read_input_line(const std::string& line);
// Returns true if "is" names an input.
bool is_input(const std::string& is);

}  // namespace handrail::record
