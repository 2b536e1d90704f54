// Stores the best times of a game, one for each world, in the person's own data folder. It also words the announcement
// of a new time. Use it on the app thread only.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace handrail::core {

class BestTimes {
public:
    // `game` is the name of the file without extension.
    explicit BestTimes(std::string game) : game_(std::move(game)) {}
    // Sets the folder for the file. Without a folder, best times are lost when the session ends.
    void keep_in(const std::filesystem::path& folder) { folder_ = folder; }
    // Compares `took_s` with the best time in `world`. Call it when a game has ended. Returns the announcement: the
    // first time, a new best time, or the old best time. If saving failed, the announcement mentions the error.
    std::string finish(const std::string& world, double took_s);

private:
    const std::string game_;
    std::filesystem::path folder_;  // folder for the file; empty: nothing is stored
    std::map<std::string, double> session_s_;
};

}  // namespace handrail::core
