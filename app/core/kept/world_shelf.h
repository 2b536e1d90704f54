// The worlds to choose from: those that come with the program, those in any folder, and those visited last, which a
// small text file of paths stores. App thread; reads only folders and that file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace handrail::core {

struct ShelvedWorld {
    std::string name;  // fit to be spoken, from the file's name
    std::filesystem::path file;
};

// World files of the supported kinds, by name. Empty: the folder is missing, unreadable or contains no worlds.
std::vector<ShelvedWorld> worlds_in(const std::filesystem::path& folder);
// "first room" for "first_room.map"; bytes that are not UTF-8 are left out.
std::string name_of_file(const std::filesystem::path& file);

class RecentWorlds {
public:
    static constexpr std::size_t kMost = 10;

    RecentWorlds() = default;  // in memory only
    // If the file is not UTF-8 text with one path a line, it is kept under another name, that is announced, and the
    // list starts empty.
    explicit RecentWorlds(std::filesystem::path file);

    const std::vector<std::filesystem::path>& worlds() const { return worlds_; }  // latest first
    // Notes a visit and saves at once. If saving fails, the list stays in memory.
    void add(const std::filesystem::path& world);
    // Sentences about the file; returned once.
    std::string take_news();

private:
    std::filesystem::path file_;
    std::vector<std::filesystem::path> worlds_;
    std::string news_;
};

// $XDG_STATE_HOME/handrail/recent-worlds.txt, else ~/.local/state/...; empty if neither is known.
std::filesystem::path recent_worlds_path();

// What the list of worlds offers.
struct WorldShelf {
    std::filesystem::path bundled;  // a folder
    std::vector<std::filesystem::path> recent;
};

}  // namespace handrail::core
