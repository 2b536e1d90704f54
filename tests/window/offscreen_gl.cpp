#include "tests/window/offscreen_gl.h"
#include "tests/support/names.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <png.h>

namespace handrail::test {

std::unique_ptr<OffscreenGl> OffscreenGl::open(PixelSize size) {
    if (!epoxy_has_egl() || !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) return nullptr;
    std::unique_ptr<OffscreenGl> gl(new OffscreenGl);
    gl->size_ = size;
    gl->display_ = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!gl->display_ || !eglInitialize(gl->display_, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) return nullptr;
    const EGLint wanted[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    gl->context_ = eglCreateContext(gl->display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (!gl->context_ || !eglMakeCurrent(gl->display_, EGL_NO_SURFACE, EGL_NO_SURFACE, gl->context_)) return nullptr;
    glGenFramebuffers(1, &gl->framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, gl->framebuffer_);
    glGenRenderbuffers(2, gl->planes_);
    glBindRenderbuffer(GL_RENDERBUFFER, gl->planes_[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, gl->planes_[0]);
    glBindRenderbuffer(GL_RENDERBUFFER, gl->planes_[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, gl->planes_[1]);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return nullptr;
    return gl;
}

OffscreenGl::~OffscreenGl() {
    if (!display_) return;
    if (framebuffer_) {
        glDeleteRenderbuffers(2, planes_);
        glDeleteFramebuffers(1, &framebuffer_);
    }
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_) eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

Picture OffscreenGl::draw(Renderer& renderer, const ViewState& view) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    renderer.draw(view, size_);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    return Renderer::read_back(size_);
}

bool save_png(const Picture& picture, const std::filesystem::path& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = PNG_FORMAT_RGB;
    return png_image_write_to_file(&image, path.c_str(), 0, picture.rgb.data(), 0, nullptr) != 0;
}

}  // namespace handrail::test
