// Collects the faults that a reader finds. It counts every fault and keeps the first 20 as sentences. Used on the
// reading thread only.
#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "worlds/base/language.h"
#include "worlds/base/result.h"
#include "worlds/scene/scene.h"

namespace handrail::readers {

// Greatest coordinate allowed in a file. Replay and rendering accept positions up to this distance.
inline constexpr double kFarthestM = 1e6;

struct TextPlace {
    int line = 0;
    int column = 0;
};

class Diagnostics {
public:
    // Greatest number of faults that are kept. Further faults are only counted, because the person hears the sentences
    // one after the other.
    static constexpr std::size_t kMostKept = 20;

    explicit Diagnostics(std::string file) : file_(std::move(file)) {}

    // Adds a warning. `action` and `message` are keys of texts. `values` fills both texts.
    using Values = std::initializer_list<TextValue>;
    void warn(TextPlace place, std::string_view action, std::string_view message, Values values = {}) {
        add(Severity::Warning, place, action, message, values);
    }
    void error(TextPlace place, std::string_view action, std::string_view message, Values values = {}) {
        add(Severity::Error, place, action, message, values);
    }
    // Adds a finished sentence, for example the message of a library.
    void pass_on(TextPlace place, std::string_view action, const std::string& words) {
        if (++in_all_ <= static_cast<int>(kMostKept))
            kept_.push_back({Severity::Warning, file_, place.line, place.column, words, phrase(action)});
    }

    const std::vector<Diagnostic>& kept() const { return kept_; }
    int in_all() const { return in_all_; }
    void move_into(ReadReport& report) {
        report.warnings = std::move(kept_);
        report.warnings_in_all = in_all_;
    }

private:
    void add(Severity severity, TextPlace place, std::string_view action, std::string_view message, Values values) {
        ++in_all_;
        if (kept_.size() >= kMostKept) return;
        kept_.push_back({severity, file_, place.line, place.column, phrase(message, values), phrase(action, values)});
    }

    std::string file_;
    std::vector<Diagnostic> kept_;
    int in_all_ = 0;
};

// Returns at most `most` bytes of `found`, a piece of text from the file. Bytes other than printable ASCII become
// question marks, so that the result is safe in a message.
std::string excerpt(std::string_view found, std::size_t most = 24);

// Returns the error for a file without usable content. It includes the first fault if there was one: "... in this map.
// It holds no brushes." `world` is "map" or "mesh".
tl::unexpected<Error> nothing_to_touch(const Diagnostics& diagnostics, const std::string& file, std::string_view world);

}  // namespace handrail::readers
