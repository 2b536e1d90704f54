// Writes a file outside the learner's folder from data that may belong to that learner. Every command that writes such
// a file must use an ExportGate, so that no data of a learner leave the folder in any other way. An ExportGate checks
// that the learner agreed to share. It also adds the file to the list in the learner's folder, so that deleting the
// learner deletes the file, too. Any thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "app/learners/learners.h"
#include "worlds/base/result.h"

namespace handrail::learners {

class ExportGate {
public:
    // Makes an ExportGate for `data`, a file or folder. The data belong to a learner if they are in that learner's
    // folder after links are resolved; otherwise they belong to nobody. Fails if the learner's file cannot be read,
    // because the consents are then unknown.
    static Result<ExportGate> of(const Learners& learners, const std::filesystem::path& data);
    // Makes an ExportGate for data of this learner, wherever they are.
    static ExportGate of(const Learners& learners, Learner learner);

    // Returns the owner of the data; null: nobody.
    const Learner* learner() const { return learner_ ? &*learner_ : nullptr; }
    // Fails if `file` is outside the learner's folder and the learner has not agreed to share. Call it before work that
    // takes long; write() checks again.
    Result<void> allows(const std::filesystem::path& file) const;
    // Checks the consent, adds the file to the list and writes it with `how`. If the file cannot be added to the list,
    // it is not written.
    using Writer = Result<void> (*)(const std::filesystem::path& file, std::string_view content);
    Result<void> write(const std::filesystem::path& file, std::string_view content, Writer how) const;

private:
    bool leaves(const std::filesystem::path& file) const;

    std::optional<Learner> learner_;
    std::filesystem::path folder_;  // folder of the learner
};

}  // namespace handrail::learners
