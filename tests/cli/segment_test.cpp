// `macula segment`: a ball of bone in water, whose voxels, place and volume are known.
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/run_command.h"

namespace macula::cli {
namespace {

using Json = nlohmann::json;

// As CommandTest::writeBall has it: 24 voxels of 4 mm a side.
int voxelsWithin(double squared) {
    int count = 0;
    for (int x = -23; x <= 23; x += 2)
        for (int y = -23; y <= 23; y += 2)
            for (int z = -23; z <= 23; z += 2) count += x * x + y * y + z * z < squared ? 1 : 0;
    return count;
}

using SegmentVerb = CommandTest;

TEST_F(SegmentVerb, CountsAndWritesWhatIsBetween) {
    const std::string ball = writeBall();
    const int bone = voxelsWithin(100);
    for (const char* name : {"a.nii.gz", "a.nrrd", "a.stl", "a.glb"}) {
        const Ran ran = runMacula({"segment", ball, "-o", at(name), "--threshold", "500", "2000", "--json"});
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        const Json json = Json::parse(ran.out);
        EXPECT_EQ(json["voxels"], bone);
        EXPECT_NEAR(json["ml"].get<double>(), bone * 0.064, 1e-9);
        EXPECT_EQ(json["mean"], 1000.0);
        EXPECT_EQ(json["deviation"], 0.0);
    }
    // The map is a volume of 0 and 1 at the same place: it can be segmented again.
    const Ran again = runMacula(
        {"segment", at("a.nii.gz"), "-o", at("b.nii.gz"), "--grow", "2,2,2", "--tolerance", "0", "--json"});
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_EQ(Json::parse(again.out)["voxels"], bone);
}

TEST_F(SegmentVerb, StepsChangeIt) {
    const std::string ball = writeBall();
    const auto count = [&](std::vector<std::string> more) {
        std::vector<std::string> all{"segment", ball, "-o", at("a.nii"), "--overwrite", "--json"};
        all.insert(all.end(), more.begin(), more.end());
        const Ran ran = runMacula(all);
        return ran.exitCode == 0 ? Json::parse(ran.out)["voxels"].get<int>() : -ran.exitCode;
    };
    const int bone = voxelsWithin(100);
    const int both = voxelsWithin(400);
    EXPECT_EQ(count({"--threshold", "-100", "100"}), both - bone) << "water around bone";
    EXPECT_EQ(count({"--threshold", "-100", "100", "--fill-holes"}), both);
    EXPECT_EQ(count({"--grow", "2,2,2", "--tolerance", "100"}), bone);
    EXPECT_EQ(count({"--threshold", "-2000", "2000", "--grow", "2,2,2"}), 24 * 24 * 24);
    EXPECT_LT(count({"--threshold", "500", "2000", "--shrink-by", "4"}), bone);
    EXPECT_GT(count({"--threshold", "500", "2000", "--grow-by", "4"}), bone);
    EXPECT_EQ(count({"--threshold", "500", "2000", "--min-ml", "1000"}), -2) << "nothing is left";
    EXPECT_EQ(count({}), -2);
    EXPECT_EQ(count({"--threshold", "500"}), -2);
    EXPECT_EQ(count({"--threshold", "500", "2000", "--grow", "900,0,0"}), -2);
    EXPECT_EQ(count({"--threshold", "500", "2000", "--median", "0"}), -2);
}

TEST_F(SegmentVerb, WritesADicomSegmentationOfImages) {
    ASSERT_EQ(runMacula({"phantom", at("PHANTOM")}).exitCode, 0);
    const Ran ran = runMacula({"segment", at("PHANTOM"), "-o", at("bone.dcm"), "--threshold", "300", "3000",
                               "--largest", "--label", "Bone"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(ran.out.find("Bone: "), std::string::npos) << ran.out;
    std::filesystem::rename(at("bone.dcm"), at("PHANTOM/bone.dcm"));
    const Ran info = runMacula({"info", at("PHANTOM")});
    EXPECT_NE(info.out.find("Bone"), std::string::npos) << info.out;
    const std::string ball = writeBall();
    const Ran none = runMacula({"segment", ball, "-o", at("a.dcm"), "--threshold", "500", "2000"});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_NE(none.err.find("DICOM images"), std::string::npos) << none.err;
    const Ran other = runMacula({"segment", ball, "-o", at("a.txt"), "--threshold", "500", "2000"});
    EXPECT_EQ(other.exitCode, 2);
    EXPECT_NE(other.err.find(".nii.gz"), std::string::npos) << other.err;
}

}  // namespace
}  // namespace macula::cli
