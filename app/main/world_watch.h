// Whether the file of the world one is in is still as it was when it was entered. App thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace handrail {

class WorldWatch {
public:
    static constexpr double kEvery_s = 2.0;

    // From now on this file, as it is now.
    void begin(const std::filesystem::path& file, double now_s);

    enum class News : std::uint8_t { None, Changed, Gone };
    // Looks every kEvery_s. Each change is told once, when the file has stayed as it is from one look to the next, so
    // half a file is no news; so is that it has gone.
    News look(double now_s);

private:
    struct Stamp {  // none: there is no such file
        std::uintmax_t size = 0;
        std::filesystem::file_time_type written;
        bool operator==(const Stamp&) const = default;
    };
    std::optional<Stamp> stamp() const;

    std::filesystem::path file_;  // empty: none
    std::optional<Stamp> known_, seen_;
    double looked_s_ = 0.0;
};

}  // namespace handrail
