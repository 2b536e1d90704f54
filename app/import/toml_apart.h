// TOML that others may have made, parsed in a process of its own (reader_process), which hands over plain values: a
// file that brings the parser down ends that process and nothing else. Of the answer nothing is trusted: every kind,
// count and depth is checked, keys must be in order, and texts must be UTF-8. Copies share what they know; any thread.
// Cost: about 5 ms of the processor for a text that is new, and a copy for one that was read before, also if reading it
// failed: read a world's files where nobody waits, and the app's thread finds the same bytes known.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "app/import/reader_process.h"
#include "settings/toml_value.h"

namespace handrail {

inline constexpr std::size_t kLargestToml_bytes = std::size_t{16} << 20;

class TomlApart {
public:
    static constexpr std::size_t kMostKnown = 128;
    static constexpr std::size_t kMostKnown_bytes = std::size_t{4} << 20;  // of text; the last one is known anyway

    explicit TomlApart(std::filesystem::path program, ReaderLimits limits = {1'000'000'000, 5, 10.0});
    // A TomlReader. Whatever the process does but answer in time makes one sentence.
    Result<TomlValue> operator()(const std::string& text) const;

private:
    struct Known;

    std::filesystem::path program_;
    ReaderLimits limits_;
    std::shared_ptr<Known> known_;
};

// What such a process answered, as toml_of would have said it, or one sentence if it cannot be that. Private to this
// folder, but for tests.
Result<TomlValue> toml_in_answer(std::string_view bytes);

}  // namespace handrail
