#include "app/core/kept/background_writer.h"

#include <cerrno>
#include <new>
#include <utility>

#include "worlds/base/contract.h"

namespace handrail::core {

void BackgroundWriter::write(std::filesystem::path file, std::string content) {
    contract_pre(!busy());
    wait();
    done_ = false;
    worker_ = executor_.run("save", [this, file = std::move(file), content = std::move(content)] {
        try {
            result_ = how_(file, content);
        } catch (const std::bad_alloc&) {
            result_ = fail(reason_of(ENOMEM));
        }
        done_ = true;
    });
}

std::optional<Result<void>> BackgroundWriter::take_result() {
    if (busy()) return std::nullopt;
    wait();
    return std::exchange(result_, std::nullopt);
}

void BackgroundWriter::wait() {
    if (worker_.joinable()) worker_.join();
}

}  // namespace handrail::core
