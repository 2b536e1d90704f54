// A recording as it is read back: as much of it as is whole, whatever ended it. Any thread.
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

namespace handrail {

// One line of events.jsonl; what it says more stands in `json`. Words that nobody here knows come along.
struct RecordedLine {
    double t_s = 0.0;  // since the recording began
    std::string is;
    std::string json;
    int line = 0;
};

struct Recording {
    RecordingHead head;
    std::vector<RecordedLine> lines;  // without the head
    std::vector<HandRow> hands[2];
    std::vector<FrameRow> frames;
    std::vector<CueRow> cues;
    std::vector<EngineRow> bodies;  // of the engine of what is free to move
    bool ended = false;             // it holds its last line
    std::vector<Error> problems;    // one a file that is cut off or damaged: where, and why
};

// Fails with a sentence where the folder is none of a recording or its head cannot be understood. Everything behind
// that is read up to its first damage.
Result<Recording> read_recording(const std::filesystem::path& folder);
// events.jsonl alone, from its text; `file` is what sentences call it.
Result<Recording> read_events(std::string_view text, const std::string& file);

// What "said" lines said, in order.
struct SaidLine {
    double t_s = 0.0;
    std::string text, speech_class;
    bool voiced = false;
};
std::vector<SaidLine> said_lines(const Recording& recording);

}  // namespace handrail
