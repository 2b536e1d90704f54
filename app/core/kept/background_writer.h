// Replaces files on a separate thread, because a disk may be slow. Only one write runs at a time. Only the thread of
// the writer's owner calls its functions.
#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>

#include "worlds/base/executor.h"
#include "worlds/base/files.h"

namespace handrail::core {

class BackgroundWriter {
public:
    // A pointer to a function of worlds/base/files.h that writes a file.
    using Write = Result<void> (*)(const std::filesystem::path&, std::string_view);

    explicit BackgroundWriter(const Executor& executor, Write how = write_file_atomically)
        : executor_(executor), how_(how) {}
    ~BackgroundWriter() { wait(); }
    BackgroundWriter(const BackgroundWriter&) = delete;
    BackgroundWriter& operator=(const BackgroundWriter&) = delete;

    // Returns true until the present write has ended.
    bool busy() const { return worker_.joinable() && !done_; }
    // Begins a write; call it only if busy() is false.
    void write(std::filesystem::path file, std::string content);
    // Returns the result of the last write once, after it has ended.
    std::optional<Result<void>> take_result();
    // Waits until no write is under way.
    void wait();

private:
    const Executor& executor_;
    Write how_;
    std::atomic<bool> done_{false};
    std::optional<Result<void>> result_;  // the worker thread owns it until `done_` is true
    std::thread worker_;
};

}  // namespace handrail::core
