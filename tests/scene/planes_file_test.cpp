// Planes that are saved as a DICOM series: where they lie, their values, and what a checker of DICOM says.
#include "scene/slices/planes_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "dicom/read/dataset.h"
#include "dicom/read/tags.h"
#include "slices/slice_plane.h"
#include "study/open/opened_study.h"
#include "support.h"
#include "synthetic.h"

namespace macula::scene {
namespace {

namespace fs = std::filesystem;

class PlanesFile : public testing::Test {
  protected:
    void SetUp() override {
        series_.size = {24, 20, 16};  // oblique
        dicom::test::writeFiles(folder_ / "ct", series_);
        study_ = open(folder_ / "ct");
        request_ = {.batch = {},
                    .volume = study_.measured(),
                    .found = study_.found,
                    .volumeIndex = study_.volumeIndex,
                    .window = DisplayWindow{.center = 40.0, .width = 400.0}};
        const glm::dvec3 middle = transformPoint(study_.volume->worldFromVoxel(), {12, 10, 8});
        // A plane that is parallel to nothing.
        const glm::dquat turn = glm::angleAxis(0.4, glm::normalize(glm::dvec3(1, 2, 3)));
        const slices::SlicePlane plane =
            slices::tilted(slices::planeOf(slices::Orientation::coronal, middle), turn);
        request_.batch.like = {.plane = plane, .mmPerPixel = 0.37, .sizePx = {60, 48}};
        request_.batch.fromMm = -2.0;
        request_.batch.toMm = 2.0;
        request_.batch.stepMm = 0.5;
    }
    study::OpenedStudy open(const fs::path& path) {
        auto study = study::openStudy(path, progress_);
        EXPECT_TRUE(study) << study.error().message;
        return study ? *std::move(study) : study::OpenedStudy{};
    }
    WrittenPlanes write(const std::string& name) {
        auto written = writePlanes(folder_ / name, request_, progress_);
        if (!written) {
            ADD_FAILURE() << written.error().message;
            return {};
        }
        return *std::move(written);
    }
    std::vector<slices::SliceFrame> frames() const {
        return *framesOf(request_.batch, mmPerPixelOf(request_.batch, *request_.volume));
    }
    ErrorCode refused() {
        const auto written = writePlanes(folder_ / "refused", request_, progress_);
        EXPECT_FALSE(written);
        EXPECT_FALSE(fs::exists(folder_ / "refused"));
        return written ? ErrorCode::deviceLost : written.error().code;
    }

    dicom::test::TemporaryFolder folder_;
    dicom::test::SyntheticSeries series_;
    study::OpenedStudy study_;
    PlaneBatchRequest request_;
    Progress progress_;
};

// Each pixel of the volume that is read back lies where the plane was, with the value that was there.
TEST_F(PlanesFile, ReadBackAsAVolumeInTheSamePlace) {
    const std::vector<slices::SliceFrame> planes = frames();
    ASSERT_EQ(planes.size(), 9u);
    EXPECT_EQ(write("planes").files.size(), 9u);
    const study::OpenedStudy again = open(folder_ / "planes");
    ASSERT_NE(again.volume, nullptr);
    EXPECT_EQ(again.frameOfReferenceUid, study_.frameOfReferenceUid);
    EXPECT_EQ(again.identity.studyDate, study_.identity.studyDate);
    const Volume& volume = *again.measured();
    ASSERT_EQ(volume.size(), glm::ivec3(planes[0].sizePx, 9));
    EXPECT_EQ(volume.unit(), study_.volume->unit());
    double worstMm = 0.0;
    double worst = 0.0;
    std::size_t values = 0;
    for (const slices::SliceFrame& plane : planes) {
        const auto slice = slices::sampleSlice(*study_.measured(), plane, {}, slices::Filter::linear);
        for (int y = 0; y < plane.sizePx.y; ++y)
            for (int x = 0; x < plane.sizePx.x; ++x) {
                const glm::dvec3 mm = plane.worldFromPicture({x + 0.5, y + 0.5});
                const glm::dvec3 voxel = transformPoint(glm::inverse(volume.worldFromVoxel()), mm);
                const glm::ivec3 nearest(glm::round(voxel));
                worstMm =
                    std::max(worstMm, glm::distance(transformPoint(volume.worldFromVoxel(), nearest), mm));
                const float wanted = slice.values[std::size_t(y * plane.sizePx.x + x)];
                const bool isPadding = volume.isPadding(nearest.x, nearest.y, nearest.z);
                ASSERT_EQ(isPadding, std::isnan(wanted));
                if (isPadding) continue;
                ++values;
                worst = std::max(worst, std::abs(volume.value(nearest.x, nearest.y, nearest.z) - wanted));
            }
    }
    EXPECT_GT(values, 1000u);
    EXPECT_LT(worstMm, 0.01);
    EXPECT_LE(worst, 0.5 * study_.volume->unitsFromStored().slope + 1e-3);
}

TEST_F(PlanesFile, RadialPlanesAllHoldTheLine) {
    const glm::dvec3 axis = request_.batch.like.plane.normal();
    const glm::dvec3 through = request_.batch.like.plane.centreMm;
    request_.batch.radial = PlaneBatch::Radial{.count = 8, .throughMm = through, .axis = axis};
    const auto planes = frames();
    ASSERT_EQ(planes.size(), 8u);
    for (std::size_t n = 0; n < planes.size(); ++n) {
        const slices::SlicePlane& plane = planes[n].plane;
        EXPECT_TRUE(plane.isUsable());
        EXPECT_NEAR(std::abs(glm::dot(plane.down, axis)), 1.0, 1e-9);
        EXPECT_EQ(plane.centreMm, through);
        const double degrees =
            glm::degrees(std::acos(std::clamp(glm::dot(planes[0].plane.right, plane.right), -1.0, 1.0)));
        EXPECT_NEAR(degrees, 22.5 * double(n), 1e-6);
    }
    EXPECT_EQ(write("radial").files.size(), 8u);
    request_.batch.radial->axis = {0.0, 0.0, 1.0};
    EXPECT_LT(frames()[0].plane.down.z, 0.0) << "the head is above";
}

TEST_F(PlanesFile, SaysWhatItWasMadeOf) {
    request_.batch.slab = {.thicknessMm = 1.5, .projection = slices::Projection::maximum};
    const auto file = write("slab").files.at(4);
    const auto header = dicom::readHeader(file);
    ASSERT_TRUE(header.header);
    const dicom::Dataset& dataset = *header.header;
    EXPECT_EQ(dataset.shortText(dicom::Tag{0x0018, 0x0050}), "1.5");
    EXPECT_NE(dataset.text(dicom::Tag{0x0008, 0x2111}).value_or("").find("slab of 1.5 mm, maximum"),
              std::string::npos);
    EXPECT_NE(dataset.text(dicom::Tag{0x0008, 0x2111}).value_or("").find("9 parallel planes, 0.5 mm apart"),
              std::string::npos);
    // A coronal plane meets many slices of the series; an axial one the two that it lies between.
    EXPECT_GT(dataset.items(dicom::Tag{0x0008, 0x2112}).size(), 4u);
    request_.batch.slab = {};
    request_.batch.like.plane =
        slices::acquiredPlane(*study_.volume, transformPoint(study_.volume->worldFromVoxel(), {12, 10, 8.5}));
    request_.batch.fromMm = request_.batch.toMm = 0.0;
    const auto axial = dicom::readHeader(write("axial").files.at(0));
    ASSERT_TRUE(axial.header);
    EXPECT_EQ(axial.header->items(dicom::Tag{0x0008, 0x2112}).size(), 2u);
}

TEST_F(PlanesFile, WithoutAPatientNothingNamesOne) {
    request_.isDeidentified = true;
    const study::OpenedStudy again = [&] {
        write("nobody");
        return open(folder_ / "nobody");
    }();
    EXPECT_NE(again.frameOfReferenceUid, study_.frameOfReferenceUid);
    EXPECT_NE(again.identity.patientName, study_.identity.patientName);
    // A volume of no DICOM images can be written so alone.
    request_.found.reset();
    EXPECT_EQ(write("file").files.size(), 9u);
    request_.isDeidentified = false;
    EXPECT_EQ(refused(), ErrorCode::usage);
}

TEST_F(PlanesFile, NumbersThatMakeNoPlanesAreRefused) {
    const PlaneBatch good = request_.batch;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {0.0, nan, std::numeric_limits<double>::infinity()}) {
        request_.batch.stepMm = bad;
        EXPECT_EQ(refused(), ErrorCode::usage) << bad;
    }
    request_.batch = good;
    request_.batch.toMm = nan;
    EXPECT_EQ(refused(), ErrorCode::usage);
    request_.batch.toMm = 90'000.0;
    EXPECT_EQ(refused(), ErrorCode::usage) << "too many";
    request_.batch = good;
    request_.batch.fromMm = request_.batch.toMm = 900.0;
    EXPECT_EQ(refused(), ErrorCode::usage) << "beside the volume";
    request_.batch = good;
    request_.batch.like.plane.right = {nan, 0.0, 0.0};
    EXPECT_EQ(refused(), ErrorCode::usage);
    request_.batch = good;
    request_.batch.radial = PlaneBatch::Radial{.axis = {0.0, 0.0, 0.0}};
    EXPECT_EQ(refused(), ErrorCode::usage);
    request_.batch.radial->axis = {0.0, 0.0, 1.0};
    request_.batch.radial->count = 2'000'000'000;
    EXPECT_EQ(refused(), ErrorCode::usage);
    // The other way round is a batch too.
    request_.batch = good;
    std::swap(request_.batch.fromMm, request_.batch.toMm);
    EXPECT_EQ(frames().size(), 9u);
}

TEST_F(PlanesFile, NothingThatIsThereIsLost) {
    fs::create_directories(folder_ / "full");
    std::ofstream(folder_ / "full/notes.txt") << "mine";
    const auto written = writePlanes(folder_ / "full", request_, progress_);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::outputNotWritable);
    EXPECT_TRUE(fs::exists(folder_ / "full/notes.txt"));
    const CancelToken token;
    token.cancel();
    Progress cancelled([](const ProgressUpdate&) {}, token);
    EXPECT_EQ(writePlanes(folder_ / "none", request_, cancelled).error().code, ErrorCode::cancelled);
    EXPECT_FALSE(fs::exists(folder_ / "none"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 2)
        << "no draft is left";
}

TEST_F(PlanesFile, TheCheckerFindsNoError) {
    if (std::system("command -v dciodvfy >/dev/null 2>&1") != 0)
        GTEST_SKIP() << "dciodvfy is not installed: packaging/bootstrap";
    for (const bool isDeidentified : {false, true}) {
        request_.isDeidentified = isDeidentified;
        const auto file = write(isDeidentified ? "nobody" : "planes").files.at(3);
        const fs::path report = folder_ / "report.txt";
        std::ignore =
            std::system(fmt::format("dciodvfy '{}' >'{}' 2>&1", file.string(), report.string()).c_str());
        std::ifstream stream(report);
        const std::string text((std::istreambuf_iterator<char>(stream)), {});
        EXPECT_NE(text.find("SCImage"), std::string::npos) << text;
        EXPECT_EQ(text.find("Error"), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace macula::scene
