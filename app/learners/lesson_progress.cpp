#include "app/learners/lesson_progress.h"

#include <sys/stat.h>
#include <toml++/toml.h>

#include <sstream>
#include <system_error>

#include "app/core/kept/folder_lock.h"
#include "app/learners/kept_results.h"
#include "app/learners/learner.h"
#include "settings/parse_toml.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::learners {
namespace {

namespace fs = std::filesystem;

constexpr double kLessonsWait_s = 0.5;
constexpr std::size_t kMostLessons_bytes = std::size_t{4} << 20;
constexpr std::int64_t kMostSession = 1000;

fs::path file_in(const fs::path& learner_folder) { return learner_folder / "lessons.toml"; }

fs::path known_by(const fs::path& lesson) {
    std::error_code ec;
    const fs::path whole = fs::weakly_canonical(fs::absolute(lesson, ec), ec);
    return ec ? lesson : whole;
}

// Parses the file. Returns an empty table if the file does not exist.
Result<toml::table> table_of(const fs::path& file) {
    std::error_code ec;
    if (!fs::exists(file, ec)) return toml::table();
    const auto text = read_whole_file(file, kMostLessons_bytes);
    if (!text) return tl::unexpected(text.error());
    if (!is_utf8(*text)) return fail(phrase("learner.no_text"), file.string());
    try {
        return settings::parse_toml(*text);
    } catch (const toml::parse_error& error) {
        return fail(phrase("learner.lessons_damaged"), file.string(), static_cast<int>(error.source().begin.line));
    }
}

Result<LessonProgress> progress_of(const toml::node& node, const fs::path& file) {
    const auto refuse = [&] {
        return fail(phrase("learner.lessons_damaged"), file.string(), static_cast<int>(node.source().begin.line));
    };
    const toml::table* entry = node.as_table();
    if (!entry) return refuse();
    const auto lesson = (*entry)["file"].value<std::string>();
    const auto taught = (*entry)["taught"].value<std::int64_t>();
    if (!lesson || lesson->empty() || !taught || *taught < 1 || *taught > kMostSession) return refuse();
    return LessonProgress{*lesson, static_cast<std::size_t>(*taught), (*entry)["day"].value_or(std::string())};
}

}  // namespace

Result<std::vector<LessonProgress>> lessons_begun(const fs::path& learner_folder) {
    const fs::path file = file_in(learner_folder);
    const auto table = table_of(file);
    if (!table) return tl::unexpected(table.error());
    std::vector<LessonProgress> all;
    const toml::node* lessons = table->get("lesson");
    if (!lessons) return all;
    if (!lessons->is_array())
        return fail(phrase("learner.lessons_damaged"), file.string(), static_cast<int>(lessons->source().begin.line));
    for (const toml::node& node : *lessons->as_array()) {
        auto one = progress_of(node, file);
        if (!one) return tl::unexpected(one.error());
        all.push_back(std::move(*one));
    }
    return all;
}

Result<std::size_t> session_taught(const fs::path& learner_folder, const fs::path& lesson) {
    const auto all = lessons_begun(learner_folder);
    if (!all) return tl::unexpected(all.error());
    const fs::path known = known_by(lesson);
    for (const LessonProgress& one : *all)
        if (one.file == known) return one.taught;
    return std::size_t{0};
}

Result<void> note_session_taught(const fs::path& learner_folder, const fs::path& lesson, std::size_t session) {
    const core::FolderLock lock(learner_folder, kLessonsWait_s);
    if (lock.held_elsewhere()) return fail(phrase("side_file.locked", {{"file", "lessons.toml"}}));
    if (const auto readable = lessons_begun(learner_folder); !readable) return tl::unexpected(readable.error());
    const fs::path file = file_in(learner_folder);
    auto table = table_of(file);
    if (!table) return tl::unexpected(table.error());
    if (!table->contains("lesson")) table->insert("lesson", toml::array());
    toml::array& lessons = *table->get("lesson")->as_array();
    const std::string known = known_by(lesson).string();
    toml::table* entry = nullptr;
    for (toml::node& node : lessons)
        if ((*node.as_table())["file"].value_or(std::string()) == known) entry = node.as_table();
    if (!entry) {
        lessons.push_back(toml::table{{"file", known}});
        entry = lessons.back().as_table();
    }
    entry->insert_or_assign("taught", static_cast<std::int64_t>(session));
    entry->insert_or_assign("day", today());
    std::ostringstream out;
    out.exceptions(std::ios::badbit);
    out << *table << '\n';
    auto written = write_file_atomically(file, out.str());
    // Ignore a failure of chmod: other users cannot enter the folder in any case.
    if (written) (void)::chmod(file.c_str(), 0600);
    return written;
}

Result<void> forget_lessons(const fs::path& learner_folder) {
    for (const fs::path& file : {file_in(learner_folder), results_in(learner_folder)}) {
        std::error_code ec;
        if (!fs::remove(file, ec) && ec)
            return fail(phrase("learner.not_deleted", {{"file", file.string()}, {"reason", reason_of(ec.value())}}));
    }
    return {};
}

}  // namespace handrail::learners
