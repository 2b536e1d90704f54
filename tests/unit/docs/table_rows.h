// Reads tables and lists of the guides.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "tests/support/names.h"
#include "tests/support/project_root.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {

// Returns the rows of the table whose header line starts with `head`, without the line of dashes.
inline std::vector<std::string> table_rows(const std::string& document, const std::string& head) {
    std::istringstream lines(test::content_of(test::project_root() / "docs" / document));
    std::vector<std::string> rows;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(head)) inside = true;
        else if (inside && !line.starts_with("|")) break;
        else if (inside && !line.starts_with("|---")) rows.push_back(line);
    }
    EXPECT_TRUE(inside) << document << " has no table that starts with: " << head;
    return rows;
}

// Returns the items of the list under a heading. Each item is one line, however it is wrapped in the document.
inline std::vector<std::string> list_items(const std::string& document, const std::string& heading) {
    std::istringstream lines(test::content_of(test::project_root() / "docs" / document));
    std::vector<std::string> items;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("#")) inside = line == heading;
        else if (inside && line.starts_with("- ")) items.push_back(line);
        else if (inside && line.starts_with("  ") && !items.empty()) items.back() += line.substr(1);
    }
    EXPECT_FALSE(items.empty()) << document << " has no list under: " << heading;
    return items;
}

}  // namespace handrail::test
