// Provides an OpenGL context that needs no display, with a framebuffer to draw into. So tests can check pictures on a
// machine without a screen.
#pragma once

#include <filesystem>
#include <memory>

#include "app/window/renderer.h"
#include "tests/support/names.h"

namespace handrail::test {

class OffscreenGl {
public:
    // Returns null if the driver cannot draw without a display. The test must then be skipped.
    static std::unique_ptr<OffscreenGl> open(PixelSize size);
    ~OffscreenGl();
    OffscreenGl(const OffscreenGl&) = delete;
    OffscreenGl& operator=(const OffscreenGl&) = delete;

    Picture draw(Renderer& renderer, const ViewState& view);

private:
    OffscreenGl() = default;
    void* display_ = nullptr;
    void* context_ = nullptr;
    unsigned framebuffer_ = 0;
    unsigned planes_[2] = {0, 0};
    PixelSize size_;
};

// Writes a PNG file. Returns false if it cannot be written.
bool save_png(const Picture& picture, const std::filesystem::path& path);

}  // namespace handrail::test
