// Every command that writes a file from data that may belong to a learner writes it with a WayOut. There is no other
// way for a learner's data to leave the learner's folder. A WayOut checks that the learner agreed to share. It also
// adds the file to the list in the learner's folder, so that deleting the learner deletes the file, too. Any thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "app/learners/learners.h"
#include "worlds/base/result.h"

namespace handrail::learners {

class WayOut {
public:
    // For a file or folder with data. It belongs to a learner if it is in that learner's folder after links are
    // resolved; otherwise to nobody. Fails if the learner's file cannot be read, because the consents are then unknown.
    static Result<WayOut> of(const Learners& learners, const std::filesystem::path& data);
    // For any data of this learner.
    static WayOut of(const Learners& learners, Learner learner);

    // The owner of the data; null: nobody.
    const Learner* learner() const { return learner_ ? &*learner_ : nullptr; }
    // Returns the owner of the data; null: nobody.
    Result<void> allows(const std::filesystem::path& file) const;
    // Checks the consent, notes the file and writes it. A file that cannot be noted is not written.
    using Writer = Result<void> (*)(const std::filesystem::path& file, std::string_view content);
    Result<void> write(const std::filesystem::path& file, std::string_view content, Writer how) const;

private:
    bool leaves(const std::filesystem::path& file) const;

    std::optional<Learner> learner_;
    std::filesystem::path folder_;  // folder of the learner
};

}  // namespace handrail::learners
