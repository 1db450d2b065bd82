// D1 order, D2 directions, D3 spacing, D6 tilt, D24 patient position: where voxels lie (PS3.3 C.7.6.2).
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cmath>

#include "opened.h"

namespace macula::dicom::test {
namespace {

using D01SliceOrder = Pitfall;
using D02Directions = Pitfall;
using D03Spacing = Pitfall;
using D06GantryTilt = Pitfall;
using D24PatientPosition = Pitfall;

TEST_F(D01SliceOrder, PositionsDecideNotNamesNorNumbers) {
    writeFiles(folder.path(), series);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_EQ(opened.series().size(), 1u);
}

TEST_F(D01SliceOrder, SliceLocationAndNumberRunTheOtherWay) {
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.instanceNumber = 100 - slice.place;
        slice.edits.push_back(
            [n = slice.place](DcmItem& item) { putNumber(item, DCM_SliceLocation, -n * 3.0); });
    }
    writeFiles(folder.path(), series, slices);
    expectOnlyVolume(open(), series);
}

TEST_F(D01SliceOrder, WithoutPositionsBySliceLocation) {
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        slice.edits.push_back([n = slice.place](DcmItem& item) {
            erase(item, DCM_ImagePositionPatient);
            putNumber(item, DCM_SliceLocation, 100.0 - n);  // the last place first
        });
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_TRUE(opened.says(key::kNoPosition)) << opened.keys();
    ASSERT_EQ(opened.stacks().size(), 1u);
    const auto& frames = opened.stacks()[0]->frames;
    ASSERT_EQ(frames.size(), slices.size());
    for (std::size_t n = 0; n < frames.size(); ++n)
        EXPECT_EQ(frames[n].instance->sopInstanceUid, slices[slices.size() - 1 - n].sopInstanceUid);
}

TEST_F(D01SliceOrder, WithoutPositionsAndLocationsByNumber) {
    auto slices = slicesOf(series);
    for (Slice& slice : slices)
        slice.edits.push_back([](DcmItem& item) { erase(item, DCM_ImagePositionPatient); });
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kNoPosition)) << opened.keys();
    ASSERT_EQ(opened.stacks().size(), 1u);
    const auto& frames = opened.stacks()[0]->frames;
    ASSERT_EQ(frames.size(), slices.size());
    for (std::size_t n = 0; n < frames.size(); ++n)
        EXPECT_EQ(frames[n].instance->instanceNumber, static_cast<int>(n) + 1);
}

// Some of the slices have lost their position: they cannot be in the volume, and that is said.
TEST_F(D01SliceOrder, OneSliceWithoutPosition) {
    auto slices = slicesOf(series);
    slices[5].edits.push_back([](DcmItem& item) { erase(item, DCM_ImagePositionPatient); });
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 12u);
    EXPECT_TRUE(opened.says(key::kInconsistentPosition) || opened.says(key::kNoPosition)) << opened.keys();
    EXPECT_TRUE(opened.says(key::kMissingSlices)) << opened.keys();
    expectOnlyVolume(opened, series);  // slice 5 interpolated: the ramp again
}

TEST_F(D02Directions, GridThatRunsAgainstTheNormal) {
    series.worldFromVoxel =
        affine(obliqueAffine()[0], obliqueAffine()[1], -glm::dvec3(obliqueAffine()[2]), {12.5, -40.25, 77.0});
    ASSERT_LT(glm::determinant(glm::dmat3(series.worldFromVoxel)), 0.0);
    writeFiles(folder.path(), series);
    expectOnlyVolume(open(), series);
}

TEST_F(D02Directions, FiveDecimalsAreOneOrientation) {
    auto slices = slicesOf(series);
    for (Slice& slice : slices) {
        // Each slice off by its own last digit.
        const auto rounded = [&](double x, int n) {
            return (std::round(x * 1e5) + (slice.place + n) % 3 - 1) * 1e-5;
        };
        const glm::dvec3 r = slice.rowDirection;
        const glm::dvec3 c = slice.columnDirection;
        slice.edits.push_back([text = decimals({rounded(r.x, 0), rounded(r.y, 1), rounded(r.z, 2),
                                                rounded(c.x, 1), rounded(c.y, 2), rounded(c.z, 0)})](
                                  DcmItem& item) { put(item, DCM_ImageOrientationPatient, text); });
    }
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectGrid(*volume, series.size, series.expectedAffine(), 1e-3);
    expectRamp(*volume, series.rampOf(), 0.5 + 47 * 8 * 2e-5);
}

TEST_F(D02Directions, NotQuiteARightAngleIsSetRight) {
    const double off = 4e-4;
    for (Slice slice : slicesOf(series)) {
        const glm::dvec3 c = std::cos(off) * slice.columnDirection + std::sin(off) * slice.rowDirection;
        const glm::dvec3 r = slice.rowDirection;
        slice.edits.push_back([text = decimals({r.x, r.y, r.z, c.x, c.y, c.z})](DcmItem& item) {
            put(item, DCM_ImageOrientationPatient, text);
        });
        writeFiles(folder.path(), series, {slice});
    }
    const Opened opened = open();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    const glm::dmat4& m = volume->worldFromVoxel();
    EXPECT_NEAR(glm::dot(glm::normalize(glm::dvec3(m[0])), glm::normalize(glm::dvec3(m[1]))), 0.0, 1e-9);
    EXPECT_LT(affineError(m, series.expectedAffine()), 1.1 * off);
}

TEST_F(D02Directions, NonsenseIsNoVolume) {
    const char* nonsense[] = {"1\\0\\0\\1\\0\\0",     "0\\0\\0\\0\\0\\0",   "1\\0\\0\\0.1\\1\\0",
                              "2\\0\\0\\0\\2\\0",     "NaN\\0\\0\\0\\1\\0", "1\\0\\0\\0\\1",
                              "1e300\\0\\0\\0\\1\\0", "inf\\0\\0\\0\\1\\0"};
    for (const char* text : nonsense) {
        SCOPED_TRACE(text);
        const TemporaryFolder own;
        series.edits = {[&](DcmItem& item) { put(item, DCM_ImageOrientationPatient, text); }};
        writeFiles(own.path(), series);
        const Opened opened(own.path());
        EXPECT_TRUE(opened.volumes().empty());
        EXPECT_EQ(opened.frames(), 12u);
        EXPECT_TRUE(opened.says(key::kInvalidOrientation) || opened.says(key::kNoPosition) ||
                    opened.says(key::kMalformedNumbers))
            << opened.keys();
    }
}

// SliceThickness is wrong in all files of the writer; the series says yet another distance.
TEST_F(D03Spacing, PositionsDecide) {
    series.modality = "MR";
    series.edits = {[](DcmItem& item) { put(item, DCM_SpacingBetweenSlices, "9.5"); }};
    writeFiles(folder.path(), series);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    ASSERT_EQ(opened.volumes().size(), 1u);
    ASSERT_TRUE(opened.volumes()[0]->spacingMm);
    const glm::dvec3 spacing = *opened.volumes()[0]->spacingMm;
    EXPECT_NEAR(spacing.x, 0.7, 1e-6);  // between columns: the second value of PixelSpacing
    EXPECT_NEAR(spacing.y, 1.1, 1e-6);
    EXPECT_NEAR(spacing.z, 2.3, 1e-6);
}

TEST_F(D03Spacing, VeryThinAndVeryThickSlices) {
    for (const double spacing : {0.01, 50.0}) {
        SCOPED_TRACE(spacing);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.worldFromVoxel[2] *= spacing / 2.3;
        s.ramp = Ramp{.throughMm = glm::dvec3(s.worldFromVoxel[3]), .perMm = {1.5, 2.5, 0.7}};
        s.slope = 0.01;
        s.intercept = 1500.0;
        writeFiles(own.path(), s);
        expectOnlyVolume(Opened(own.path()), s);
    }
}

TEST_F(D03Spacing, OneSliceIsNoVolume) {
    auto slices = slicesOf(series);
    slices.resize(1);
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_TRUE(opened.says(key::kSingleSlice)) << opened.keys();
    EXPECT_EQ(opened.frames(), 1u);
}

SyntheticSeries tilted(double degrees) {
    SyntheticSeries series;
    const double t = degrees * 3.14159265358979 / 180.0;
    // The table moves along z; the gantry leans by t about x.
    series.worldFromVoxel =
        affine({0.8, 0, 0}, glm::dvec3(0, std::cos(t), -std::sin(t)) * 0.9, {0, 0, 2.5}, {-100, -90, 40});
    return series;
}

TEST_F(D06GantryTilt, ShearedAffineWithoutResampling) {
    for (const double degrees : {-25.0, 3.0, 14.0, 45.0}) {
        SCOPED_TRACE(degrees);
        const TemporaryFolder own;
        const SyntheticSeries s = tilted(degrees);
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        expectOnlyVolume(opened, s);
        const Message* told = opened.find(key::kTiltedStack);
        ASSERT_NE(told, nullptr) << opened.keys();
        EXPECT_NEAR(numberArgument(*told, "degrees"), std::abs(degrees), 0.01);
    }
}

TEST_F(D06GantryTilt, TheTiltTagPlaysNoPart) {
    SyntheticSeries straight;
    straight.edits = {[](DcmItem& item) { put(item, DCM_GantryDetectorTilt, "20"); }};
    writeFiles(folder.path(), straight);
    const Opened opened = open();
    EXPECT_FALSE(opened.says(key::kTiltedStack));
    expectOnlyVolume(opened, straight);
}

TEST_F(D06GantryTilt, MissingSliceOfATiltedStack) {
    const SyntheticSeries s = tilted(14.0);
    auto slices = slicesOf(s);
    slices.erase(slices.begin() + 4);
    writeFiles(folder.path(), s, slices);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kMissingSlices)) << opened.keys();
    expectOnlyVolume(opened, s);
}

// The gantry was set upright half way: two directions, two volumes.
TEST_F(D06GantryTilt, TwoTiltsAreTwoVolumes) {
    SyntheticSeries lower = tilted(0.0);
    SyntheticSeries upper = tilted(18.0);
    lower.size.z = upper.size.z = 6;
    upper.worldFromVoxel[3] += upper.worldFromVoxel[2] * 6.0;
    lower.ramp = upper.ramp = lower.rampOf();
    auto slices = slicesOf(lower);
    for (Slice slice : slicesOf(upper)) {
        slice.sopInstanceUid += ".2";
        slice.fileName += "b";
        slices.push_back(slice);
    }
    writeFiles(folder.path(), lower, slices);
    const Opened opened = open();
    EXPECT_EQ(opened.frames(), 12u);
    EXPECT_TRUE(opened.says(key::kInconsistentOrientation)) << opened.keys();
    ASSERT_EQ(opened.volumes().size(), 2u) << opened.keys();
    for (const Stack* stack : opened.volumes()) {
        const auto volume = opened.load(*stack);
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->size().z, 6);
        expectRamp(*volume, *lower.ramp);
    }
}

TEST_F(D06GantryTilt, SlicesShiftedSidewaysAreNoVolume) {
    auto slices = slicesOf(series);
    for (Slice& slice : slices) slice.positionMm += slice.rowDirection * (slice.place % 3 == 0 ? 3.0 : 0.0);
    writeFiles(folder.path(), series, slices);
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_TRUE(opened.says(key::kNotReconstructable)) << opened.keys();
    EXPECT_EQ(opened.frames(), 12u);
}

// The letters of the sides may say otherwise (PS3.3 C.7.6.1.1.1): geometry counts, and it is told.
TEST_F(D24PatientPosition, LettersThatSayTheOppositeAreToldOf) {
    struct Case {
        const char* letters;
        const char* kind;
        bool told;
    };
    // Rows of these images go to the left, columns to the front.
    const Case cases[]{{"L\\A", "BIPED", false},     {"L\\F", "", false}, {"LA\\AF", "", false},
                       {"R\\A", "", true},           {"L\\P", "", true},  {"RA\\A", "BIPED", true},
                       {"R\\A", "QUADRUPED", false}, {"L", "", false},    {"", "", false},
                       {"RT\\V", "", false},         {"x\\y", "", false}};
    for (const Case& c : cases) {
        SCOPED_TRACE(fmt::format("{} {}", c.letters, c.kind));
        const TemporaryFolder own;
        SyntheticSeries s;
        s.size.z = 3;
        s.worldFromVoxel = affine({1, 0, 0}, {0, -1.5, 0}, {0, 0, -2}, {-10, 20, 30});
        s.edits.push_back([&](DcmItem& item) {
            put(item, DCM_PatientOrientation, c.letters);
            put(item, DCM_AnatomicalOrientationType, c.kind);
        });
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        EXPECT_EQ(opened.says(key::kContradictedOrientation), c.told) << opened.keys();
        expectOnlyVolume(opened, s);
    }
}

TEST_F(D24PatientPosition, LettersComeFromTheDirectionsOnly) {
    struct Case {
        glm::dvec3 row, column;
        const char* letters;
    };
    const Case cases[] = {
        {{1, 0, 0}, {0, 1, 0}, "LPS"},    // axial, supine
        {{-1, 0, 0}, {0, 1, 0}, "RPI"},   // axial, seen from above
        {{0, 1, 0}, {0, 0, -1}, "PIR"},   // sagittal
        {{1, 0, 0}, {0, 0, -1}, "LIP"},   // coronal
        {{0, 1, 0}, {-1, 0, 0}, "PRS"},   // axial, decubitus
        {{-1, 0, 0}, {0, -1, 0}, "RAS"},  // axial, prone
    };
    for (const Case& c : cases) {
        for (const char* position : {"HFS", "FFS", "HFDR", "FFP", "AFDL", ""}) {
            SCOPED_TRACE(fmt::format("{} {}", c.letters, position));
            const TemporaryFolder own;
            SyntheticSeries s;
            s.size.z = 3;
            s.patientPosition = position;
            s.worldFromVoxel =
                affine(c.row * 0.7, c.column * 1.1, glm::cross(c.row, c.column) * 2.0, {5, 6, 7});
            writeFiles(own.path(), s);
            const Opened opened(own.path());
            expectOnlyVolume(opened, s);
            ASSERT_EQ(opened.volumes().size(), 1u);
            EXPECT_EQ(opened.volumes()[0]->orientation, c.letters);
        }
    }
}

}  // namespace
}  // namespace macula::dicom::test
