// Reads everything that is intact in a recording, however the recording ended. Any thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/record/recorder.h"
#include "app/record/rows.h"
#include "worlds/base/result.h"

namespace handrail::record {

// One line of events.jsonl. `json` is the whole line, so it also contains the fields that have no member here.
struct RecordedLine {
    double t_s = 0.0;  // time since the recording began
    std::string is;
    std::string json;
    int line = 0;
};

struct Recording {
    RecordingHead head;
    std::vector<RecordedLine> lines;  // all lines except the first one, which is the head
    std::vector<servo::HandRow> hands[2];
    std::vector<FrameRow> frames;
    std::vector<CueRow> cues;
    std::vector<dynamics::EngineRow> bodies;  // steps of the engine of free bodies
    bool ended = false;                       // true if the last line of a properly ended recording is present
    std::vector<Error> problems;  // where and why a file is cut off or damaged; one entry for each such file
};

// Reads a recording up to the first damage in each file. Fails with a sentence if the folder is not a recording, or if
// its head is invalid.
Result<Recording> read_recording(const std::filesystem::path& folder);
// Reads a recording from the text of events.jsonl alone; `file` is its name in error messages.
Result<Recording> read_events(std::string_view text, const std::string& file);

// A line that was said.
struct SaidLine {
    double t_s = 0.0;
    std::string text, speech_class;
    bool voiced = false;
};
std::vector<SaidLine> said_lines(const Recording& recording);

}  // namespace handrail::record
