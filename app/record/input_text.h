// Everything that reaches a session, and what it tells of, as lines of JSON and back. Pure functions, app thread.
#pragma once

#include <cstdint>
#include <string>

#include "app/core/context/session_event.h"
#include "app/core/session/session_input.h"
#include "worlds/base/result.h"

namespace handrail {

// Times in the session's clock; begun_s is what "t" counts from, in whole milliseconds.
std::string input_line(const SessionInput& input, double now_s, std::uint64_t frame, double begun_s);
// Where a feature has a name in `scene` it stands beside its number; null: none has.
std::string event_line(const SessionEvent& event, const Scene* scene, double begun_s);

// What the settings are where they are not the defaults, as JSON.
std::string settings_text(const Settings& settings);
// Fails with a sentence, naming the key.
Result<Settings> read_settings_text(const std::string& json);

// A world as a recording names it: to be read again by who computes it again.
struct RecordedWorld {
    WorldRequest request;
    std::string checksum;  // of the file's bytes; empty: unknown
    bool has_additions = false;
    std::string additions;  // the text of its side file; empty: there was none
};
struct RecordedInput {
    std::uint64_t frame = 0;  // it came before this one, counted from 0
    double now_s = 0.0;
    SessionInput input;   // a WorldEntered without its world
    RecordedWorld world;  // of a WorldEntered
};
// One line that input_line made. Fails where it is none.
Result<RecordedInput> read_input_line(const std::string& line);
// True where "is" names an input.
bool is_input(const std::string& is);

}  // namespace handrail
