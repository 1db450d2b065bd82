// More in a file than it says, and the same said twice or otherwise: nothing of it is passed over without a
// word, and what `info` promises is what loading gives.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <fstream>
#include <sstream>

#include "../bytes.h"
#include "../encapsulated.h"
#include "opened.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;
using Surplus = Pitfall;
using Repeated = Pitfall;
using Encoding = Pitfall;
using TextNumbers = Pitfall;

std::string contentOf(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

void write(const fs::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

// The pixel data of a file in Explicit VR Little Endian, in which they come last, are replaced by others.
void replacePixels(const fs::path& file, const std::string& element) {
    std::string bytes = contentOf(file);
    const std::size_t at = bytes.rfind(std::string("\xE0\x7F\x10\x00", 4) + "OW");
    ASSERT_NE(at, std::string::npos);
    write(file, bytes.substr(0, at) + element);
}

std::vector<std::uint16_t> cellsOf(const SyntheticSeries& series, const Slice& slice) {
    std::vector<std::uint16_t> cells;
    for (int j = 0; j < series.size.y; ++j) {
        for (int i = 0; i < series.size.x; ++i)
            cells.push_back(static_cast<std::uint16_t>(rawAt(series, slice, i, j)));
    }
    return cells;
}

std::string nativePixels(const std::vector<std::uint16_t>& cells) {
    std::string bytes = longElement({0x7FE0, 0x0010}, "OW", static_cast<std::uint32_t>(2 * cells.size()));
    for (const std::uint16_t cell : cells) bytes += bytesOf(cell, 2);
    return bytes;
}

void expectSurplus(const Opened& opened, double files, const char* frames) {
    const Message* told = opened.find(key::kSurplusFrames);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(told->severity, Severity::warning);
    EXPECT_EQ(numberArgument(*told, "files"), files);
    EXPECT_NE(told->sentence.english().find(std::string(" ") + frames + " frames"), std::string::npos)
        << told->sentence;
}

TEST_F(Surplus, FramesBeyondTheirNumberAreCounted) {
    const auto all = slicesOf(series);
    writeMultiFrame(folder / "enhanced", series, all);
    editFile(folder / "enhanced", [](DcmItem& item) { put(item, DCM_NumberOfFrames, "9"); });
    const Opened opened = open();
    expectSurplus(opened, 1, "3");
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->size().z, 9);
    expectRamp(*volume, series.rampOf());
}

TEST_F(Surplus, FunctionalGroupsWithoutPixelsAndPixelsWithoutGroups) {
    const auto all = slicesOf(series);
    for (const bool groups : {true, false}) {
        SCOPED_TRACE(groups);
        const TemporaryFolder own;
        writeMultiFrame(own / "enhanced", series, all);
        editFile(own / "enhanced", [&](DcmItem& item) {
            put(item, DCM_NumberOfFrames, "9");
            if (groups) {
                const Uint16* cells = nullptr;
                ASSERT_TRUE(item.findAndGetUint16Array(DCM_PixelData, cells).good());
                const std::vector<Uint16> some(cells, cells + 9 * 8 * 7);
                ASSERT_TRUE(item.putAndInsertUint16Array(DCM_PixelData, some.data(), some.size()).good());
            } else {
                DcmSequenceOfItems* sequence = nullptr;
                ASSERT_TRUE(item.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, sequence).good());
                while (sequence->card() > 9) delete sequence->remove(sequence->card() - 1);
            }
        });
        expectSurplus(Opened(own.path()), 1, "3");
    }
}

TEST_F(Surplus, PixelsOfSingleImages) {
    const auto slices = slicesOf(series);
    for (const auto& [times, frames] : {std::pair(2.0, "12"), std::pair(1.5, "6")}) {
        SCOPED_TRACE(times);
        const TemporaryFolder own;
        const auto files = writeFiles(own.path(), series, slices);
        for (std::size_t n = 0; n < files.size(); ++n) {
            auto cells = cellsOf(series, slices[n]);
            cells.resize(static_cast<std::size_t>(times * double(cells.size())), 7);
            replacePixels(files[n], nativePixels(cells));
        }
        const Opened opened(own.path());
        expectSurplus(opened, 12, frames);
        expectOnlyVolume(opened, series);
    }
}

// A byte or a few of padding are none.
TEST_F(Surplus, PaddingIsNone) {
    const auto slices = slicesOf(series);
    const auto files = writeFiles(folder.path(), series, slices);
    for (std::size_t n = 0; n < files.size(); ++n) {
        auto cells = cellsOf(series, slices[n]);
        cells.resize(cells.size() + 2, 0);
        replacePixels(files[n], nativePixels(cells));
    }
    const Opened opened = open();
    EXPECT_FALSE(opened.says(key::kSurplusFrames)) << opened.keys();
    expectOnlyVolume(opened, series);
}

TEST_F(Surplus, StreamsOfSingleImages) {
    const auto slices = slicesOf(series);
    for (const char* uid : {kJpegLossless, kJpegLs, kJpeg2000}) {
        SCOPED_TRACE(uid);
        const TemporaryFolder own;
        const auto files = writeFiles(own.path(), series, slices);
        for (std::size_t n = 0; n < files.size(); ++n) {
            const std::string stream = encode(uid, 8, 7, 16, cellsOf(series, slices[n]));
            const std::string other = encode(uid, 8, 7, 16, std::vector<std::uint16_t>(56, 9));
            // Each stream in two fragments: the number of these alone says nothing.
            replacePixels(files[n], encapsulated(cut({stream, other}, 2).fragments));
        }
        const Opened opened(own.path());
        expectSurplus(opened, 12, "12");
        expectOnlyVolume(opened, series);
    }
}

TEST_F(Surplus, BytesAfterThePixelsAreMeasured) {
    const auto files = writeFiles(folder.path(), series);
    const std::size_t pixels = 2 * 8 * 7;
    for (const std::size_t bytes : {std::size_t{7}, pixels, std::size_t{3} << 20}) {
        SCOPED_TRACE(bytes);
        const std::string before = contentOf(files[1]);
        write(files[1], before + std::string(bytes, '\x7F'));
        const Opened opened = open();
        const Message* told = opened.find(key::kStrayBytes);
        ASSERT_NE(told, nullptr) << opened.keys();
        EXPECT_EQ(told->severity, bytes >= pixels ? Severity::warning : Severity::info);
        const std::string text = bytes < 10'000 ? std::to_string(bytes) + " bytes" : "3145 kB";
        EXPECT_NE(told->sentence.english().find(text), std::string::npos) << told->sentence;
        expectOnlyVolume(opened, series);
        write(files[1], before);
    }
}

// Raw pixels behind those of the file may look like an element that comes last.
TEST_F(Surplus, PixelsAfterThePixelsAreNoElement) {
    const auto files = writeFiles(folder.path(), series);
    std::string more;
    for (int n = 0; n < 56; ++n) more += bytesOf(0xFC18, 2);
    write(files[1], contentOf(files[1]) + more);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kStrayBytes)) << opened.keys();
    // Data Set Trailing Padding is one.
    const TemporaryFolder own;
    const auto padded = writeFiles(own.path(), series);
    write(padded[1], contentOf(padded[1]) + longElement({0xFFFC, 0xFFFC}, "OB", 64) + std::string(64, '\0'));
    EXPECT_FALSE(Opened(own.path()).says(key::kStrayBytes));
}

// NumberOfFrames says more than there are: those that are there are shown, the first ones.
TEST_F(Surplus, FewerStreamsThanFrames) {
    auto all = slicesOf(series);
    for (const std::size_t fragmentsEach : {1u, 2u}) {
        for (const char* uid : {kJpegLossless, kJpeg2000, kRle}) {
            if (uid == kRle && fragmentsEach > 1) continue;
            SCOPED_TRACE(std::string(uid) + " in " + std::to_string(fragmentsEach));
            const TemporaryFolder own;
            writeMultiFrame(own / "enhanced", series, all);
            std::vector<std::string> streams;
            for (int n = 0; n < 10; ++n)
                streams.push_back(encode(uid, 8, 7, 16, cellsOf(series, all[std::size_t(n)])));
            replacePixels(own / "enhanced", encapsulated(cut(streams, fragmentsEach).fragments));
            const Opened opened(own.path());
            const Message* told = opened.find(key::kMissingFrames);
            ASSERT_NE(told, nullptr) << opened.keys();
            EXPECT_EQ(numberArgument(*told, "missing"), 2.0);
            EXPECT_EQ(opened.frames(), 10u);
            const auto volume = opened.onlyVolume();
            ASSERT_NE(volume, nullptr);
            EXPECT_EQ(volume->size().z, 10);
            expectRamp(*volume, series.rampOf());
        }
    }
}

// --- encoding ---

// The file names one encoding, and its pixels are in another: read as what they are, and told.
TEST_F(Encoding, IsWhatThePixelsAreAndNotWhatTheFileNames) {
    const auto slices = slicesOf(series);
    for (const char* uid : {kJpegLossless, kJpegLosslessFirstOrder, kJpegLs, kJpeg2000, kRle}) {
        SCOPED_TRACE(uid);
        const TemporaryFolder own;
        const auto files = writeFiles(own.path(), series, slices);
        for (std::size_t n = 0; n < files.size(); ++n)
            replacePixels(
                files[n],
                encapsulated(cut({encode(uid, 8, 7, 16, cellsOf(series, slices[n]))}, 1).fragments));
        const Opened opened(own.path());
        const Message* told = opened.find(key::kContradictedSyntax);
        ASSERT_NE(told, nullptr) << opened.keys();
        EXPECT_EQ(told->severity, Severity::warning);
        EXPECT_NE(told->sentence.english().find("Explicit VR Little Endian"), std::string::npos)
            << told->sentence;
        expectOnlyVolume(opened, series);
    }
}

// --- the same twice ---

// A second element of the same tag right after the first.
void repeat(const fs::path& file, Tag tag, const std::string& vr, const std::string& value) {
    std::string bytes = contentOf(file);
    const std::string name = bytesOf(tag.group, 2) + bytesOf(tag.element, 2) + vr;
    const std::size_t at = bytes.find(name, 132);
    ASSERT_NE(at, std::string::npos);
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    const std::size_t length = std::size_t{byte(at + 6)} | std::size_t{byte(at + 7)} << 8;
    bytes.insert(at + 8 + length, shortElement(tag, vr, value));
    write(file, bytes);
}

TEST_F(Repeated, ElementsWithOtherValuesAreNamed) {
    struct Case {
        Tag tag;
        const char* vr;
        std::string value;
        const char* keyword;
    };
    const Case cases[]{
        {{0x0028, 0x1052}, "DS", "0", "RescaleIntercept"},
        {{0x0028, 0x1053}, "DS", "2", "RescaleSlope"},
        {{0x0028, 0x0030}, "DS", "9\\9", "PixelSpacing"},
        {{0x0028, 0x0010}, "US", bytesOf(6, 2), "Rows"},
        {{0x0020, 0x0032}, "DS", "0\\0\\0", "ImagePositionPatient"},
        {{0x0028, 0x0103}, "US", bytesOf(1, 2), "PixelRepresentation"},
        {{0x0010, 0x0020}, "LO", "ANOTHER", "PatientID"},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.keyword);
        const TemporaryFolder own;
        const auto files = writeFiles(own.path(), series);
        for (std::size_t n = 0; n < 5; ++n) repeat(files[n], c.tag, c.vr, c.value);
        const Opened opened(own.path());
        const Message* told = opened.find(key::kRepeatedElement);
        ASSERT_NE(told, nullptr) << opened.keys();
        EXPECT_EQ(told->severity, Severity::warning);
        EXPECT_EQ(numberArgument(*told, "count"), 5.0);
        EXPECT_EQ(numberArgument(*told, "total"), 12.0);
        EXPECT_NE(told->sentence.english().find(c.keyword), std::string::npos) << told->sentence;
        EXPECT_EQ(told->sentence.english().find("ANOTHER"), std::string::npos) << told->sentence;
        expectOnlyVolume(opened, series);  // the first counts, as DCMTK reads it
    }
}

TEST_F(Repeated, ElementsWithTheSameValueAreNoMatter) {
    const auto files = writeFiles(folder.path(), series);
    for (const auto& file : files) {
        repeat(file, {0x0028, 0x1052}, "DS", "-1024.0");
        repeat(file, {0x0028, 0x0010}, "US", bytesOf(7, 2));
        repeat(file, {0x0010, 0x0010}, "PN", series.patientName);
        repeat(file, {0x0018, 0x0050}, "DS", "7.250");
    }
    const Opened opened = open();
    EXPECT_FALSE(opened.says(key::kRepeatedElement)) << opened.keys();
    expectOnlyVolume(opened, series);
}

TEST_F(Repeated, PixelData) {
    const auto files = writeFiles(folder.path(), series);
    for (const auto& file : files)
        write(file, contentOf(file) + nativePixels(std::vector<std::uint16_t>(56, 9)));
    const Opened opened = open();
    const Message* told = opened.find(key::kRepeatedElement);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_NE(told->sentence.english().find("PixelData"), std::string::npos) << told->sentence;
    EXPECT_FALSE(opened.says(key::kStrayBytes)) << opened.keys();
    expectOnlyVolume(opened, series);
}

// In the functional groups of one frame.
TEST_F(Repeated, ElementsOfAFrame) {
    const auto all = slicesOf(series);
    writeMultiFrame(folder / "enhanced", series, all, {.sharedTransformation = false});
    // DCMTK writes no tag twice: another attribute of that macro, with a value of the same length, takes its
    // name.
    std::string bytes = contentOf(folder / "enhanced");
    const std::string slope = bytesOf(0x0028, 2) + bytesOf(0x1053, 2) + "DS";
    const std::string intercept = bytesOf(0x0028, 2) + bytesOf(0x1052, 2) + "DS";
    const std::size_t at = bytes.find(slope);
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at, intercept.size(), intercept);
    write(folder / "enhanced", bytes);
    const Opened opened = open();
    const Message* told = opened.find(key::kRepeatedElement);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(numberArgument(*told, "count"), 1.0);
    EXPECT_NE(told->sentence.english().find("RescaleIntercept"), std::string::npos) << told->sentence;
}

// --- numbers in another VR ---

void putAs(DcmItem& item, const DcmTagKey& tag, const DcmEVR vr, int value) {
    delete item.remove(tag);
    const DcmTag named(tag, vr);
    if (vr == EVR_UL) {
        ASSERT_TRUE(item.putAndInsertUint32(named, static_cast<Uint32>(value)).good());
    } else {
        ASSERT_TRUE(item.putAndInsertString(named, std::to_string(value).c_str()).good());
    }
}

// What is listed as a volume can be loaded.
TEST_F(TextNumbers, AreReadAlikeWhenListedAndWhenLoaded) {
    series.size = {64, 64, 12};
    series.worldFromVoxel = affine({0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 1}, {-3, -2, 4});
    for (const DcmEVR vr : {EVR_IS, EVR_DS, EVR_UL}) {
        SCOPED_TRACE(DcmVR(vr).getVRName());
        const TemporaryFolder own;
        SyntheticSeries s = series;
        s.edits.push_back([vr](DcmItem& item) {
            putAs(item, DCM_Rows, vr, 64);
            putAs(item, DCM_Columns, vr, 64);
            putAs(item, DCM_BitsAllocated, vr, 16);
            putAs(item, DCM_BitsStored, vr, 16);
            putAs(item, DCM_HighBit, vr, 15);
            putAs(item, DCM_PixelRepresentation, vr, 0);
            putAs(item, DCM_SamplesPerPixel, vr, 1);
        });
        writeFiles(own.path(), s);
        expectOnlyVolume(Opened(own.path()), s);
    }
}

TEST_F(TextNumbers, OfPaddingToo) {
    series.rawInstead = [](const Slice&, int i, int) { return i == 0 ? std::optional(63) : std::nullopt; };
    series.edits.push_back([](DcmItem& item) { putAs(item, DCM_PixelPaddingValue, EVR_IS, 63); });
    writeFiles(folder.path(), series);
    const auto volume = open().onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_TRUE(volume->isPadding(0, 3, 2));
    EXPECT_FALSE(volume->isPadding(1, 3, 2));
}

TEST_F(TextNumbers, CodeStringsInSmallLettersAreTheSame) {
    series.edits.push_back([](DcmItem& item) {
        put(item, DCM_PhotometricInterpretation, "monochrome2");
        put(item, DCM_Modality, "ct");
    });
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_FALSE(opened.says(key::kColourImage)) << opened.keys();
    expectOnlyVolume(opened, series);
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->unit(), Unit::hounsfield);
}

}  // namespace
}  // namespace macula::dicom::test
