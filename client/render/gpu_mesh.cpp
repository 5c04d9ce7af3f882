// Takes a mesh; gives buffers in OpenGL's memory.
#include "client/render/gpu_mesh.h"

#include <cstddef>

namespace billiards::client {

namespace {

void describe(GLuint place, GLint numbers, std::size_t offset) {
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, numbers, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(offset));
}

template <class T>
void upload(GLenum target, const GlBuffer& buffer, const std::vector<T>& values) {
    glBindBuffer(target, buffer.name());
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
                 GL_STATIC_DRAW);
}

}  // namespace

GpuMesh::GpuMesh(const Mesh& mesh) : count_(static_cast<GLsizei>(mesh.indices.size())) {
    glBindVertexArray(array_.name());
    upload(GL_ARRAY_BUFFER, vertices_, mesh.vertices);
    upload(GL_ELEMENT_ARRAY_BUFFER, indices_, mesh.indices);
    describe(0, 3, offsetof(Vertex, position_m));
    describe(1, 3, offsetof(Vertex, normal));
    describe(2, 2, offsetof(Vertex, uv));
}

void GpuMesh::draw() const {
    glBindVertexArray(array_.name());
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
}

}  // namespace billiards::client
