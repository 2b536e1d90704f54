// The one way out of a learner's data. Every command that writes a file from data that may belong to a learner writes
// it with a WayOut, which checks that the learner agreed to share and notes the file in the learner's folder, so that
// deleting the learner takes it away again. Any thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "app/learners/learners.h"
#include "worlds/base/result.h"

namespace handrail {

class WayOut {
public:
    // Out of a file or folder. It belongs to a learner if it is in that learner's folder, links followed; everything
    // else is nobody's. Fails if the learner's file cannot be read, as nobody knows then what was agreed to.
    static Result<WayOut> of(const Learners& learners, const std::filesystem::path& data);
    // Out of what there is of this learner.
    static WayOut of(const Learners& learners, Learner learner);

    // Whose data it is; null: nobody's.
    const Learner* learner() const { return learner_ ? &*learner_ : nullptr; }
    // Fails if the file is outside of the learner's folder and the learner has not agreed to share. Call it before long
    // work; write() checks again.
    Result<void> allows(const std::filesystem::path& file) const;
    // Checks, notes and writes. A file that cannot be noted is not written.
    using Writer = Result<void> (*)(const std::filesystem::path& file, std::string_view content);
    Result<void> write(const std::filesystem::path& file, std::string_view content, Writer how) const;

private:
    bool leaves(const std::filesystem::path& file) const;

    std::optional<Learner> learner_;
    std::filesystem::path folder_;  // the learner's
};

}  // namespace handrail
