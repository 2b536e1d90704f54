// Replaces files on another thread, because a disk may be slow. One write at a time; one owner.
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
    // A function of worlds/base/files.h.
    using Write = Result<void> (*)(const std::filesystem::path&, std::string_view);

    explicit BackgroundWriter(const Executor& executor, Write how = write_file_atomically)
        : executor_(executor), how_(how) {}
    ~BackgroundWriter() { wait(); }
    BackgroundWriter(const BackgroundWriter&) = delete;
    BackgroundWriter& operator=(const BackgroundWriter&) = delete;

    // True until the present write has ended.
    bool busy() const { return worker_.joinable() && !done_; }
    // Begins a write; call it only if busy() is false.
    void write(std::filesystem::path file, std::string content);
    // The result of the last write, once it has ended; returned once.
    std::optional<Result<void>> take_result();
    // Waits until no write is under way.
    void wait();

private:
    const Executor& executor_;
    Write how_;
    std::atomic<bool> done_{false};
    std::optional<Result<void>> result_;  // belongs to the worker until done_
    std::thread worker_;
};

}  // namespace handrail::core
