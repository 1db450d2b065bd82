// A view as a DICOM presentation state: written by export, drawn by render, and the same picture.
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/paths.h"
#include "cli/run_command.h"
#include "dicom/write/series_writer.h"
#include "image/image_file.h"

namespace macula::cli {
namespace {

using nlohmann::json;

class Presentation : public CommandTest {
  protected:
    void SetUp() override {
        CommandTest::SetUp();
        writeStudy("study", 0);
        state_ = at("state.dcm");
    }
    // A ball of bone in water, 24 voxels a side; `more` makes it another study.
    void writeStudy(const std::string& name, int more) const {
        constexpr int kSide = 24;
        std::vector<std::uint16_t> voxels;
        for (int k = 0; k < kSide; ++k) {
            for (int j = 0; j < kSide; ++j) {
                for (int i = 0; i < kSide; ++i) {
                    const double r = std::hypot(i - 11.5, j - 11.5, k - 11.5);
                    voxels.push_back(std::uint16_t(r < 6.0 + more ? 2200 : r < 10.0 ? 1040 : 0));
                }
            }
        }
        const auto volume = Volume::create({.size = glm::ivec3(kSide),
                                            .worldFromVoxel = affine({4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {}),
                                            .unitsFromStored = {1.0, -1000.0},
                                            .unit = Unit::hounsfield,
                                            .modality = "CT"},
                                           std::move(voxels));
        ASSERT_TRUE(volume.ok());
        Progress progress;
        ASSERT_TRUE(dicom::writeSeries(*volume, at(name), {}, progress).ok());
    }
    std::string writeView() const {
        const auto builtIn = [](const std::string& file) {
            return json::parse(readAll(macula::test::projectFolder() / "presets" / file));
        };
        const json camera{{"positionMm", {220.0, -420.0, 90.0}},
                          {"targetMm", {46, 46, 46}},
                          {"up", {0, 0, 1}},
                          {"verticalFovDeg", 20.0}};
        return write("view.json", json{{"version", 1},
                                       {"look", "cinematic"},
                                       {"bounces", 2},
                                       {"exposure", 1.25},
                                       {"preset", builtIn("transfer/cinematic-bone.json")},
                                       {"clip", builtIn("clip/left-half.json")},
                                       {"lights", builtIn("lights/rim.json")},
                                       {"camera", camera}}
                                      .dump());
    }
    Ran exportState(const std::vector<std::string>& more, const std::string& study = "study") const {
        std::vector<std::string> all{"export", at(study), "--presentation-state", state_, "--overwrite"};
        all.insert(all.end(), more.begin(), more.end());
        return runMacula(all);
    }
    Ran render(const std::vector<std::string>& more, const std::string& study = "study") const {
        std::vector<std::string> all{"render", at(study), "-o",     at("a.png"), "--size",     "32x24",
                                     "--spp",  "2",       "--seed", "5",         "--overwrite"};
        all.insert(all.end(), more.begin(), more.end());
        return runMacula(all);
    }
    std::vector<float> pixels(const std::vector<std::string>& more) const {
        const Ran ran = render(more);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        const auto picture = image::readImage(at("a.png"));
        EXPECT_TRUE(picture.ok());
        return picture ? picture->pixels : std::vector<float>{};
    }

    std::string state_;
};

TEST_F(Presentation, OfAViewIsTheSamePicture) {
    const std::string view = writeView();
    for (const bool isDeidentified : {false, true}) {
        std::vector<std::string> more{"--session", view};
        if (isDeidentified) more.emplace_back("--deidentify");
        const Ran ran = exportState(more);
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        EXPECT_NE(ran.out.find("24 images"), std::string::npos) << ran.out;
        EXPECT_NE(ran.err.find("no path tracing"), std::string::npos) << "others cannot do that: " << ran.err;
        const auto drawn = pixels({"--presentation-state", state_});
        EXPECT_EQ(drawn, pixels({"--session", view}));
        EXPECT_NE(drawn, pixels({}));
    }
}

TEST_F(Presentation, OfOptionsIsTheSamePicture) {
    const Ran ran = exportState({"--preset", "ct-bone", "--clip", "left-half", "--view", "left"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const auto drawn = pixels({"--presentation-state", state_});
    EXPECT_NE(drawn, pixels({}));
    // What is given besides counts more.
    EXPECT_EQ(pixels({"--presentation-state", state_, "--preset", "ct-bone", "--clip", "left-half"}), drawn);
    EXPECT_NE(pixels({"--presentation-state", state_, "--view", "anterior"}), drawn);
}

// Both fit what can be seen, and not the box around the air.
TEST_F(Presentation, FitsWhatIsVisibleAsRenderDoes) {
    const std::vector<std::string> request{"--preset", "ct-bone", "--view", "left"};
    ASSERT_EQ(exportState(request).exitCode, 0);
    const auto squareOf = [&](std::vector<std::string> more) {
        std::vector<std::string> all{"render", at("study"), "-o",     at("a.png"), "--size",     "24x24",
                                     "--spp",  "2",         "--seed", "5",         "--overwrite"};
        all.insert(all.end(), more.begin(), more.end());
        const Ran ran = runMacula(all);
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        const auto picture = image::readImage(at("a.png"));
        EXPECT_TRUE(picture.ok());
        return picture ? picture->pixels : std::vector<float>{};
    };
    const auto presented = squareOf({"--presentation-state", state_});
    std::vector<std::string> direct = request;
    direct.insert(direct.end(), {"--look", "dvr", "--shading"});
    const auto rendered = squareOf(direct);
    ASSERT_EQ(presented.size(), rendered.size());
    double difference = 0.0;
    double light = 0.0;
    for (std::size_t i = 0; i < rendered.size(); ++i) {
        difference += std::abs(double(presented[i]) - rendered[i]);
        light += rendered[i];
    }
    EXPECT_GT(light, 0.0);
    EXPECT_LT(difference, 0.05 * light) << "in other sizes most of the edges would lie elsewhere";
}

TEST_F(Presentation, IsListedWithItsStudy) {
    ASSERT_EQ(exportState({}).exitCode, 0);
    std::filesystem::rename(state_, at("study/state.dcm"));
    const Ran info = runMacula({"info", at("study"), "--json"});
    ASSERT_EQ(info.exitCode, 0) << info.err;
    EXPECT_NE(info.out.find("presentation-state"), std::string::npos) << info.out;
    EXPECT_EQ(info.out.find("unsupported-sop-class"), std::string::npos) << info.out;
    // The series that it is of is found by itself.
    EXPECT_EQ(render({"--presentation-state", at("study/state.dcm")}).exitCode, 0);
}

TEST_F(Presentation, ThatDoesNotFitIsRefused) {
    const auto refused = [](const Ran& ran, int exitCode, const std::string& words) {
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
    };
    ASSERT_EQ(exportState({"--session", writeView()}).exitCode, 0);
    writeStudy("another", 2);
    refused(render({"--presentation-state", state_}, "another"), 3, "of another series");
    refused(render({"--presentation-state", at("gone.dcm")}), 3, "cannot be read");
    refused(render({"--presentation-state", at("study/IM00001.dcm")}), 3, "no presentation state");
    const std::string whole = readAll(state_);
    refused(render({"--presentation-state", write("cut.dcm", whole.substr(0, whole.size() / 2))}), 3,
            "presentation state");
    EXPECT_EQ(render({"--presentation-state", state_, "--session", writeView()}).exitCode, 2);

    refused(runMacula({"export", writeBall(), "--presentation-state", at("b.dcm")}), 2, "DICOM images");
    refused(runMacula({"export", "phantom:", "--presentation-state", at("b.dcm")}), 2, "DICOM images");
    refused(runMacula({"export", at("study")}), 2, "--output");
    EXPECT_EQ(runMacula({"export", at("study"), "-o", at("b.nii"), "--preset", "ct-bone"}).exitCode, 2);
    EXPECT_EQ(
        runMacula({"export", at("study"), "-o", at("b.nii"), "--presentation-state", at("b.dcm")}).exitCode,
        2);
    EXPECT_EQ(runMacula({"export", at("study"), "--presentation-state", state_}).exitCode, 2)
        << "it is there already";
    EXPECT_FALSE(std::filesystem::exists(at("b.dcm")));
    EXPECT_FALSE(std::filesystem::exists(at("b.nii")));
}

}  // namespace
}  // namespace macula::cli
