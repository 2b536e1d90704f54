#include "haptic/drivers/guard_permissions.h"

#include <cstdlib>
#include <system_error>

#include "haptic/drivers/falcon_device.h"
#include "haptic/drivers/found_device.h"
#include "haptic/drivers/haply_device.h"

namespace handrail::drivers {
namespace {

namespace fs = std::filesystem;

// Permits reading the files that libusb and udev read about devices, and those that the C library reads about the
// process itself.
void permit_finding_devices(confine::Permissions& permissions) {
    permissions.read.insert(permissions.read.end(), {"/sys", "/run/udev", "/etc/udev", "/proc/self"});
    permissions.device_events = true;
}

// Permits a folder and the targets of the links in it. A maker's library is often a link to a version installed
// elsewhere.
void permit_folder_with_links(const fs::path& folder, std::vector<fs::path>& paths) {
    paths.push_back(folder);
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
        if (entry.is_symlink(none)) paths.push_back(fs::weakly_canonical(entry.path(), none));
}

void permit_folders_of(const char* variable, std::vector<fs::path>& paths) {
    const char* value = std::getenv(variable);
    for (std::string rest = value ? value : ""; !rest.empty();) {
        const std::size_t end = rest.find(':');
        if (end != 0) permit_folder_with_links(rest.substr(0, end), paths);
        rest = end == std::string::npos ? std::string() : rest.substr(end + 1);
    }
}

// Permits what a maker's library needs. The guard loads the library after it is confined, and the library reads its
// settings where its installer put them.
void permit_makers_library(confine::Permissions& permissions) {
    permissions.read.insert(permissions.read.end(), {"/usr", "/lib", "/lib64", "/opt", "/etc", "/var/lib"});
    for (const char* variable : {"LD_LIBRARY_PATH", "GTDD_HOME", "OH_SDK_BASE"})
        permit_folders_of(variable, permissions.read);
    permissions.read_and_write.insert(permissions.read_and_write.end(), {"/dev/null", "/dev/urandom"});
}

void permit_falcon(confine::Permissions& permissions) {
    for (const fs::path& file : falcon_firmware_files()) permissions.read.push_back(file.parent_path());
    permissions.read.push_back(falcon_firmware_folder());
}

}  // namespace

confine::Permissions guard_permissions(std::string_view device) {
    confine::Permissions permissions;
    permissions.calls = confine::Calls::Drive;
#if defined(HANDRAIL_SANITIZED)
    permissions.read.emplace_back("/proc");  // a sanitizer reads /proc to search for memory leaks
#endif
    if (device == "inverse3") {
        permissions.tcp_ports.push_back(kHaplyPort);
        return permissions;
    }
    permit_finding_devices(permissions);
    if (device == "falcon") permit_falcon(permissions);
    else if (device == "force-stick") permissions.read_and_write.emplace_back("/dev/input");
    else permit_makers_library(permissions);
    // A device that only its library can find may be on USB, FireWire, a serial or parallel port, or Ethernet.
    if (is_found_only_by_opening(device)) {
        permissions.read_and_write.emplace_back("/dev");
        permissions.any_internet = true;
    } else if (device != "force-stick") {
        permissions.read_and_write.emplace_back("/dev/bus/usb");
    }
    return permissions;
}

}  // namespace handrail::drivers
