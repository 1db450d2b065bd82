// Measurements on images: closed forms, calibrations as files give them, regions of ultrasound, and nonsense.
#include "study/planar/image_measurement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "dicom/support.h"
#include "study/planar/images_state.h"

namespace macula::study {
namespace {

using Kind = ImageMeasurement::Kind;
using Of = dicom::PixelSize::Of;
using Unit = dicom::UltrasoundRegion::Unit;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

ImageMeasurement drawn(Kind kind, std::vector<glm::dvec2> points) {
    return {.kind = kind, .image = imageKey("1.2"), .points = std::move(points)};
}
std::string textOf(const ImageMeasurement& measurement, const dicom::PlanarHeader& header,
                   const dicom::PlanarFrame* pixels = nullptr) {
    return textOf(measured(measurement, header, pixels)).english();
}
dicom::PlanarHeader sized(dicom::PixelSize size) {
    dicom::PlanarHeader header;
    header.pixelSize = size;
    header.pixelHeightOverWidth = size.rowMm / size.columnMm;
    return header;
}

TEST(ImageMeasurements, SayWhatTheirLengthsRestOn) {
    const ImageMeasurement line = drawn(Kind::distance, {{10, 20}, {210, 20}});
    EXPECT_EQ(textOf(line, {}), "200.0 px");
    EXPECT_EQ(textOf(line, sized({.columnMm = 0.2, .rowMm = 0.2})), "40.0 mm");
    EXPECT_EQ(textOf(line, sized({.of = Of::detector, .columnMm = 0.2, .rowMm = 0.2})),
              "40.0 mm, at the detector");
    EXPECT_EQ(
        textOf(line, sized({.of = Of::estimate, .columnMm = 0.16, .rowMm = 0.16, .magnification = 1.25})),
        "32.0 mm, at the object by magnification 1.25");
    EXPECT_EQ(
        textOf(
            line,
            sized({.calibration = dicom::PixelSize::Calibration::fiducial, .columnMm = 0.1, .rowMm = 0.1})),
        "20.0 mm, calibrated by a fiducial");
    EXPECT_EQ(textOf(line, sized({.of = Of::film, .columnMm = 0.1, .rowMm = 0.1})),
              "200.0 px, the size of the film alone is known");
}

TEST(ImageMeasurements, UseTheHeightAndTheWidthOfPixels) {
    const dicom::PlanarHeader header = sized({.columnMm = 0.5, .rowMm = 2.0});
    EXPECT_EQ(textOf(drawn(Kind::distance, {{0, 0}, {6, 2}}), header), "5.0 mm");
    EXPECT_EQ(textOf(drawn(Kind::angle, {{4, 0}, {0, 0}, {4, 1}}), header), "45.0°");
    dicom::PlanarHeader without;
    without.pixelHeightOverWidth = 4.0;
    EXPECT_EQ(textOf(drawn(Kind::angle, {{4, 0}, {0, 0}, {4, 1}}), without), "45.0°");
    EXPECT_EQ(textOf(drawn(Kind::ellipse, {{0, 0}, {4, 1}}), header), "3.14 mm²");
}

TEST(ImageMeasurements, OfCobbAreTheSmallerAngleBetweenTwoLines) {
    const auto between = [](double a, double b) {
        const auto end = [](double degrees) {
            return 10.0 * glm::dvec2(std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees)));
        };
        return measured(drawn(Kind::cobb, {{0, 0}, end(a), {50, 50}, glm::dvec2(50, 50) + end(b)}), {},
                        nullptr)
            .quantities.at(0)
            .value;
    };
    EXPECT_NEAR(between(10, 35), 25.0, 1e-9);
    EXPECT_NEAR(between(10, 215), 25.0, 1e-9) << "however the lines are drawn";
    EXPECT_NEAR(between(170, -10), 0.0, 1e-9);
    EXPECT_NEAR(between(0, 90), 90.0, 1e-9);
}

// A sector in mm, a spectrum in s and cm/s beside it, a strip in s without a scale down, and an overlap.
dicom::PlanarHeader ultrasound() {
    dicom::PlanarHeader header;
    header.regions = {{.left = 0,
                       .top = 0,
                       .right = 99,
                       .bottom = 99,
                       .unitX = Unit::millimetres,
                       .unitY = Unit::millimetres,
                       .perColumn = 0.5,
                       .perRow = 0.5},
                      {.left = 100,
                       .top = 0,
                       .right = 199,
                       .bottom = 99,
                       .unitX = Unit::seconds,
                       .unitY = Unit::centimetresPerSecond,
                       .perColumn = 0.01,
                       .perRow = -2.0},
                      {.left = 0,
                       .top = 120,
                       .right = 199,
                       .bottom = 139,
                       .unitX = Unit::seconds,
                       .unitY = Unit::none,
                       .perColumn = 0.01,
                       .perRow = 0.0},
                      {.left = 20,
                       .top = 20,
                       .right = 39,
                       .bottom = 39,
                       .unitX = Unit::millimetres,
                       .unitY = Unit::millimetres,
                       .perColumn = 0.5,
                       .perRow = 0.5}};
    return header;
}

TEST(ImageMeasurements, InARegionOfUltrasoundHaveItsUnits) {
    const auto distance = [](glm::dvec2 from, glm::dvec2 to) {
        return textOf(drawn(Kind::distance, {from, to}), ultrasound());
    };
    EXPECT_EQ(distance({10, 10}, {16, 18}), "5.0 mm");
    EXPECT_EQ(distance({10, 10}, {30, 10}), "10.0 mm") << "into a region of the same scale";
    EXPECT_EQ(distance({110, 10}, {145, 31}), "0.350 s, 42.0 cm/s");
    EXPECT_EQ(distance({10, 125}, {60, 130}), "0.500 s, 5.0 px");
    EXPECT_EQ(distance({50, 10}, {150, 10}), "100.0 px, across two regions of ultrasound");
    EXPECT_EQ(distance({50, 10}, {50, 110}), "100.0 px, outside the regions of ultrasound");
    EXPECT_EQ(textOf(drawn(Kind::angle, {{110, 10}, {120, 20}, {130, 10}}), ultrasound()),
              "–, rows and columns have different units here");
    EXPECT_EQ(textOf(drawn(Kind::ellipse, {{110, 10}, {130, 30}}), ultrasound()), "–");
    EXPECT_EQ(textOf(drawn(Kind::ellipse, {{10, 10}, {14, 14}}), ultrasound()), "3.14 mm²");
}

TEST(ImageMeasurements, WhereRegionsMeetCountTheOneOfHighPriority) {
    dicom::PlanarHeader header = ultrasound();
    header.regions[3].perColumn = header.regions[3].perRow = 0.1;
    const ImageMeasurement within = drawn(Kind::distance, {{25, 30}, {35, 30}});
    EXPECT_EQ(textOf(within, header), "1.0 mm") << "the smaller one";
    header.regions[3].isLowPriority = true;
    EXPECT_EQ(textOf(within, header), "5.0 mm");
}

TEST(ImageMeasurements, OfAnEllipseCountTheMiddlesOfPixels) {
    dicom::PlanarFrame pixels{.columns = 5, .rows = 4, .values = {}, .rgb = {}};
    for (int i = 0; i < 20; ++i) pixels.values.push_back(float(i));
    const auto values = [&](glm::dvec2 from, glm::dvec2 to) {
        return measured(drawn(Kind::ellipse, {from, to}), {}, &pixels).values;
    };
    // Around the middle of pixel (2, 1), with its four neighbours: 7, 2, 6, 8, 12.
    const auto five = values({1.4, 0.4}, {3.6, 2.6});
    ASSERT_TRUE(five);
    EXPECT_EQ(five->pixels, 5u);
    EXPECT_DOUBLE_EQ(five->mean, 7.0);
    EXPECT_NEAR(five->deviation, std::sqrt((25.0 + 1.0 + 1.0 + 25.0) / 4.0), 1e-12);
    EXPECT_EQ(five->low, 2.0);
    EXPECT_EQ(five->high, 12.0);
    const auto none = values({1.1, 1.1}, {1.3, 1.3});
    ASSERT_TRUE(none) << "the pixel that it lies in";
    EXPECT_EQ(none->pixels, 1u);
    EXPECT_EQ(none->mean, 6.0);
    pixels.values[7] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(values({1.4, 0.4}, {3.6, 2.6})->pixels, 4u) << "padding";
    EXPECT_EQ(values({-1e6, -1e6}, {1e6, 1e6})->pixels, 19u);
    EXPECT_FALSE(values({-50, -50}, {-40, -40}));
    EXPECT_FALSE(values({kNaN, 0}, {1, 1}));
}

TEST(ImageMeasurements, WithoutTheirPointsMeasureNothing) {
    EXPECT_TRUE(measured(drawn(Kind::angle, {{0, 0}, {1, 1}}), {}, nullptr).quantities.empty());
    EXPECT_EQ(textOf(drawn(Kind::angle, {{1, 1}, {1, 1}, {2, 2}}), {}), "–");
    EXPECT_EQ(textOf(drawn(Kind::distance, {{kNaN, 1}, {1, 1}}), {}), "–");
}

TEST(ImageMeasurements, AreATableForOtherPrograms) {
    ImageMeasurement line = drawn(Kind::distance, {{10, 20}, {210, 20}});
    line.label = "=1+1, \"x\"";
    line.frame = 3;
    const auto header = sized({.of = Of::detector, .columnMm = 0.2, .rowMm = 0.2});
    const std::string csv =
        csvOf(std::vector<ListedImageMeasurement>{{line, 7, measured(line, header, nullptr)}});
    EXPECT_EQ(
        csv,
        "kind,label,image,frame,points,value,unit,second_value,second_unit,basis,mean,deviation,min,max,"
        "pixels\r\n"
        "distance,\"'=1+1, \"\"x\"\"\",7,4,10.000 20.000; 210.000 20.000,40,mm,,,at the detector,,,,,\r\n");
}

TEST(ImageMeasurements, OnRealImagesHaveTheLengthsThatTheseSay) {
    SKIP_WITHOUT_SHARED_DATA();
    const std::filesystem::path data = dicom::test::sharedData() / "planar/1_planar_and_cine";
    if (!std::filesystem::is_directory(data)) GTEST_SKIP() << "the planar data are not on this machine";
    const ImageMeasurement bar = drawn(Kind::distance, {{10, 20}, {210, 20}});
    const auto textOn = [&](const char* name, const ImageMeasurement& of) {
        const auto header = dicom::readPlanarHeader(data / name);
        EXPECT_TRUE(header) << name;
        return header ? textOf(of, *header) : std::string();
    };
    // The picture says itself: 50 mm is right, 100 mm that of the detector.
    EXPECT_EQ(textOn("mg_pixel_spacing_calibration.dcm", bar).substr(0, 7), "50.0 mm");
    EXPECT_EQ(textOn("made_dx_mono1_voilut.dcm", bar), "32.0 mm, at the object by magnification 1.25");
    // A sector in cm, and a strip of time below it.
    EXPECT_EQ(textOn("us_palette.dcm", drawn(Kind::distance, {{200, 100}, {300, 100}})), "26.2 mm");
    EXPECT_EQ(textOn("us_palette.dcm", drawn(Kind::distance, {{200, 530}, {300, 530}})), "0.964 s, 0.0 px");
    EXPECT_EQ(textOn("us_palette.dcm", drawn(Kind::distance, {{200, 100}, {200, 530}})),
              "430.0 px, across two regions of ultrasound");
}

TEST(ImagesStates, AreReadAsTheyWereWritten) {
    ImagesState state{.measurements = {drawn(Kind::cobb, {{1, 2}, {3, 4}, {5, 6}, {7, 8.25}})}, .place = 4};
    state.measurements[0].label = "Größe";
    state.measurements[0].frame = 2;
    state.window = {.center = 40, .width = 400, .explanation = {}, .function = "SIGMOID"};
    state.isInverted = true;
    state.quarters = 3;
    state.scale = 2.5;
    state.middlePx = {-3, 8};
    state.overlaysAreShown = false;
    EXPECT_EQ(imagesStateOf(toJsonText(state)), state);
    EXPECT_EQ(imagesStateOf(toJsonText({})), ImagesState{});
    EXPECT_EQ(toJsonText(state).find("1.2"), std::string::npos) << "no UID";
}

TEST(ImagesStates, LeaveOutWhatMakesNoSense) {
    for (const char* none : {"", "[]", "{}", "{\"version\":2}", "{\"version\":\"1\"}", "nonsense"})
        EXPECT_FALSE(imagesStateOf(none)) << none;
    const std::string key = imageKey("1.2");
    const auto read = imagesStateOf(
        R"({"version":1,"place":-4,"turned":77,"scale":-1,"middle":[1,2],"window":{"center":1e300,"width":1},)"
        R"("measurements":[7,{"kind":"square"},)"
        R"({"kind":"distance","image":"../../etc","frame":0,"points":[[0,0],[1,1]]},)"
        R"({"kind":"distance","image":")" +
        key + R"(","frame":0,"points":[[0,0]]},{"kind":"distance","image":")" + key +
        R"(","frame":0,"points":[[0,0],[1e99,1]]},{"kind":"distance","image":")" + key +
        R"(","frame":1,"points":[[0,0],[3,4]]}]})");
    ASSERT_TRUE(read);
    ASSERT_EQ(read->measurements.size(), 1u);
    EXPECT_EQ(read->measurements[0].frame, 1);
    EXPECT_EQ(read->place, 0u);
    EXPECT_EQ(read->quarters, 0);
    EXPECT_FALSE(read->scale || read->window);
}

}  // namespace
}  // namespace macula::study
