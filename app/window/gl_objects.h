// Owns objects of the graphics card: buffers, vertex arrays and programs. Used by the app thread, on which an OpenGL
// context must be current.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <vector>

#include "worlds/base/result.h"

namespace handrail::window {

// Owns one OpenGL name. The context must be current when the object is destroyed.
class GlName {
protected:
    GLuint name_ = 0;
    GlName() = default;
    ~GlName() = default;

public:
    GlName(const GlName&) = delete;
    GlName& operator=(const GlName&) = delete;
};

class GlBuffer : GlName {
public:
    GlBuffer() { glGenBuffers(1, &name_); }
    ~GlBuffer() { glDeleteBuffers(1, &name_); }
    template <class T>
    void fill(GLenum target, const std::vector<T>& values) {
        glBindBuffer(target, name_);
        glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
    }
};

class GlVertexArray : GlName {
public:
    GlVertexArray() { glGenVertexArrays(1, &name_); }
    ~GlVertexArray() { glDeleteVertexArrays(1, &name_); }
    void bind() const { glBindVertexArray(name_); }
};

class GlProgram : GlName {
public:
    GlProgram() { name_ = glCreateProgram(); }
    ~GlProgram() { glDeleteProgram(name_); }

    // Compiles the two shaders and links the program. If the driver rejects it, fails with the driver's own message.
    Result<void> build(const char* vertex, const char* fragment);
    void use() const { glUseProgram(name_); }
    void set(const char* uniform, float value) const { glUniform1f(at(uniform), value); }
    void set(const char* uniform, bool value) const { glUniform1i(at(uniform), value ? 1 : 0); }
    void set(const char* uniform, const glm::vec2& value) const { glUniform2fv(at(uniform), 1, glm::value_ptr(value)); }
    void set(const char* uniform, const glm::vec3& value) const { glUniform3fv(at(uniform), 1, glm::value_ptr(value)); }
    void set(const char* uniform, const glm::mat3& value) const {
        glUniformMatrix3fv(at(uniform), 1, GL_FALSE, glm::value_ptr(value));
    }
    void set(const char* uniform, const glm::mat4& value) const {
        glUniformMatrix4fv(at(uniform), 1, GL_FALSE, glm::value_ptr(value));
    }

private:
    GLint at(const char* uniform) const { return glGetUniformLocation(name_, uniform); }
};

inline const void* byte_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace handrail::window
