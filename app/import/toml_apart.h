// Parses TOML from untrusted sources in a separate process (reader_process), which returns plain values. A file that
// crashes the parser ends only that process. The answer is not trusted: every kind, count and depth is checked, keys
// must be in order, and texts must be UTF-8. Copies share their cache; any thread. Cost: about 5 ms of processor time
// for a new text, and a copy for one that was parsed before, even if that failed. So parse a world's files in the
// background first; the app thread then finds the result in the cache.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "app/import/reader_process.h"
#include "settings/toml_value.h"

namespace handrail::importing {

inline constexpr std::size_t kLargestToml_bytes = std::size_t{16} << 20;

class TomlApart {
public:
    static constexpr std::size_t kMostKnown = 128;
    // Total size of cached texts; the last text is always cached.
    static constexpr std::size_t kMostKnown_bytes = std::size_t{4} << 20;

    explicit TomlApart(std::filesystem::path program, ReaderLimits limits = {1'000'000'000, 5, 10.0});
    // Serves as a TomlReader. If the process does anything except answer in time, the result is one sentence.
    Result<settings::TomlValue> operator()(const std::string& text) const;

private:
    struct Known;

    std::filesystem::path program_;
    ReaderLimits limits_;
    std::shared_ptr<Known> known_;
};

// The answer of such a process in the form that toml_of would return, or one sentence if it is invalid. Private to this
// folder, except for tests.
Result<settings::TomlValue> toml_in_answer(std::string_view bytes);

}  // namespace handrail::importing
