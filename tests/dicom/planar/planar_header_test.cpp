// What an image says about how it is to be shown: made here, and the real ones of ../shared/data.
#include "dicom/planar/planar_header.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "support.h"
#include "synthetic.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Of = PixelSize::Of;

PlanarHeader headerWith(const Edit& edit, int frames = 1) {
    const TemporaryFolder folder;
    SyntheticSeries series;
    series.modality = "DX";
    series.sopClassUid = UID_DigitalXRayImageStorageForPresentation;
    series.edits.push_back([&](DcmItem& item) {
        item.findAndDeleteElement(DCM_PixelSpacing);
        if (frames > 1) put(item, DCM_NumberOfFrames, std::to_string(frames));
        edit(item);
    });
    const auto files = writeFiles(folder.path(), series, {slicesOf(series).front()});
    const auto read = readPlanarHeader(files.at(0));
    EXPECT_TRUE(read);
    return read ? *read : PlanarHeader{};
}

TEST(PlanarHeaders, TellTheSizeOfAPixelWhereItIsMeasured) {
    const auto size = [](const char* spacing, const char* imager, const char* magnification,
                         const char* calibration = "") {
        return headerWith([&](DcmItem& item) {
                   if (*spacing != '\0') put(item, DCM_PixelSpacing, spacing);
                   if (*imager != '\0') put(item, DCM_ImagerPixelSpacing, imager);
                   if (*magnification != '\0')
                       put(item, DCM_EstimatedRadiographicMagnificationFactor, magnification);
                   if (*calibration != '\0') put(item, DCM_PixelSpacingCalibrationType, calibration);
               })
            .pixelSize;
    };
    EXPECT_FALSE(size("", "", ""));
    EXPECT_FALSE(size("0\\0", "-1\\2", ""));
    const auto calibrated = size("0.25\\0.5", "0.5\\0.5", "1.5");
    ASSERT_TRUE(calibrated);
    EXPECT_EQ(calibrated->of, Of::object);
    EXPECT_EQ(calibrated->rowMm, 0.25);
    EXPECT_EQ(calibrated->columnMm, 0.5);
    EXPECT_EQ(size("0.5\\0.5", "0.5\\0.5", "")->of, Of::detector) << "a copy of the detector's";
    EXPECT_EQ(size("0.5\\0.5", "0.5\\0.5", "", "GEOMETRY")->of, Of::object);
    const auto estimated = size("", "0.2\\0.2", "1.25");
    ASSERT_TRUE(estimated);
    EXPECT_EQ(estimated->of, Of::estimate);
    EXPECT_DOUBLE_EQ(estimated->columnMm, 0.16);
    EXPECT_DOUBLE_EQ(size("", "0.2\\0.2", "0")->columnMm, 0.2) << "no magnification";
}

TEST(PlanarHeaders, TellTheAspectWithoutASize) {
    EXPECT_EQ(headerWith([](DcmItem& item) { put(item, DCM_PixelAspectRatio, "3\\2"); }).pixelHeightOverWidth,
              1.5);
    EXPECT_EQ(headerWith([](DcmItem& item) { put(item, DCM_PixelAspectRatio, "0\\2"); }).pixelHeightOverWidth,
              1.0);
    EXPECT_EQ(
        headerWith([](DcmItem& item) { put(item, DCM_ImagerPixelSpacing, "0.4\\0.2"); }).pixelHeightOverWidth,
        2.0);
}

TEST(PlanarHeaders, TellHowLongEachFrameIsShown) {
    const auto timing = [](const Edit& edit) { return headerWith(edit, 4).cine; };
    EXPECT_TRUE(timing([](DcmItem&) {}).frameMs.empty());
    EXPECT_EQ(timing([](DcmItem& item) { put(item, DCM_FrameTime, "40"); }).frameMs,
              std::vector<double>(4, 40.0));
    EXPECT_EQ(timing([](DcmItem& item) { put(item, DCM_FrameTimeVector, "0\\100\\50\\200"); }).frameMs,
              (std::vector<double>{100, 50, 200, 200}));
    EXPECT_EQ(timing([](DcmItem& item) { put(item, DCM_CineRate, "25"); }).frameMs,
              std::vector<double>(4, 40.0));
    // What makes no sense is none: too short a list, no time at all, and more than a person would wait.
    EXPECT_TRUE(timing([](DcmItem& item) { put(item, DCM_FrameTimeVector, "0\\100"); }).frameMs.empty());
    EXPECT_TRUE(timing([](DcmItem& item) { put(item, DCM_FrameTimeVector, "0\\0\\1\\1"); }).frameMs.empty());
    EXPECT_TRUE(timing([](DcmItem& item) { put(item, DCM_FrameTime, "1e30"); }).frameMs.empty());
    EXPECT_TRUE(timing([](DcmItem& item) { putWord(item, DCM_PreferredPlaybackSequencing, 1); }).sweeps);
}

TEST(PlanarHeaders, TellWhetherLowValuesAreBright) {
    const auto isLowBright = [](const char* photometric, const char* shape) {
        return headerWith([&](DcmItem& item) {
                   put(item, DCM_PhotometricInterpretation, photometric);
                   if (*shape != '\0') put(item, DCM_PresentationLUTShape, shape);
               })
            .isLowBright;
    };
    EXPECT_TRUE(isLowBright("MONOCHROME1", ""));
    EXPECT_TRUE(isLowBright("MONOCHROME1", "INVERSE"));
    EXPECT_FALSE(isLowBright("MONOCHROME2", ""));
    EXPECT_FALSE(isLowBright("MONOCHROME2", "IDENTITY"));
    EXPECT_TRUE(isLowBright("MONOCHROME2", "INVERSE"));
}

TEST(PlanarHeaders, TellSidesOnlyInLettersThatHaveOpposites) {
    const auto towards = [](const char* letters) {
        return headerWith([&](DcmItem& item) { put(item, DCM_PatientOrientation, letters); }).towards;
    };
    EXPECT_EQ(towards("L\\FP"), (std::array<std::string, 2>{"L", "FP"}));
    for (const char* other : {"", "L", "CR\\D", "l\\f", "LRAP\\F"})
        EXPECT_EQ(towards(other), (std::array<std::string, 2>{})) << other;
}

TEST(PlanarHeaders, OfEndlessFramesTakeNoEndlessMemory) {
    const CineTiming timing = headerWith(
                                  [](DcmItem& item) {
                                      put(item, DCM_NumberOfFrames, "2147483647");
                                      put(item, DCM_FrameTime, "33");
                                  },
                                  2)
                                  .cine;
    EXPECT_LE(timing.frameMs.size(), 100'000u);
}

TEST(PlanarHeaders, OfNoImageAreErrors) {
    const TemporaryFolder folder;
    std::ofstream(folder / "text.dcm") << "no image";
    for (const char* name : {"text.dcm", "gone.dcm"}) {
        const auto read = readPlanarHeader(folder / name);
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
    }
}

void expectRegions(const PlanarHeader& header, const Json& regions) {
    ASSERT_EQ(header.regions.size(), regions.size());
    for (std::size_t i = 0; i < regions.size(); ++i) {
        const UltrasoundRegion& region = header.regions[i];
        EXPECT_EQ(regions[i]["box"], Json({region.left, region.top, region.right, region.bottom}));
        const bool isCm = regions[i]["units"][0] == 3;
        EXPECT_EQ(region.unitX == UltrasoundRegion::Unit::millimetres, isCm);
        EXPECT_NEAR(region.perColumn, regions[i]["delta"][0].get<double>() * (isCm ? 10.0 : 1.0), 1e-9);
    }
}

TEST(PlanarHeaders, OfRealImagesAreTheTruth) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path data = sharedData() / "planar";
    if (!fs::is_directory(data)) GTEST_SKIP() << "the planar data are not on this machine";
    std::ifstream stream(data / "truth" / "1_planar_and_cine.json");
    const Json all = Json::parse(stream);
    std::size_t images = 0;
    for (const auto& [name, truth] : all.items()) {
        if (!truth.is_object() || !truth.contains("probes")) continue;
        SCOPED_TRACE(name);
        ++images;
        const auto read = readPlanarHeader(data / name);
        ASSERT_TRUE(read);
        if (truth.contains("us_regions")) expectRegions(*read, truth["us_regions"]);
        if (const double ms = truth.value("frame_time_ms", 0.0); ms > 0.0 && truth["frames"] > 1) {
            ASSERT_EQ(read->cine.frameMs.size(), truth["frames"].get<std::size_t>());
            EXPECT_NEAR(read->cine.frameMs[0], ms, 1e-6);
        }
        if (truth.contains("voi_luts")) {
            EXPECT_EQ(read->tables.size(), truth["voi_luts"].size());
            EXPECT_EQ(read->tables[0].explanation, truth["voi_luts"][0]["explanation"].get<std::string>());
        }
        if (truth.contains("magnification") && !truth.contains("pixel_spacing_mm")) {
            ASSERT_TRUE(read->pixelSize);
            EXPECT_NEAR(
                read->pixelSize->columnMm,
                truth["imager_pixel_spacing_mm"][1].get<double>() / truth["magnification"].get<double>(),
                1e-9);
        }
    }
    EXPECT_GE(images, 20u);
    // Lengths that the bar of each of two images must have.
    const auto bar = readPlanarHeader(data / "1_planar_and_cine/mg_pixel_spacing_calibration.dcm");
    ASSERT_TRUE(bar && bar->pixelSize);
    EXPECT_NEAR(200 * bar->pixelSize->columnMm, 50.0, 1e-9);
    EXPECT_EQ(bar->pixelSize->of, Of::object);
}

}  // namespace
}  // namespace macula::dicom::test
