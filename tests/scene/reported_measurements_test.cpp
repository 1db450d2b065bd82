// Measurements as a report: each place is that of the pixel or the point that it was made of, each number
// that of the window, and nothing is lost in silence.
#include "scene/slices/reported_measurements.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "base/atomic_file.h"
#include "study/open/slice_images.h"
#include "support.h"
#include "synthetic.h"

namespace macula::scene {
namespace {

using dicom::PointsInSpace;
using dicom::PointsOnImage;
using dicom::test::Slice;
using slices::Angle;
using slices::Distance;
using slices::Ellipse;
using slices::Measurement;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The middle of a pixel, from the numbers that its header holds.
glm::dvec3 middleOf(const Slice& slice, double column, double row) {
    return slice.positionMm + column * slice.columnSpacingMm * slice.rowDirection +
           row * slice.rowSpacingMm * slice.columnDirection;
}

class ReportedMeasurementsTest : public testing::Test {
  protected:
    void open(const std::filesystem::path& folder) {
        auto scan = dicom::test::scan(folder);
        ASSERT_TRUE(scan);
        found_ = std::make_shared<const study::FoundVolumes>(*std::move(scan));
        ASSERT_EQ(found_->volumes().size(), 1u);
        volume_ = dicom::test::load(*of().series, *of().stack);
        ASSERT_TRUE(volume_);
    }
    void openSeries() {
        slices_ = dicom::test::slicesOf(series_);
        dicom::test::writeFiles(folder_ / "study", series_, slices_);
        open(folder_ / "study");
    }
    const study::FoundVolume& of() const { return found_->volumes()[0]; }
    Result<SaidMeasurements> say(const std::vector<Measurement>& measurements, bool isDeidentified = false) {
        return saidMeasurements(measurements, {*volume_, *of().series, *of().stack}, isDeidentified);
    }
    // In the plane of that slice, of 1.5 by 2.5 pixels around the middle of a pixel.
    Ellipse ellipseOn(const Slice& slice, double column, double row) const {
        Ellipse ellipse;
        ellipse.plane = {.centreMm = middleOf(slice, column, row),
                         .right = slice.rowDirection,
                         .down = slice.columnDirection};
        ellipse.radiiMm = {1.5 * slice.columnSpacingMm, 2.5 * slice.rowSpacingMm};
        return ellipse;
    }
    static std::map<std::string, double> numbersOf(const dicom::ReportedMeasurement& said) {
        std::map<std::string, double> numbers;
        for (const dicom::ReportedNumber& each : said.numbers)
            numbers[each.name.meaning + " in " + each.unit.value] = each.value;
        return numbers;
    }
    static void expectPixels(const dicom::ReportedMeasurement& said, const std::vector<glm::dvec2>& pixels) {
        const auto* on = std::get_if<PointsOnImage>(&said.points);
        ASSERT_NE(on, nullptr);
        ASSERT_EQ(on->pointsPx.size(), pixels.size());
        for (std::size_t i = 0; i < pixels.size(); ++i)
            EXPECT_LT(glm::length(on->pointsPx[i] - pixels[i]), 1e-4) << i;
    }

    const dicom::test::TemporaryFolder folder_;
    dicom::test::SyntheticSeries series_;
    std::vector<Slice> slices_;
    std::shared_ptr<const study::FoundVolumes> found_;
    std::shared_ptr<const Volume> volume_;
};

TEST_F(ReportedMeasurementsTest, ALesionHasBothAxesWithALineEach) {
    openSeries();
    const Slice& one = slices_[3];
    const slices::Bidirectional lesion{.firstMm = {middleOf(one, 3, 1), middleOf(one, 3, 2)},
                                       .secondMm = {middleOf(one, 1, 1), middleOf(one, 5, 1)}};
    const auto said =
        say({{.shape = lesion}, {.label = "seen", .shape = slices::Arrow{middleOf(one, 1, 1), {}}}});
    ASSERT_TRUE(said) << said.error().message.english();
    ASSERT_EQ(said->report.measurements.size(), 1u);
    const dicom::ReportedMeasurement& each = said->report.measurements[0];
    EXPECT_EQ(each.label, "Bidirectional 1");
    expectPixels(each, {{1.5, 1.5}, {5.5, 1.5}});
    ASSERT_TRUE(each.second);
    const auto* other = std::get_if<PointsOnImage>(&*each.second);
    ASSERT_NE(other, nullptr);
    EXPECT_LT(glm::length(other->pointsPx[0] - glm::dvec2(3.5, 1.5)), 1e-4);
    ASSERT_EQ(each.numbers.size(), 2u);
    EXPECT_EQ(each.numbers[0].name, (CodedName{"103339001", "SCT", "Long Axis"}));
    EXPECT_NEAR(each.numbers[0].value, 4.0 * one.columnSpacingMm, 1e-9);
    EXPECT_EQ(each.numbers[1].name, (CodedName{"103340004", "SCT", "Short Axis"}));
    EXPECT_NEAR(each.numbers[1].value, one.rowSpacingMm, 1e-9);
    EXPECT_TRUE(each.numbers[1].isOfSecond);
    ASSERT_EQ(said->leftOut.size(), 1u);
    EXPECT_NE(said->leftOut[0].english().find("arrows"), std::string::npos);
    const auto none = say({{.shape = slices::Outline{}}, {.shape = slices::OpenLine{}}});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::usage);
}

TEST_F(ReportedMeasurementsTest, InThePlaneOfAnImageTheyAreInItsPixels) {
    openSeries();
    const Slice& one = slices_[3];
    const Slice& other = slices_[8];
    const Distance distance{{middleOf(one, 1, 2), middleOf(one, 4, 2.5)}};
    const Angle angle{{middleOf(other, 2, 1), middleOf(other, 2, 3), middleOf(other, 5, 3)}};
    const Ellipse ellipse = ellipseOn(one, 3, 3);
    const auto said =
        say({{.label = "Größe", .shape = distance}, {.shape = angle}, {.shape = ellipse}, {.shape = angle}});
    ASSERT_TRUE(said) << said.error().message.english();
    EXPECT_TRUE(said->leftOut.empty());
    const dicom::MeasurementReport& report = said->report;
    ASSERT_EQ(report.measurements.size(), 4u);
    EXPECT_EQ(report.series.seriesInstanceUid, series_.seriesUid);
    EXPECT_EQ(report.series.frameOfReferenceUid, series_.frameOfReferenceUid);
    EXPECT_EQ(report.modality, "CT");
    ASSERT_EQ(report.series.images.size(), 2u) << "each once";
    EXPECT_EQ(report.series.images[0].sopInstanceUid, one.sopInstanceUid);
    EXPECT_EQ(report.series.images[1].sopInstanceUid, other.sopInstanceUid);
    EXPECT_EQ(said->image.sopInstanceUid, one.sopInstanceUid);

    EXPECT_EQ(report.measurements[0].label, "Größe");
    expectPixels(report.measurements[0], {{1.5, 2.5}, {4.5, 3.0}});
    const double mm = std::hypot(3 * one.columnSpacingMm, 0.5 * one.rowSpacingMm);
    EXPECT_NEAR(numbersOf(report.measurements[0]).at("Length in mm"), mm, 1e-9);

    EXPECT_EQ(report.measurements[1].label, "Angle 1");
    EXPECT_EQ(report.measurements[3].label, "Angle 2");
    EXPECT_EQ(std::get<PointsOnImage>(report.measurements[1].points).image, 1u);
    expectPixels(report.measurements[1], {{2.5, 1.5}, {2.5, 3.5}, {5.5, 3.5}});
    EXPECT_NEAR(numbersOf(report.measurements[1]).at("Angle in deg"), 90.0, 1e-9);

    const dicom::ReportedMeasurement& region = report.measurements[2];
    EXPECT_EQ(region.shape, dicom::ReportedShape::ellipse);
    // The longer axis comes first.
    const bool isUpright = 2.5 * one.rowSpacingMm > 1.5 * one.columnSpacingMm;
    ASSERT_TRUE(isUpright);
    expectPixels(region, {{3.5, 1.0}, {3.5, 6.0}, {2.0, 3.5}, {5.0, 3.5}});
    const auto values = slices::valuesIn(ellipse, *volume_);
    ASSERT_TRUE(values);
    const auto numbers = numbersOf(region);
    EXPECT_EQ(numbers.size(), 5u);
    EXPECT_NEAR(numbers.at("Area in mm2"),
                std::acos(-1.0) * 1.5 * one.columnSpacingMm * 2.5 * one.rowSpacingMm, 1e-9);
    EXPECT_EQ(numbers.at("Mean Attenuation Coefficient in [hnsf'U]"), values->mean);
    EXPECT_EQ(numbers.at("Standard Deviation of Attenuation Coefficient in [hnsf'U]"), values->deviation);
    EXPECT_EQ(numbers.at("Minimum Attenuation Coefficient in [hnsf'U]"), values->low);
    EXPECT_EQ(numbers.at("Maximum Attenuation Coefficient in [hnsf'U]"), values->high);
    EXPECT_TRUE(region.comment.empty());
}

TEST_F(ReportedMeasurementsTest, AcrossImagesTheyAreInSpace) {
    openSeries();
    const glm::dvec3 from = middleOf(slices_[2], 1, 1);
    const glm::dvec3 to = middleOf(slices_[5], 4, 3);
    const auto said = say({{.shape = Distance{{from, to}}},
                           {.shape = Distance{{middleOf(slices_[7], -3, 1), middleOf(slices_[7], 4, 1)}}}});
    ASSERT_TRUE(said);
    const auto* points = std::get_if<PointsInSpace>(&said->report.measurements[0].points);
    ASSERT_NE(points, nullptr);
    EXPECT_EQ(points->pointsMm, (std::vector<glm::dvec3>{from, to}));
    EXPECT_NE(std::get_if<PointsInSpace>(&said->report.measurements[1].points), nullptr)
        << "it begins beside the image";
    std::vector<std::string> images;
    for (const dicom::ReferencedImage& each : said->report.series.images)
        images.push_back(each.sopInstanceUid);
    std::vector<std::string> between;
    for (const std::size_t slice : {2, 3, 4, 5, 7}) between.push_back(slices_[slice].sopInstanceUid);
    EXPECT_EQ(images, between);
}

TEST_F(ReportedMeasurementsTest, WhereThereIsNoImageTheyAreInSpace) {
    series_.places = {0, 1, 2, 4, 5, 6};  // the fourth slice is interpolated
    series_.size.z = 6;
    openSeries();
    ASSERT_EQ(volume_->size().z, 7);
    Slice missing = slices_[2];
    missing.positionMm = 0.5 * (slices_[2].positionMm + slices_[3].positionMm);
    const auto said = say({{.shape = ellipseOn(missing, 3, 3)}});
    ASSERT_TRUE(said);
    const dicom::ReportedMeasurement& region = said->report.measurements[0];
    EXPECT_NE(std::get_if<PointsInSpace>(&region.points), nullptr);
    const auto values = slices::valuesIn(ellipseOn(missing, 3, 3), *volume_);
    ASSERT_TRUE(values);
    EXPECT_EQ(region.comment, "Of " + std::to_string(values->voxels) + " voxels, " +
                                  std::to_string(values->voxels) + " lie in slices without an image.");
    ASSERT_EQ(said->report.series.images.size(), 2u);
    EXPECT_EQ(said->report.series.images[0].sopInstanceUid, slices_[2].sopInstanceUid);
    EXPECT_EQ(said->report.series.images[1].sopInstanceUid, slices_[3].sopInstanceUid);
}

TEST_F(ReportedMeasurementsTest, WithoutFrameOfReferenceThoseInSpaceAreLeftOutAndASentenceSaysSo) {
    series_.frameOfReferenceUid.clear();
    openSeries();
    const Measurement inPlane{.shape = Distance{{middleOf(slices_[2], 1, 1), middleOf(slices_[2], 2, 1)}}};
    const Measurement across{.shape = Distance{{middleOf(slices_[2], 1, 1), middleOf(slices_[4], 2, 1)}}};
    const auto said = say({across, inPlane});
    ASSERT_TRUE(said);
    ASSERT_EQ(said->report.measurements.size(), 1u);
    EXPECT_EQ(said->report.measurements[0].label, "Distance 2") << "as the window numbers it";
    ASSERT_EQ(said->leftOut.size(), 1u);
    EXPECT_NE(said->leftOut[0].english().find("of 2 measurements, it leaves out 1"), std::string::npos);
    const auto none = say({across});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::usage);
    EXPECT_NE(none.error().message.english().find("frame of reference"), std::string::npos);
}

TEST_F(ReportedMeasurementsTest, WhatIsNotDefinedIsLeftOutAndASentenceSaysSo) {
    openSeries();
    const glm::dvec3 a = middleOf(slices_[2], 1, 1);
    Ellipse huge = ellipseOn(slices_[2], 3, 3);
    huge.radiiMm = {1e200, 1e200};
    std::vector<Measurement> measurements{{.shape = Distance{{a, {kNaN, 0, 0}}}},
                                          {.shape = Angle{{a, a, middleOf(slices_[2], 2, 1)}}},
                                          {.shape = huge},
                                          {.shape = Distance{{a, {1e30, 0, 0}}}}};
    const auto none = say(measurements);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::usage);
    EXPECT_FALSE(none.error().hint.empty());
    measurements.push_back({.shape = Distance{{a, a}}});  // 0 mm is a length
    const auto said = say(measurements);
    ASSERT_TRUE(said);
    ASSERT_EQ(said->report.measurements.size(), 1u);
    EXPECT_EQ(said->report.measurements[0].numbers[0].value, 0.0);
    ASSERT_EQ(said->leftOut.size(), 1u);
    EXPECT_NE(said->leftOut[0].english().find("of 5 measurements, it leaves out 4"), std::string::npos)
        << said->leftOut[0].english();
    EXPECT_FALSE(say({}));
    // Outside of the volume an ellipse has an area alone.
    Ellipse outside = ellipseOn(slices_[2], 3, 3);
    outside.plane.centreMm += 500.0 * outside.plane.normal();
    const auto area = say({{.shape = outside}});
    ASSERT_TRUE(area);
    EXPECT_EQ(area->report.measurements[0].numbers.size(), 1u);
}

TEST_F(ReportedMeasurementsTest, OneVoxelHasNoDeviation) {
    openSeries();
    Ellipse small = ellipseOn(slices_[2], 3, 3);
    small.radiiMm = {0.01, 0.01};
    const auto said = say({{.shape = small}});
    ASSERT_TRUE(said);
    EXPECT_EQ(said->report.measurements[0].numbers.size(), 4u);
    EXPECT_FALSE(numbersOf(said->report.measurements[0])
                     .contains("Standard Deviation of Attenuation Coefficient in [hnsf'U]"));
}

TEST_F(ReportedMeasurementsTest, OfAFileOfSeveralFramesTheFrameIsNamed) {
    slices_ = dicom::test::slicesOf(series_);
    std::filesystem::create_directories(folder_ / "frames");
    dicom::test::writeMultiFrame(folder_ / "frames" / "all.dcm", series_, slices_);
    open(folder_ / "frames");
    const auto said = say({{.shape = Distance{{middleOf(slices_[5], 1, 1), middleOf(slices_[5], 2, 1)}}}});
    ASSERT_TRUE(said);
    EXPECT_EQ(std::get<PointsOnImage>(said->report.measurements[0].points).frame, 6);
    EXPECT_EQ(said->report.series.images.size(), 1u);
}

TEST_F(ReportedMeasurementsTest, UnitsAreThoseOfTheVolume) {
    openSeries();
    const auto unitOf = [&](VolumeOptions options) {
        options.size = volume_->size();
        options.worldFromVoxel = volume_->worldFromVoxel();
        auto made = Volume::create(std::move(options), std::vector<std::uint16_t>(volume_->voxelCount(), 7));
        EXPECT_TRUE(made.ok());
        volume_ = std::make_shared<const Volume>(*std::move(made));
        const auto said = say({{.shape = ellipseOn(slices_[2], 3, 3)}});
        EXPECT_TRUE(said);
        const dicom::ReportedMeasurement& region = said->report.measurements[0];
        EXPECT_EQ(region.numbers[1].name.meaning, "Mean");
        EXPECT_EQ(region.numbers[1].value, 7.0);
        return region.numbers[1].unit.value + " " + region.numbers[1].unit.scheme + " " +
               region.numbers[1].unit.meaning;
    };
    EXPECT_EQ(unitOf({.unit = Unit::raw}), "1 UCUM no units");
    EXPECT_EQ(unitOf({.unit = Unit::suvBodyWeight}),
              "g/ml{SUVbw} UCUM Standardized Uptake Value body weight");
    EXPECT_EQ(unitOf({.unit = Unit::becquerelsPerMillilitre}), "Bq/ml UCUM Becquerels/milliliter");
    EXPECT_EQ(unitOf({.unit = Unit::other, .unitName = "10⁻⁶ mm²/s"}), "UNIT-OF-IMAGES 99MACULA 10⁻⁶ mm²/s");
    EXPECT_EQ(unitOf({.unit = Unit::other, .unitName = "a\\b"}), "UNIT-OF-IMAGES 99MACULA a/b");
    const std::string longest(80, 'u');
    EXPECT_EQ(unitOf({.unit = Unit::other, .unitName = longest}),
              "UNIT-OF-IMAGES 99MACULA " + longest.substr(0, 64));

    VolumeOptions estimated{.size = volume_->size(), .worldFromVoxel = volume_->worldFromVoxel()};
    estimated.provenance.isCalibrated = false;
    volume_ = std::make_shared<const Volume>(
        *Volume::create(std::move(estimated), std::vector<std::uint16_t>(volume_->voxelCount(), 7)));
    const glm::dvec3 a = middleOf(slices_[2], 1, 1);
    const glm::dvec3 b = middleOf(slices_[2], 2, 1);
    const auto said =
        say({{.shape = Distance{{a, b}}}, {.shape = Angle{{a, b, middleOf(slices_[2], 2, 2)}}}});
    ASSERT_TRUE(said);
    EXPECT_NE(said->report.measurements[0].comment.find("estimates"), std::string::npos);
    EXPECT_TRUE(said->report.measurements[1].comment.empty());
}

TEST_F(ReportedMeasurementsTest, AsAFileWithAndWithoutPatient) {
    openSeries();
    ReportRequest request{
        .measurements = {{.label = "Ms Miller's cyst",
                          .shape = Distance{{middleOf(slices_[2], 1, 1), middleOf(slices_[2], 2, 1)}}}},
        .volume = volume_,
        .found = found_};
    const std::filesystem::path path = folder_ / "report.dcm";
    for (const bool isDeidentified : {false, true}) {
        request.isDeidentified = isDeidentified;
        const auto written = writeMeasurementReport(path, request);
        ASSERT_TRUE(written) << written.error().message.english();
        EXPECT_EQ(written->size(), isDeidentified ? 1u : 0u);
        const auto found = dicom::test::scan(path);
        ASSERT_TRUE(found);
        ASSERT_EQ(found->studies.size(), 1u);
        const dicom::Study& study = found->studies[0];
        ASSERT_EQ(study.series.size(), 1u);
        ASSERT_EQ(study.series[0].objects.size(), 1u);
        EXPECT_EQ(study.series[0].objects[0].kind.english(), "Structured report");
        EXPECT_EQ(study.patientId == series_.patientId, !isDeidentified);
        EXPECT_EQ(study.studyInstanceUid == series_.studyUid, !isDeidentified);
        const auto bytes = readText(path);
        ASSERT_TRUE(bytes);
        EXPECT_EQ(bytes->find("Miller") != std::string::npos, !isDeidentified);
    }
    // The same finding has the same UID in each report, and none of it when nobody may be recognised.
    const auto once = say(request.measurements);
    const auto again = say(request.measurements);
    EXPECT_EQ(once->report.measurements[0].trackingUid, again->report.measurements[0].trackingUid);
    EXPECT_NE(say(request.measurements, true)->report.measurements[0].trackingUid,
              once->report.measurements[0].trackingUid);
}

// The report must not name an image of which nothing was shown.
TEST_F(ReportedMeasurementsTest, AnImageThatCouldNotBeReadIsNotReferredTo) {
    slices_ = dicom::test::slicesOf(series_);
    dicom::test::writeFiles(folder_ / "study", series_, slices_);
    auto scan = dicom::test::scan(folder_ / "study");
    ASSERT_TRUE(scan);
    found_ = std::make_shared<const study::FoundVolumes>(*std::move(scan));
    ASSERT_EQ(found_->volumes().size(), 1u);
    const dicom::Stack& stack = *of().stack;
    const std::size_t count = stack.slices.size();
    const auto cut = [&](std::size_t slice) {
        const std::filesystem::path& file = stack.frames.at(stack.slices[slice].below).instance->file;
        std::filesystem::resize_file(file, std::filesystem::file_size(file) - 40);
    };
    cut(0);  // the volume begins behind it
    cut(5);  // interpolated
    volume_ = dicom::test::load(*of().series, stack);
    ASSERT_TRUE(volume_);
    ASSERT_EQ(std::size_t(volume_->size().z), count - 1);

    const std::vector<study::SliceImage> images = study::imagesOfSlices(*volume_, stack);
    ASSERT_EQ(images.size(), count - 1);
    const std::vector<glm::dvec3> positionsMm = dicom::slicePositionsMm(stack);
    for (std::size_t k = 0; k < images.size(); ++k) {
        EXPECT_LT(glm::length(images[k].positionMm - positionsMm[k + 1]), 1e-3) << k;
        const bool isInterpolated = k + 1 == 5;
        ASSERT_EQ(images[k].frame == nullptr, isInterpolated) << k;
        if (!isInterpolated) {
            EXPECT_EQ(images[k].frame, &stack.frames.at(stack.slices[k + 1].below)) << k;
        }
    }

    const auto middleOnSlice = [&](std::size_t slice, double column, double row) {
        const dicom::ImagePlane& plane = *stack.frames.at(stack.slices[slice].below).plane;
        return plane.positionMm + column * plane.columnSpacingMm * plane.rowDirection +
               row * plane.rowSpacingMm * plane.columnDirection;
    };
    const auto uidOf = [&](std::size_t slice) {
        return stack.frames.at(stack.slices[slice].below).instance->sopInstanceUid;
    };
    const auto said = say({{.shape = Distance{{middleOnSlice(3, 1, 2), middleOnSlice(3, 4, 2)}}},
                           {.shape = Distance{{middleOnSlice(5, 1, 2), middleOnSlice(5, 4, 2)}}}});
    ASSERT_TRUE(said) << said.error().message.english();
    ASSERT_EQ(said->report.measurements.size(), 2u);
    expectPixels(said->report.measurements[0], {{1.5, 2.5}, {4.5, 2.5}});
    EXPECT_TRUE(std::holds_alternative<PointsInSpace>(said->report.measurements[1].points));
    ASSERT_EQ(said->report.series.images.size(), 3u);
    EXPECT_EQ(said->report.series.images[0].sopInstanceUid, uidOf(3));
    EXPECT_EQ(said->report.series.images[1].sopInstanceUid, uidOf(4));
    EXPECT_EQ(said->report.series.images[2].sopInstanceUid, uidOf(6));
}

}  // namespace
}  // namespace macula::scene
