#include "app/main/world_watch.h"

#include <system_error>
#include <utility>

namespace handrail::program {

void WorldWatch::begin(const std::filesystem::path& file, double now_s) {
    file_ = file;
    known_ = seen_ = stamp();
    looked_s_ = now_s;
}

std::optional<WorldWatch::Stamp> WorldWatch::stamp() const {
    std::error_code size_error, time_error;
    const std::uintmax_t size = std::filesystem::file_size(file_, size_error);
    const auto written = std::filesystem::last_write_time(file_, time_error);
    if (size_error || time_error) return std::nullopt;
    return Stamp{size, written};
}

WorldWatch::News WorldWatch::look(double now_s) {
    if (file_.empty() || now_s - looked_s_ < kEvery_s) return News::None;
    looked_s_ = now_s;
    const std::optional<Stamp> before = std::exchange(seen_, stamp());
    if (seen_ != before || seen_ == known_) return News::None;
    known_ = seen_;
    return known_ ? News::Changed : News::Removed;
}

}  // namespace handrail::program
