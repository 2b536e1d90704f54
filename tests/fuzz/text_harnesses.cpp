// Contains the harnesses for text that people and the program write: settings, side files of worlds, scenarios,
// languages and recorded paths of a hand. The parsers read all of these from files, except the recorded paths.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "app/core/kept/side_file.h"
#include "app/core/kept/side_merge.h"
#include "app/core/scenario/scenario.h"
#include "app/import/toml_apart.h"
#include "app/learners/learner.h"
#include "app/main/path_csv.h"
#include "app/record/recording.h"
#include "app/teaching/lesson_file.h"
#include "settings/settings.h"
#include "tests/fuzz/harness.h"
#include "tests/support/names.h"
#include "tests/support/temporary_folder.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::fuzz {
namespace {

// Uses a folder in memory if the system has one, because on a real disk every save waits for the disk.
struct InMemory {
    InMemory() {
        if (std::filesystem::exists("/dev/shm")) ::setenv("TMPDIR", "/dev/shm", 0);
    }
};
const InMemory in_memory;

const test::TemporaryFolder& folder() {
    static const test::TemporaryFolder made;
    return made;
}

std::string rows_text(const SettingsStore& store) {
    std::string text;
    for (const SettingRow& row : store.explain()) text += row.key + '=' + row.value + '\n';
    return text;
}

}  // namespace

// Settings that were read must still be the same after a change, a save and a second reading. The program must never
// replace a file that it could not understand.
std::string settings_fault(std::string_view bytes) {
    const std::filesystem::path file = folder().write("settings.toml", bytes);
    SettingsStore store;
    for (const Diagnostic& problem : store.load_file(file, SettingSource::UserFile))
        if (std::string fault = words_fault(problem.sentence()); !fault.empty()) return fault;
    if (!store.set("workspace.scale", store.values().workspace.scale == 30.0 ? "31" : "30", SettingSource::Live))
        return "a live change was refused";
    const Result<void> saved = store.save_user_file();
    if (!saved) {
        if (test::content_of(file) != bytes) return "a file was changed by a saving that failed";
        return words_fault(saved.error().sentence());
    }
    SettingsStore again;
    again.load_file(file, SettingSource::UserFile);
    if (rows_text(again) != rows_text(store)) return "settings changed by saving and reading: " + rows_text(again);
    return {};
}

// The side file must read back the entries that it saved. It must keep a file that it cannot understand under another
// name.
std::string side_file_fault(std::string_view bytes) {
    const test::TemporaryFolder own;
    const std::filesystem::path world = own.write("x.map", "{}"), path = own.write("x.map.handrail.toml", bytes);
    SideFile file = SideFile::of_world(world, {});
    for (const std::string& news : file.news())
        if (std::string fault = words_fault(news); !fault.empty()) return fault;
    if (!file.news().empty()) {
        bool kept = false;
        for (const auto& entry : std::filesystem::directory_iterator(own.path()))
            kept = kept || test::content_of(entry.path()) == bytes;
        if (!kept) return "a file that could not be read was lost";
    }
    for (const char* list : {"mark", "room_name", "way"}) {
        std::vector<SideEntry> entries = file.entries(list);
        if (auto fault = file.fault_of_list(list))
            if (std::string words = words_fault(fault->sentence()); !words.empty()) return words;
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (std::string words = words_fault(file.fault_in(list, i, "This is no entry.").sentence()); !words.empty())
                return words;
            for (const double number : numbers_of(entries[i], "place_m", 3))
                if (!std::isfinite(number)) return "a place that is not finite";
        }
        SideEntry added{{"name", std::string("here")}};
        put_place(added, Vec3(1.0, 2.5, -3.0));
        entries.push_back(added);
        file.set_entries(list, entries);
        if (const Result<void> saved = file.save(); !saved) return words_fault(saved.error().sentence());
        const std::vector<SideEntry> again = SideFile::of_world(world, {}).entries(list);
        // The comparison treats NaN as equal to NaN, as the program does when it merges side files.
        if (!std::equal(again.begin(), again.end(), entries.begin(), entries.end(),
                        [](const SideEntry& a, const SideEntry& b) { return same(a, b); }))
            return std::string("entries changed by saving and reading: ") + list;
    }
    return {};
}

// A learner file must read back as it was written, including consents and unknown entries.
std::string learner_fault(std::string_view bytes) {
    const std::string text(bytes);
    const Result<Learner> learner = read_learner(text, "learner.toml");
    if (!learner) return words_fault(learner.error().sentence());
    if (std::string fault = words_fault(learner->name); !fault.empty()) return fault;
    const Result<std::string> written = text_of(*learner, text, "learner.toml");
    if (!written) return "a learner that cannot be written: " + written.error().sentence();
    const Result<Learner> again = read_learner(*written, "learner.toml");
    if (!again) return "a learner that cannot be read again: " + *written;
    for (const Purpose purpose : kPurposes) {
        const auto &one = learner->consent(purpose), &other = again->consent(purpose);
        if (one.has_value() != other.has_value()) return "a consent that came or went: " + *written;
        if (one && (one->given != other->given || one->until != other->until)) return "other days: " + *written;
        if (one && learner->allows(purpose, one->given) && !one->until.empty() && one->until < one->given)
            return "a consent that holds when it is over";
    }
    return again->name == learner->name ? std::string() : "another name: " + *written;
}

// Bytes that begin with { are read as events, other bytes as a table of a hand's positions. The reader must report
// damage with its line. The rows before the damage must read back as they were written.
std::string recording_fault(std::string_view bytes) {
    if (bytes.starts_with("{")) {
        const Result<Recording> recording = read_events(bytes, "events.jsonl");
        if (!recording) return words_fault(recording.error().sentence());
        for (const Error& problem : recording->problems) {
            if (std::string fault = words_fault(problem.sentence()); !fault.empty()) return fault;
            if (problem.line < 2) return "a problem without its line";
        }
        for (const RecordedLine& line : recording->lines)
            if (!std::isfinite(line.t_s)) return "a time that is not finite";
        for (const SaidLine& said : said_lines(*recording))
            if (!is_utf8(said.text)) return "what was said is no UTF-8";
        return {};
    }
    const TableRows<kHandColumns> table = read_rows<kHandColumns>(bytes, hand_header(), "hand.csv");
    if (table.problem)
        if (std::string fault = words_fault(table.problem->sentence()); !fault.empty()) return fault;
    std::string text(hand_header());
    text += '\n';
    HandNumbers before{};
    for (const HandNumbers& numbers : table.rows) {
        (void)row_of(numbers);
        text += row_text(numbers, before, &numbers == table.rows.data());
        before = numbers;
    }
    if (table.rows.empty()) return {};
    const TableRows<kHandColumns> again = read_rows<kHandColumns>(text, hand_header(), "hand.csv");
    return again.problem || again.rows != table.rows ? "rows changed by writing and reading" : std::string();
}

std::string scenario_fault(std::string_view bytes) {
    folder().write("box.map", "{\n\"classname\" \"worldspawn\"\n}\n");
    const Result<Scenario> scenario = read_scenario(folder().write("scenario.toml", bytes), {folder().path()});
    if (!scenario) return words_fault(scenario.error().sentence());
    if (scenario->expectations.empty()) return "a scenario that expects nothing";
    for (const ScenarioAction& action : scenario->actions)
        if (action.at_s && !std::isfinite(*action.at_s)) return "a time that is not finite";
    return std::isfinite(scenario->tail_s) && scenario->tail_s >= 0.0 ? std::string() : "a tail that is none";
}

// The program either refuses the answer of a reader process, or can write the answer and read it again.
std::string toml_answer_fault(std::string_view bytes) {
    const Result<TomlValue> values = toml_in_answer(bytes);
    if (!values) return values.error().message.size() > 300 ? "a long fault" : std::string();
    const std::string text = written_toml(*values);
    const Result<TomlValue> again = toml_of(text);
    if (!again) return "its own text is refused: " + again.error().message + text;
    return *again == *values ? std::string() : "it changed by writing and reading: " + text;
}

// A lesson must read back unchanged from its own text, except for its learners.
std::string lesson_fault(std::string_view bytes) {
    folder().write("box.map", "{\n\"classname\" \"worldspawn\"\n}\n");
    const std::filesystem::path file = folder().path() / "fuzz.lesson.toml";
    Result<LessonFile> lesson = read_lesson_text(std::string(bytes), file, {folder().path()});
    if (!lesson) return words_fault(lesson.error().sentence());
    if (lesson->sessions.empty() || lesson->landmarks.empty()) return "a lesson with nothing in it";
    lesson->pupils.clear();
    const std::string text = lesson_text(*lesson);
    const Result<LessonFile> again = read_lesson_text(text, file, {folder().path()});
    if (!again) return "its own text is refused: " + again.error().sentence() + text;
    return lesson_text(*again) == text ? std::string() : "it changed by writing and reading: " + text;
}

// Whatever a language file contains, every text must exist: another language provides the texts that the file lacks.
std::string language_fault(std::string_view bytes) {
    folder().write("xx.toml", bytes);
    const Result<std::vector<Diagnostic>> spoken = speak_language("xx", folder().path());
    std::string fault = spoken ? std::string() : words_fault(spoken.error().sentence());
    if (spoken)
        for (const Diagnostic& diagnostic : *spoken)
            if (fault.empty()) fault = words_fault(diagnostic.sentence());
    for (const std::string& said : {phrase("program.path_time"), phrase("program.path_cells", {{"count", 3}}),
                                    phrase("program.path_no_number", {{"text", "x"}})})
        if (fault.empty() && (said.empty() || !is_utf8(said))) fault = "a text that cannot be said";
    if (!speak_language("en")) fault = "English is gone";
    return fault;
}

std::string path_fault(std::string_view bytes) {
    const Result<std::vector<PathRow>> rows = parse_path(bytes, "fuzz.csv");
    if (!rows) return words_fault(rows.error().sentence());
    for (std::size_t i = 0; i < rows->size(); ++i)
        if (!std::isfinite((*rows)[i].t_s) || (i > 0 && !((*rows)[i].t_s > (*rows)[i - 1].t_s)))
            return "time does not go on";
    return {};
}

}  // namespace handrail::fuzz
