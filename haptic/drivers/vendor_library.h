// Loads a maker's closed library if it is installed. The library is never linked or shipped. Symbols are looked up by
// name; a missing symbol leads to an error sentence, not a crash. Any thread. Loading runs the library's own start-up
// code, so it happens in the guard process.
#pragma once

#include <initializer_list>
#include <string>

#include "worlds/base/result.h"

namespace handrail::drivers {

class VendorLibrary {
public:
    // Loads the first library in `names` that the loader finds. If the loader finds none, the error sentence says what
    // is missing.
    static Result<VendorLibrary> load(std::initializer_list<std::string> names, const std::string& maker);
    VendorLibrary(VendorLibrary&& other) noexcept;
    VendorLibrary& operator=(VendorLibrary&&) = delete;
    ~VendorLibrary();

    // Looks up a function by name and stores it in `function`. Remembers the first name that is missing.
    template <class Function>
    VendorLibrary& get(const char* name, Function*& function) {
        function = reinterpret_cast<Function*>(find(name));
        return *this;
    }
    // Succeeds if every requested function was found.
    Result<void> complete() const;

private:
    explicit VendorLibrary(void* handle, std::string name) : handle_(handle), name_(std::move(name)) {}
    void* find(const char* name);

    void* handle_ = nullptr;
    std::string name_, missing_;
};

}  // namespace handrail::drivers
