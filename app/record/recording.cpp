#include "app/record/recording.h"

#include <cmath>

#include "app/record/gzip_pieces.h"
#include "app/record/input_text.h"
#include "app/record/json_fields.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"

namespace handrail::record {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = std::size_t{512} << 20;  // greatest size of one file after unpacking
constexpr double kLongest_s = 1e7;                          // longest accepted time in a line, about a hundred days

Result<RecordingHead> read_head(const std::string& line) {
    const Json json = Json::parse(line, nullptr, false);
    if (!json.is_object() || json.value("is", Json()) != "recording") return fail(phrase("recording.no_head"));
    try {
        RecordingHead head;
        head.form = whole_of<int>(json.at("form"));
        if (head.form > RecordingHead::kForm)
            return fail(phrase("recording.newer", {{"form", head.form}, {"known", RecordingHead::kForm}}));
        head.program = json.at("program").get<std::string>();
        head.language = json.at("language").get<std::string>();
        head.begun_utc = json.at("begun_utc").get<std::string>();
        head.begun_s = json.at("begun_s").get<double>();
        head.virtual_time = json.at("virtual_time").get<bool>();
        auto settings = read_settings_text(json.at("settings").dump());
        if (!settings) return tl::unexpected(settings.error());
        head.settings = std::move(*settings);
        return head;
    } catch (const Json::exception&) {
        return fail(phrase("recording.no_head"));
    }
}

bool read_line(const std::string& text, RecordedLine& line) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) return false;
    const auto is = json.find("is");
    if (is == json.end() || !is->is_string()) return false;
    line.is = is->get<std::string>();
    const auto t = json.find("t");
    if (t != json.end() && (!t->is_number() || !(std::abs(t->get<double>()) < kLongest_s * 1e3))) return false;
    line.t_s = t == json.end() ? -1.0 : t->get<double>() * 1e-3;
    line.json = text;
    return true;
}

// Reads one table of the folder. If the file does not exist, returns no rows and no problem, because a session without
// a hand has no such table.
template <std::size_t N, class Row>
void read_table(const fs::path& file, std::string_view header, std::vector<Row>& rows, std::vector<Error>& problems) {
    std::error_code ec;
    if (!fs::exists(file, ec)) return;
    const std::string name = file.filename().string();
    const auto bytes = read_whole_file(file);
    if (!bytes) {
        problems.push_back(bytes.error());
        return;
    }
    const GzipText unpacked = gunzip_pieces(*bytes, kMostBytes);
    TableRows<N> table = read_rows<N>(unpacked.text, header, name);
    rows.reserve(table.rows.size());
    for (const auto& numbers : table.rows) rows.push_back(row_of(numbers));
    // If the end of the file is cut off, report only that, because it also explains an incomplete last line.
    if (!unpacked.whole || unpacked.huge)
        problems.push_back({name, static_cast<int>(table.rows.size()) + 2, 0,
                            phrase(unpacked.huge ? "recording.huge" : "recording.cut_file")});
    else if (table.problem) problems.push_back(std::move(*table.problem));
}

}  // namespace

Result<Recording> read_events(std::string_view text, const std::string& file) {
    Recording recording;
    double last_s = 0.0;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = text.find('\n');
        const std::string one(text.substr(0, end));
        if (number == 1) {
            auto head = end == std::string_view::npos ? fail(phrase("recording.no_head")) : read_head(one);
            if (!head) return fail(head.error().message, file, 1);
            recording.head = std::move(*head);
        } else if (RecordedLine line; end != std::string_view::npos && read_line(one, line)) {
            if (line.t_s < 0.0) line.t_s = last_s;
            last_s = line.t_s;
            line.line = number;
            recording.ended = recording.ended || line.is == "end";
            recording.lines.push_back(std::move(line));
        } else {
            recording.problems.push_back(
                {file, number, 0, phrase(end == std::string_view::npos ? "recording.cut_line" : "recording.no_line")});
            return recording;
        }
        text.remove_prefix(end + 1);
    }
    if (recording.head.program.empty()) return fail(phrase("recording.no_head"), file, 1);
    return recording;
}

Result<Recording> read_recording(const fs::path& folder) {
    const fs::path events = folder / "events.jsonl";
    std::error_code ec;
    if (!fs::exists(events, ec))
        return fail(phrase("recording.missing", {{"file", "events.jsonl"}}), folder.filename().string());
    auto text = read_whole_file(events, kMostBytes);
    if (!text) return tl::unexpected(text.error());
    auto recording = read_events(*text, "events.jsonl");
    if (!recording) return recording;
    read_table<kHandColumns>(folder / "hand.csv.gz", hand_header(), recording->hands[0], recording->problems);
    read_table<kHandColumns>(folder / "left.csv.gz", hand_header(), recording->hands[1], recording->problems);
    read_table<kFrameColumns>(folder / "frames.csv.gz", frame_header(), recording->frames, recording->problems);
    read_table<kCueColumns>(folder / "cues.csv.gz", cue_header(), recording->cues, recording->problems);
    read_table<kEngineColumns>(folder / "engine.csv.gz", engine_header(), recording->bodies, recording->problems);
    return recording;
}

std::vector<SaidLine> said_lines(const Recording& recording) {
    std::vector<SaidLine> said;
    for (const RecordedLine& line : recording.lines) {
        if (line.is != "said") continue;
        const Json json = Json::parse(line.json, nullptr, false);
        const auto text = [&json](const char* key) {
            const auto at = json.find(key);
            return at != json.end() && at->is_string() ? at->get<std::string>() : std::string();
        };
        const auto voiced = json.find("voiced");
        said.push_back({line.t_s, text("text"), text("class"), voiced != json.end() && *voiced == true});
    }
    return said;
}

}  // namespace handrail::record
