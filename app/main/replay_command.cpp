#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>

#include "app/core/dialogue/command_words.h"
#include "app/core/kept/side_file.h"
#include "app/core/kept/spoken_language.h"
#include "app/core/session/session.h"
#include "app/learners/export_gate.h"
#include "app/main/commands.h"
#include "app/main/end_signals.h"
#include "app/main/world_files.h"
#include "app/record/compute_again.h"
#include "app/record/hearing.h"
#include "app/record/scenario_of.h"
#include "app/terminal/line_watch.h"
#include "app/terminal/raw_terminal.h"
#include "app/terminal/terminal_keys.h"
#include "audio-cues/plan/audio_thread.h"
#include "audio-cues/sinks/sound_outputs.h"
#include "worlds/base/clock.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"

namespace handrail::program {
namespace {

namespace fs = std::filesystem;

// After a line was handed over to the voice, the program assumes for at least this time that the voice is speaking.
constexpr double kBegins_s = 0.1;
constexpr double kReplayLastWords_s = 3.0;  // longest time that the program waits at the end for the current sentence
constexpr double kEars_m = 1.6;             // height of the listener's ears above the soles

// ---- playback ----

enum class Act : std::uint8_t { None, Stop, Back, On, Leave };

constexpr std::array<std::string_view, 4> kTypedWords{"stop", "back", "on", "leave"};

Act act_of(std::string_view typed) {
    const std::string word = core::english_word("replay_word", kTypedWords, typed);
    const auto is_one_of = [&word](std::initializer_list<std::string_view> words) {
        return std::find(words.begin(), words.end(), word) != words.end();
    };
    if (is_one_of({"Space", " ", "", "stop"})) return Act::Stop;
    if (is_one_of({"Left", "left", "back"})) return Act::Back;
    if (is_one_of({"Right", "right", "on"})) return Act::On;
    if (is_one_of({"Escape", "leave"})) return Act::Leave;
    return Act::None;
}

// Reads what the person wants during playback. If the terminal supports it, keys act at once; otherwise the person
// types words, one on each line.
class Acts {
public:
    explicit Acts(Clock& clock) : terminal_(terminal::RawTerminal::take(STDIN_FILENO, STDOUT_FILENO)) {
        const char* kind = std::getenv("TERM");
        if (terminal_)
            keys_.emplace(STDIN_FILENO,
                          terminal::terminal_keyboard(spoken_language(), kind ? kind : "", terminal_->erase()), clock,
                          [](const std::string&) { return false; });
        else lines_.emplace(STDIN_FILENO, terminal::LineWatch::WhenFull::Waits, [](std::string_view) { return false; });
    }
    bool has_keys() const { return keys_.has_value(); }
    std::vector<Act> take() {
        std::vector<Act> chosen;
        bool emptied = false;
        if (keys_)
            for (const terminal::TimedInput& one : keys_->take(emptied))
                chosen.push_back(act_of(one.input.key.empty() ? one.input.text : one.input.key));
        else
            for (const std::string& line : lines_->take(emptied)) chosen.push_back(act_of(line));
        return chosen;
    }

private:
    std::unique_ptr<terminal::RawTerminal> terminal_;
    std::optional<terminal::TerminalKeys> keys_;
    std::optional<terminal::LineWatch> lines_;
};

class HeardAgain {
public:
    HeardAgain(const record::Recording& recording, double speed, const settings::Settings& settings)
        : hearing_(recording, speed), acts_(clock_) {
        sinks::SoundOutputs outputs = sinks::open_sound_outputs(settings, STDOUT_FILENO);
        sound_ = std::make_unique<cues::AudioThread>(std::move(outputs.audio), std::move(outputs.speech), clock_,
                                                     nullptr, settings);
        sound_->start();
    }

    void run() {
        const EndSignals signals;
        say(phrase(acts_.has_keys() ? "replay.begin_keys" : "replay.begin_words",
                   {{"length", time_words(hearing_.length_s())}}));
        double then_s = clock_.now_s();
        while (!signals.requested() && !left_ && !(hearing_.over() && !speaking())) {
            const double now_s = clock_.now_s();
            for (const Act chosen : acts_.take()) act(chosen);
            record::Hearing::Heard heard = hearing_.go_on(now_s - then_s, speaking());
            then_s = now_s;
            if (const record::FrameRow* place = hearing_.place())
                sound_->set_listener({place->feet_m + Vec3(0.0, 0.0, kEars_m), place->heading_rad, 0.0});
            for (const record::Hearing::Knock& knock : heard.knocks) play(knock);
            for (record::SaidLine& line : heard.lines)
                if (line.voiced) say(std::move(line.text));
            clock_.sleep_until_s(now_s + core::kFrame_s);
        }
        sound_->stop(signals.requested() ? 0.0 : kReplayLastWords_s);
    }

private:
    static std::string time_words(double t_s) {
        const int seconds = static_cast<int>(t_s);
        return phrase("learning.minutes_and_seconds", {{"minutes", seconds / 60}, {"seconds", seconds % 60}});
    }
    bool speaking() const { return sound_->speaking() || clock_.now_s() - said_s_ < kBegins_s; }

    void say(std::string text) {
        cues::CueRequest request;
        request.text = std::move(text);
        request.repeatable = true;
        request.time_s = said_s_ = clock_.now_s();
        sound_->post(std::move(request));
    }
    void play(const record::Hearing::Knock& knock) {
        cues::CueRequest request;
        request.kind = cues::CueRequestKind::Play;
        request.sound = cues::SoundKind::Contact;
        request.time_s = clock_.now_s();
        request.position_m = knock.at_m;
        request.loudness = std::clamp(knock.force_n / 2.0, 0.2, 1.0);
        sound_->post(std::move(request));
    }
    void act(Act chosen) {
        if (chosen == Act::None) return;
        cues::CueRequest quiet;
        quiet.kind = cues::CueRequestKind::StopSpeech;
        quiet.time_s = clock_.now_s();
        sound_->post(std::move(quiet));
        if (chosen == Act::Leave) left_ = true;
        if (chosen == Act::Stop) hearing_.stop_or_go_on();
        if (chosen == Act::Back || chosen == Act::On)
            hearing_.jump(chosen == Act::On ? record::Hearing::kJump_s : -record::Hearing::kJump_s);
        if (left_) return;
        say(phrase(hearing_.stopped() ? "replay.stopped_at" : "replay.at", {{"time", time_words(hearing_.at_s())}}));
    }

    SteadyClock clock_;
    record::Hearing hearing_;
    Acts acts_;
    std::unique_ptr<cues::AudioThread> sound_;
    double said_s_ = -1e9;
    bool left_ = false;
};

// ---- conversion to tables ----

template <class Rows>
Result<void> write_table(const learners::ExportGate& export_gate, const fs::path& file, std::string_view header,
                         const Rows& rows) {
    if (rows.empty()) return {};
    std::string text = std::string(header) + "\r\n";
    for (const auto& row : rows) text += fmt::format("{}\r\n", fmt::join(record::numbers_of(row), ","));
    return export_gate.write(file, text, write_file_atomically);
}

Result<void> write_tables(const learners::ExportGate& export_gate, const record::Recording& recording,
                          const fs::path& folder) {
    for (const Result<void>& written :
         {write_table(export_gate, folder / "hand.csv", record::hand_header(), recording.hands[0]),
          write_table(export_gate, folder / "left.csv", record::hand_header(), recording.hands[1]),
          write_table(export_gate, folder / "frames.csv", record::frame_header(), recording.frames),
          write_table(export_gate, folder / "cues.csv", record::cue_header(), recording.cues),
          write_table(export_gate, folder / "engine.csv", record::engine_header(), recording.bodies)})
        if (!written) return written;
    return {};
}

// ---- recomputation ----

int check(const record::Recording& recording, std::ostream& out, std::ostream& err, const LongWork& progress) {
    if (const auto spoken = speak_language(recording.head.language, core::user_languages_folder()); !spoken) {
        err << spoken.error().sentence() << '\n';
        return 1;
    }
    progress.at(phrase("progress.again"));
    const auto again = record::compute_again(recording, {imported_scene, toml_next_to_worlds()});
    progress.done();
    if (!again) {
        err << again.error().sentence() << '\n';
        return 1;
    }
    for (const std::string& remark : again->remarks) out << remark << '\n';
    if (const auto other = record::first_difference(recording, *again)) {
        err << phrase("replay.differs", {{"line", other->line + 1},
                                         {"recorded", other->recorded},
                                         {"computed", other->computed},
                                         {"version", recording.head.program}})
            << '\n';
        return 1;
    }
    out << phrase("replay.same", {{"count", again->said.size()}}) << '\n';
    return 0;
}

}  // namespace

fs::path newest_in(const fs::path& folder) {
    fs::path newest;
    std::error_code ec;
    for (const auto& entry : fs::directory_iterator(folder, ec))
        if (entry.is_directory(ec) && entry.path().filename() > newest.filename()) newest = entry.path();
    return newest;
}

int run_replay(const ReplayArguments& arguments, const settings::Settings& settings, std::ostream& out,
               std::ostream& err, const LongWork& progress) {
    const fs::path folder = arguments.folder.value_or(newest_in(core::user_data_folder("recordings")));
    const auto refuse = [&err](const Error& error) {
        err << error.sentence() << '\n';
        return 1;
    };
    if (folder.empty()) return refuse({{}, 0, 0, phrase("replay.none")});
    const auto export_gate = learners::ExportGate::of(learners::Learners(core::user_data_folder()), folder);
    if (!export_gate) return refuse(export_gate.error());
    for (const auto& file : {arguments.csv, arguments.scenario})
        if (file)
            if (const auto allowed = export_gate->allows(*file); !allowed) return refuse(allowed.error());
    progress.at(phrase("progress.recording"));
    const auto recording = record::read_recording(folder);
    progress.done();
    if (!recording) return refuse(recording.error());
    for (const Error& problem : recording->problems) err << problem.sentence() << '\n';
    if (!recording->ended) out << phrase("replay.ends_early") << '\n';
    if (arguments.csv)
        if (const auto written = write_tables(*export_gate, *recording, *arguments.csv); !written)
            return refuse(written.error());
    if (arguments.scenario) {
        auto scenario = record::scenario_of(*recording, folder.filename().string());
        progress.at(phrase("progress.scenario", {{"title", folder.filename().string()}}));
        if (scenario) scenario = record::as_it_runs(std::move(*scenario), {imported_scene, toml_next_to_worlds()});
        progress.done();
        if (!scenario) return refuse(scenario.error());
        for (const std::string& sentence : scenario->left_out) out << sentence << '\n';
        if (const auto written = export_gate->write(*arguments.scenario, record::with_expectations(*scenario),
                                                    write_named_file_atomically);
            !written)
            return refuse(written.error());
    }
    if (arguments.check) return check(*recording, out, err, progress);
    if (arguments.csv || arguments.scenario) return 0;
    HeardAgain(*recording, arguments.speed, settings).run();
    return 0;
}

}  // namespace handrail::program
