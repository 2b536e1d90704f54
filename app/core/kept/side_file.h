// What a person adds to a world (marks, names of rooms, saved routes), in one TOML file next to the world:
// house.map.handrail.toml. If that folder cannot be written, the file is in the person's own data folder. A world
// without a file, as in tests and scenarios, keeps its additions in memory.
// Each topic owns its lists and tables by name and does not touch the others; unknown content stays in the file. App
// thread only.
// Two sessions in one world both keep their additions: saving locks the folder, reads the file again, and merges entry
// by entry (side_merge.h).
// Cost: opening and saving take a few hundred microseconds, and opening also reads the whole world file for its
// checksum. A save waits at most kLockWait_s for another session.
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

namespace handrail::core {

struct SideTable;
// TomlValue holds whatever is none of the other types; it is kept and written back unchanged.
using SideValue = CopyableVariant<bool, std::int64_t, double, std::string, std::vector<double>, std::vector<SideTable>,
                                  settings::TomlValue>;
using SideEntry = std::map<std::string, SideValue>;
// A table in a list inside an entry, such as [[way.stop]] in a [[way]].
struct SideTable {
    SideEntry entry;
    bool operator==(const SideTable&) const = default;
};

// The value of a key, or `otherwise` if it is missing or of another type. Numbers that are not finite count as missing.
std::string text_of(const SideEntry& entry, const std::string& key, const std::string& otherwise = {});
double number_of(const SideEntry& entry, const std::string& key, double otherwise);
// Exactly `count` finite numbers, or an empty vector.
std::vector<double> numbers_of(const SideEntry& entry, const std::string& key, std::size_t count);
// The place under "place_m", world metres; no value if it is missing or of another type.
std::optional<Vec3> place_of(const SideEntry& entry);
void put_place(SideEntry& entry, const Vec3& place_m);
// The keys that a reader does not know, to be written back later.
SideEntry without(SideEntry entry, std::initializer_list<const char*> known);

// Checks a name that a person gives: one line of UTF-8, 1 to 200 bytes. The error says what is wrong.
inline constexpr std::size_t kLongestName_bytes = 200;
Result<std::string> good_name(std::string_view typed);
// Name and place of an entry that must have both. Otherwise it fails with the phrase `no_name`, or with `no_place`,
// which includes the name.
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

    // Opens the file that belongs to `world`. A damaged file is kept under another name, and the additions start empty;
    // news() says so. shipped: the world came with the program, so additions always go to the data folder. `toml`
    // parses the file, now and whenever save() finds changes by another session. If it cannot tell what the file
    // contains, the file stays untouched and additions go elsewhere.
    static SideFile of_world(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                             bool shipped = false, settings::TomlReader toml = settings::toml_of);

    // The same as path() and world_checksum() of an opened file, but without parsing it.
    static std::filesystem::path path_of(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                         bool shipped = false);
    static std::string checksum_of_world(const std::filesystem::path& world);

    // Reads the table [name] of the file that belongs to `world` without opening it for use: nothing is written,
    // renamed or announced. Empty if there is no such table or the file is damaged. Any thread.
    static SideEntry peek(const std::filesystem::path& world, const std::filesystem::path& data_folder, bool shipped,
                          const std::string& name, const settings::TomlReader& toml = settings::toml_of);

    // The table [name] in the text of a side file; empty if there is none or the text is damaged. Any thread.
    static SideEntry table_of_text(const std::string& text, const std::string& name);

    // One sentence, fit to be spoken, for each part that could not be read.
    const std::vector<std::string>& news() const;
    // Where save() writes; empty: in memory only.
    const std::filesystem::path& path() const;
    // Checksum of the world's bytes, eight hex digits; empty if there is no file.
    const std::string& world_checksum() const;

    // The [[name]] tables in their order; empty if there are none. They include keys that the caller does not know;
    // hand these back in set_entries().
    std::vector<SideEntry> entries(const std::string& name) const;
    void set_entries(const std::string& name, const std::vector<SideEntry>& entries);
    // An error with file and line if `name` is not a list of tables. Saving entries there anyway first keeps a copy of
    // the whole file.
    std::optional<Error> fault_of_list(const std::string& name) const;
    // An error about one of entries(), with file and first line; without a line if the entry did not come from a file.
    Error fault_in(const std::string& name, std::size_t entry, std::string message) const;
    // The table [name]; empty if there is none.
    SideEntry table(const std::string& name) const;
    void set_table(const std::string& name, const SideEntry& table);

    // Writes everything atomically if anything has changed, merged with what another session has written meanwhile;
    // from then on entries() and table() include that. If the world's folder cannot be written, the data folder is
    // used. Fails with a sentence only if that fails too.
    Result<void> save();
    // What save() took over from another session since the last call.
    struct TakenOver {
        bool differs = false;           // entries or tables are no longer what this session set
        std::vector<std::string> news;  // one sentence each about what both sessions changed
    };
    TakenOver take_over();

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

// The entries of a list in the order of the file, converted by `from`, which returns a Result. Entries that it rejects
// are left out but stay in the file; `faults` receives an error with file and line for each.
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
// The sentence about unreadable entries from the text `key`, with the first error as {fault} and the number of others
// as {more}. Empty if there are none.
std::string unreadable_words(std::string_view key, const std::vector<Error>& faults);
// Writes the items as entries made by `to`, followed by the entries that `from` could not read.
template <class T, class To, class From>
void write_list(SideFile& file, const std::string& name, const std::vector<T>& all, To to, From from) {
    std::vector<SideEntry> entries;
    for (const T& one : all) entries.push_back(to(one));
    for (const SideEntry& entry : file.entries(name))
        if (!from(entry)) entries.push_back(entry);
    file.set_entries(name, entries);
}

// The sentence on additions that no longer fit the world, from the text `key` with {count}, {all} and {names}, which
// lists the first five. Empty if all fit.
std::string unfit_words(std::string_view key, const std::vector<std::string>& unfit, std::size_t all);

// $XDG_DATA_HOME/handrail, else ~/.local/share/handrail; empty if neither is known.
std::filesystem::path user_data_folder();
// A folder inside it, whether it exists or not. Empty if there is no user_data_folder(), because a relative path would
// depend on the program's working directory.
std::filesystem::path user_data_folder(std::string_view name);

}  // namespace handrail::core
