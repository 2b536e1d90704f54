// Replaces files on a thread beside the caller's, since a disk may take long. One write at a time; one owner.
#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>

#include "worlds/base/result.h"

namespace handrail {

class WriteBeside {
public:
    WriteBeside() = default;
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
    std::future<Result<void>> writing_;
};

}  // namespace handrail
