// SHA-256 of bytes that come in pieces, by libgcrypt. One owner; any thread.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace handrail {

class Sha256 {
public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(std::string_view bytes);
    // Their number and then the bytes, so that "ab" and "c" differ from "a" and "bc".
    void add_counted(std::string_view bytes);
    // 64 hex digits. The last call.
    std::string hex();

private:
    struct State;
    std::unique_ptr<State> state_;
};

std::string sha256_of(std::string_view bytes);

}  // namespace handrail
