// Computes the SHA-256 of bytes that arrive in pieces, with libgcrypt. An object has one owner and may be used on any
// thread.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace handrail::cache {

class Sha256 {
public:
    Sha256();
    ~Sha256();
    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

    void add(std::string_view bytes);
    // Adds the number of bytes and then the bytes themselves. So "ab" and "c" give another digest than "a" and "bc".
    void add_counted(std::string_view bytes);
    // Returns the digest as 64 hex digits. Call no other function of the object afterwards.
    std::string hex();

private:
    struct State;
    std::unique_ptr<State> state_;
};

std::string sha256_of(std::string_view bytes);

}  // namespace handrail::cache
