// Reads and writes the tables of a recording as text. All values are whole numbers. A row contains the differences from
// the row before. An unchanged column is empty, and empty columns at the end are left out. A row that begins with "="
// contains the numbers themselves; each gzip piece begins with such a row. The first line names the columns. If an
// older recording lacks a column, its value is 0 in all rows. Pure functions; any thread.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "haptic/dynamics/engine_recording.h"
#include "haptic/servo/hand_recording.h"
#include "worlds/base/result.h"

namespace handrail::record {

// One tick of the session.
struct FrameRow {
    double now_s = 0.0;                     // time in whole microseconds
    std::uint64_t tick = 0, left_tick = 0;  // ToolState::ticks of each hand, as the session read it; 0: no hand
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
    std::uint32_t engine = 0;  // number of the current engine of free bodies (EngineRow::engine); 0: none
    // The number of the newest frame, and how many events, the session had read from the engine by the end of the tick.
    std::uint64_t engine_frame = 0, engine_events = 0;
};
// One step of the ears, with how many items it read. Times are in whole microseconds of the session's clock.
struct CueRow {
    double now_s = 0.0;
    std::uint32_t contacts = 0, left_contacts = 0;  // how many contacts of each hand this step read
    std::uint32_t posts = 0;                        // how many items from the app this step read
    // The answers of SpeechSink::speaking() in binary: a leading 1, then a digit for each answer. 0: all answers equal
    // the last answer of an earlier step.
    std::uint64_t speaking = 0;
};

inline constexpr std::size_t kHandColumns = 24, kFrameColumns = 10, kCueColumns = 5, kEngineColumns = 12;
using HandNumbers = std::array<std::int64_t, kHandColumns>;
using FrameNumbers = std::array<std::int64_t, kFrameColumns>;
using CueNumbers = std::array<std::int64_t, kCueColumns>;
using EngineNumbers = std::array<std::int64_t, kEngineColumns>;

// These functions return the names of the columns in order, which are the first line of the file.
std::string_view hand_header();
std::string_view frame_header();
std::string_view cue_header();
std::string_view engine_header();

HandNumbers numbers_of(const servo::HandRow& row);
FrameNumbers numbers_of(const FrameRow& row);
CueNumbers numbers_of(const CueRow& row);
EngineNumbers numbers_of(const dynamics::EngineRow& row);
// Returns the values that were given to numbers_of. They are exact if they were multiples of the stored steps. Heading
// and feet are rounded to the stored precision.
servo::HandRow row_of(const HandNumbers& numbers);
FrameRow row_of(const FrameNumbers& numbers);
CueRow row_of(const CueNumbers& numbers);
dynamics::EngineRow row_of(const EngineNumbers& numbers);

// Returns a row as one line with its line break. `absolute`: the line begins with "=" and does not depend on `before`.
template <std::size_t N>
std::string row_text(const std::array<std::int64_t, N>& row, const std::array<std::int64_t, N>& before, bool absolute);

// The rows of a table up to the first invalid one. `problem` says why the rows end there, with file and line; nothing
// if all rows were read. A last line without a line break is not a row, and is reported as a problem.
template <std::size_t N>
struct TableRows {
    std::vector<std::array<std::int64_t, N>> rows;
    std::optional<Error> problem;
};
template <std::size_t N>
TableRows<N> read_rows(std::string_view text, std::string_view header, const std::string& file);

}  // namespace handrail::record
