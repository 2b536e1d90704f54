// What a person adds to a world - marks, names of rooms - is kept beside it in one TOML file: house.map.handrail.toml. Where that folder
// cannot be written it lies in the person's own data folder. A world without a file (a test, a scenario) keeps its additions in memory.
// Each topic owns its lists and tables by name and leaves the others alone; what nobody here knows stays in the file. App thread only.
// Cost: opening and saving are a few hundred microseconds, and reading the world's bytes once for its checksum.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "worlds/base/result.h"

namespace handrail {

// A value that none of the others is, as TOML writes it: kept and written back as it was.
struct SideText {
    std::string toml;
    bool operator==(const SideText&) const = default;
};
using SideValue = std::variant<bool, std::int64_t, double, std::string, std::vector<double>, SideText>;
using SideEntry = std::map<std::string, SideValue>;

// Of an entry; the second argument where it is missing or of another kind. Numbers that are not finite count as missing.
std::string text_of(const SideEntry& entry, const std::string& key, const std::string& otherwise = {});
double number_of(const SideEntry& entry, const std::string& key, double otherwise);
// Exactly `count` finite numbers, or none.
std::vector<double> numbers_of(const SideEntry& entry, const std::string& key, std::size_t count);

// A name as a person may give one: one line of UTF-8, 1 to 200 bytes. Says what is wrong with it.
inline constexpr std::size_t kLongestName_bytes = 200;
Result<std::string> good_name(std::string_view typed);

class SideFile {
public:
    SideFile();  // in memory only: nothing is read, saving succeeds and writes nothing
    ~SideFile();
    SideFile(SideFile&&) noexcept;
    SideFile& operator=(SideFile&&) noexcept;

    // The file that belongs to `world`. A file that cannot be understood is kept under another name and the additions start empty; news() says so.
    // shipped: the world is the program's own, so what is added to it belongs into the data folder whatever can be written.
    static SideFile of_world(const std::filesystem::path& world, const std::filesystem::path& data_folder, bool shipped = false);

    // One sentence each about what could not be read; fit to be spoken.
    const std::vector<std::string>& news() const;
    // Where save() writes; empty: in memory.
    const std::filesystem::path& path() const;
    // Of the world's bytes, eight hex digits; empty where there is no file.
    const std::string& world_checksum() const;

    // [[name]] tables, in their order; none: empty. Keys that the caller does not know come along and are to be handed back.
    std::vector<SideEntry> entries(const std::string& name) const;
    void set_entries(const std::string& name, const std::vector<SideEntry>& entries);
    // The table [name]; none: empty.
    SideEntry table(const std::string& name) const;
    void set_table(const std::string& name, const SideEntry& table);

    // Writes all of it atomically, if anything changed. Where the world's folder refuses, the data folder takes it; fails with a sentence only
    // when that refuses too.
    Result<void> save();

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

// Which of `all` additions no longer fit the world, the first five by name, as the text `key` says it with {count}, {all} and {names}; empty where all fit.
std::string unfit_words(std::string_view key, const std::vector<std::string>& unfit, std::size_t all);

// $XDG_DATA_HOME/handrail, else ~/.local/share/handrail; empty when neither is known.
std::filesystem::path user_data_folder();

}  // namespace handrail
