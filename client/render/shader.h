// Takes the text of two shaders; gives a program that runs on the GPU.
#pragma once

#include "client/render/gl_objects.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace billiards::client {

class Shader {
  public:
    /// `name` is said where the driver will not take it: CannotDraw with the driver's words.
    /// `defined` is put before both texts.
    Shader(const char* name, const char* vertex_text, const char* fragment_text,
           const char* defined = "");

    void use() const { glUseProgram(program_.name()); }

    // Of the program in use. A name that the program does not have is nothing.
    void set(const char* name, int value) const;
    void set(const char* name, float value) const;
    void set(const char* name, const glm::vec3& value) const;
    void set(const char* name, const glm::mat3& value) const;
    void set(const char* name, const glm::mat4& value) const;

  private:
    GLint location(const char* name) const;

    GlProgram program_;
};

}  // namespace billiards::client
