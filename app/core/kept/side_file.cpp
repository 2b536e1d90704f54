#include "app/core/kept/side_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>

#include "app/core/kept/folder_lock.h"
#include "app/core/kept/side_merge.h"
#include "worlds/base/contract.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/overloaded.h"
#include "worlds/base/text.h"

namespace handrail::core {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kLongestFile_bytes = std::size_t{16} << 20;
// A file system allows 255 bytes for a name. The rest is for our extension and the extension of a temporary file.
constexpr std::size_t kLongestFileName_bytes = 220;
constexpr std::string_view kEnding = ".handrail.toml";
constexpr std::size_t kMostNamed = 5;
// Name of the list of marks. Two equal entries in this list are still two different marks.
constexpr std::string_view kMarks = "mark";

std::string checksum_of(std::string_view bytes) {
    auto crc = ::crc32(0, Z_NULL, 0);
    // The bytes are checked in pieces, because zlib counts bytes in 32 bits.
    for (std::size_t at = 0; at < bytes.size(); at += 1U << 30)
        crc = ::crc32(crc, reinterpret_cast<const Bytef*>(bytes.data() + at),
                      static_cast<uInt>(std::min<std::size_t>(bytes.size() - at, 1U << 30)));
    return fmt::format("{:08x}", crc);
}

fs::path beside(const fs::path& world) {
    fs::path path = world;
    path += kEnding;
    return path;
}

// The name contains a checksum of the path, which distinguishes worlds of the same name in different folders.
fs::path in_data_folder(const fs::path& world, const fs::path& folder) {
    std::error_code ec;
    fs::path whole = fs::weakly_canonical(world, ec);
    if (ec) whole = world;
    const std::string name = world.filename().string();
    return folder / "worlds" / fmt::format("{}-{}{}", name.substr(0, 150), checksum_of(whole.string()), kEnding);
}

bool is_there(const fs::path& path) {
    std::error_code ec;
    return fs::exists(fs::symlink_status(path, ec));
}
bool is_link(const fs::path& path) {
    std::error_code ec;
    return fs::is_symlink(path, ec);
}

// Returns true if the folder of `near` can be written, or if there is no other folder to write to.
bool lies_beside(const fs::path& near, const fs::path& far, bool shipped) {
    const fs::path folder = near.has_parent_path() ? near.parent_path() : fs::path(".");
    return far.empty() || (!shipped && near.filename().string().size() <= kLongestFileName_bytes &&
                           ::access(folder.c_str(), W_OK | X_OK) == 0);
}

SideEntry entry_from(const settings::TomlValue& table);
settings::TomlValue table_from(const SideEntry& entry);

SideValue from_toml(const settings::TomlValue& value) {
    if (const auto* v = value.flag()) return *v;
    if (const auto* v = value.whole()) return *v;
    if (const auto* v = value.fraction()) return *v;
    if (const auto* v = value.text()) return *v;
    if (const settings::TomlValue::Array* list = value.array()) {
        std::vector<double> numbers;
        for (const settings::TomlValue& one : *list)
            if (const double* number = one.fraction()) numbers.push_back(*number);
        if (!list->empty() && numbers.size() == list->size()) return numbers;
        if (value.is_tables()) {
            std::vector<SideTable> tables;
            for (const settings::TomlValue& one : *list) tables.push_back({entry_from(one)});
            return tables;
        }
    }
    settings::TomlValue as_it_is = value;
    as_it_is.in_line = value.table() != nullptr;
    return as_it_is;
}

settings::TomlValue toml_from(const SideValue& value) {
    settings::TomlValue made;
    std::visit(Overloaded{[&](const std::vector<double>& numbers) {
                              settings::TomlValue::Array list(numbers.size());
                              for (std::size_t i = 0; i < numbers.size(); ++i) list[i].value = numbers[i];
                              made.value = std::move(list);
                          },
                          [&](const std::vector<SideTable>& tables) {
                              settings::TomlValue::Array list;
                              for (const SideTable& one : tables) list.push_back(table_from(one.entry));
                              made.value = std::move(list);
                          },
                          [&](const settings::TomlValue& as_it_is) { made = as_it_is; },
                          [&](const auto& plain) { made.value = plain; }},
               value);
    return made;
}

SideEntry entry_from(const settings::TomlValue& table) {
    SideEntry entry;
    for (const auto& [key, value] : *table.table()) entry.emplace(key, from_toml(value));
    return entry;
}

settings::TomlValue table_from(const SideEntry& entry) {
    settings::TomlValue table = settings::TomlValue::empty_table();
    for (const auto& [key, value] : entry) table.set(key, toml_from(value));
    return table;
}

bool missing_or_tables(const settings::TomlValue* value) { return !value || value->is_tables(); }
bool missing_or_table(const settings::TomlValue* value) { return !value || value->table(); }

bool alike(const settings::TomlValue* a, const settings::TomlValue* b) {
    return a && b ? same(from_toml(*a), from_toml(*b)) : a == b;
}

std::vector<SideEntry> entries_in(const settings::TomlValue* value) {
    std::vector<SideEntry> entries;
    if (const settings::TomlValue::Array* list = value ? value->array() : nullptr)
        for (const settings::TomlValue& one : *list)
            if (one.table()) entries.push_back(entry_from(one));
    return entries;
}

SideEntry table_in(const settings::TomlValue* value) {
    return value && value->table() ? entry_from(*value) : SideEntry{};
}

void put_list(settings::TomlValue& root, const std::string& name, const std::vector<SideEntry>& entries) {
    if (entries.empty()) return root.erase(name);
    settings::TomlValue::Array tables;
    for (const SideEntry& entry : entries) tables.push_back(table_from(entry));
    settings::TomlValue list;
    list.value = std::move(tables);
    root.set(name, std::move(list));
}

// Lists up to five of `names` in one sentence.
std::string first_names(const std::vector<std::string>& names) {
    const std::size_t count = std::min(names.size(), kMostNamed);
    std::string text =
        fmt::format("{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(count), "; "));
    return names.size() > count ? phrase("side_file.more", {{"names", text}, {"count", names.size() - count}}) : text;
}

// Returns an unused name for a copy next to the file at `path`, or an empty path if none is available.
fs::path kept_name(const fs::path& path) {
    for (int i = 1; i < 1000; ++i) {
        fs::path kept = path;
        kept += i == 1 ? std::string(".damaged") : fmt::format(".damaged-{}", i);
        if (!is_there(kept)) return kept;
    }
    return {};
}

// Returns the content of the side file of `world`, or an empty table.
settings::TomlValue peek_root(const fs::path& world, const fs::path& data_folder, bool shipped,
                              const settings::TomlReader& toml) {
    const fs::path near = beside(world), far = data_folder.empty() ? fs::path() : in_data_folder(world, data_folder);
    for (const fs::path& from : {shipped ? far : near, shipped ? near : far}) {
        if (from.empty() || !is_there(from) || is_link(from)) continue;
        Result<settings::TomlValue> read = toml(read_whole_file(from, kLongestFile_bytes).value_or(""));
        if (read) return std::move(*read);
        // Nothing is announced here, because SideFile::of_world reports the damage. If the parser cannot tell what the
        // file contains, the other file is tried, as in of_world.
        if (read.error().line > 0) break;
    }
    return settings::TomlValue::empty_table();
}

}  // namespace

struct SideFile::Content {
    // The side file is saved as `path`; if the folder of `path` cannot be written, as `other_path`.
    fs::path path, other_path;
    fs::path read_from;  // the file that was read at opening
    std::string checksum;
    settings::TomlReader toml = settings::toml_of;
    settings::TomlValue root = settings::TomlValue::empty_table();
    settings::TomlValue base = settings::TomlValue::empty_table();  // content of the file as it was read or last saved
    std::string saved;                                              // text of `base`
    std::vector<std::string> news;
    TakenOver taken_over;
    // `overwrites`: saving would overwrite a value that is not a list or table of entries.
    bool changed = false, overwrites = false;

    // Copies the whole file to an unused name, and returns the path of the copy.
    static Result<fs::path> keep_aside(const fs::path& file) {
        const fs::path kept = kept_name(file);
        std::error_code ec;
        if (kept.empty() || !fs::copy_file(file, kept, ec))
            return fail(phrase("side_file.not_kept_aside", {{"file", file.filename().string()}}));
        return kept;
    }

    // Merges the content that another session has written into the content of this session.
    settings::TomlValue merged_with(const settings::TomlValue& other, TakenOver& taken) const {
        settings::TomlValue merged = other;
        std::set<std::string> names;
        for (const settings::TomlValue* one : {&base, &root, &other})
            for (const settings::TomlMember& member : *one->table()) names.insert(member.key);
        std::vector<std::string> conflicts, twice;
        for (const std::string& name : names) {
            const settings::TomlValue *before = base.find(name), *here = root.find(name), *there = other.find(name);
            // If both sessions set equal marks, the result has two marks.
            const bool new_marks = name == kMarks && !alike(before, here);
            if (alike(here, there) && !new_marks) continue;
            if (alike(before, here)) {
                taken.differs = true;
            } else if (missing_or_tables(before) && missing_or_tables(here) && missing_or_tables(there)) {
                const MergedEntries list = merge_entries(entries_in(before), entries_in(here), entries_in(there),
                                                         name == kMarks ? Alike::TwoThings : Alike::OneThing);
                put_list(merged, name, list.entries);
                taken.differs |= list.differs;
                for (const std::string& entry : list.conflicts) conflicts.push_back(entry.empty() ? name : entry);
                twice.insert(twice.end(), list.twice.begin(), list.twice.end());
            } else if (missing_or_table(before) && missing_or_table(here) && missing_or_table(there)) {
                const MergedTable table = merge_table(table_in(before), table_in(here), table_in(there));
                if (table.table.empty()) merged.erase(name);
                else merged.set(name, table_from(table.table));
                taken.differs |= table.differs;
                conflicts.insert(conflicts.end(), table.conflicts.begin(), table.conflicts.end());
            } else if (here) {
                merged.set(name, *here);
            } else {
                merged.erase(name);
            }
        }
        if (!conflicts.empty()) taken.news.push_back(phrase("side_file.conflict", {{"names", first_names(conflicts)}}));
        if (!twice.empty()) taken.news.push_back(phrase("side_file.twice", {{"names", first_names(twice)}}));
        return merged;
    }

    // Sets the two possible files of this world, `first` being the preferred one. If `first` is a link and `second` is
    // not, they are swapped, because Handrail never creates links.
    void lies_in(const fs::path& first, const fs::path& second) {
        const bool first_is_link = is_link(first);
        const bool swaps = first_is_link && !second.empty() && !is_link(second);
        path = swaps ? second : first;
        other_path = swaps ? first : second;
        if (first_is_link)
            news.push_back(
                phrase(swaps ? "side_file.link" : "side_file.link_only", {{"file", first.filename().string()}}));
    }

    void belongs_to(const fs::path& world, const fs::path& data_folder, bool shipped) {
        const fs::path near = beside(world),
                       far = data_folder.empty() ? fs::path() : in_data_folder(world, data_folder);
        const bool near_works = lies_beside(near, far, shipped);
        lies_in(near_works ? near : far, near_works ? far : near);
    }

    // Locks the folder of `to`, merges the present content of that file, and writes the result.
    Result<void> write(const fs::path& to) {
        if (is_link(to)) return fail(phrase("files.link"), to.filename().string());
        const fs::path folder = to.has_parent_path() ? to.parent_path() : fs::path(".");
        std::error_code ec;
        // The lock needs the folder. If creating the folder fails, the write below reports the error.
        fs::create_directories(folder, ec);
        const FolderLock lock(folder, kLockWait_s);
        if (lock.held_elsewhere()) return fail(phrase("side_file.locked", {{"file", to.filename().string()}}));
        settings::TomlValue all = root;
        TakenOver taken;
        if (overwrites && to == read_from) {
            if (const auto kept = keep_aside(to); !kept) return tl::unexpected(kept.error());
        }
        if (fs::exists(to, ec)) {
            const auto now = read_whole_file(to, kLongestFile_bytes);
            if (!now) return tl::unexpected(now.error());
            if (*now != saved) {
                if (const Result<settings::TomlValue> other = toml(*now)) {
                    all = merged_with(*other, taken);
                    // The file could not be read, but it may be intact, so it is not overwritten.
                } else if (other.error().line == 0) {
                    return fail(other.error().message, to.filename().string());
                } else {
                    const auto kept = keep_aside(to);
                    if (!kept) return tl::unexpected(kept.error());
                    taken.news.push_back(phrase("side_file.damaged_meanwhile",
                                                {{"line", other.error().line}, {"file", kept->filename().string()}}));
                }
            }
        }
        std::string text = "# What was added to this world in Handrail. Lengths are world metres.\n" +
                           settings::written_toml(all) + "\n";
        // The text is parsed again before it is written, so that memory and file agree, including line numbers.
        // Handrail wrote this text itself, so it is safe to parse it in this process. If memory is short, toml++ 3.3
        // writes fewer digits of a number. The comparison detects that.
        Result<settings::TomlValue> again = settings::toml_of(text);
        if (!again || !same(entry_from(all), entry_from(*again)))
            return fail(phrase("side_file.unwritable"), to.filename().string());
        if (auto written = write_file_atomically(to, text); !written) return written;
        base = *again;
        root = std::move(*again);
        saved = std::move(text);
        read_from = to;
        taken_over.differs |= taken.differs;
        taken_over.news.insert(taken_over.news.end(), taken.news.begin(), taken.news.end());
        changed = overwrites = false;
        return {};
    }

    // Reads the file `from`. Returns false if the parser cannot tell what the file contains. In that case, the file
    // stays as it is, and additions go to the other file.
    bool read(const fs::path& from) {
        const std::string name = from.filename().string();
        std::optional<int> damaged_line;  // line of the damage; no value: the file cannot be read
        if (const auto text = read_whole_file(from, kLongestFile_bytes); text) {
            if (Result<settings::TomlValue> read = toml(*text)) {
                root = std::move(*read);
                base = root;
                saved = *text;
                read_from = from;
                return true;
            } else if (read.error().line == 0) {
                news.push_back(phrase("side_file.unreadable_stays", {{"file", name}}));
                if (path == from && !other_path.empty()) std::swap(path, other_path);
                return false;
            } else {
                damaged_line = read.error().line;
            }
        }
        const fs::path kept = kept_name(from);
        std::error_code ec;
        if (!kept.empty()) fs::rename(from, kept, ec);
        if (!kept.empty() && !ec) {
            const std::string kept_as = kept.filename().string();
            news.push_back(damaged_line ? phrase("side_file.damaged_kept", {{"line", *damaged_line}, {"file", kept_as}})
                                        : phrase("side_file.unreadable_kept", {{"file", kept_as}}));
            return true;
        }
        // The damaged file could not be renamed, so it must not be overwritten.
        news.push_back(damaged_line ? phrase("side_file.damaged_stays", {{"line", *damaged_line}, {"file", name}})
                                    : phrase("side_file.unreadable_stays", {{"file", name}}));
        if (path == from) std::swap(path, other_path);
        if (path == from || path.empty()) path = kept;
        return true;
    }
};

SideFile::SideFile() : content_(std::make_unique<Content>()) {}
SideFile::~SideFile() = default;
SideFile::SideFile(SideFile&&) noexcept = default;
SideFile& SideFile::operator=(SideFile&&) noexcept = default;

SideFile SideFile::of_world(const fs::path& world, const fs::path& data_folder, bool shipped,
                            settings::TomlReader toml) {
    SideFile file;
    Content& content = *file.content_;
    content.toml = std::move(toml);
    content.checksum = checksum_of_world(world);
    content.belongs_to(world, data_folder, shipped);
    // After the file was opened, the folder may have become writable or read-only. So both files are tried.
    for (const fs::path& from : {fs::path(content.path), fs::path(content.other_path)})
        if (!from.empty() && is_there(from) && !is_link(from) && content.read(from)) break;
    return file;
}

fs::path SideFile::path_of(const fs::path& world, const fs::path& data_folder, bool shipped) {
    Content content;
    content.belongs_to(world, data_folder, shipped);
    return content.path;
}

std::string SideFile::checksum_of_world(const fs::path& world) {
    const auto bytes = read_whole_file(world);
    return bytes ? checksum_of(*bytes) : std::string();
}

SideEntry SideFile::peek(const fs::path& world, const fs::path& data_folder, bool shipped, const std::string& name,
                         const settings::TomlReader& toml) {
    const settings::TomlValue root = peek_root(world, data_folder, shipped, toml);
    return table_in(root.find(name));
}

std::vector<SideEntry> SideFile::peek_entries(const fs::path& world, const fs::path& data_folder, bool shipped,
                                              const std::string& name, const settings::TomlReader& toml) {
    const settings::TomlValue root = peek_root(world, data_folder, shipped, toml);
    return entries_in(root.find(name));
}

// Errors in the text are ignored in these two, because SideFile::of_world reports them.
SideEntry SideFile::table_of_text(const std::string& text, const std::string& name) {
    const Result<settings::TomlValue> read = settings::toml_of(text);
    return read ? table_in(read->find(name)) : SideEntry{};
}

std::vector<SideEntry> SideFile::entries_of_text(const std::string& text, const std::string& name) {
    const Result<settings::TomlValue> read = settings::toml_of(text);
    return read ? entries_in(read->find(name)) : std::vector<SideEntry>{};
}

const std::vector<std::string>& SideFile::news() const { return content_->news; }
const fs::path& SideFile::path() const { return content_->path; }
const std::string& SideFile::world_checksum() const { return content_->checksum; }

std::vector<SideEntry> SideFile::entries(const std::string& name) const {
    return entries_in(content_->root.find(name));
}

void SideFile::set_entries(const std::string& name, const std::vector<SideEntry>& entries) {
    contract_pre(!name.empty());
    if (fault_of_list(name) && !content_->read_from.empty()) content_->overwrites = true;
    put_list(content_->root, name, entries);
    content_->changed = true;
}

std::optional<Error> SideFile::fault_of_list(const std::string& name) const {
    const settings::TomlValue* value = content_->root.find(name);
    const settings::TomlValue::Array* list = value ? value->array() : nullptr;
    const bool fits = !value || (list && std::all_of(list->begin(), list->end(), [](const settings::TomlValue& one) {
                                     return one.table() != nullptr;
                                 }));
    if (fits) return std::nullopt;
    return Error{
        content_->read_from.filename().string(), value->line, 0,
        phrase("side_file.no_list", {{"list", name}, {"file", kept_name(content_->read_from).filename().string()}})};
}

Error SideFile::fault_in(const std::string& name, std::size_t entry, std::string message) const {
    Error fault{content_->read_from.filename().string(), 0, 0, std::move(message)};
    const settings::TomlValue* value = content_->root.find(name);
    if (const settings::TomlValue::Array* list = value ? value->array() : nullptr)
        for (const settings::TomlValue& one : *list)
            if (one.table() && entry-- == 0) fault.line = one.line;
    return fault;
}

SideEntry SideFile::table(const std::string& name) const { return table_in(content_->root.find(name)); }

void SideFile::set_table(const std::string& name, const SideEntry& table) {
    contract_pre(!name.empty());
    if (const settings::TomlValue* value = content_->root.find(name);
        value && !value->table() && !content_->read_from.empty())
        content_->overwrites = true;
    if (table.empty()) content_->root.erase(name);
    else content_->root.set(name, table_from(table));
    content_->changed = true;
}

Result<void> SideFile::save() {
    Content& content = *content_;
    if (!content.changed || content.path.empty()) return {};
    Result<void> written = content.write(content.path);
    if (!written && !content.other_path.empty() && !is_there(content.other_path)) {
        if (const auto elsewhere = content.write(content.other_path)) {
            std::swap(content.path, content.other_path);
            written = elsewhere;
        }
    }
    return written;
}

SideFile::TakenOver SideFile::take_over() { return std::exchange(content_->taken_over, {}); }

std::string unreadable_words(std::string_view key, const std::vector<Error>& faults) {
    return faults.empty() ? std::string()
                          : phrase(key, {{"fault", faults.front().sentence()}, {"more", faults.size() - 1}});
}

std::string unfit_words(std::string_view key, const std::vector<std::string>& unfit, std::size_t all) {
    if (unfit.empty()) return {};
    return phrase(key, {{"count", unfit.size()}, {"all", all}, {"names", first_names(unfit)}});
}

fs::path user_data_folder() {
    // The XDG Base Directory Specification says that a relative XDG_DATA_HOME must be ignored.
    const char* data = std::getenv("XDG_DATA_HOME");
    if (data && data[0] == '/') return fs::path(data) / "handrail";
    const char* home = std::getenv("HOME");
    if (home && home[0] == '/') return fs::path(home) / ".local" / "share" / "handrail";
    return {};
}

fs::path user_data_folder(std::string_view name) {
    const fs::path folder = user_data_folder();
    return folder.empty() ? folder : folder / name;
}

}  // namespace handrail::core
