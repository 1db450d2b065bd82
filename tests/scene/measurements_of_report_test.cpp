// Measurements of reports: what this program writes comes back as the same points, and reports of others give
// points that were calculated by hand.
#include "scene/slices/measurements_of_report.h"

#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include "dicom/documents/read_document.h"
#include "scene/slices/reported_measurements.h"
#include "support.h"
#include "synthetic.h"

namespace macula::scene {
namespace {

using dicom::test::put;
using dicom::test::Slice;
using slices::Angle;
using slices::Distance;
using slices::Ellipse;
using slices::Measurement;

constexpr double kSameMm = 1e-3;

class MeasurementsOfReportTest : public testing::Test {
  protected:
    void SetUp() override {
        slices_ = dicom::test::slicesOf(series_);
        dicom::test::writeFiles(folder_ / "study", series_, slices_);
        auto scan = dicom::test::scan(folder_ / "study");
        ASSERT_TRUE(scan);
        found_ = std::make_shared<const study::FoundVolumes>(*std::move(scan));
        ASSERT_EQ(found_->volumes().size(), 1u);
        volume_ = dicom::test::load(*of().series, *of().stack);
        ASSERT_TRUE(volume_);
    }
    const study::FoundVolume& of() const { return found_->volumes()[0]; }
    // The middle of a pixel, from the numbers that its header holds.
    static glm::dvec3 middleOf(const Slice& slice, double column, double row) {
        return slice.positionMm + column * slice.columnSpacingMm * slice.rowDirection +
               row * slice.rowSpacingMm * slice.columnDirection;
    }
    void write(const std::vector<Measurement>& measurements) {
        const auto written =
            writeMeasurementReport(file_, {.measurements = measurements, .volume = volume_, .found = found_});
        ASSERT_TRUE(written) << written.error().message.english();
    }
    Result<MeasurementsOfReport> take(const std::vector<Measurement>& there = {}) {
        const auto document = dicom::readDocument(file_);
        EXPECT_TRUE(document);
        return measurementsOf(*document, {*of().series, *of().stack}, there);
    }

    const dicom::test::TemporaryFolder folder_;
    const std::filesystem::path file_ = folder_ / "report.dcm";
    dicom::test::SyntheticSeries series_;
    std::vector<Slice> slices_;
    std::shared_ptr<const study::FoundVolumes> found_;
    std::shared_ptr<const Volume> volume_;
};

TEST_F(MeasurementsOfReportTest, WhatIsWrittenComesBack) {
    const Slice& one = slices_[3];
    const Slice& other = slices_[8];
    Ellipse ellipse;
    ellipse.plane = {middleOf(one, 3, 3), one.rowDirection, one.columnDirection};
    ellipse.radiiMm = {1.5 * one.columnSpacingMm, 2.5 * one.rowSpacingMm};
    const std::vector<Measurement> measured{
        {.label = "Größe", .shape = Distance{{middleOf(one, 1, 2), middleOf(one, 4, 2.5)}}},
        {.shape = Angle{{middleOf(other, 2, 1), middleOf(other, 2, 3), middleOf(other, 5, 3)}}},
        {.label = "Cyst", .shape = ellipse},
        {.label = "Across", .shape = Distance{{middleOf(one, 1, 1), middleOf(other, 4, 3)}}}};
    write(measured);
    const auto taken = take();
    ASSERT_TRUE(taken) << taken.error().message.english();
    EXPECT_TRUE(taken->leftOut.empty());
    ASSERT_EQ(taken->taken.size(), measured.size());
    for (std::size_t i = 0; i < measured.size(); ++i) {
        EXPECT_EQ(kindOf(taken->taken[i]), kindOf(measured[i]));
        EXPECT_EQ(taken->taken[i].label, i == 1 ? "Angle 1" : measured[i].label);
        if (kindOf(measured[i]) == "ellipse") continue;
        const auto before = pointsOf(measured[i]);
        const auto after = pointsOf(taken->taken[i]);
        ASSERT_EQ(before.size(), after.size());
        for (std::size_t p = 0; p < before.size(); ++p)
            EXPECT_LT(glm::length(before[p] - after[p]), kSameMm) << i;
    }
    const auto& back = std::get<Ellipse>(taken->taken[2].shape);
    EXPECT_LT(glm::length(back.plane.centreMm - ellipse.plane.centreMm), kSameMm);
    EXPECT_NEAR(areaMm2(back), areaMm2(ellipse), 1e-3 * areaMm2(ellipse));
    const auto before = valuesIn(ellipse, *volume_);
    const auto after = valuesIn(back, *volume_);
    ASSERT_TRUE(before && after);
    EXPECT_EQ(before->voxels, after->voxels);
    EXPECT_NEAR(before->mean, after->mean, 1e-6);
    // Each is shown where it was drawn.
    const slices::SlicePlane plane{middleOf(one, 3, 3), one.rowDirection, one.columnDirection};
    EXPECT_TRUE(liesIn(taken->taken[0], plane, 0.1));
    EXPECT_TRUE(liesIn(taken->taken[2], plane, 0.1));
}

// In the plane of an image, and between two images.
TEST_F(MeasurementsOfReportTest, DrawnShapesThatAreWrittenComeBack) {
    const Slice& one = slices_[3];
    const Slice& other = slices_[8];
    const auto lesionFrom = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                               const glm::dvec3& d) {
        return slices::Bidirectional{.firstMm = {a, b}, .secondMm = {c, d}};
    };
    const std::vector<Measurement> measured{
        {.label = "Target 1",
         .shape =
             lesionFrom(middleOf(one, 3, 1), middleOf(one, 3, 2), middleOf(one, 1, 1), middleOf(one, 5, 1))},
        {.label = "Leaning",
         .shape = lesionFrom(middleOf(one, 1, 1), middleOf(other, 1, 1), middleOf(one, 1, 2),
                             middleOf(one, 2, 2))},
        {.label = "Cobb",
         .shape = slices::CobbAngle{{middleOf(one, 1, 1), middleOf(one, 4, 1), middleOf(one, 1, 3),
                                     middleOf(one, 4, 5)}}},
        {.label = "Outline",
         .shape = slices::Outline{{middleOf(one, 1, 1), middleOf(one, 5, 1), middleOf(one, 5, 4),
                                   middleOf(one, 2, 5)}}},
        {.label = "Outline in space",
         .shape = slices::Outline{{middleOf(one, 1, 1), middleOf(one, 5, 1), middleOf(other, 5, 4)}}},
        {.label = "Line",
         .shape = slices::OpenLine{{middleOf(one, 1, 1), middleOf(one, 3, 2), middleOf(one, 5, 1)}}}};
    write(measured);
    const auto taken = take();
    ASSERT_TRUE(taken) << taken.error().message.english();
    EXPECT_TRUE(taken->leftOut.empty()) << taken->leftOut.front().english();
    ASSERT_EQ(taken->taken.size(), measured.size());
    for (std::size_t i = 0; i < measured.size(); ++i) {
        EXPECT_EQ(kindOf(taken->taken[i]), kindOf(measured[i]));
        EXPECT_EQ(taken->taken[i].label, measured[i].label);
        const bool isBackFirst = i == 0;  // the long axis comes first in a report
        auto before = pointsOf(measured[i]);
        const auto after = pointsOf(taken->taken[i]);
        if (isBackFirst) before = {before[2], before[3], before[0], before[1]};
        ASSERT_EQ(before.size(), after.size());
        for (std::size_t p = 0; p < before.size(); ++p)
            EXPECT_LT(glm::length(before[p] - after[p]), kSameMm) << i;
    }
    const auto again = take(measured);
    ASSERT_FALSE(again) << "all are there already";
}

TEST_F(MeasurementsOfReportTest, WhatIsThereIsNotTakenAgain) {
    const std::vector<Measurement> measured{
        {.shape = Distance{{middleOf(slices_[3], 1, 2), middleOf(slices_[3], 4, 2)}}},
        {.shape = Distance{{middleOf(slices_[4], 1, 2), middleOf(slices_[4], 4, 2)}}}};
    write(measured);
    const auto some = take({measured[0]});
    ASSERT_TRUE(some);
    EXPECT_EQ(some->taken.size(), 1u);
    ASSERT_EQ(some->leftOut.size(), 1u);
    EXPECT_NE(some->leftOut[0].english().find("there already"), std::string::npos);
    const auto none = take(measured);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::inputNotUsable);
}

TEST_F(MeasurementsOfReportTest, AnotherPatientOrStudyTakesNothing) {
    write({{.shape = Distance{{middleOf(slices_[3], 1, 2), middleOf(slices_[3], 4, 2)}}}});
    dicom::test::editFile(file_, [](DcmItem& item) { put(item, DCM_PatientID, "SOMEBODY ELSE"); });
    auto refused = take();
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.english().find("another patient"), std::string::npos);
    dicom::test::editFile(file_, [this](DcmItem& item) {
        put(item, DCM_PatientID, series_.patientId);
        put(item, DCM_StudyInstanceUID, "2.25.9");
    });
    refused = take();
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.english().find("another study"), std::string::npos);
}

// A report of another program, by the standard alone: a circle, an outline, a line on an image elsewhere.
TEST_F(MeasurementsOfReportTest, ShapesOfOthersAreTakenOrSaid) {
    write({{.shape = Distance{{middleOf(slices_[3], 1, 2), middleOf(slices_[3], 4, 2)}}}});
    const auto draw = [](DcmItem& group, const char* type, std::vector<Float32> px, const std::string& uid) {
        DcmItem& shape = dicom::test::appended(group, DCM_ContentSequence);
        put(shape, DCM_RelationshipType, "CONTAINS");
        put(shape, DCM_ValueType, "SCOORD");
        put(shape, DCM_GraphicType, type);
        shape.putAndInsertFloat32Array(DCM_GraphicData, px.data(), px.size());
        DcmItem& image = dicom::test::appended(shape, DCM_ContentSequence);
        put(image, DCM_RelationshipType, "SELECTED FROM");
        put(image, DCM_ValueType, "IMAGE");
        put(dicom::test::nested(image, DCM_ReferencedSOPSequence), DCM_ReferencedSOPInstanceUID, uid);
    };
    const std::string uid = slices_[5].sopInstanceUid;
    dicom::test::editFile(file_, [&](DcmItem& root) {
        DcmItem& group = dicom::test::appended(root, DCM_ContentSequence);
        put(group, DCM_RelationshipType, "CONTAINS");
        put(group, DCM_ValueType, "CONTAINER");
        draw(group, "CIRCLE", {3.5, 3.5, 3.5, 5.5}, uid);
        draw(group, "POLYLINE", {1, 1, 2, 1, 2, 2, 1, 1}, uid);
        draw(group, "MULTIPOINT", {1, 1, 2, 1, 2, 2}, uid);
        draw(group, "POLYLINE", {1, 1, 4, 1}, "2.25.404");
        draw(group, "ELLIPSE", {1, 1, 4, 1, 2, 0, 5, 1}, uid);
        draw(group, "POLYLINE", {2, 2, 2, 2}, uid);
        DcmItem& number = dicom::test::appended(group, DCM_ContentSequence);
        put(number, DCM_ValueType, "NUM");
        DcmItem& value = dicom::test::nested(number, DCM_MeasuredValueSequence);
        put(value, DCM_NumericValue, "99999");
        DcmItem& unit = dicom::test::nested(value, DCM_MeasurementUnitsCodeSequence);
        put(unit, DCM_CodeValue, "cm2");
        put(unit, DCM_CodingSchemeDesignator, "UCUM");
    });
    const auto taken = take();
    ASSERT_TRUE(taken) << taken.error().message.english();
    ASSERT_EQ(taken->taken.size(), 3u);
    EXPECT_EQ(std::get<slices::Outline>(taken->taken[2].shape).pointsMm.size(), 3u);
    const auto& circle = std::get<Ellipse>(taken->taken[1].shape);
    EXPECT_LT(glm::length(circle.plane.centreMm - middleOf(slices_[5], 3, 3)), kSameMm);
    EXPECT_NEAR(circle.radiiMm.x, 2.0 * slices_[5].rowSpacingMm, kSameMm);
    EXPECT_NEAR(circle.radiiMm.y, circle.radiiMm.x, 1e-9);
    const auto says = [&](std::string_view part) {
        return std::ranges::any_of(
            taken->leftOut, [&](const Text& each) { return each.english().find(part) != std::string::npos; });
    };
    EXPECT_TRUE(says("images that are not open"));
    EXPECT_TRUE(says("does not measure, and that were left out: 1"));
    EXPECT_TRUE(says("cannot be right, and that were left out: 2"));
    EXPECT_TRUE(says("another value")) << "the area is another one";
}

// sr_document.dcm: a circle around (58, 52) through (58, 41) on an image of 0.661468 mm a pixel, whose first
// pixel lies at (-158.135803, -179.035797, -75.699997).
TEST(SharedReport, ACircleOfAnotherProgramLiesWhereItsNumbersSay) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto folder = dicom::test::sharedData() / "planar/2_structured/sr_tid1500_highdicom";
    const auto scan = dicom::test::scan(folder);
    ASSERT_TRUE(scan);
    const dicom::Series* images = nullptr;
    for (const dicom::Study& study : scan->studies)
        for (const dicom::Series& series : study.series)
            if (!series.stacks.empty()) images = &series;
    ASSERT_NE(images, nullptr);
    const auto document = dicom::readDocument(folder / "sr_document.dcm");
    ASSERT_TRUE(document);
    const auto taken = measurementsOf(*document, {*images, images->stacks.front()});
    ASSERT_TRUE(taken) << taken.error().message.english();
    ASSERT_EQ(taken->taken.size(), 1u);
    const auto& circle = std::get<Ellipse>(taken->taken[0].shape);
    constexpr double kMmPerPixel = 0.661468;
    const glm::dvec3 centre{-158.135803 + 57.5 * kMmPerPixel, -179.035797 + 51.5 * kMmPerPixel, -75.699997};
    EXPECT_LT(glm::length(circle.plane.centreMm - centre), kSameMm);
    EXPECT_NEAR(circle.radiiMm.x, 11.0 * kMmPerPixel, kSameMm);
    EXPECT_EQ(taken->taken[0].label, "Planar ROI Measurements");
}

}  // namespace
}  // namespace macula::scene
