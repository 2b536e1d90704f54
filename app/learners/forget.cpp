#include "app/learners/forget.h"

#include <algorithm>
#include <system_error>

#include "app/learners/exported.h"
#include "app/record/gzip_pieces.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"

namespace handrail::learners {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostUnpacked_bytes = std::size_t{1} << 30;

std::size_t entries_in(const fs::path& folder) {
    std::error_code ec;
    std::size_t count = 0;
    for (fs::directory_iterator at(folder, ec), end; !ec && at != end; at.increment(ec)) ++count;
    return count;
}

bool part_of_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           static_cast<unsigned char>(c) >= 0x80;
}

bool holds(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !part_of_word(text[at - 1])) && (end == text.size() || !part_of_word(text[end]))) return true;
    }
    return false;
}

bool holds_any(std::string_view text, std::span<const std::string> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return !word.empty() && holds(text, word); });
}

void look_into(const fs::path& file, std::span<const std::string> words, Search& search) {
    const auto bytes = read_whole_file(file);
    if (!bytes) {
        search.unread.push_back(file);
        return;
    }
    ++search.files;
    bool hit = holds_any(*bytes, words);
    if (!hit && bytes->starts_with("\x1f\x8b")) {
        const record::GzipText unpacked = record::gunzip_pieces(*bytes, kMostUnpacked_bytes);
        hit = holds_any(unpacked.text, words);
        if (!hit && unpacked.huge) search.unread.push_back(file);
    }
    if (hit) search.hits.push_back(file);
}

}  // namespace

Holdings holdings_of(const fs::path& learner_folder) {
    Holdings holdings;
    holdings.recordings = entries_in(learner_folder / "recordings");
    holdings.worlds = std::max(entries_in(learner_folder / "worlds"), entries_in(learner_folder / "learnt"));
    std::error_code ec;
    for (const Exported& one : exported_of(learner_folder, holdings.faults))
        if (unchanged(one)) holdings.exported.push_back(one.file);
        else if (fs::exists(fs::symlink_status(one.file, ec))) holdings.exported_other.push_back(one.file);
    return holdings;
}

Result<void> delete_learner(const fs::path& learner_folder, const Holdings& holdings) {
    std::error_code ec;
    for (const fs::path& file : holdings.exported)
        if (!fs::remove(file, ec) && ec)
            return fail(phrase("learner.not_deleted", {{"file", file.string()}, {"reason", reason_of(ec.value())}}));
    fs::remove_all(learner_folder, ec);
    if (ec)
        return fail(
            phrase("learner.not_deleted", {{"file", learner_folder.string()}, {"reason", reason_of(ec.value())}}));
    return {};
}

Search search_for(std::span<const std::string> words, std::span<const fs::path> folders) {
    Search search;
    for (const fs::path& folder : folders) {
        std::error_code ec;
        fs::recursive_directory_iterator at(folder, ec);
        for (const fs::recursive_directory_iterator end; !ec && at != end; at.increment(ec)) {
            std::error_code of_entry;
            if (holds_any(at->path().filename().string(), words)) search.hits.push_back(at->path());
            if (fs::is_regular_file(at->symlink_status(of_entry))) look_into(at->path(), words, search);
        }
        if (ec && ec != std::errc::no_such_file_or_directory) search.unread.push_back(folder);
    }
    const auto once = [](std::vector<fs::path>& paths) {
        std::sort(paths.begin(), paths.end());
        paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
    };
    once(search.hits);
    once(search.unread);
    return search;
}

}  // namespace handrail::learners
