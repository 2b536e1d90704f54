// The learners of one data folder: below learners/ each has a folder of their own, named by chance, that holds
// learner.toml, settings.toml, recordings/, what they added to worlds (worlds/) and what they know of them (learnt/),
// and exports.jsonl, which says what was written elsewhere. Only the person may read them (0700, 0600). Any thread;
// what changes a file holds a lock on its folder and replaces the file atomically.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/learners/learner.h"

namespace handrail {

class Learners {
public:
    static constexpr double kLockWait_s = 0.5;

    explicit Learners(const std::filesystem::path& data_folder);

    struct Found {
        std::vector<Learner> learners;  // by name
        std::vector<Error> faults;      // one for each folder whose learner.toml cannot be read
    };
    Found all() const;
    // By chosen name (case of ASCII letters ignored) or id. Fails with the nearest name, or with what is wrong with the
    // file.
    Result<Learner> find(const std::string& name_or_id) const;
    // The folder's name of whoever that is, also where learner.toml is damaged and only the id says it; empty: nobody.
    std::string id_of(const std::string& name_or_id) const;
    // A new one with a folder; `settings` is what settings.toml begins as. Fails where the name is taken.
    Result<Learner> make(const std::string& name, const std::string& settings) const;
    // Reads the file, lets `change` change the learner, and writes it.
    Result<Learner> change(const std::string& id, const std::function<void(Learner&)>& to) const;
    // A name from the two lists that nobody has yet.
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

}  // namespace handrail
