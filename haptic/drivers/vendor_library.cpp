#include "haptic/drivers/vendor_library.h"

#include <dlfcn.h>

#include <utility>

#include "worlds/base/language.h"

namespace handrail::drivers {

Result<VendorLibrary> VendorLibrary::load(std::initializer_list<std::string> names, const std::string& maker) {
    for (const std::string& name : names)
        if (void* handle = ::dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL)) return VendorLibrary(handle, name);
    return fail(phrase("drivers.no_library", {{"library", *names.begin()}, {"maker", maker}}));
}

VendorLibrary::VendorLibrary(VendorLibrary&& other) noexcept
    : handle_(std::exchange(other.handle_, nullptr)),
      name_(std::move(other.name_)),
      missing_(std::move(other.missing_)) {}

VendorLibrary::~VendorLibrary() {
    if (handle_) ::dlclose(handle_);
}

void* VendorLibrary::find(const char* name) {
    void* found = ::dlsym(handle_, name);
    if (!found && missing_.empty()) missing_ = name;
    return found;
}

Result<void> VendorLibrary::complete() const {
    if (missing_.empty()) return {};
    return fail(phrase("drivers.library_lacks", {{"library", name_}, {"function", missing_}}));
}

}  // namespace handrail::drivers
