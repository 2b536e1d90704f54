// Manages the learners of one data folder. Each has a folder with a random name below learners/, which contains:
// - learner.toml and settings.toml
// - recordings/
// - worlds/: what the learner added to worlds
// - learnt/: what the learner knows about worlds
// - exports.jsonl: the list of files about the learner outside this folder
// Only the person at the computer may read these files (0700, 0600). Any thread. Changes lock the folder and replace
// files atomically.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/learners/learner.h"

namespace handrail::learners {

class Learners {
public:
    static constexpr double kLockWait_s = 0.5;

    explicit Learners(const std::filesystem::path& data_folder);

    struct Found {
        std::vector<Learner> learners;  // sorted by name
        std::vector<Error> faults;      // one fault for each folder whose learner.toml cannot be read
    };
    Found all() const;
    // Finds a learner by id, or by the chosen name, ignoring the case of ASCII letters. If there is no such learner,
    // fails and suggests the nearest name. If the learner's file is damaged, fails and says what is wrong with it.
    Result<Learner> find(const std::string& name_or_id) const;
    // Returns the name of the learner's folder, which is the id; empty if there is none. If learner.toml is damaged,
    // the function recognises only the id, not the chosen name.
    std::string id_of(const std::string& name_or_id) const;
    // Creates a learner with a folder. `settings` is the initial text of settings.toml. Fails if another learner has
    // this name.
    Result<Learner> make(const std::string& name, const std::string& settings) const;
    // Reads the learner's file, calls `to` to change the learner, and writes the file.
    Result<Learner> change(const std::string& id, const std::function<void(Learner&)>& to) const;
    // Returns an offered name (see offered_name) that no learner has yet.
    std::string offer() const;

    const std::filesystem::path& folder() const { return folder_; }
    std::filesystem::path folder_of(const std::string& id) const { return folder_ / id; }
    std::filesystem::path settings_of(const std::string& id) const { return folder_ / id / "settings.toml"; }
    std::filesystem::path recordings_of(const std::string& id) const { return folder_ / id / "recordings"; }

private:
    std::filesystem::path file_of(const std::string& id) const { return folder_ / id / "learner.toml"; }
    Result<Learner> read(const std::string& id) const;

    std::filesystem::path folder_;
};

}  // namespace handrail::learners
