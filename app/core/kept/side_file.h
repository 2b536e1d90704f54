// Reads and writes the side file of a world, which contains what a person adds to the world: marks, names of rooms, and
// saved routes. It is one TOML file next to the world's file, such as house.map.handrail.toml. If that folder cannot be
// written, the side file is in the person's own data folder. A world without a file, as in tests and scenarios, keeps
// its additions in memory. Each feature owns its lists and tables by name and does not touch the others. Unknown
// content stays in the file. Use this class on the app thread only. Two sessions in the same world both keep their
// additions: saving locks the folder, reads the file again and merges it entry by entry (side_merge.h). Opening and
// saving cost a few hundred microseconds each. Opening also reads the whole file of the world for its checksum. A save
// waits at most kLockWait_s for another session.
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
// A value of any other type is stored as a TomlValue, and written back unchanged.
using SideValue = CopyableVariant<bool, std::int64_t, double, std::string, std::vector<double>, std::vector<SideTable>,
                                  settings::TomlValue>;
using SideEntry = std::map<std::string, SideValue>;
// A table in a list inside an entry, such as [[way.stop]] in [[way]].
struct SideTable {
    SideEntry entry;
    bool operator==(const SideTable&) const = default;
};

// Return the value of a key. If the value is missing or of another type, they return `otherwise`. A number that is not
// finite is treated as missing.
std::string text_of(const SideEntry& entry, const std::string& key, const std::string& otherwise = {});
double number_of(const SideEntry& entry, const std::string& key, double otherwise);
// Returns the numbers of a key, or an empty vector unless they are exactly `count` finite numbers.
std::vector<double> numbers_of(const SideEntry& entry, const std::string& key, std::size_t count);
// Returns the place under the key "place_m" in world metres, or no value if the place is missing or of another type.
std::optional<Vec3> place_of(const SideEntry& entry);
void put_place(SideEntry& entry, const Vec3& place_m);
// Returns the entry without the `known` keys, so that the unknown ones can be written back later.
SideEntry without(SideEntry entry, std::initializer_list<const char*> known);

// Checks a name that a person gives: one line of UTF-8 with 1 to 200 bytes. The error says what is wrong.
inline constexpr std::size_t kLongestName_bytes = 200;
Result<std::string> good_name(std::string_view typed);
// Returns the name and the place of an entry, which must have both. Otherwise it fails with the phrase `no_name`, or
// with the phrase `no_place`, which contains the name.
struct NamedPlace {
    std::string name;
    Vec3 place_m{0.0};
};
Result<NamedPlace> named_place_of(const SideEntry& entry, std::string_view no_name, std::string_view no_place);

class SideFile {
public:
    static constexpr double kLockWait_s = 0.3;

    SideFile();  // Keeps additions in memory only: reads nothing. Saving succeeds and writes nothing.
    ~SideFile();
    SideFile(SideFile&&) noexcept;
    SideFile& operator=(SideFile&&) noexcept;

    // Opens the side file of `world`. If the file is damaged, it is renamed, the additions start empty, and news() says
    // so. If `shipped` is true, the world came with the program, so additions always go to the data folder. `toml`
    // parses the file now, and again whenever save() finds changes by another session. If `toml` cannot tell what the
    // file contains, the file stays untouched, and additions go to the other folder.
    static SideFile of_world(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                             bool shipped = false, settings::TomlReader toml = settings::toml_of);

    // Return the path() and the world_checksum() that the opened side file of `world` would have, without parsing the
    // file.
    static std::filesystem::path path_of(const std::filesystem::path& world, const std::filesystem::path& data_folder,
                                         bool shipped = false);
    static std::string checksum_of_world(const std::filesystem::path& world);

    // Reads the table [name] from the side file of `world`. Writes, renames and announces nothing. Returns an empty
    // entry if there is no such table or the file is damaged. Any thread may call it.
    static SideEntry peek(const std::filesystem::path& world, const std::filesystem::path& data_folder, bool shipped,
                          const std::string& name, const settings::TomlReader& toml = settings::toml_of);

    // Returns the [[name]] tables of the side file of `world`, with the same rules.
    static std::vector<SideEntry> peek_entries(const std::filesystem::path& world,
                                               const std::filesystem::path& data_folder, bool shipped,
                                               const std::string& name, const settings::TomlReader& toml);

    // Return the table [name] or the [[name]] tables in the text of a side file. The result is empty if the text has no
    // such table or is damaged. Any thread may call these functions.
    static SideEntry table_of_text(const std::string& text, const std::string& name);
    static std::vector<SideEntry> entries_of_text(const std::string& text, const std::string& name);

    // Returns one sentence for each part of the file that could not be read, worded for speech.
    const std::vector<std::string>& news() const;
    // Returns the path of the file that save() writes. The path is empty if additions are in memory only.
    const std::filesystem::path& path() const;
    // Returns the checksum of the bytes of the world's file, as eight hex digits. It is empty if there is no file.
    const std::string& world_checksum() const;

    // entries() returns the [[name]] tables in their order, or an empty list. The entries include keys that the caller
    // does not know. The caller must pass these keys back in set_entries().
    std::vector<SideEntry> entries(const std::string& name) const;
    void set_entries(const std::string& name, const std::vector<SideEntry>& entries);
    // Returns an error with file and line if `name` is not a list of tables. If the caller sets entries there anyway,
    // save() first copies the whole file.
    std::optional<Error> fault_of_list(const std::string& name) const;
    // Makes an error about the entry with the index `entry` in entries(), with the file and the entry's first line. If
    // the entry did not come from a file, the error has no line.
    Error fault_in(const std::string& name, std::size_t entry, std::string message) const;
    // Returns the table [name], or an empty entry if there is none.
    SideEntry table(const std::string& name) const;
    void set_table(const std::string& name, const SideEntry& table);

    // If anything has changed, merges the additions with what another session has written, and writes everything
    // atomically. After that, entries() and table() include the other session's content. If the world's folder cannot
    // be written, save() uses the data folder. It fails with a sentence only if writing to the data folder is also
    // impossible.
    Result<void> save();
    // What save() has added from another session since the last call of this function.
    struct TakenOver {
        bool differs = false;           // true: entries or tables differ from those that this session set
        std::vector<std::string> news;  // one sentence for each thing that both sessions changed
    };
    TakenOver take_over();

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

// Returns the entries of a list in the order of the file, converted by `from`, which returns a Result. Entries that
// `from` rejects stay in the file but are not returned. `faults` receives an error with file and line for each of them.
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
// Returns the sentence about unreadable entries from the text `key`, with the first error as {fault} and the number of
// other errors as {more}. The sentence is empty if there are no errors.
std::string unreadable_words(std::string_view key, const std::vector<Error>& faults);
// Writes the items as entries converted by `to`. The old entries that `from` cannot read follow them unchanged.
template <class T, class To, class From>
void write_list(SideFile& file, const std::string& name, const std::vector<T>& all, To to, From from) {
    std::vector<SideEntry> entries;
    for (const T& one : all) entries.push_back(to(one));
    for (const SideEntry& entry : file.entries(name))
        if (!from(entry)) entries.push_back(entry);
    file.set_entries(name, entries);
}

// Returns the sentence about additions that no longer fit the world. The text `key` has {count}, {all} and {names},
// which lists the first five. The sentence is empty if all additions fit.
std::string unfit_words(std::string_view key, const std::vector<std::string>& unfit, std::size_t all);

// Returns $XDG_DATA_HOME/handrail, or else ~/.local/share/handrail. The result is empty if neither path is known.
std::filesystem::path user_data_folder();
// Returns a folder inside user_data_folder(), whether that folder exists or not. If user_data_folder() is empty, so is
// the result, because a relative path would depend on the program's working directory.
std::filesystem::path user_data_folder(std::string_view name);

}  // namespace handrail::core
