// The worlds one can go to: those that come with the program, those of any folder, and the last ones visited, kept in a
// small text file of paths. App thread; reads folders and that file, nothing else.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace handrail {

struct ShelvedWorld {
    std::string name;  // fit to be spoken, from the file's name
    std::filesystem::path file;
};

// Files of the kinds we read, by name. None: the folder is missing, unreadable or empty of worlds.
std::vector<ShelvedWorld> worlds_in(const std::filesystem::path& folder);
// "first room" of "first_room.map"; bytes that are no UTF-8 are left out.
std::string name_of_file(const std::filesystem::path& file);

class RecentWorlds {
public:
    static constexpr std::size_t kMost = 10;

    RecentWorlds() = default;  // in memory only
    // A file that is not UTF-8 text of paths, one a line, is kept aside under another name, said, and the list starts
    // empty.
    explicit RecentWorlds(std::filesystem::path file);

    const std::vector<std::filesystem::path>& worlds() const { return worlds_; }  // last one first
    // Visited now. Saves at once; what cannot be saved is kept in memory.
    void add(const std::filesystem::path& world);
    // What there was to say about the file; once.
    std::string take_news();

private:
    std::filesystem::path file_;
    std::vector<std::filesystem::path> worlds_;
    std::string news_;
};

// $XDG_STATE_HOME/handrail/recent-worlds.txt, else ~/.local/state/...; empty when neither is known.
std::filesystem::path recent_worlds_path();

// What the chooser has to offer.
struct WorldShelf {
    std::filesystem::path bundled;  // a folder
    std::vector<std::filesystem::path> recent;
};

}  // namespace handrail
