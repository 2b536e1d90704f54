// The best times of a game, one for each world, stored in the person's own data folder. Also words the announcement of
// a new time. App thread only.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace handrail::core {

class BestTimes {
public:
    // `game` is the file's name without extension.
    explicit BestTimes(std::string game) : game_(std::move(game)) {}
    // Sets the folder for the file. Without it, best times are lost when the session ends.
    void keep_in(const std::filesystem::path& folder) { folder_ = folder; }
    // Call it when a game in `world` has ended after `took_s`. Returns the announcement: the first time, a new best
    // time, or the old best time. It also mentions an error of saving.
    std::string finish(const std::string& world, double took_s);

private:
    const std::string game_;
    std::filesystem::path folder_;  // empty: nothing is stored
    std::map<std::string, double> session_s_;
};

}  // namespace handrail::core
