// Opens the program where something is missing or damaged; gives whether it says so in a sentence,
// and ends with 1.
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace billiards::client {
namespace {

namespace fs = std::filesystem;

class WindowErrors : public testing::Test {
  protected:
    struct Ran {
        int exit_code = -1;
        std::string said;
    };

    /// Without a display, except where `environment` names one.
    Ran run(const std::vector<std::string>& options,
            const std::vector<std::string>& environment = {}) const {
        std::vector<std::string> command{"/usr/bin/env",
                                         "-u",
                                         "DISPLAY",
                                         "-u",
                                         "WAYLAND_DISPLAY",
                                         "ASAN_OPTIONS=detect_leaks=0",
                                         "LIBGL_ALWAYS_SOFTWARE=1"};
        command.insert(command.end(), environment.begin(), environment.end());
        command.insert(command.end(),
                       {BILLIARDS_PROGRAM, "--data", (folder_.path() / "data").string()});
        command.insert(command.end(), options.begin(), options.end());
        support::Process program(command);
        Ran ran;
        for (const std::string& line : program.read_lines()) ran.said += line + "\n";
        ran.exit_code = program.exit_code();
        return ran;
    }

    /// The picture of the menu, into `picture()`.
    Ran draw(const std::vector<std::string>& options = {},
             const std::vector<std::string>& environment = {}) const {
        std::vector<std::string> words{"--offscreen", "--screenshot", picture().string()};
        words.insert(words.end(), options.begin(), options.end());
        return run(words, environment);
    }
    fs::path picture() const { return folder_.path() / "picture.png"; }

    static void expect_told(const Ran& ran, const std::string& what) {
        EXPECT_EQ(ran.exit_code, 1) << ran.said;
        EXPECT_NE(ran.said.find("billiards: "), std::string::npos) << ran.said;
        EXPECT_NE(ran.said.find(what), std::string::npos) << ran.said;
    }

    support::TemporaryFolder folder_;
};

TEST_F(WindowErrors, NothingIsWrongWithWhatComesWithIt) {
    const Ran ran = draw();
    EXPECT_EQ(ran.exit_code, 0) << ran.said;
    EXPECT_TRUE(fs::exists(picture()));
}

TEST_F(WindowErrors, NoDisplay) {
    expect_told(run({}), "No display can be opened");
}

TEST_F(WindowErrors, OpenGlIsTooOld) {
    expect_told(draw({}, {"MESA_GL_VERSION_OVERRIDE=2.1"}), "OpenGL 3.3");
}

TEST_F(WindowErrors, ASizeThatIsNone) {
    for (const char* size : {"1280", "0x0", "1280x720x", "99999x720", "-1x-1"}) {
        expect_told(draw({"--size", size}), std::string("--size ") + size);
    }
}

TEST_F(WindowErrors, ASceneThatIsNone) {
    expect_told(draw({"--scene", "nowhere"}), "--scene nowhere");
}

TEST_F(WindowErrors, AReportThatCannotBeWritten) {
    const std::string report = (folder_.path() / "nowhere" / "report").string();
    expect_told(draw({"--report", report}), report);
}

TEST_F(WindowErrors, APictureThatCannotBeWritten) {
    const std::string picture = (folder_.path() / "nowhere" / "a.png").string();
    expect_told(run({"--offscreen", "--screenshot", picture}), picture);
}

TEST_F(WindowErrors, ASceneWithNoFolderToPlayIn) {
    const fs::path data = folder_.path() / "data";
    std::ofstream(data) << "no folder";
    expect_told(draw({"--scene", "rack"}), data.string());
}

TEST_F(WindowErrors, ANameThatNoServerTakes) {
    for (const std::string& name : {std::string(100, 'x'), std::string(" "), std::string()}) {
        expect_told(draw({"--name", name}), "--name " + name);
    }
}

/// A copy of the models and textures, to be damaged.
class WindowAssets : public WindowErrors {
  protected:
    WindowAssets() { fs::copy(BILLIARDS_ASSETS, assets_, fs::copy_options::recursive); }

    void expect_told_of(const fs::path& file) const {
        expect_told(draw({"--assets", assets_.string()}), file.filename().string());
    }
    /// Little-endian, as both formats have it.
    static void write_number(const fs::path& file, std::streamoff at, std::uint32_t number) {
        std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
        stream.seekp(at);
        for (int byte = 0; byte < 4; ++byte) {
            stream.put(static_cast<char>(number >> (8 * byte) & 0xFFU));
        }
    }
    static void cut(const fs::path& file) { fs::resize_file(file, fs::file_size(file) / 2); }

    static constexpr std::streamoff kChunkLength = 2;
    static constexpr std::streamoff kBitmapWidth = 18;
    static constexpr std::streamoff kBitmapHeight = 22;

    fs::path assets_ = folder_.path() / "assets";
    fs::path model_ = assets_ / "models" / "floor.3ds";
    fs::path texture_ = assets_ / "textures" / "cloth.bmp";
};

TEST_F(WindowAssets, AModelThatIsMissing) {
    fs::remove(model_);
    expect_told_of(model_);
}

TEST_F(WindowAssets, AModelThatIsCutOff) {
    cut(model_);
    expect_told_of(model_);
}

TEST_F(WindowAssets, AModelWhoseLengthLies) {
    write_number(model_, kChunkLength, 0xFFFFFFFF);
    expect_told_of(model_);
}

TEST_F(WindowAssets, ATextureThatIsMissing) {
    fs::remove(texture_);
    expect_told_of(texture_);
}

TEST_F(WindowAssets, ATextureThatIsCutOff) {
    cut(texture_);
    expect_told_of(texture_);
}

TEST_F(WindowAssets, ATextureOf100By100) {
    write_number(texture_, kBitmapWidth, 100);
    write_number(texture_, kBitmapHeight, 100);
    expect_told_of(texture_);
}

TEST_F(WindowAssets, ATextureThatSaysItIsHuge) {
    write_number(texture_, kBitmapWidth, 4096);
    write_number(texture_, kBitmapHeight, 4096);
    expect_told_of(texture_);
}

TEST_F(WindowAssets, ATextureWhoseLengthLies) {
    write_number(texture_, kBitmapWidth, 0x7FFFFFFF);
    expect_told_of(texture_);
}

}  // namespace
}  // namespace billiards::client
