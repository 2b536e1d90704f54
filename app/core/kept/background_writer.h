// Replaces files in the background, since a disk may take long. One write at a time; one owner.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>

#include "worlds/base/executor.h"
#include "worlds/base/files.h"

namespace handrail {

class BackgroundWriter {
public:
    // One of the functions of worlds/base/files.h.
    using Write = Result<void> (*)(const std::filesystem::path&, std::string_view);

    explicit BackgroundWriter(const Executor& executor, Write how = write_file_atomically)
        : executor_(executor), how_(how) {}
    ~BackgroundWriter() { wait(); }
    BackgroundWriter(const BackgroundWriter&) = delete;
    BackgroundWriter& operator=(const BackgroundWriter&) = delete;

    // A write has not ended yet.
    bool busy() const { return worker_.joinable() && !done_; }
    // Begins one; not while another is busy.
    void write(std::filesystem::path file, std::string content);
    // How the last one that ended went; once.
    std::optional<Result<void>> take_result();
    // Until nothing is on its way.
    void wait();

private:
    const Executor& executor_;
    Write how_;
    std::atomic<bool> done_{false};
    std::optional<Result<void>> result_;  // the worker's until done_
    std::thread worker_;
};

}  // namespace handrail
