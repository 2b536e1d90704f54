// Checks spelling with hunspell and with the word lists of this folder.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {

// Returns the lines of a file in this folder, without comments.
inline std::vector<std::string> listed_in(const char* file) {
    std::istringstream lines(content_of(project_root() / "tests" / "unit" / "docs" / file));
    std::vector<std::string> listed;
    for (std::string line; std::getline(lines, line);)
        if (!line.empty() && !line.starts_with('#')) listed.push_back(line);
    return listed;
}

// Returns the words that are not in this hunspell dictionary.
inline std::set<std::string> unknown_words(const std::set<std::string>& words, const std::string& dictionary) {
    const TemporaryFolder folder;
    const std::filesystem::path in = folder.path() / "words", out = folder.path() / "unknown";
    std::ofstream file(in);
    for (const std::string& word : words) file << word << '\n';
    file.close();
    const std::string command = "LC_ALL=C.UTF-8 hunspell -i UTF-8 -d " + dictionary + " -l '" + in.string() + "' >'" +
                                out.string() + "' 2>/dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::istringstream lines(content_of(out));
    std::set<std::string> unknown;
    for (std::string line; std::getline(lines, line);) unknown.insert(line);
    return unknown;
}

inline bool has_dictionary(const std::string& dictionary) {
    const std::string command = "hunspell -d " + dictionary + " -l /dev/null >/dev/null 2>&1";
    return std::system(command.c_str()) == 0;
}

}  // namespace handrail::test
