#include "app/record/recorder.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <ctime>
#include <mutex>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include "app/record/gzip_pieces.h"
#include "app/record/input_text.h"
#include "app/record/json_fields.h"
#include "worlds/base/executor.h"
#include "worlds/base/files.h"
#include "worlds/base/folder_unless_kept.h"
#include "worlds/base/language.h"

namespace handrail::record {
namespace {

namespace fs = std::filesystem;
using SteadyTime = std::chrono::steady_clock::time_point;

// Greatest number of bytes in lines that may wait to be written.
constexpr std::size_t kMostWaiting_bytes = std::size_t{64} << 20;
constexpr std::size_t kMostWaitingRows = 200'000;  // greatest number of rows of each table that may wait to be written

double seconds_since(SteadyTime then) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

std::string name_by_time_and_chance(std::time_t now) {
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz234567";
    std::random_device chance;
    std::string name = fmt::format("{:%Y-%m-%dT%H-%M-%SZ}-", fmt::gmtime(now));
    for (int i = 0; i < 8; ++i) name += kLetters[chance() % kLetters.size()];
    return name;
}

// A file to which text is only appended.
class Growing {
public:
    explicit Growing(fs::path path) : path_(std::move(path)) {}
    ~Growing() {
        if (file_ >= 0) ::close(file_);
    }
    Growing(const Growing&) = delete;
    Growing& operator=(const Growing&) = delete;

    // Appends the text. Returns 0, or the errno of the failure. The first text that is not empty creates the file.
    int append(std::string_view text) {
        if (text.empty()) return 0;
        if (file_ < 0) file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0600);
        if (file_ < 0) return errno;
        while (!text.empty()) {
            const ssize_t put = ::write(file_, text.data(), text.size());
            if (put < 0 && errno == EINTR) continue;
            if (put <= 0) return put < 0 ? errno : ENOSPC;
            text.remove_prefix(static_cast<std::size_t>(put));
        }
        return 0;
    }
    void sync() const {
        if (file_ >= 0) (void)::fdatasync(file_);
    }

private:
    fs::path path_;
    int file_ = -1;
};

// Collects the rows of a table, and writes them to its file piece by piece.
template <class Numbers>
class Table {
public:
    Table(const fs::path& path, std::string_view header) : file_(path), header_(header) {}

    void add(const Numbers& row) {
        text_ += row_text(row, before_, text_.empty());
        before_ = row;
    }
    int write() {
        if (text_.empty()) return 0;
        std::string piece = std::exchange(text_, {});
        if (!std::exchange(begun_, true)) piece.insert(0, std::string(header_) + "\n");
        return file_.append(gzip_piece(piece));
    }
    void sync() const { file_.sync(); }

private:
    Growing file_;
    std::string_view header_;
    std::string text_;
    Numbers before_{};
    bool begun_ = false;
};

std::string head_line(const RecordingHead& head) {
    Json line{{"t", 0},
              {"is", "recording"},
              {"form", head.form},
              {"program", head.program},
              {"language", head.language},
              {"begun_utc", head.begun_utc},
              {"begun_s", head.begun_s},
              {"virtual_time", head.virtual_time}};
    line["settings"] = Json::parse(settings_text(head.settings));
    return line_of(line);
}

}  // namespace

struct Recorder::State {
    State(fs::path in, RecordingHead with)
        : folder(std::move(in)),
          head(std::move(with)),
          bodies{{}, Table<EngineNumbers>(folder / "engine.csv.gz", engine_header())},
          events(folder / "events.jsonl"),
          hands{Table<HandNumbers>(folder / "hand.csv.gz", hand_header()),
                Table<HandNumbers>(folder / "left.csv.gz", hand_header())},
          frame_table(folder / "frames.csv.gz", frame_header()),
          cue_table(folder / "cues.csv.gz", cue_header()) {}

    const fs::path folder;
    const RecordingHead head;
    std::array<servo::HandRing, 2> rings;
    struct {
        dynamics::EngineRecording recording;
        Table<EngineNumbers> table;  // the members from here on are used only by the writing thread
        std::uint64_t reported_lost = 0;
    } bodies;
    std::atomic<bool> over{false};  // true once the recording has ended

    // Members that only the app thread uses.
    std::uint64_t frames_reported = 0;
    std::uint32_t stops = 0;
    bool fresh_frame = false;  // true if nothing was recorded since the last frame
    bool problem_reported = false, ended = false;

    std::mutex mutex;  // guards the members from here to `problem`
    std::condition_variable wake;
    bool end_requested = false;
    std::string lines;
    std::vector<FrameRow> frames;
    std::vector<CueRow> cues;
    std::string problem;

    // Members that only the writing thread uses.
    Growing events;
    std::array<Table<HandNumbers>, 2> hands;
    Table<FrameNumbers> frame_table;
    Table<CueNumbers> cue_table;
    std::array<std::uint64_t, 2> reported_lost{};
    SteadyTime pieces_at = std::chrono::steady_clock::now(), synced_at = pieces_at;
    std::thread writer;

    void add(std::string line) {
        if (over.load(std::memory_order_relaxed)) return;
        line += '\n';
        const std::lock_guard lock(mutex);
        lines += line;
    }
    long t_ms(double now_s) const { return std::lround((now_s - head.begun_s) * 1e3); }
    void stop_with(std::string sentence) {
        over = true;
        const std::lock_guard lock(mutex);
        problem = std::move(sentence);
        lines.clear();
        frames.clear();
        cues.clear();
    }
    void fail_with(int error) { stop_with(phrase("recording.stopped", {{"reason", reason_of(error)}})); }

    void run();
    int write_round(bool last);
};

// Writes all lines and rows that are waiting. Called on the writing thread. Returns 0, or the errno of the failure.
int Recorder::State::write_round(bool last) {
    std::string text;
    std::vector<FrameRow> more_frames;
    std::vector<CueRow> more_cues;
    bool too_much = false;
    {
        const std::lock_guard lock(mutex);
        too_much = lines.size() > kMostWaiting_bytes || frames.size() > kMostWaitingRows;
        text.swap(lines);
        more_frames.swap(frames);
        more_cues.swap(cues);
    }
    if (too_much) {
        stop_with(phrase("recording.too_slow"));
        return 0;
    }
    for (const FrameRow& row : more_frames) frame_table.add(numbers_of(row));
    for (const CueRow& row : more_cues) cue_table.add(numbers_of(row));
    for (std::size_t which = 0; which < rings.size(); ++which) {
        rings[which].rows.consume_all([&](const servo::HandRow& row) { hands[which].add(numbers_of(row)); });
        const std::uint64_t lost = rings[which].lost.load(std::memory_order_relaxed);
        if (std::exchange(reported_lost[which], lost) != lost)
            text += line_of({{"is", "lost_rows"}, {"hand", which}, {"rows", lost}}) + "\n";
    }
    bodies.recording.rows.consume_all([this](const dynamics::EngineRow& row) { bodies.table.add(numbers_of(row)); });
    const std::uint64_t lost_bodies = bodies.recording.lost.load(std::memory_order_relaxed);
    if (std::exchange(bodies.reported_lost, lost_bodies) != lost_bodies)
        text += line_of({{"is", "lost_rows"}, {"engine", true}, {"rows", lost_bodies}}) + "\n";
    if (const int error = events.append(text)) return error;
    if (!last && seconds_since(pieces_at) < kPieces_s) return 0;
    pieces_at = std::chrono::steady_clock::now();
    for (auto& hand : hands)
        if (const int error = hand.write()) return error;
    if (const int error = frame_table.write()) return error;
    if (const int error = cue_table.write()) return error;
    if (const int error = bodies.table.write()) return error;
    if (!last && seconds_since(synced_at) < kSync_s) return 0;
    synced_at = std::chrono::steady_clock::now();
    events.sync();
    for (auto& hand : hands) hand.sync();
    frame_table.sync();
    cue_table.sync();
    bodies.table.sync();
    return 0;
}

void Recorder::State::run() {
    for (bool last = false; !last && !over;) {
        {
            std::unique_lock lock(mutex);
            wake.wait_for(lock, std::chrono::duration<double>(kLines_s), [this] { return end_requested; });
            last = end_requested;
        }
        try {
            if (const int error = write_round(last)) fail_with(error);
        } catch (const std::bad_alloc&) {
            fail_with(ENOMEM);
        }
    }
    over = true;
}

Result<std::unique_ptr<Recorder>> Recorder::begin(const fs::path& recordings, RecordingHead head) {
    const std::time_t now = std::time(nullptr);
    head.begun_utc = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
    if (recordings.empty()) return fail(phrase("files.no_home"));
    const fs::path folder = recordings / name_by_time_and_chance(now);
    const auto refuse = [&](int error) {
        return fail(phrase("recording.no_folder", {{"folder", recordings.string()}, {"reason", reason_of(error)}}));
    };
    std::error_code ec;
    if (!fs::exists(recordings, ec)) {
        fs::create_directories(recordings.parent_path().empty() ? fs::path(".") : recordings.parent_path(), ec);
        if (::mkdir(recordings.c_str(), 0700) != 0 && errno != EEXIST) return refuse(errno);
    }
    FolderUnlessKept begun(folder);
    if (const int error = begun.make()) return refuse(error);
    auto state = std::make_unique<State>(folder, std::move(head));
    if (const int error = state->events.append(head_line(state->head) + "\n")) return refuse(error);
    std::unique_ptr<Recorder> recorder(new Recorder(std::move(state)));
    begun.keep();
    return recorder;
}

Recorder::Recorder(std::unique_ptr<State> state) : state_(std::move(state)) {
    state_->writer = std::thread([state = state_.get()] {
        name_this_thread("recorder");
        state->run();
    });
}

Recorder::~Recorder() {
    if (!state_->ended) end(state_->head.begun_s);
}

const fs::path& Recorder::folder() const { return state_->folder; }
servo::HandRing& Recorder::hand(std::size_t which) { return state_->rings.at(which); }
dynamics::EngineRecording& Recorder::bodies() { return state_->bodies.recording; }

void Recorder::input(const core::SessionInput& input, double now_s) {
    if (state_->over) return;
    // Each frame reports the number of stops. Record it only if it has changed.
    if (const auto* stopped = std::get_if<core::Stopped>(&input);
        stopped && std::exchange(state_->stops, stopped->count) == stopped->count)
        return;
    state_->fresh_frame = false;
    state_->add(input_line(input, now_s, state_->frames_reported, state_->head.begun_s));
}

void Recorder::not_taken() {
    if (!state_->over) state_->add(line_of({{"is", "not_taken"}}));
}

void Recorder::frame(const FrameRow& row) {
    ++state_->frames_reported;
    state_->fresh_frame = true;
    if (state_->over) return;
    const std::lock_guard lock(state_->mutex);
    state_->frames.push_back(row);
}

void Recorder::handed_over() {
    // After each frame, the session always hands over its results, so no line is needed.
    if (std::exchange(state_->fresh_frame, false) || state_->over) return;
    state_->add(line_of({{"is", "handed_over"}, {"frame", state_->frames_reported}}));
}

void Recorder::event(const core::SessionEvent& event, const Scene* scene) {
    if (!state_->over) state_->add(event_line(event, scene, state_->head.begun_s));
}

void Recorder::note(const char* is, double now_s, std::uint64_t number) {
    if (state_->over) return;
    state_->add(
        line_of({{"t", state_->t_ms(now_s)}, {"is", is}, {"number", number}, {"frame", state_->frames_reported}}));
}

void Recorder::cue_step(const CueRow& row) {
    if (state_->over) return;
    const std::lock_guard lock(state_->mutex);
    state_->cues.push_back(row);
}

void Recorder::said(double now_s, const cues::Utterance& utterance, bool voiced) {
    if (state_->over) return;
    state_->add(line_of({{"t", state_->t_ms(now_s)},
                         {"is", "said"},
                         {"text", utterance.text},
                         {"class", kClassWords.at(static_cast<std::size_t>(utterance.speech_class))},
                         {"voiced", voiced}}));
}

void Recorder::sink_news(double now_s, std::uint64_t step, bool from_voice, const std::string& text) {
    if (state_->over) return;
    state_->add(line_of({{"t", state_->t_ms(now_s)},
                         {"is", "sink_news"},
                         {"step", step},
                         {"from", from_voice ? "voice" : "sound"},
                         {"text", text}}));
}

std::optional<std::string> Recorder::take_problem() {
    if (state_->problem_reported || !state_->over) return std::nullopt;
    const std::lock_guard lock(state_->mutex);
    if (state_->problem.empty()) return std::nullopt;
    state_->problem_reported = true;
    return state_->problem;
}

void Recorder::end(double now_s) {
    if (std::exchange(state_->ended, true)) return;
    state_->add(line_of({{"t", state_->t_ms(now_s)}, {"is", "end"}}));
    {
        const std::lock_guard lock(state_->mutex);
        state_->end_requested = true;
    }
    state_->wake.notify_one();
    state_->writer.join();
}

}  // namespace handrail::record
