// Sets an environment variable while a test needs it, and restores its old value afterwards.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace handrail::test {

class WithEnvironment {
public:
    // If `value` is null, the variable is unset.
    WithEnvironment(std::string name, const char* value) : name_(std::move(name)) {
        if (const char* was = std::getenv(name_.c_str())) was_ = was;
        put(value);
    }
    ~WithEnvironment() { put(was_ ? was_->c_str() : nullptr); }
    WithEnvironment(const WithEnvironment&) = delete;
    WithEnvironment& operator=(const WithEnvironment&) = delete;

    void put(const char* value) {
        if (value) ::setenv(name_.c_str(), value, 1);
        else ::unsetenv(name_.c_str());
    }

private:
    std::string name_;
    std::optional<std::string> was_;
};

}  // namespace handrail::test
