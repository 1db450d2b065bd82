// Models of Gaussians from one format to another.
#include "cli/run_command.h"
#include "pipeline/splat/files/model_file.h"

namespace macula::cli {
namespace {

class SplatExport : public CommandTest {
  protected:
    void SetUp() override {
        CommandTest::SetUp();
        splat::Splats splats;
        splats.originMm = {10.0, -20.0, 30.0};
        splats.resize(2);
        splats.position[1] = {1.0f, 2.0f, 3.0f};
        splats.dc[1] = {1.0f, 0.0f, -1.0f};
        ASSERT_TRUE(splat::writeModel(at("model.ply"), splats).ok());
    }
    int codeOf(const std::string& output, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{"splat-export", at("model.ply"), "-o", at(output)};
        words.insert(words.end(), more.begin(), more.end());
        return runMacula(words).exitCode;
    }
};

TEST_F(SplatExport, EachFormatHoldsTheModel) {
    for (const char* name : {"a.ply", "a.spz", "a.glb"}) {
        EXPECT_EQ(codeOf(name), 0) << name;
        const auto read = splat::readModel(at(name));
        ASSERT_TRUE(read.ok()) << name << ": " << read.error().message;
        ASSERT_EQ(read->splats.size(), 2u);
        EXPECT_EQ(read->splats.originMm, glm::dvec3(10.0, -20.0, 30.0));
        EXPECT_LT(glm::distance(read->splats.position[1], glm::vec3(1.0f, 2.0f, 3.0f)), 1e-3f);
        EXPECT_EQ(read->splats.colourSpace, splat::ColourSpace::linear);
    }
    EXPECT_EQ(codeOf("b.glb", {"--display-colours"}), 0);
    EXPECT_EQ(splat::readModel(at("b.glb"))->splats.colourSpace, splat::ColourSpace::display);
}

TEST_F(SplatExport, NothingIsReplacedOrWrittenByMistake) {
    EXPECT_EQ(codeOf("a.glb"), 0);
    EXPECT_EQ(codeOf("a.glb"), 2) << "it is there";
    EXPECT_EQ(codeOf("a.glb", {"--overwrite"}), 0);
    EXPECT_EQ(codeOf("model.ply", {"--overwrite"}), 2) << "it is read";
    EXPECT_EQ(codeOf("a.macula"), 2) << "splats alone are no training";
    EXPECT_EQ(codeOf("a.obj"), 2);
    EXPECT_EQ(runMacula({"splat-export", at("none.ply"), "-o", at("b.glb")}).exitCode, 3);
    EXPECT_FALSE(std::filesystem::exists(at("b.glb")));
}

}  // namespace
}  // namespace macula::cli
