// The tables of a recording as text. All values are whole numbers. Each row contains the differences from the row
// before; an unchanged column is empty, and empty columns at the end are left out. A row that begins with "=" contains
// the numbers themselves, and each gzip piece begins with one. The first line names the columns. Columns that an older
// recording lacks are 0 in all its rows. Pure functions; any thread.
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
    double now_s = 0.0;                     // in whole microseconds
    std::uint64_t tick = 0, left_tick = 0;  // ToolState::ticks of each hand, as read; 0: no hand
    Vec3 feet_m{0.0};
    double heading_rad = 0.0;
    // The number of the current engine of free bodies (EngineRow::engine), and what was read from it by the end of the
    // tick: the newest frame, and how many events. 0: none.
    std::uint32_t engine = 0;
    std::uint64_t engine_frame = 0, engine_events = 0;
};
// One step of the ears: what it took. Times in whole microseconds of the session's clock.
struct CueRow {
    double now_s = 0.0;
    std::uint32_t contacts = 0, left_contacts = 0;  // taken in this step
    std::uint32_t posts = 0;  // number of items handed over by the app that were taken in this step
    // The answers of SpeechSink::speaking() in binary: a leading 1, then a digit for each answer. 0: all answers equal
    // the last one before.
    std::uint64_t speaking = 0;
};

inline constexpr std::size_t kHandColumns = 24, kFrameColumns = 10, kCueColumns = 5, kEngineColumns = 12;
using HandNumbers = std::array<std::int64_t, kHandColumns>;
using FrameNumbers = std::array<std::int64_t, kFrameColumns>;
using CueNumbers = std::array<std::int64_t, kCueColumns>;
using EngineNumbers = std::array<std::int64_t, kEngineColumns>;

// The names of the columns in order, which is the first line of the file.
std::string_view hand_header();
std::string_view frame_header();
std::string_view cue_header();
std::string_view engine_header();

HandNumbers numbers_of(const servo::HandRow& row);
FrameNumbers numbers_of(const FrameRow& row);
CueNumbers numbers_of(const CueRow& row);
EngineNumbers numbers_of(const dynamics::EngineRow& row);
// Restores exactly what numbers_of was given if that was in whole steps. Heading and feet are rounded to the stored
// precision.
servo::HandRow row_of(const HandNumbers& numbers);
FrameRow row_of(const FrameNumbers& numbers);
CueRow row_of(const CueNumbers& numbers);
dynamics::EngineRow row_of(const EngineNumbers& numbers);

// One line with its line break. `absolute`: begins with "=" and does not depend on `before`.
template <std::size_t N>
std::string row_text(const std::array<std::int64_t, N>& row, const std::array<std::int64_t, N>& before, bool absolute);

// All rows of a table's text up to the first that is invalid. `problem`: why it ends there, with file and line; nothing
// if all was read. A last line without a line break is not a row, and is a problem too.
template <std::size_t N>
struct TableRows {
    std::vector<std::array<std::int64_t, N>> rows;
    std::optional<Error> problem;
};
template <std::size_t N>
TableRows<N> read_rows(std::string_view text, std::string_view header, const std::string& file);

}  // namespace handrail::record
