// Checks whether the file of the current world has changed since the world was entered. App thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace handrail::program {

class WorldWatch {
public:
    static constexpr double kEvery_s = 2.0;

    // From now on, compares `file` with its present state.
    void begin(const std::filesystem::path& file, double now_s);

    enum class News : std::uint8_t { None, Changed, Removed };
    // Checks the file every kEvery_s. Reports each change or removal once, and only when two checks in a row have found
    // the same new state. So a half-written file is not reported.
    News look(double now_s);

private:
    struct Stamp {  // size and time of the file; none: the file does not exist
        std::uintmax_t size = 0;
        std::filesystem::file_time_type written;
        bool operator==(const Stamp&) const = default;
    };
    std::optional<Stamp> stamp() const;

    std::filesystem::path file_;  // the watched file; empty: none
    std::optional<Stamp> known_, seen_;
    double looked_s_ = 0.0;
};

}  // namespace handrail::program
