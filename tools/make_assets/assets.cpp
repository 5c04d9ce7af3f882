// Takes the meshes and pictures of the other files; gives them as .3ds and .bmp.
#include "tools/make_assets/assets.h"

#include "client/scene/room.h"
#include "tools/make_assets/ball_mesh.h"
#include "tools/make_assets/ball_picture.h"
#include "tools/make_assets/cue.h"
#include "tools/make_assets/fittings.h"
#include "tools/make_assets/surface.h"
#include "tools/make_assets/surface_pictures.h"
#include "tools/make_assets/table_mesh.h"
#include "tools/make_assets/write_3ds.h"
#include "tools/make_assets/write_bmp.h"

#include <fmt/format.h>

namespace billiards::make_assets {

namespace {

using client::Mesh;
using model::TableSize;

void add_model(std::vector<Asset>& assets, const std::string& name, const std::vector<Mesh>& meshes,
               std::string_view texture) {
    assets.push_back({fmt::format("models/{}.3ds", name), write_3ds(meshes, texture)});
}

void add_texture(std::vector<Asset>& assets, const std::string& name, const Picture& picture) {
    assets.push_back({fmt::format("textures/{}.bmp", name), write_bmp(picture)});
}

void add_tables(std::vector<Asset>& assets) {
    for (const auto& [name, size] :
         {std::pair("7ft", TableSize::SevenFoot), std::pair("8ft", TableSize::EightFoot),
          std::pair("9ft", TableSize::NineFoot)}) {
        const model::TableSpec& table = model::table_of(size);
        const auto part = [name = name](const char* of) {
            return fmt::format("table_{}_{}", name, of);
        };
        add_model(assets, part("cloth"), cloth_meshes(table), "cloth.bmp");
        add_model(assets, part("cushion"), cushion_meshes(table), "cushion.bmp");
        add_model(assets, part("shade"), shade_meshes(table), "table_shade.bmp");
        add_model(assets, part("wood"), wood_meshes(table), "wood.bmp");
        add_model(assets, part("fittings"), fitting_meshes(table), "fittings.bmp");
    }
    add_texture(assets, "cloth", cloth_picture());
    add_texture(assets, "cushion", cushion_picture());
    add_texture(assets, "table_shade", table_shade_picture());
    add_texture(assets, "wood", wood_picture());
    add_texture(assets, "fittings", fittings_picture());
}

Mesh plate(const std::string& name, double half_side, double height_m, const base::Vec2& tile) {
    Row outline;
    for (const base::Vec2 corner :
         {base::Vec2(-1, -1), base::Vec2(1, -1), base::Vec2(1, 1), base::Vec2(-1, 1)}) {
        outline.push_back({base::Vec3(half_side * corner, height_m), half_side * corner / tile});
    }
    Mesh mesh{.name = name, .vertices = {}, .indices = {}};
    add_plate(mesh, outline);
    return mesh;
}

/// The models name the cue ball's picture; each ball is drawn with its own. The shade at a ball's
/// foot is a square of side 2; its picture lies around the middle.
void add_balls(std::vector<Asset>& assets) {
    add_model(assets, "ball", {ball_mesh(32, 30)}, "ball_00.bmp");
    add_model(assets, "ball_low", {ball_mesh(20, 13)}, "ball_00.bmp");
    Mesh shade = plate("shade", 1.0, 0.0, {2.0, 2.0});
    for (client::Vertex& vertex : shade.vertices) vertex.uv += 0.5F;
    add_model(assets, "ball_shade", {shade}, "ball_shade.bmp");
    add_texture(assets, "ball_shade", ball_shade_picture());
    for (int number = 0; number <= 15; ++number) {
        add_texture(assets, fmt::format("ball_{:02}", number), ball_picture(number));
    }
}

}  // namespace

std::vector<Asset> all_assets() {
    std::vector<Asset> assets;
    add_tables(assets);
    add_balls(assets);
    add_model(assets, "cue", {cue_mesh()}, "cue.bmp");
    add_texture(assets, "cue", cue_picture());
    add_model(assets, "floor", {plate("floor", client::kHalfRoom_m, client::kFloor_m, {3.2, 1.6})},
              "floor.bmp");
    add_texture(assets, "floor", floor_picture());
    return assets;
}

}  // namespace billiards::make_assets
