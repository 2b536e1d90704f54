#include "app/window/window_system.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdlib>

#include "worlds/base/language.h"

namespace handrail::window {
namespace {

// These hints exist since GLFW 3.4. An older library rejects them, which has no consequences.
constexpr int kPlatform = 0x00050003, kPlatformWayland = 0x00060003, kPlatformX11 = 0x00060004;
constexpr int kWaylandLibdecor = 0x00053001, kWaylandDisableLibdecor = 0x00038002;
#ifdef GLFW_PLATFORM
static_assert(kPlatform == GLFW_PLATFORM && kPlatformWayland == GLFW_PLATFORM_WAYLAND &&
              kPlatformX11 == GLFW_PLATFORM_X11 && kWaylandLibdecor == GLFW_WAYLAND_LIBDECOR &&
              kWaylandDisableLibdecor == GLFW_WAYLAND_DISABLE_LIBDECOR);
#endif

bool in_wayland_session() {
    const char* display = std::getenv("WAYLAND_DISPLAY");
    return display && *display;
}

bool start_glfw(int platform) {
    glfwInitHint(kPlatform, platform);
    // Do not use libdecor, because it may load GTK, whose accessible objects would replace those of Handrail.
    glfwInitHint(kWaylandLibdecor, kWaylandDisableLibdecor);
    glfwGetError(nullptr);
    return glfwInit() == GLFW_TRUE;
}

// Returns true if this GLFW supports Wayland. The version string names the window systems for which the library was
// built; before 3.4 there was only one.
bool glfw_knows_wayland() { return std::string(glfwGetVersionString()).find("Wayland") != std::string::npos; }

}  // namespace

std::string glfw_problem() {
    const char* description = nullptr;
    glfwGetError(&description);
    return description ? std::string(description) : phrase("window.no_reason");
}

Result<std::unique_ptr<WindowSystem>> WindowSystem::open() {
    if (!start_glfw(kPlatformX11)) {
        const std::string reason = glfw_problem();
        if (!in_wayland_session()) return fail(phrase("window.no_display", {{"reason", reason}}));
        if (!glfw_knows_wayland()) return fail(phrase("window.no_wayland", {{"reason", reason}}));
        if (!start_glfw(kPlatformWayland)) return fail(phrase("window.no_display", {{"reason", glfw_problem()}}));
    }
    if (auto system = x11_system()) return system;
    if (auto system = wayland_system()) return system;
    glfwTerminate();
    return fail(phrase("window.no_display", {{"reason", phrase("window.no_reason")}}));
}

}  // namespace handrail::window
