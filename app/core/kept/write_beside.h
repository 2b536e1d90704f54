// Replaces files on a thread beside the caller's, since a disk may take long. One write at a time; one owner.
#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>

#include "worlds/base/files.h"

namespace handrail {

class WriteBeside {
public:
    // One of the functions of worlds/base/files.h.
    using Write = Result<void> (*)(const std::filesystem::path&, std::string_view);

    explicit WriteBeside(Write how = write_file_atomically) : how_(how) {}
    ~WriteBeside() { wait(); }
    WriteBeside(const WriteBeside&) = delete;
    WriteBeside& operator=(const WriteBeside&) = delete;

    // A write has not ended yet.
    bool busy() const;
    // Begins one; not while another is busy. Where no thread is to be had it is done at once.
    void write(std::filesystem::path file, std::string content);
    // How the last one that ended went; once.
    std::optional<Result<void>> take_result();
    // Until nothing is on its way.
    void wait() const;

private:
    Write how_;
    std::future<Result<void>> writing_;
};

}  // namespace handrail
