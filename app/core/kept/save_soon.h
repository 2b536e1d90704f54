// Decides when to save the person's changes: two seconds after the first unsaved change. So a crash loses at most two
// seconds of changes, and a held key does not cause a write for each repetition. If saving fails, the person hears it
// once, and the owner tries again every kRetry_s. Plain state over the caller's clock, for the app thread.
#pragma once

#include <optional>
#include <string>

#include "worlds/base/result.h"

namespace handrail::core {

class SaveSoon {
public:
    static constexpr double kAfter_s = 2.0, kRetry_s = 30.0;

    void changed(double now_s);
    // Returns true if it is time to save. The caller then saves, and passes the result to ended().
    bool take_due(double now_s);
    // Returns the sentence to announce about the result, if any. After a failure, the sentence is not repeated until a
    // save has succeeded.
    std::optional<std::string> ended(const Result<void>& saved, double now_s);
    // Returns true if there is a change that no save has included yet.
    bool unsaved() const { return due_s_.has_value(); }

private:
    std::optional<double> due_s_;
    std::string reported_;
};

}  // namespace handrail::core
