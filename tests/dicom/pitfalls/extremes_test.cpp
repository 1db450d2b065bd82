// D15 pixel sizes, D27 speed, and numbers nobody would write on purpose.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <string>

#include "opened.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

// By this process, from files, in all.
std::uint64_t bytesRead() {
    std::ifstream counts("/proc/self/io");
    std::string name;
    std::uint64_t bytes = 0;
    counts >> name >> bytes;
    EXPECT_EQ(name, "rchar:");
    return bytes;
}

// Of all threads: what else runs on the machine does not count.
double processorSeconds() {
    return double(std::clock()) / CLOCKS_PER_SEC;
}

using D15UncalibratedPixels = Pitfall;
using D27Speed = Pitfall;
using Extremes = Pitfall;

// Only the size at the detector is known: shown, and marked.
TEST_F(D15UncalibratedPixels, ImagerPixelSpacing) {
    series.edits.push_back([](DcmItem& item) {
        erase(item, DCM_PixelSpacing);
        put(item, DCM_ImagerPixelSpacing, "1.1\\0.7");
    });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    const Message* told = opened.find(key::kUncalibrated);
    ASSERT_NE(told, nullptr) << opened.keys();

    expectOnlyVolume(opened, series);
}

// Whoever has the volume knows it, whatever is done with its voxels.
TEST_F(D15UncalibratedPixels, TheVolumeSaysThatSizesAreEstimates) {
    for (const bool isCalibrated : {true, false}) {
        SCOPED_TRACE(isCalibrated);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.edits.push_back([&](DcmItem& item) {
            if (!isCalibrated) erase(item, DCM_PixelSpacing);
            put(item, DCM_ImagerPixelSpacing, "1.1\\0.7");
        });
        auto slices = slicesOf(s);
        for (Slice& slice : slices) slice.slope = std::sqrt(2.0 + slice.place);  // floats
        writeFiles(own.path(), s, slices);
        const Opened opened(own.path());
        ASSERT_EQ(opened.volumes().size(), 1u);
        EXPECT_EQ(opened.volumes().front()->isCalibrated, isCalibrated);
        const auto volume = opened.onlyVolume();
        ASSERT_NE(volume, nullptr);
        EXPECT_EQ(volume->format(), VoxelFormat::float32);
        EXPECT_EQ(volume->provenance().isCalibrated, isCalibrated);
        EXPECT_EQ(in16Bits(volume)->provenance().isCalibrated, isCalibrated);
    }
}

TEST_F(D15UncalibratedPixels, MagnificationIsTakenOut) {
    series.edits.push_back([](DcmItem& item) {
        erase(item, DCM_PixelSpacing);
        put(item, DCM_ImagerPixelSpacing, "1.65\\1.05");
        put(item, DCM_EstimatedRadiographicMagnificationFactor, "1.5");
    });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kUncalibrated)) << opened.keys();
    expectOnlyVolume(opened, series);
}

TEST_F(D15UncalibratedPixels, NominalScannedPixelSpacing) {
    series.edits.push_back([](DcmItem& item) {
        erase(item, DCM_PixelSpacing);
        put(item, DCM_NominalScannedPixelSpacing, "1.1\\0.7");
    });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kUncalibrated)) << opened.keys();
    expectOnlyVolume(opened, series);
}

TEST_F(D15UncalibratedPixels, CalibratedOnesWin) {
    series.edits.push_back([](DcmItem& item) { put(item, DCM_ImagerPixelSpacing, "9\\9"); });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_FALSE(opened.says(key::kUncalibrated)) << opened.keys();
    expectOnlyVolume(opened, series);
}

TEST_F(D15UncalibratedPixels, NoneIsNoVolume) {
    series.edits.push_back([](DcmItem& item) {
        erase(item, DCM_PixelSpacing);
        put(item, DCM_PixelAspectRatio, "11\\7");
    });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_TRUE(opened.says(key::kNoPixelSpacing)) << opened.keys();
}

// Headers are read up to the pixels: files that claim gigabytes cost nothing.
TEST_F(D27Speed, PixelsAreNotRead) {
    series.size = {4, 4, 20};
    for (const fs::path& file : writeFiles(folder.path(), series)) {
        editFile(file, [](DcmItem& item) {
            putWord(item, DCM_Rows, 8000);
            putWord(item, DCM_Columns, 8000);
        });
        // The last element is the pixel data: its length, and a hole in the file.
        const auto end = fs::file_size(file);
        std::FILE* stream = std::fopen(file.c_str(), "r+b");
        ASSERT_NE(stream, nullptr);
        std::fseek(stream, static_cast<long>(end - 32 - 4), SEEK_SET);
        const std::uint32_t length = 8000 * 8000 * 2;
        std::fwrite(&length, 4, 1, stream);
        std::fclose(stream);
        fs::resize_file(file, end - 32 + length);
    }
    const std::uint64_t before = bytesRead();
    const Opened opened = open();
    EXPECT_LT(bytesRead() - before, 100'000'000u) << "the pixel data, 2.5 GB, are not read";
    EXPECT_EQ(opened.frames(), 20u);
    EXPECT_EQ(opened.volumes().size(), 1u) << opened.keys();
}

TEST_F(D27Speed, ProgressAtMostTenTimesASecond) {
    for (int n = 0; n < 40; ++n) {
        SyntheticSeries s;
        s.size = {2, 2, 12};
        s.number = n;
        s.seriesUid = fmt::format("2.25.7{:03}", n);
        writeFiles(folder.path(), s);
    }
    std::atomic<int> calls{0};
    std::atomic<int> stages{0};
    Text last;
    Progress progress([&](const ProgressUpdate& update) {
        ++calls;
        if (update.stage != last) ++stages;
        last = update.stage;
    });
    const auto start = std::chrono::steady_clock::now();
    ASSERT_TRUE(scanFolder(folder.path(), progress));
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_GE(calls, 2);
    EXPECT_LE(calls, 10 * taken.count() + 1 + 2 * stages);
}

// As the files begin to be read: after that only those are that were begun.
TEST_F(D27Speed, CancelledInTheMiddle) {
    for (int n = 0; n < 40; ++n) {
        SyntheticSeries s;
        s.size = {2, 2, 12};
        s.number = n;
        s.seriesUid = fmt::format("2.25.7{:03}", n);
        writeFiles(folder.path(), s);
    }
    CancelToken token;
    std::atomic<bool> started{false};
    std::uint64_t bytesBefore = 0;
    // Files are looked at before that stage begins; its first update comes before any of them is read.
    const auto countFromReading = [&](const ProgressUpdate& update) {
        if (!update.stage.english().starts_with("Reading") || started.exchange(true)) return false;
        bytesBefore = bytesRead();
        return true;
    };
    Progress whole([&](const ProgressUpdate& update) { countFromReading(update); });
    ASSERT_TRUE(scanFolder(folder.path(), whole));
    const std::uint64_t allBytes = bytesRead() - bytesBefore;
    started = false;
    Progress progress(
        [&](const ProgressUpdate& update) {
            if (countFromReading(update)) token.cancel();
        },
        token);
    const auto found = scanFolder(folder.path(), progress);
    ASSERT_TRUE(started);
    EXPECT_LT(bytesRead() - bytesBefore, allBytes / 2);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::cancelled);
}

TEST_F(Extremes, OnePixelPerSlice) {
    series.size = {1, 1, 12};
    writeFiles(folder.path(), series);
    expectOnlyVolume(open(), series);
}

TEST_F(Extremes, OneRowOneColumnTwoSlices) {
    for (const glm::ivec3& size : {glm::ivec3{9, 1, 4}, glm::ivec3{1, 9, 4}, glm::ivec3{3, 3, 2}}) {
        const TemporaryFolder own;
        SyntheticSeries s;
        s.size = size;
        writeFiles(own.path(), s);
        expectOnlyVolume(Opened(own.path()), s);
    }
}

TEST_F(Extremes, NoPixelsAtAll) {
    series.edits.push_back([](DcmItem& item) {
        putWord(item, DCM_Rows, 0);
        putWord(item, DCM_Columns, 0);
    });
    writeFiles(folder.path(), series);
    Progress progress;
    const auto found = scanFolder(folder.path(), progress);
    if (!found) {
        EXPECT_EQ(found.error().code, ErrorCode::inputNotUsable);
        EXPECT_FALSE(found.error().hint.empty());
        return;
    }
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    EXPECT_FALSE(opened.keys().empty());
}

TEST_F(Extremes, WidestImageClaimedWithFewBytes) {
    for (const char* syntax : {"1.2.840.10008.1.2.1", "1.2.840.10008.1.2.5", "1.2.840.10008.1.2.1.99"}) {
        SCOPED_TRACE(syntax);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.transferSyntaxUid = syntax;
        const auto files = writeFiles(own.path(), s);
        for (const fs::path& file : files) {
            editFile(file, [](DcmItem& item) {
                putWord(item, DCM_Rows, 65535);
                putWord(item, DCM_Columns, 65535);
            });
        }
        Progress progress;
        const auto found = scanFolder(own.path(), progress);
        if (!found) {
            EXPECT_EQ(found.error().code, ErrorCode::inputNotUsable);
            continue;
        }
        const Opened opened(own.path());
        for (const Series* each : opened.series()) {
            for (const Stack& stack : each->stacks) {
                Progress loading;
                EXPECT_FALSE(loadVolume(*each, stack, loading));
            }
        }
    }
}

TEST_F(Extremes, PixelSpacingsThatAreNone) {
    for (const char* text :
         {"0\\0", "-1\\1", "1\\-1", "NaN\\NaN", "abc\\1", "1", "", "inf\\1", "1e400\\1", "\\"}) {
        SCOPED_TRACE(text);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.edits.push_back([&](DcmItem& item) { put(item, DCM_PixelSpacing, text); });
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        EXPECT_TRUE(opened.volumes().empty());
        EXPECT_EQ(opened.frames(), 12u);
        EXPECT_TRUE(opened.says(key::kNoPixelSpacing) || opened.says(key::kInvalidOrientation) ||
                    opened.says(key::kMalformedNumbers))
            << opened.keys();
    }
}

TEST_F(Extremes, PixelSpacingsFromMicroscopeToTelescope) {
    for (const double scale : {1e-2, 1e3}) {
        SCOPED_TRACE(scale);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.worldFromVoxel =
            affine(glm::dvec3(obliqueAffine()[0]) * scale, glm::dvec3(obliqueAffine()[1]) * scale,
                   glm::dvec3(obliqueAffine()[2]) * scale, {1, 2, 3});
        s.ramp = s.rampOf();
        s.ramp->perMm /= scale;
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        const auto volume = opened.onlyVolume();
        ASSERT_NE(volume, nullptr);
        expectGrid(*volume, s.size, s.expectedAffine(), 1e-6 * std::max(1.0, scale));
        expectRamp(*volume, *s.ramp, 0.6);
    }
}

TEST_F(Extremes, FarFromTheOrigin) {
    series.worldFromVoxel[3] = glm::dvec4(1e5, -1e5, 1e5, 1.0);
    writeFiles(folder.path(), series);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectGrid(*volume, series.size, series.expectedAffine(), 1e-4);
    expectRamp(*volume, series.rampOf(), 0.6);
}

TEST_F(Extremes, PositionsThatAreNone) {
    for (const char* text :
         {"NaN\\0\\0", "1\\2", "1e400\\0\\0", "left\\1\\2", "1\\2\\3\\4", "1e308\\1e308\\1e308"}) {
        SCOPED_TRACE(text);
        const TemporaryFolder own;
        SyntheticSeries s;
        s.edits.push_back([&](DcmItem& item) { put(item, DCM_ImagePositionPatient, text); });
        writeFiles(own.path(), s);
        const Opened opened(own.path());
        EXPECT_TRUE(opened.volumes().empty());
        EXPECT_EQ(opened.frames(), 12u);
        EXPECT_FALSE(opened.keys().empty());
    }
}

// Whole numbers with a point, blanks, plus signs, exponents: all of it occurs.
TEST_F(Extremes, NumbersAsPeopleWriteThem) {
    series.size = {2, 2, 3};
    series.worldFromVoxel = affine({0.5, 0, 0}, {0, 2, 0}, {0, 0, 3}, {-10, 20, 0});
    series.ramp = Ramp{.perMm = {11, 23, 47}};
    auto slices = slicesOf(series);
    const char* positions[] = {"-10.\\+20 \\ 0", " -1.0E+1\\2e1\\3.000", "-10\\20.0\\+6."};
    for (Slice& slice : slices) {
        slice.edits.push_back([text = positions[slice.place]](DcmItem& item) {
            put(item, DCM_ImagePositionPatient, text);
            put(item, DCM_PixelSpacing, " 2.0 \\.5");
            put(item, DCM_RescaleSlope, "+1.E0 ");
        });
    }
    writeFiles(folder.path(), series, slices);
    expectOnlyVolume(open(), series);
}

// A few bytes that say they are 100 000 frames, in 30 files: they cost what a few bytes cost.
TEST_F(Extremes, FramesThatAreClaimedOnly) {
    for (const char* syntax : {"1.2.840.10008.1.2.1", "1.2.840.10008.1.2.5"}) {
        SCOPED_TRACE(syntax);
        const TemporaryFolder own;
        series.size = {4, 4, 1};
        series.transferSyntaxUid = syntax;
        const auto one = slicesOf(series);
        for (int n = 0; n < 30; ++n) {
            writeMultiFrame(own / std::to_string(n), series, one,
                            {.sopInstanceUid = fmt::format("2.25.{}", 7000 + n)});
            editFile(own / std::to_string(n), [](DcmItem& item) { put(item, DCM_NumberOfFrames, "100000"); });
        }
        const double start = processorSeconds();
        const Opened opened(own.path());
        EXPECT_LT(processorSeconds() - start, 10.0);  // all that are claimed would take minutes
        // Of compressed frames the file's size is the only bound before they are decoded.
        EXPECT_LE(opened.frames(), syntax == std::string("1.2.840.10008.1.2.1") ? 30u : 30u * 512u);
        EXPECT_TRUE(opened.volumes().empty());
        EXPECT_FALSE(opened.keys().empty());
    }
}

// One file with 20 000 frames and as many offsets, as of a dose grid: read once, not once per frame.
TEST_F(Extremes, ManyFramesWithALongOffsetVector) {
    series.size = {1, 1, 20000};
    series.intercept = 0.0;
    series.worldFromVoxel = affine({1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}, {0, 0, 0});
    series.ramp = Ramp{.value = 100, .throughMm = {0, 0, 0}, .perMm = {11, 23, 1}};
    std::string offsets;
    for (int n = 0; n < 20000; ++n) offsets += (n ? "\\" : "") + decimal(0.5 * n);
    writeMultiFrame(
        folder / "grid", series, slicesOf(series),
        {.functionalGroups = false, .dimensions = false, .edits = {[&](DcmItem& item) {
                                                             put(item, DCM_PixelSpacing, "1\\1");
                                                             put(item, DCM_ImagePositionPatient, "0\\0\\0");
                                                             put(item, DCM_ImageOrientationPatient,
                                                                 "1\\0\\0\\0\\1\\0");
                                                             put(item, DCM_GridFrameOffsetVector, offsets);
                                                         }}});
    const double start = processorSeconds();
    const Opened opened = open();
    EXPECT_LT(processorSeconds() - start, 10.0);  // once per frame would be 400 million numbers
    expectOnlyVolume(opened, series);
}

TEST_F(Extremes, EmptyFolderIsAnErrorWithAHint) {
    Progress progress;
    const auto found = scanFolder(folder.path(), progress);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().code, ErrorCode::inputNotUsable);
    EXPECT_FALSE(found.error().hint.empty());
}

}  // namespace
}  // namespace macula::dicom::test
