// The best time of a game in each world, stored in the person's own data folder, and the announcement of a new time.
// App thread only.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace handrail::core {

class BestTimes {
public:
    // The file's name without extension.
    explicit BestTimes(std::string game) : game_(std::move(game)) {}
    // Folder for the file; without it, times last as long as the session.
    void keep_in(const std::filesystem::path& folder) { folder_ = folder; }
    // A game in that world took this long. Returns the announcement: the first time, a new best, or the old best. It
    // also reports errors of storing.
    std::string finish(const std::string& world, double took_s);

private:
    const std::string game_;
    std::filesystem::path folder_;  // empty: nothing is stored
    std::map<std::string, double> session_s_;
};

}  // namespace handrail::core
