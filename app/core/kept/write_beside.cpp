#include "app/core/kept/write_beside.h"

#include <cerrno>
#include <chrono>
#include <new>
#include <system_error>

#include "worlds/base/contract.h"

namespace handrail {

bool WriteBeside::busy() const {
    return writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) == std::future_status::timeout;
}

void WriteBeside::write(std::filesystem::path file, std::string content) {
    contract_pre(!busy());
    const auto job = [how = how_, file = std::move(file), content = std::move(content)] { return how(file, content); };
    try {
        writing_ = std::async(std::launch::async, job);
    } catch (const std::system_error&) {
        std::promise<Result<void>> done;
        writing_ = done.get_future();
        done.set_value(job());
    }
}

std::optional<Result<void>> WriteBeside::take_result() {
    if (!writing_.valid() || busy()) return std::nullopt;
    try {
        return writing_.get();
    } catch (const std::bad_alloc&) {
        return fail(reason_of(ENOMEM));
    }
}

void WriteBeside::wait() const {
    if (writing_.valid()) writing_.wait();
}

}  // namespace handrail
