#include "app/learners/exported.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <zlib.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/core/kept/folder_lock.h"
#include "app/learners/kept_lines.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"

namespace handrail::learners {
namespace {

namespace fs = std::filesystem;

constexpr double kLockWait_s = 0.5;
constexpr std::size_t kLongestList_bytes = std::size_t{16} << 20;

fs::path list_in(const fs::path& learner_folder) { return learner_folder / "exports.jsonl"; }

std::string checksum_of(std::string_view bytes) {
    return fmt::format("{:08x}",
                       ::crc32_z(::crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace

Result<void> note_exported(const fs::path& learner_folder, const fs::path& file, std::string_view content) {
    const core::FolderLock lock(learner_folder, kLockWait_s);
    if (lock.held_elsewhere()) return fail(phrase("side_file.locked", {{"file", "exports.jsonl"}}));
    std::string list;
    std::error_code ec;
    if (fs::exists(list_in(learner_folder), ec)) {
        auto before = read_whole_file(list_in(learner_folder), kLongestList_bytes);
        if (!before) return tl::unexpected(before.error());
        list = std::move(*before);
        if (!list.empty() && list.back() != '\n') list += '\n';
    }
    const nlohmann::json line{{"file", fs::absolute(file, ec).lexically_normal().string()},
                              {"crc32", checksum_of(content)}};
    list += line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
    auto written = write_file_atomically(list_in(learner_folder), list);
    // Ignore a failure of chmod: other users cannot enter the folder in any case.
    if (written) (void)::chmod(list_in(learner_folder).c_str(), 0600);
    return written;
}

std::vector<Exported> exported_of(const fs::path& learner_folder, std::vector<Error>& faults) {
    std::vector<Exported> all;
    const fs::path path = list_in(learner_folder);
    each_kept_line(path, kLongestList_bytes, faults, [&](std::string_view text, int number) {
        const nlohmann::json line = nlohmann::json::parse(text, nullptr, false);
        if (!line.is_object() || !line.contains("file") || !line["file"].is_string() || !line.contains("crc32") ||
            !line["crc32"].is_string())
            return faults.push_back({path.string(), number, 0, phrase("learner.no_export")});
        const std::string file = line["file"];
        auto one = std::find_if(all.begin(), all.end(), [&](const Exported& known) { return known.file == file; });
        if (one == all.end()) one = all.insert(all.end(), {file, {}});
        one->checksums.push_back(line["crc32"]);
    });
    return all;
}

bool unchanged(const Exported& exported) {
    const auto bytes = read_whole_file(exported.file);
    return bytes && std::find(exported.checksums.begin(), exported.checksums.end(), checksum_of(*bytes)) !=
                        exported.checksums.end();
}

}  // namespace handrail::learners
