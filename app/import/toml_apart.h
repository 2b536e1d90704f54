// Parses TOML from untrusted sources in a separate process (reader_process), which returns plain values. A file that
// crashes the parser ends only that process. TomlApart does not trust the answer: it checks every kind, count and
// depth, requires keys in order, and accepts only UTF-8.
//
// Copies of an object share their cache. Any thread may use it. A new text costs about 5 ms of processor time. A text
// that was parsed before, even without success, costs only a copy of the result. So parse the files of a world in the
// background first; the app thread then finds the results in the cache.
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
    // Greatest total size of cached texts. The cache always keeps the newest text, even a larger one.
    static constexpr std::size_t kMostKnown_bytes = std::size_t{4} << 20;

    explicit TomlApart(std::filesystem::path program, ReaderLimits limits = {1'000'000'000, 5, 10.0});
    // Parses a text and returns what a TomlReader must return. Fails with one sentence if the process gives no valid
    // answer in time.
    Result<settings::TomlValue> operator()(const std::string& text) const;

private:
    struct Known;

    std::filesystem::path program_;
    ReaderLimits limits_;
    std::shared_ptr<Known> known_;
};

// Decodes the answer of the process into a value such as toml_of returns. Fails with one sentence if the answer is
// invalid. Private to this folder, except for tests.
Result<settings::TomlValue> toml_in_answer(std::string_view bytes);

}  // namespace handrail::importing
