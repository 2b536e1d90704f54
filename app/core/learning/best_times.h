// The best time of a game in each world, kept in the person's own data folder, and what is said of a new one. App
// thread only.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>

namespace handrail {

class BestTimes {
public:
    // The file's name without an ending.
    explicit BestTimes(std::string game) : game_(std::move(game)) {}
    // Until told, they last as long as the session.
    void keep_in(const std::filesystem::path& folder) { folder_ = folder; }
    // A game of that world has taken so long. What is said of it: the first, a better or the best one before; and what
    // went wrong with keeping it.
    std::string finish(const std::string& world, double took_s);

private:
    const std::string game_;
    std::filesystem::path folder_;  // empty: nothing is kept
    std::map<std::string, double> session_s_;
};

}  // namespace handrail
