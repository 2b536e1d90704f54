// A maker's closed library, loaded when it is installed and never linked or shipped. Symbols are asked for by name, and
// one that is missing is a sentence, not a crash. Any thread; loading runs the library's own start-up code, so it
// happens in the guard process.
#pragma once

#include <initializer_list>
#include <string>

#include "worlds/base/result.h"

namespace handrail {

class VendorLibrary {
public:
    // The first of the names that the loader finds. Fails with what is missing, in a sentence.
    static Result<VendorLibrary> load(std::initializer_list<std::string> names, const std::string& maker);
    VendorLibrary(VendorLibrary&& other) noexcept;
    VendorLibrary& operator=(VendorLibrary&&) = delete;
    ~VendorLibrary();

    // Looks a function up into `function`; the first one missing is remembered.
    template <class Function>
    VendorLibrary& get(const char* name, Function*& function) {
        function = reinterpret_cast<Function*>(find(name));
        return *this;
    }
    // Everything that was asked for is there.
    Result<void> complete() const;

private:
    explicit VendorLibrary(void* handle, std::string name) : handle_(handle), name_(std::move(name)) {}
    void* find(const char* name);

    void* handle_ = nullptr;
    std::string name_, missing_;
};

}  // namespace handrail
