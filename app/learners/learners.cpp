#include "app/learners/learners.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <random>

#include "app/core/kept/folder_lock.h"
#include "worlds/base/files.h"
#include "worlds/base/folder_unless_kept.h"
#include "worlds/base/language.h"
#include "worlds/base/text.h"

namespace handrail::learners {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestFile_bytes = std::size_t{1} << 20;
constexpr std::size_t kLetters_in_id = 8;

bool is_id(std::string_view text) {
    return text.size() == kLetters_in_id && std::all_of(text.begin(), text.end(), [](char c) {
               return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
           });
}

std::string id_by_chance() {
    // letters and digits of ids, without those that can be mistaken for others
    constexpr std::string_view kLetters = "abcdefghijkmnpqrstuvwxyz23456789";
    std::random_device chance;
    std::string id;
    for (std::size_t i = 0; i < kLetters_in_id; ++i) id += kLetters[chance() % kLetters.size()];
    return id;
}

tl::unexpected<Error> no_folder(const fs::path& folder, int error) {
    return fail(phrase("learner.no_folder", {{"folder", folder.string()}, {"reason", reason_of(error)}}));
}

// Creates a folder that only the person at the computer can access, regardless of the umask.
Result<void> make_private(const fs::path& folder) {
    if (::mkdir(folder.c_str(), 0700) == 0 || errno == EEXIST) return {};
    return no_folder(folder, errno);
}

}  // namespace

Learners::Learners(const fs::path& data_folder)
    : folder_(data_folder.empty() ? data_folder : data_folder / "learners") {}

Result<Learner> Learners::read(const std::string& id) const {
    const auto text = read_whole_file(file_of(id), kLongestFile_bytes);
    if (!text) return tl::unexpected(text.error());
    auto learner = read_learner(*text, file_of(id).string());
    if (learner) learner->id = id;
    return learner;
}

Learners::Found Learners::all() const {
    Found found;
    std::error_code ec;
    for (fs::directory_iterator at(folder_, ec), end; !ec && at != end; at.increment(ec)) {
        const std::string id = at->path().filename().string();
        std::error_code no_folder;
        if (!is_id(id) || !at->is_directory(no_folder)) continue;
        auto learner = read(id);
        if (learner) found.learners.push_back(std::move(*learner));
        else found.faults.push_back(std::move(learner.error()));
    }
    std::sort(found.learners.begin(), found.learners.end(),
              [](const Learner& a, const Learner& b) { return std::pair(a.name, a.id) < std::pair(b.name, b.id); });
    return found;
}

Result<Learner> Learners::find(const std::string& name_or_id) const {
    const Found found = all();
    std::vector<std::string> names;
    for (const Learner& one : found.learners) {
        if (lower_ascii(one.name) == lower_ascii(name_or_id) || one.id == name_or_id) return one;
        names.push_back(one.name);
    }
    std::error_code ec;
    if (!folder_.empty() && is_id(name_or_id) && fs::is_directory(folder_of(name_or_id), ec))
        return read(name_or_id);  // fails with what is wrong in learner.toml
    if (names.empty()) return fail(phrase("learner.nobody", {{"name", one_line(name_or_id)}}));
    return fail(
        phrase("learner.unknown", {{"name", one_line(name_or_id)}, {"nearest", nearest_name(name_or_id, names)}}));
}

std::string Learners::id_of(const std::string& name_or_id) const {
    if (const auto learner = find(name_or_id)) return learner->id;
    std::error_code ec;
    return !folder_.empty() && is_id(name_or_id) && fs::is_directory(folder_of(name_or_id), ec) ? name_or_id
                                                                                                : std::string();
}

Result<Learner> Learners::make(const std::string& name, const std::string& settings) const {
    auto good = good_learner_name(name);
    if (!good) return tl::unexpected(good.error());
    if (folder_.empty()) return fail(phrase("files.no_home"));
    std::error_code ec;
    // Ignore a failure: the next line then fails, too, and reports it.
    fs::create_directories(folder_.parent_path(), ec);
    if (auto made = make_private(folder_); !made) return tl::unexpected(made.error());
    const core::FolderLock lock(folder_, kLockWait_s);
    if (lock.held_elsewhere()) return fail(phrase("side_file.locked", {{"file", folder_.filename().string()}}));
    for (const Learner& one : all().learners)
        if (lower_ascii(one.name) == lower_ascii(*good)) return fail(phrase("learner.taken", {{"name", one.name}}));
    Learner learner;
    do learner.id = id_by_chance();
    while (fs::exists(folder_of(learner.id), ec));
    learner.name = std::move(*good);
    learner.created = today();
    FolderUnlessKept begun(folder_of(learner.id));
    if (const int error = begun.make()) return no_folder(folder_of(learner.id), error);
    const auto text = text_of(learner, {}, file_of(learner.id).string());
    if (!text) return tl::unexpected(text.error());
    if (auto written = write_private_file_atomically(settings_of(learner.id), settings); !written)
        return tl::unexpected(written.error());
    if (auto written = write_private_file_atomically(file_of(learner.id), *text); !written)
        return tl::unexpected(written.error());
    begun.keep();
    return learner;
}

Result<Learner> Learners::change(const std::string& id, const std::function<void(Learner&)>& to) const {
    const core::FolderLock lock(folder_of(id), kLockWait_s);
    if (lock.held_elsewhere()) return fail(phrase("side_file.locked", {{"file", "learner.toml"}}));
    const auto before = read_whole_file(file_of(id), kLongestFile_bytes);
    if (!before) return tl::unexpected(before.error());
    auto learner = read_learner(*before, file_of(id).string());
    if (!learner) return learner;
    learner->id = id;
    to(*learner);
    const auto text = text_of(*learner, *before, file_of(id).string());
    if (!text) return tl::unexpected(text.error());
    if (auto written = write_private_file_atomically(file_of(id), *text); !written)
        return tl::unexpected(written.error());
    return learner;
}

std::string Learners::offer() const {
    const std::vector<Learner> taken = all().learners;
    std::random_device chance;
    std::string name;
    for (int tries = 0; tries < 1000; ++tries) {
        name = offered_name(static_cast<std::uint32_t>(chance()));
        if (std::none_of(taken.begin(), taken.end(), [&](const Learner& one) { return one.name == name; })) break;
    }
    return name;
}

}  // namespace handrail::learners
