// What a person adds to a world - marks, names of rooms, ways - is kept beside it in one TOML file:
// house.map.handrail.toml. Where that folder cannot be written it lies in the person's own data folder. A world without
// a file (a test, a scenario) keeps its additions in memory. Each topic owns its lists and tables by name and leaves
// the others alone; what nobody here knows stays in the file. App thread only. Two sessions in one world keep both
// their additions: saving holds a lock on the folder, reads again what stands there, and merges by entry
// (side_merge.h). Cost: opening and saving are a few hundred microseconds, and reading the world's bytes once for its
// checksum; a save waits at most kLockWait_s for another session's.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "settings/toml_value.h"
#include "worlds/base/result.h"
#include "worlds/base/variant.h"
#include "worlds/base/vec.h"

namespace handrail {

struct SideTable;
// The last is what none of the others is: kept and written back as it was.
using SideValue =
    CopyableVariant<bool, std::int64_t, double, std::string, std::vector<double>, std::vector<SideTable>, TomlValue>;
using SideEntry = std::map<std::string, SideValue>;
// One of the tables of a list inside an entry: the [[way.stop]] of a [[way]].
struct SideTable {
    SideEntry entry;
    bool operator==(const SideTable&) const = default;
};

// Of an entry; the second argument where it is missing or of another kind. Numbers that are not finite count as
// missing.
std::string text_of(const SideEntry& entry, const std::string& key, const std::string& otherwise = {});
double number_of(const SideEntry& entry, const std::string& key, double otherwise);
// Exactly `count` finite numbers, or none.
std::vector<double> numbers_of(const SideEntry& entry, const std::string& key, std::size_t count);
// The place under "place_m", world metres; none where it is missing or of another kind.
std::optional<Vec3> place_of(const SideEntry& entry);
void put_place(SideEntry& entry, const Vec3& place_m);
// What of an entry a reader does not know, to be handed back.
SideEntry without(SideEntry entry, std::initializer_list<const char*> known);

// A name as a person may give one: one line of UTF-8, 1 to 200 bytes. Says what is wrong with it.
inline constexpr std::size_t kLongestName_bytes = 200;
Result<std::string> good_name(std::string_view typed);
// Name and place of an entry that must have both. Else fails with the phrase `no_name`, or `no_place`, which tells the
// name.
struct NamedPlace {
    std::string name;
    Vec3 place_m{0.0};
};
Result<NamedPlace> named_place_of(const SideEntry& entry, std::string_view no_name, std::string_view no_place);

class SideFile {
public:
    static constexpr double kLockWait_s = 0.3;

    SideFile();  // in memory only: nothing is read, saving succeeds and writes nothing
    ~SideFile();
    SideFile(SideFile&&) noexcept;
    SideFile& operator=(SideFile&&) noexcept;

    // The file that belongs to `world`. A file that cannot be understood is kept under another name and the additions
    // start empty; news() says so. shipped: the world is the program's own, so what is added to it belongs into the
    // data folder whatever can be written. `toml` parses it, now and whenever save() finds what another session has
    // written. Where that cannot say what the file holds, the file stays as it is and the additions go elsewhere.
    static SideFile of_world(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                             bool shipped = false, TomlReader toml = toml_of);

    // path() of it, and world_checksum(), of which neither needs to be parsed.
    static std::filesystem::path path_of(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                         bool shipped = false);
    static std::string checksum_of_world(const std::filesystem::path& world);

    // The table [name] of the file that belongs to `world`, before it is opened for good: nothing is written, renamed
    // or said. None, or nothing to be understood: empty. Any thread.
    static SideEntry peek(const std::filesystem::path& world, const std::filesystem::path& data_folder, bool shipped,
                          const std::string& name, const TomlReader& toml = toml_of);

    // The table [name] of such a file's text; none, or nothing to be understood: empty. Any thread.
    static SideEntry table_of_text(const std::string& text, const std::string& name);

    // One sentence each about what could not be read; fit to be spoken.
    const std::vector<std::string>& news() const;
    // Where save() writes; empty: in memory.
    const std::filesystem::path& path() const;
    // Of the world's bytes, eight hex digits; empty where there is no file.
    const std::string& world_checksum() const;

    // [[name]] tables, in their order; none: empty. Keys that the caller does not know come along and are to be handed
    // back.
    std::vector<SideEntry> entries(const std::string& name) const;
    void set_entries(const std::string& name, const std::vector<SideEntry>& entries);
    // What stands under the name where that is no list of tables, with file and line; saving other entries in its place
    // keeps the whole file aside first.
    std::optional<Error> fault_of_list(const std::string& name) const;
    // What is wrong with one of entries(), with the file and the line where it begins; no line where it was not read
    // from a file.
    Error fault_in(const std::string& name, std::size_t entry, std::string message) const;
    // The table [name]; none: empty.
    SideEntry table(const std::string& name) const;
    void set_table(const std::string& name, const SideEntry& table);

    // Writes all of it atomically, if anything changed, together with what another session has written since; that is
    // in entries() and table() from then on. Where the world's folder refuses, the data folder takes it; fails with a
    // sentence only when that refuses too.
    Result<void> save();
    // What save() took over from another session since this was last asked.
    struct TakenOver {
        bool differs = false;           // entries or tables are not what was set here
        std::vector<std::string> news;  // one sentence each about what both changed
    };
    TakenOver take_over();

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

// The entries of a list as `from` reads them (a Result), in the order of the file. Those it makes nothing of are left
// out and stay in the file; `faults` gets each with file and line.
template <class From>
auto read_list(const SideFile& file, const std::string& name, From from, std::vector<Error>& faults) {
    std::vector<typename decltype(from(SideEntry{}))::value_type> all;
    const std::vector<SideEntry> entries = file.entries(name);
    faults.clear();
    if (auto fault = file.fault_of_list(name)) faults.push_back(std::move(*fault));
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (auto one = from(entries[i])) all.push_back(std::move(*one));
        else faults.push_back(file.fault_in(name, i, one.error().message));
    }
    return all;
}
// What could not be read, as the text `key` says it: the first with {fault}, and how many {more}; empty where there is
// none.
std::string unreadable_words(std::string_view key, const std::vector<Error>& faults);
// Writes them as `to` makes entries of them, and after them what `from` could not read.
template <class T, class To, class From>
void write_list(SideFile& file, const std::string& name, const std::vector<T>& all, To to, From from) {
    std::vector<SideEntry> entries;
    for (const T& one : all) entries.push_back(to(one));
    for (const SideEntry& entry : file.entries(name))
        if (!from(entry)) entries.push_back(entry);
    file.set_entries(name, entries);
}

// Which of `all` additions no longer fit the world, the first five by name, as the text `key` says it with {count},
// {all} and {names}; empty where all fit.
std::string unfit_words(std::string_view key, const std::vector<std::string>& unfit, std::size_t all);

// $XDG_DATA_HOME/handrail, else ~/.local/share/handrail; empty when neither is known.
std::filesystem::path user_data_folder();
// A folder in it, whether it exists or not. Empty if there is no user_data_folder(): a relative path would be looked
// for in whatever folder the program was started in.
std::filesystem::path user_data_folder(std::string_view name);

}  // namespace handrail
