// Takes shader texts; gives a linked program, or the driver's complaint.
#include "client/render/shader.h"

#include "client/render/window.h"

#include <array>
#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

namespace billiards::client {

namespace {

constexpr GLsizei kLogLength = 1024;

[[noreturn]] void refuse(const char* name, const char* log) {
    throw CannotDraw(fmt::format("The graphics driver does not take the shader {}: {}", name, log));
}

GlShader compiled(const char* name, GLenum kind, const char* defined, const char* text) {
    GlShader shader(glCreateShader(kind));
    const std::array texts{"#version 330 core\n", defined, text};
    glShaderSource(shader.name(), static_cast<GLsizei>(texts.size()), texts.data(), nullptr);
    glCompileShader(shader.name());
    GLint is_fine = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &is_fine);
    if (is_fine == GL_TRUE) return shader;
    std::array<char, kLogLength> log{};
    glGetShaderInfoLog(shader.name(), kLogLength, nullptr, log.data());
    refuse(name, log.data());
}

}  // namespace

Shader::Shader(const char* name, const char* vertex_text, const char* fragment_text,
               const char* defined)
    : program_(glCreateProgram()) {
    const GlShader vertex = compiled(name, GL_VERTEX_SHADER, defined, vertex_text);
    const GlShader fragment = compiled(name, GL_FRAGMENT_SHADER, defined, fragment_text);
    glAttachShader(program_.name(), vertex.name());
    glAttachShader(program_.name(), fragment.name());
    glLinkProgram(program_.name());
    GLint is_fine = GL_FALSE;
    glGetProgramiv(program_.name(), GL_LINK_STATUS, &is_fine);
    if (is_fine == GL_TRUE) return;
    std::array<char, kLogLength> log{};
    glGetProgramInfoLog(program_.name(), kLogLength, nullptr, log.data());
    refuse(name, log.data());
}

GLint Shader::location(const char* name) const {
    return glGetUniformLocation(program_.name(), name);
}

void Shader::set(const char* name, int value) const {
    glUniform1i(location(name), value);
}
void Shader::set(const char* name, float value) const {
    glUniform1f(location(name), value);
}
void Shader::set(const char* name, const glm::vec3& value) const {
    glUniform3fv(location(name), 1, glm::value_ptr(value));
}
void Shader::set(const char* name, const glm::mat3& value) const {
    glUniformMatrix3fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void Shader::set(const char* name, const glm::mat4& value) const {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace billiards::client
