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
        add_model(assets, part("wood"), wood_meshes(table), "wood.bmp");
        add_model(assets, part("fittings"), fitting_meshes(table), "fittings.bmp");
    }
    add_texture(assets, "cloth", cloth_picture());
    add_texture(assets, "wood", wood_picture());
    add_texture(assets, "fittings", fittings_picture());
}

/// The models name the cue ball's picture; each ball is drawn with its own.
void add_balls(std::vector<Asset>& assets) {
    add_model(assets, "ball", {ball_mesh(32, 30)}, "ball_00.bmp");
    add_model(assets, "ball_low", {ball_mesh(20, 13)}, "ball_00.bmp");
    for (int number = 0; number <= 15; ++number) {
        add_texture(assets, fmt::format("ball_{:02}", number), ball_picture(number));
    }
}

Mesh floor_mesh() {
    constexpr double kTile_m = 1.6;
    const double half = client::kHalfRoom_m;
    Row outline;
    for (const base::Vec2 corner :
         {base::Vec2(-1, -1), base::Vec2(1, -1), base::Vec2(1, 1), base::Vec2(-1, 1)}) {
        outline.push_back({base::Vec3(half * corner, client::kFloor_m),
                           half * corner / base::Vec2(2 * kTile_m, kTile_m)});
    }
    Mesh mesh{.name = "floor", .vertices = {}, .indices = {}};
    add_plate(mesh, outline);
    return mesh;
}

}  // namespace

std::vector<Asset> all_assets() {
    std::vector<Asset> assets;
    add_tables(assets);
    add_balls(assets);
    add_model(assets, "cue", {cue_mesh()}, "cue.bmp");
    add_texture(assets, "cue", cue_picture());
    add_model(assets, "floor", {floor_mesh()}, "floor.bmp");
    add_texture(assets, "floor", floor_picture());
    return assets;
}

}  // namespace billiards::make_assets
