// Takes triangles; gives them to OpenGL, to be drawn any number of times.
#pragma once

#include "client/render/gl_objects.h"
#include "client/scene/mesh.h"

namespace billiards::client {

/// A vertex buffer where the original had a display list.
class GpuMesh {
  public:
    explicit GpuMesh(const Mesh& mesh);
    /// With the shader in use: place 0 is the position, 1 the normal, 2 the texture place.
    void draw() const;

  private:
    GlVertexArray array_ = make_vertex_array();
    GlBuffer vertices_ = make_buffer();
    GlBuffer indices_ = make_buffer();
    GLsizei count_ = 0;
};

}  // namespace billiards::client
