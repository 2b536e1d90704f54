#include "app/window/gl_objects.h"

#include <array>
#include <utility>

#include "worlds/base/language.h"

namespace handrail::window {

Result<void> GlProgram::build(const char* vertex, const char* fragment) {
    for (const auto& [kind, text] : {std::pair(GL_VERTEX_SHADER, vertex), std::pair(GL_FRAGMENT_SHADER, fragment)}) {
        const GLuint shader = glCreateShader(kind);
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(name_, shader);
        glDeleteShader(shader);  // marks the shader for deletion, which happens together with that of the program
    }
    glLinkProgram(name_);
    GLint linked = GL_FALSE;
    glGetProgramiv(name_, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return {};
    std::array<char, 512> log{};
    glGetProgramInfoLog(name_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    return fail(phrase("window.driver_refuses", {{"reason", log.data()}}));
}

}  // namespace handrail::window
