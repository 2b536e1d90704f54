// When what a person changed is saved: two seconds after the first change that is not saved yet, so that a crash costs
// no more than that and a key that is held writes no file each time. What cannot be saved is told once and tried again
// every kRetry_s. Plain state over the caller's clock; app thread.
#pragma once

#include <optional>
#include <string>

#include "worlds/base/result.h"

namespace handrail {

class SaveSoon {
public:
    static constexpr double kAfter_s = 2.0, kRetry_s = 30.0;

    void changed(double now_s);
    // True when it is to be saved now; the caller does so and tells how it went.
    bool take_due(double now_s);
    // The sentence to be said, if any: not the same one again until a save has worked.
    std::optional<std::string> ended(const Result<void>& saved, double now_s);
    // Something changed that no save has been begun for.
    bool unsaved() const { return due_s_.has_value(); }

private:
    std::optional<double> due_s_;
    std::string told_;
};

}  // namespace handrail
