// Holds the reader of .3ds files against files that are right, and files that are wrong in every
// way that has a name.
#include "client/scene/model_3ds.h"

#include "tools/make_assets/write_3ds.h"

#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace billiards::client {
namespace {

using make_assets::Bytes;
using make_assets::ByteWriter;

Mesh square(std::string name) {
    Mesh mesh{.name = std::move(name), .vertices = {}, .indices = {0, 1, 2, 0, 2, 3}};
    for (const glm::vec2 corner :
         {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        mesh.vertices.push_back(
            {.position_m = {corner.x, corner.y, 0.5F}, .normal = {0, 0, 1}, .uv = 0.5F * corner});
    }
    return mesh;
}

Bytes chunk(std::uint16_t id, const Bytes& body) {
    ByteWriter writer;
    writer.u16(id);
    writer.u32(static_cast<std::uint32_t>(6 + body.size()));
    writer.append(body);
    return std::move(writer).take();
}

template <class Fill>
Bytes filled(Fill fill) {
    ByteWriter writer;
    fill(writer);
    return std::move(writer).take();
}

/// A file around the content of one object.
Bytes file_with(const Bytes& parts, const char* name = "thing") {
    const Bytes object = filled([&](ByteWriter& body) {
        body.text(name);
        body.append(chunk(0x4100, parts));
    });
    return chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, object)));
}

Bytes points(std::uint16_t said, const std::vector<float>& numbers, std::uint16_t id = 0x4110) {
    return chunk(id, filled([&](ByteWriter& body) {
                     body.u16(said);
                     for (const float number : numbers) body.f32(number);
                 }));
}

Bytes one_face(std::uint16_t a, std::uint16_t b, std::uint16_t c) {
    return chunk(0x4120, filled([&](ByteWriter& body) {
                     for (const std::uint16_t number : {std::uint16_t{1}, a, b, c})
                         body.u16(number);
                     body.u16(7);
                 }));
}

Bytes operator+(Bytes a, const Bytes& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

const std::vector<float> kTriangle{0, 0, 0, 1, 0, 0, 0, 1, 0};

Model3dsFault fault_of(const Bytes& bytes) {
    const auto meshes = read_3ds(bytes);
    EXPECT_FALSE(meshes.ok());
    return meshes ? Model3dsFault{} : meshes.error().fault;
}

TEST(Read3ds, GivesEveryMeshAsItWasWritten) {
    const std::vector<Mesh> meshes{square("one"), square("two")};
    const auto read = read_3ds(make_assets::write_3ds(meshes, "wood.bmp"));
    ASSERT_TRUE(read.ok()) << in_words(read.error().fault);
    EXPECT_EQ(*read, meshes);
}

TEST(Read3ds, SkipsWhatItDoesNotKnow) {
    const Bytes unknown = chunk(0x7777, Bytes(5));
    const auto read =
        read_3ds(file_with(unknown + points(3, kTriangle) + unknown + one_face(0, 1, 2) + unknown));
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->front().vertices.size(), 3U);
    EXPECT_EQ(read->front().indices, (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(Read3ds, TakesAMeshWithoutTexturePlaces) {
    const auto read = read_3ds(file_with(points(3, kTriangle) + one_face(0, 1, 2)));
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->front().vertices[1].uv, glm::vec2(0));
}

TEST(Read3ds, TakesFacesBeforeTheirVertices) {
    EXPECT_TRUE(read_3ds(file_with(one_face(0, 1, 2) + points(3, kTriangle))).ok());
}

TEST(Read3ds, RefusesWhatIsNo3ds) {
    EXPECT_EQ(fault_of({}), Model3dsFault::NotA3ds);
    EXPECT_EQ(fault_of(Bytes(100)), Model3dsFault::NotA3ds);
}

TEST(Read3ds, RefusesAFileCutShortAnywhere) {
    const Bytes whole = make_assets::write_3ds(std::vector{square("one")}, "wood.bmp");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        EXPECT_FALSE(read_3ds(std::span(whole).first(size)).ok()) << size;
    }
}

TEST(Read3ds, RefusesALengthBeyondItsParent) {
    Bytes file = file_with(points(3, kTriangle));
    file[8] = std::byte{0xff};  // The length of the edit chunk.
    const auto read = read_3ds(file);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error(), (Model3dsError{Model3dsFault::ChunkBeyondItsParent, 6}));
}

TEST(Read3ds, RefusesALengthThatDoesNotHoldItsOwnHead) {
    for (const int length : {0, 5}) {
        Bytes file = file_with(points(3, kTriangle));
        file[8] = static_cast<std::byte>(length);
        EXPECT_EQ(fault_of(file), Model3dsFault::ChunkBeyondItsParent);
    }
}

TEST(Read3ds, RefusesListsThatAreShorterThanTheySay) {
    EXPECT_EQ(fault_of(file_with(points(4, kTriangle))), Model3dsFault::ChunkTooShort);
    EXPECT_EQ(fault_of(file_with(points(65'535, kTriangle))), Model3dsFault::ChunkTooShort);
    EXPECT_EQ(fault_of(file_with(chunk(0x4120, Bytes(1)))), Model3dsFault::ChunkTooShort);
    EXPECT_EQ(fault_of(file_with(points(3, {0, 0}, 0x4140))), Model3dsFault::ChunkTooShort);
}

TEST(Read3ds, RefusesCoordinatesThatAreNoNumbers) {
    for (const float wrong :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        std::vector<float> numbers = kTriangle;
        numbers[4] = wrong;
        EXPECT_EQ(fault_of(file_with(points(3, numbers))), Model3dsFault::NumberNotFinite);
        EXPECT_EQ(fault_of(file_with(points(1, {0, wrong}, 0x4140))),
                  Model3dsFault::NumberNotFinite);
    }
}

TEST(Read3ds, RefusesAFaceBeyondItsVertices) {
    EXPECT_EQ(fault_of(file_with(points(3, kTriangle) + one_face(0, 1, 3))),
              Model3dsFault::IndexBeyondVertices);
    EXPECT_EQ(fault_of(file_with(one_face(0, 0, 0))), Model3dsFault::IndexBeyondVertices);
}

TEST(Read3ds, RefusesTexturePlacesForOtherVertices) {
    EXPECT_EQ(fault_of(file_with(points(3, kTriangle) + points(2, {0, 0, 1, 1}, 0x4140))),
              Model3dsFault::TexturePlacesDiffer);
}

TEST(Read3ds, RefusesANameWithoutEnd) {
    EXPECT_EQ(fault_of(chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, Bytes(4, std::byte{'a'}))))),
              Model3dsFault::NameWithoutEnd);
    EXPECT_TRUE(
        read_3ds(file_with(points(3, kTriangle), std::string(kMaxMeshName, 'a').c_str())).ok());
    EXPECT_EQ(fault_of(file_with(points(3, kTriangle), std::string(kMaxMeshName + 1, 'a').c_str())),
              Model3dsFault::NameWithoutEnd);
}

TEST(Read3ds, RefusesAFileWithoutMesh) {
    EXPECT_EQ(fault_of(chunk(0x4D4D, {})), Model3dsFault::NoMesh);
    EXPECT_EQ(fault_of(chunk(0x4D4D, chunk(0x3D3D, {}))), Model3dsFault::NoMesh);
}

TEST(Read3ds, HoldsEachLimit) {
    EXPECT_TRUE(read_3ds(make_assets::write_3ds(std::vector(kMaxMeshes, square("a")), "")).ok());
    EXPECT_EQ(fault_of(make_assets::write_3ds(std::vector(kMaxMeshes + 1, square("a")), "")),
              Model3dsFault::TooManyMeshes);

    Mesh many = square("many");
    many.vertices.resize(65'535);
    EXPECT_TRUE(read_3ds(make_assets::write_3ds(std::vector(4, many), "")).ok());
    EXPECT_EQ(fault_of(make_assets::write_3ds(std::vector(5, many), "")),
              Model3dsFault::TooManyVertices);

    Mesh dense = square("dense");
    dense.indices.resize(3 * 65'535);
    EXPECT_TRUE(read_3ds(make_assets::write_3ds(std::vector(4, dense), "")).ok());
    EXPECT_EQ(fault_of(make_assets::write_3ds(std::vector(5, dense), "")),
              Model3dsFault::TooManyFaces);

    EXPECT_EQ(fault_of(Bytes(kMaxModelBytes + 1)), Model3dsFault::FileTooLarge);
}

}  // namespace
}  // namespace billiards::client
