// Lists the worlds to choose from: the worlds that come with the program, the worlds in any folder, and the worlds
// visited last. A small text file contains the paths of the worlds visited last. This code reads only folders and that
// file, not the worlds. Use it on the app thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace handrail::core {

struct ShelvedWorld {
    std::string name;  // spoken name, made from the file's name
    std::filesystem::path file;
};

// Returns the world files of the supported kinds, sorted by name. The list is empty if the folder is missing,
// unreadable or contains no worlds.
std::vector<ShelvedWorld> worlds_in(const std::filesystem::path& folder);
// Returns "first room" for "first_room.map". Bytes that are not UTF-8 are left out.
std::string name_of_file(const std::filesystem::path& file);

class RecentWorlds {
public:
    static constexpr std::size_t kMost = 10;

    RecentWorlds() = default;  // keeps the list in memory only
    // Reads the list from `file`, which must be UTF-8 text with one path a line. If it is not, the file is renamed,
    // take_news() says so, and the list starts empty.
    explicit RecentWorlds(std::filesystem::path file);

    const std::vector<std::filesystem::path>& worlds() const { return worlds_; }  // the latest visit first
    // Notes a visit and saves the list at once. If saving fails, the list stays in memory.
    void add(const std::filesystem::path& world);
    // Returns sentences about problems with the file of the list. Each sentence is returned only once.
    std::string take_news();

private:
    std::filesystem::path file_;
    std::vector<std::filesystem::path> worlds_;
    std::string news_;
};

// Returns $XDG_STATE_HOME/handrail/recent-worlds.txt, or else ~/.local/state/handrail/recent-worlds.txt. The result is
// empty if neither path is known.
std::filesystem::path recent_worlds_path();

// The contents of the list of worlds from which a person chooses.
struct WorldShelf {
    std::filesystem::path bundled;  // folder of the worlds that come with the program
    std::vector<std::filesystem::path> recent;
};

}  // namespace handrail::core
