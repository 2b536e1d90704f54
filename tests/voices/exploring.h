// Runs the program with a separate home folder. The test types into the program or, if the program has a window,
// presses keys.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/support/child_process.h"
#include "tests/support/project_root.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace handrail::test {

class Exploring {
public:
    // The program gets `environment` in addition to a bare environment. If `first_start` is true, it finds no settings,
    // as at its first start.
    Exploring(const TemporaryFolder& folder, Environment environment,
              const std::vector<std::string>& arguments = {"--no-window", "--device", "none"}, bool first_start = false)
        : said_(folder.path() / "said") {
        environment.merge(bare_environment(folder.path().string(), true));
        if (first_start) std::filesystem::remove(folder.path() / ".config" / "handrail" / "settings.toml");
        std::vector<std::string> words{test::built_program("handrail")};
        words.insert(words.end(), arguments.begin(), arguments.end());
        // On a busy machine, the sound device runs out of data if it has fewer periods. The program would then report
        // that in the middle of other messages.
        for (const char* steady : {"--set", "sound.periods=3"}) words.emplace_back(steady);
        process_ = ChildProcess::start(words, environment, said_);
    }
    std::string said() const { return content_of(said_); }
    bool says(const std::string& words) const {
        return eventually([&] { return said().find(words) != std::string::npos; });
    }
    ChildProcess& process() { return *process_; }
    void type(const std::string& lines) { process_->type(lines); }

private:
    std::filesystem::path said_;
    std::unique_ptr<ChildProcess> process_;
};

}  // namespace handrail::test
