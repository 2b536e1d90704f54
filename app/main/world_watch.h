// Watches whether the file of the current world has changed since it was entered. App thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace handrail::program {

class WorldWatch {
public:
    static constexpr double kEvery_s = 2.0;

    // Watches this file from now on, starting from its present state.
    void begin(const std::filesystem::path& file, double now_s);

    enum class News : std::uint8_t { None, Changed, Gone };
    // Looks every kEvery_s. Reports each change or removal once, when the file has stayed the same from one look to the
    // next, so that a half-written file is not reported.
    News look(double now_s);

private:
    struct Stamp {  // none: the file does not exist
        std::uintmax_t size = 0;
        std::filesystem::file_time_type written;
        bool operator==(const Stamp&) const = default;
    };
    std::optional<Stamp> stamp() const;

    std::filesystem::path file_;  // empty: none
    std::optional<Stamp> known_, seen_;
    double looked_s_ = 0.0;
};

}  // namespace handrail::program
