#include "app/core/kept/side_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>
#include <sstream>

#include "app/core/kept/folder_lock.h"
#include "app/core/kept/side_merge.h"
#include "settings/parse_toml.h"
#include "worlds/base/contract.h"
#include "worlds/base/files.h"
#include "worlds/base/language.h"
#include "worlds/base/overloaded.h"
#include "worlds/base/text.h"

namespace handrail {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kLongestFile_bytes = std::size_t{16} << 20;
constexpr std::size_t kLongestFileName_bytes = 220;  // of 255, less our ending and that of a file being written
constexpr std::string_view kEnding = ".handrail.toml";
constexpr std::size_t kMostTold = 5;
constexpr std::string_view kMarks = "mark";  // the list of which each entry is a thing of its own

std::string checksum_of(std::string_view bytes) {
    auto crc = ::crc32(0, Z_NULL, 0);
    // In pieces, as zlib counts bytes in 32 bits.
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

// Worlds of one name in different folders stay apart.
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

// True where the folder of `near` can be written, or there is nowhere else.
bool lies_beside(const fs::path& near, const fs::path& far, bool shipped) {
    const fs::path folder = near.has_parent_path() ? near.parent_path() : fs::path(".");
    return far.empty() || (!shipped && near.filename().string().size() <= kLongestFileName_bytes &&
                           ::access(folder.c_str(), W_OK | X_OK) == 0);
}

SideEntry entry_from(const toml::table& table);
toml::table table_from(const SideEntry& entry);

SideValue from_toml(const toml::node& node) {
    if (const auto* v = node.as_boolean()) return v->get();
    if (const auto* v = node.as_integer()) return v->get();
    if (const auto* v = node.as_floating_point()) return v->get();
    if (const auto* v = node.as_string()) return v->get();
    if (const toml::array* list = node.as_array()) {
        std::vector<double> numbers;
        for (const toml::node& one : *list)
            if (one.is_floating_point()) numbers.push_back(*one.value<double>());
        if (!list->empty() && numbers.size() == list->size()) return numbers;
        if (list->is_array_of_tables()) {
            std::vector<SideTable> tables;
            for (const toml::node& one : *list) tables.push_back({entry_from(*one.as_table())});
            return tables;
        }
    }
    std::ostringstream out;
    out.exceptions(std::ios::badbit);  // or a want of memory would cut the text short
    if (const toml::table* table = node.as_table()) {
        toml::table inline_one = *table;
        inline_one.is_inline(true);
        out << toml::toml_formatter{inline_one, toml::format_flags::none};
    } else {
        out << toml::toml_formatter{node, toml::format_flags::none};
    }
    return SideText{out.str()};
}

void put(toml::table& table, const std::string& key, const SideValue& value) {
    std::visit(Overloaded{[&](const std::vector<double>& numbers) {
                              toml::array list;
                              for (const double number : numbers) list.push_back(number);
                              table.insert_or_assign(key, std::move(list));
                          },
                          [&](const std::vector<SideTable>& tables) {
                              toml::array list;
                              for (const SideTable& one : tables) list.push_back(table_from(one.entry));
                              table.insert_or_assign(key, std::move(list));
                          },
                          [&](const SideText& text) {
                              try {
                                  toml::table parsed = toml::parse("v = " + text.toml);
                                  table.insert_or_assign(key, *parsed.get("v"));
                              } catch (const toml::parse_error&) {  // not from a file of ours; there is nothing to keep
                              }
                          },
                          [&](const auto& plain) { table.insert_or_assign(key, plain); }},
               value);
}

SideEntry entry_from(const toml::table& table) {
    SideEntry entry;
    for (const auto& [key, node] : table) entry.emplace(std::string(key.str()), from_toml(node));
    return entry;
}

toml::table table_from(const SideEntry& entry) {
    toml::table table;
    for (const auto& [key, value] : entry) put(table, key, value);
    return table;
}

bool missing_or_tables(const toml::node* node) { return !node || node->is_array_of_tables(); }
bool missing_or_table(const toml::node* node) { return !node || node->is_table(); }

bool alike(const toml::node* a, const toml::node* b) { return a && b ? same(from_toml(*a), from_toml(*b)) : a == b; }

std::vector<SideEntry> entries_in(const toml::node* node) {
    std::vector<SideEntry> entries;
    if (const toml::array* list = node ? node->as_array() : nullptr)
        for (const toml::node& one : *list)
            if (const toml::table* table = one.as_table()) entries.push_back(entry_from(*table));
    return entries;
}

SideEntry table_in(const toml::node* node) {
    const toml::table* table = node ? node->as_table() : nullptr;
    return table ? entry_from(*table) : SideEntry{};
}

void put_list(toml::table& root, const std::string& name, const std::vector<SideEntry>& entries) {
    toml::array list;
    for (const SideEntry& entry : entries) list.push_back(table_from(entry));
    if (list.empty()) root.erase(name);
    else root.insert_or_assign(name, std::move(list));
}

// Up to five of them, in one sentence.
std::string told(const std::vector<std::string>& names) {
    const std::size_t count = std::min(names.size(), kMostTold);
    std::string text =
        fmt::format("{}", fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(count), "; "));
    return names.size() > count ? phrase("side_file.more", {{"names", text}, {"count", names.size() - count}}) : text;
}

// A name beside the file that nothing has yet; empty where there is none to be had.
fs::path kept_name(const fs::path& path) {
    for (int i = 1; i < 1000; ++i) {
        fs::path kept = path;
        kept += i == 1 ? std::string(".damaged") : fmt::format(".damaged-{}", i);
        if (!is_there(kept)) return kept;
    }
    return {};
}

}  // namespace

struct SideFile::Content {
    fs::path path, other_path;  // where it is saved, and where when that folder refuses
    fs::path read_from;         // the file that was read
    std::string checksum;
    toml::table root;
    toml::table base;   // as it was read or last saved
    std::string saved;  // the text of that
    std::vector<std::string> news;
    TakenOver taken_over;
    bool changed = false, overwrites = false;  // overwrites: what no entry stands for

    // The whole file, under another name.
    static Result<fs::path> keep_aside(const fs::path& file) {
        const fs::path kept = kept_name(file);
        std::error_code ec;
        if (kept.empty() || !fs::copy_file(file, kept, ec))
            return fail(phrase("side_file.not_kept_aside", {{"file", file.filename().string()}}));
        return kept;
    }

    // What another session has written since into what is here.
    toml::table merged_with(const toml::table& other, TakenOver& taken) const {
        toml::table merged = other;
        std::set<std::string> names;
        for (const toml::table* one : {&base, &root, &other})
            for (const auto& [name, node] : *one) names.emplace(name.str());
        std::vector<std::string> conflicts, twice;
        for (const std::string& name : names) {
            const toml::node *before = base.get(name), *here = root.get(name), *there = other.get(name);
            // Marks that both sessions have set alike are two.
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
                else merged.insert_or_assign(name, table_from(table.table));
                taken.differs |= table.differs;
                conflicts.insert(conflicts.end(), table.conflicts.begin(), table.conflicts.end());
            } else if (here) {
                merged.insert_or_assign(name, *here);
            } else {
                merged.erase(name);
            }
        }
        if (!conflicts.empty()) taken.news.push_back(phrase("side_file.conflict", {{"names", told(conflicts)}}));
        if (!twice.empty()) taken.news.push_back(phrase("side_file.twice", {{"names", told(twice)}}));
        return merged;
    }

    // Files that may be this world's, the preferred one first. A link in place of one was not put there by Handrail.
    void lies_in(const fs::path& first, const fs::path& second) {
        const bool first_is_link = is_link(first);
        const bool swaps = first_is_link && !second.empty() && !is_link(second);
        path = swaps ? second : first;
        other_path = swaps ? first : second;
        if (first_is_link)
            news.push_back(
                phrase(swaps ? "side_file.link" : "side_file.link_only", {{"file", first.filename().string()}}));
    }

    // Under the lock of its folder, merged with what stands there.
    Result<void> write(const fs::path& to) {
        if (is_link(to)) return fail(phrase("files.link"), to.filename().string());
        const fs::path folder = to.has_parent_path() ? to.parent_path() : fs::path(".");
        std::error_code ec;
        fs::create_directories(folder, ec);  // a lock needs it; what is wrong with it writing tells
        const FolderLock lock(folder, kLockWait_s);
        if (lock.held_elsewhere()) return fail(phrase("side_file.locked", {{"file", to.filename().string()}}));
        toml::table all = root;
        TakenOver taken;
        if (overwrites && to == read_from) {
            if (const auto kept = keep_aside(to); !kept) return tl::unexpected(kept.error());
        }
        if (fs::exists(to, ec)) {
            const auto now = read_whole_file(to, kLongestFile_bytes);
            if (!now) return tl::unexpected(now.error());
            if (*now != saved) {
                try {
                    all = merged_with(parse_toml(*now), taken);
                } catch (const toml::parse_error& error) {
                    const auto kept = keep_aside(to);
                    if (!kept) return tl::unexpected(kept.error());
                    taken.news.push_back(phrase("side_file.damaged_meanwhile", {{"line", error.source().begin.line},
                                                                                {"file", kept->filename().string()}}));
                }
            }
        }
        std::ostringstream out;
        out.exceptions(std::ios::badbit);
        out << "# What was added to this world in Handrail. Lengths are world metres.\n"
            << toml::toml_formatter{all, toml::format_flags::none} << "\n";
        std::string text = out.str();
        // Read back before it is written, so that what is kept here afterwards is what stands in the file, with its
        // lines.
        toml::table again;
        try {
            again = parse_toml(text);
        } catch (const toml::parse_error&) {
            return fail(phrase("side_file.unwritable"), to.filename().string());
        }
        // Where memory is short toml++ 3.3 writes fewer digits of a number.
        if (!same(entry_from(all), entry_from(again)))
            return fail(phrase("side_file.unwritable"), to.filename().string());
        if (auto written = write_file_atomically(to, text); !written) return written;
        base = again;
        root = std::move(again);
        saved = std::move(text);
        read_from = to;
        taken_over.differs |= taken.differs;
        taken_over.news.insert(taken_over.news.end(), taken.news.begin(), taken.news.end());
        changed = overwrites = false;
        return {};
    }

    void read(const fs::path& from) {
        const std::string name = from.filename().string();
        std::optional<std::uint32_t> damaged_line;  // else it cannot be read
        if (const auto text = read_whole_file(from, kLongestFile_bytes); text) {
            try {
                root = parse_toml(*text);
                base = root;
                saved = *text;
                read_from = from;
                return;
            } catch (const toml::parse_error& error) {
                damaged_line = error.source().begin.line;
            }
        }
        const fs::path kept = kept_name(from);
        std::error_code ec;
        if (!kept.empty()) fs::rename(from, kept, ec);
        if (!kept.empty() && !ec) {
            const std::string kept_as = kept.filename().string();
            news.push_back(damaged_line ? phrase("side_file.damaged_kept", {{"line", *damaged_line}, {"file", kept_as}})
                                        : phrase("side_file.unreadable_kept", {{"file", kept_as}}));
            return;
        }
        // It stays where it is and must not be written over.
        news.push_back(damaged_line ? phrase("side_file.damaged_stays", {{"line", *damaged_line}, {"file", name}})
                                    : phrase("side_file.unreadable_stays", {{"file", name}}));
        if (path == from) std::swap(path, other_path);
        if (path == from || path.empty()) path = kept;
    }
};

SideFile::SideFile() : content_(std::make_unique<Content>()) {}
SideFile::~SideFile() = default;
SideFile::SideFile(SideFile&&) noexcept = default;
SideFile& SideFile::operator=(SideFile&&) noexcept = default;

SideFile SideFile::of_world(const fs::path& world, const fs::path& data_folder, bool shipped) {
    SideFile file;
    Content& content = *file.content_;
    if (const auto bytes = read_whole_file(world)) content.checksum = checksum_of(*bytes);
    const fs::path near = beside(world), far = data_folder.empty() ? fs::path() : in_data_folder(world, data_folder);
    const bool near_works = lies_beside(near, far, shipped);
    content.lies_in(near_works ? near : far, near_works ? far : near);
    // A folder that could not be written when something was added may be writable now, and the other way round.
    for (const fs::path& from : {content.path, content.other_path})
        if (!from.empty() && is_there(from) && !is_link(from)) {
            content.read(from);
            break;
        }
    return file;
}

SideEntry SideFile::peek(const fs::path& world, const fs::path& data_folder, bool shipped, const std::string& name) {
    const fs::path near = beside(world), far = data_folder.empty() ? fs::path() : in_data_folder(world, data_folder);
    for (const fs::path& from : {shipped ? far : near, shipped ? near : far}) {
        if (from.empty() || !is_there(from) || is_link(from)) continue;
        return table_of_text(read_whole_file(from, kLongestFile_bytes).value_or(""), name);
    }
    return {};
}

SideEntry SideFile::table_of_text(std::string_view text, const std::string& name) {
    try {
        return table_in(toml::parse(text).get(name));
    } catch (const toml::parse_error&) {
        return {};  // of_world says so
    }
}

const std::vector<std::string>& SideFile::news() const { return content_->news; }
const fs::path& SideFile::path() const { return content_->path; }
const std::string& SideFile::world_checksum() const { return content_->checksum; }

std::vector<SideEntry> SideFile::entries(const std::string& name) const { return entries_in(content_->root.get(name)); }

void SideFile::set_entries(const std::string& name, const std::vector<SideEntry>& entries) {
    contract_pre(!name.empty());
    if (fault_of_list(name) && !content_->read_from.empty()) content_->overwrites = true;
    put_list(content_->root, name, entries);
    content_->changed = true;
}

std::optional<Error> SideFile::fault_of_list(const std::string& name) const {
    const toml::node* node = content_->root.get(name);
    const toml::array* list = node ? node->as_array() : nullptr;
    const bool fits = !node || (list && std::all_of(list->begin(), list->end(),
                                                    [](const toml::node& one) { return one.is_table(); }));
    if (fits) return std::nullopt;
    return Error{
        content_->read_from.filename().string(), static_cast<int>(node->source().begin.line), 0,
        phrase("side_file.no_list", {{"list", name}, {"file", kept_name(content_->read_from).filename().string()}})};
}

Error SideFile::fault_in(const std::string& name, std::size_t entry, std::string message) const {
    Error fault{content_->read_from.filename().string(), 0, 0, std::move(message)};
    if (const toml::array* list = content_->root[name].as_array())
        for (const toml::node& node : *list)
            if (node.is_table() && entry-- == 0) fault.line = static_cast<int>(node.source().begin.line);
    return fault;
}

SideEntry SideFile::table(const std::string& name) const { return table_in(content_->root.get(name)); }

void SideFile::set_table(const std::string& name, const SideEntry& table) {
    contract_pre(!name.empty());
    if (const toml::node* node = content_->root.get(name); node && !node->is_table() && !content_->read_from.empty())
        content_->overwrites = true;
    if (table.empty()) content_->root.erase(name);
    else content_->root.insert_or_assign(name, table_from(table));
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
    return phrase(key, {{"count", unfit.size()}, {"all", all}, {"names", told(unfit)}});
}

fs::path user_data_folder() {
    // The base directory specification says: only an absolute XDG_DATA_HOME counts.
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

}  // namespace handrail
