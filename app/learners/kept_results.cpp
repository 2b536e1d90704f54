#include "app/learners/kept_results.h"

#include <fmt/chrono.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "app/core/kept/folder_lock.h"
#include "app/learners/kept_lines.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"

namespace handrail::learners {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double kResultsWait_s = 0.5;
constexpr std::size_t kMostResults_bytes = std::size_t{64} << 20;

std::string line_of(const KeptResults& results) {
    Json tasks = Json::array();
    for (const record::RecordedTask& task : results.tasks) {
        Json measures = Json::object();
        for (const auto& [key, value] : task.measures)
            if (std::isfinite(value)) measures[key] = value;
        tasks.push_back({{"t_s", task.t_s}, {"kind", task.kind}, {"name", task.name}, {"measures", measures}});
    }
    const Json line{{"begun_utc", results.begun_utc},
                    {"lesson", results.lesson},
                    {"world", results.world},
                    {"seconds", results.seconds},
                    {"tasks", std::move(tasks)}};
    return line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<KeptResults> results_of(std::string_view text) {
    const Json line = Json::parse(text, nullptr, false);
    if (!line.is_object()) return std::nullopt;
    try {
        KeptResults results{line.at("begun_utc").get<std::string>(),
                            line.at("lesson").get<std::string>(),
                            line.at("world").get<std::string>(),
                            line.at("seconds").get<double>(),
                            {}};
        for (const Json& one : line.at("tasks")) {
            record::RecordedTask task{
                one.at("t_s").get<double>(), one.at("kind").get<std::string>(), one.at("name").get<std::string>(), {}};
            for (const auto& [key, value] : one.at("measures").items()) task.measures[key] = value.get<double>();
            results.tasks.push_back(std::move(task));
        }
        return results;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

}  // namespace

fs::path results_in(const fs::path& learner_folder) { return learner_folder / "results.jsonl"; }

std::string now_utc() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

Result<void> keep_results(const fs::path& learner_folder, const KeptResults& results) {
    const core::FolderLock lock(learner_folder, kResultsWait_s);
    if (lock.held_elsewhere()) return fail(phrase("side_file.locked", {{"file", "results.jsonl"}}));
    const fs::path file = results_in(learner_folder);
    std::string all;
    std::error_code ec;
    if (fs::exists(file, ec)) {
        auto before = read_whole_file(file, kMostResults_bytes);
        if (!before) return tl::unexpected(before.error());
        all = std::move(*before);
        if (!all.empty() && all.back() != '\n') all += '\n';
    }
    auto written = write_file_atomically(file, all + line_of(results));
    // Ignore a failure of chmod: other users cannot enter the folder in any case.
    if (written) (void)::chmod(file.c_str(), 0600);
    return written;
}

std::vector<KeptResults> kept_results(const fs::path& learner_folder, std::vector<Error>& faults) {
    std::vector<KeptResults> all;
    const fs::path file = results_in(learner_folder);
    each_kept_line(file, kMostResults_bytes, faults, [&](std::string_view line, int number) {
        if (auto one = results_of(line)) all.push_back(std::move(*one));
        else faults.push_back({file.string(), number, 0, phrase("learner.no_results")});
    });
    return all;
}

}  // namespace handrail::learners
