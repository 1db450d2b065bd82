// Frames of any image: made here in each colour model and encoding, and the real ones of ../shared/data
// against what other decoders read.
#include "dicom/planar/planar_frame.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "dicom/read/transfer_syntax.h"
#include "dicom/stack/examination.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// All frames of one file, in their order.
Stack stackOf(const fs::path& file) {
    Stack stack;
    Examination found = examine(file);
    EXPECT_EQ(found.kind, Examination::Kind::image) << file;
    stack.frames = std::move(found.frames);
    return stack;
}

struct Opened {
    explicit Opened(const fs::path& file) : stack(stackOf(file)) {
        auto read = readPlanarHeader(file);
        EXPECT_TRUE(read) << file;
        if (read) header = *std::move(read);
    }
    PlanarFrame frame(std::size_t i) const {
        auto loaded = loadPlanarFrame(stack, i, header);
        EXPECT_TRUE(loaded) << loaded.error().message;
        return loaded ? *std::move(loaded) : PlanarFrame{};
    }
    Stack stack;
    PlanarHeader header;
};

constexpr int kColumns = 4;
constexpr int kRows = 3;

// A colour for each pixel and frame, which no exchange of rows, columns, samples or frames makes.
std::array<int, 3> colourAt(int frame, int row, int column) {
    return {10 * frame + 20 * row + column, 100 + 30 * row + 3 * column + frame, 250 - 40 * row - 7 * column};
}

struct ColourFile {
    const char* photometric = "RGB";
    bool isByPlane = false;
    bool isSubsampled = false;
    int bits = 8;
    E_TransferSyntax syntax = EXS_LittleEndianExplicit;
};

std::vector<Uint16> samplesOf(const ColourFile& file, int frames) {
    const int scale = file.bits == 16 ? 257 : 1;
    std::vector<Uint16> samples;
    const auto put = [&](int value) { samples.push_back(static_cast<Uint16>(value * scale)); };
    for (int f = 0; f < frames; ++f) {
        for (int c = 0; file.isByPlane && c < 3; ++c)
            for (int i = 0; i < kRows * kColumns; ++i)
                put(colourAt(f, i / kColumns, i % kColumns)[std::size_t(c)]);
        for (int i = 0; !file.isByPlane && i < kRows * kColumns; ++i) {
            const auto colour = colourAt(f, i / kColumns, i % kColumns);
            if (!file.isSubsampled) {
                for (const int value : colour) put(value);
            } else if (i % 2 == 0) {
                put(colour[0]);
                put(colourAt(f, i / kColumns, i % kColumns + 1)[0]);
                put(colour[1]);
                put(colour[2]);
            }
        }
    }
    return samples;
}

void write(const fs::path& path, const ColourFile& file, int frames) {
    DcmFileFormat format;
    DcmDataset& d = *format.getDataset();
    d.putAndInsertString(DCM_SOPClassUID, UID_MultiframeTrueColorSecondaryCaptureImageStorage);
    d.putAndInsertString(DCM_SOPInstanceUID, "2.25.1");
    d.putAndInsertString(DCM_StudyInstanceUID, "2.25.2");
    d.putAndInsertString(DCM_SeriesInstanceUID, "2.25.3");
    d.putAndInsertString(DCM_Modality, "OT");
    d.putAndInsertUint16(DCM_SamplesPerPixel, 3);
    d.putAndInsertString(DCM_PhotometricInterpretation, file.photometric);
    d.putAndInsertUint16(DCM_PlanarConfiguration, file.isByPlane ? 1 : 0);
    d.putAndInsertString(DCM_NumberOfFrames, std::to_string(frames).c_str());
    d.putAndInsertUint16(DCM_Rows, kRows);
    d.putAndInsertUint16(DCM_Columns, kColumns);
    const auto bits = static_cast<Uint16>(file.bits);
    d.putAndInsertUint16(DCM_BitsAllocated, bits);
    d.putAndInsertUint16(DCM_BitsStored, bits);
    d.putAndInsertUint16(DCM_HighBit, static_cast<Uint16>(bits - 1));
    d.putAndInsertUint16(DCM_PixelRepresentation, 0);
    const std::vector<Uint16> samples = samplesOf(file, frames);
    if (file.bits == 16) {
        d.putAndInsertUint16Array(DCM_PixelData, samples.data(), samples.size());
    } else {
        const std::vector<Uint8> bytes(samples.begin(), samples.end());
        d.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size());
    }
    if (file.syntax == EXS_RLELossless) {
        DcmRLEEncoderRegistration::registerCodecs();
        ASSERT_TRUE(d.chooseRepresentation(file.syntax, nullptr).good());
    }
    ASSERT_TRUE(format.saveFile(path.c_str(), file.syntax).good());
}

void expectColours(const fs::path& path, const ColourFile& file, int frames) {
    const Opened opened(path);
    ASSERT_EQ(opened.stack.frames.size(), std::size_t(frames));
    const auto model = colourModelOf(file.photometric);
    ASSERT_TRUE(model);
    for (int f = 0; f < frames; ++f) {
        const PlanarFrame frame = opened.frame(std::size_t(f));
        ASSERT_EQ(frame.rgb.size(), std::size_t(3 * kRows * kColumns));
        for (int i = 0; i < kRows * kColumns; ++i) {
            auto colour = colourAt(f, i / kColumns, i % kColumns);
            if (file.isSubsampled) {
                const auto shared = colourAt(f, i / kColumns, i % kColumns / 2 * 2);
                colour = {colour[0], shared[1], shared[2]};
            }
            const std::array<std::uint16_t, 3> samples{std::uint16_t(colour[0]), std::uint16_t(colour[1]),
                                                       std::uint16_t(colour[2])};
            const auto expected = toRgb(*model, 8, samples);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_EQ(frame.rgb[3 * std::size_t(i) + c], expected[c]) << f << " " << i << " " << c;
        }
    }
}

TEST(PlanarFrames, AreTheColoursOfTheFileInEachForm) {
    const std::vector<ColourFile> forms{
        {},
        {.isByPlane = true},
        {.bits = 16},
        {.isByPlane = true, .bits = 16},
        {.syntax = EXS_RLELossless},
        {.bits = 16, .syntax = EXS_RLELossless},
        {.photometric = "YBR_FULL"},
        {.photometric = "YBR_FULL", .isByPlane = true},
        {.photometric = "YBR_FULL_422", .isSubsampled = true},
        {.photometric = "YBR_FULL_422"},  // named so, and whole
        {.syntax = EXS_BigEndianExplicit},
        {.bits = 16, .syntax = EXS_BigEndianExplicit},
    };
    const TemporaryFolder folder;
    for (std::size_t i = 0; i < forms.size(); ++i) {
        SCOPED_TRACE(i);
        write(folder / "image.dcm", forms[i], 3);
        expectColours(folder / "image.dcm", forms[i], 3);
    }
}

TEST(PlanarFrames, ThatEndEarlyAreErrorsAndTheOthersAreThere) {
    const TemporaryFolder folder;
    const fs::path file = folder / "image.dcm";
    write(file, {}, 3);
    fs::resize_file(file, fs::file_size(file) - 10);
    const Opened opened(file);
    EXPECT_TRUE(loadPlanarFrame(opened.stack, 0, opened.header));
    ASSERT_LE(opened.stack.frames.size(), 3u);
    for (std::size_t f = 2; f < opened.stack.frames.size(); ++f) {
        const auto cut = loadPlanarFrame(opened.stack, f, opened.header);
        ASSERT_FALSE(cut);
        EXPECT_EQ(cut.error().code, ErrorCode::inputNotUsable);
    }
}

TEST(PlanarFrames, InColoursThatNobodyWritesAreRefused) {
    const TemporaryFolder folder;
    const fs::path file = folder / "image.dcm";
    for (const char* photometric : {"HSV", "CMYK", "PALETTE COLOR"}) {
        write(file, {.photometric = photometric}, 1);
        const Opened opened(file);
        const auto refused = loadPlanarFrame(opened.stack, 0, opened.header);
        ASSERT_FALSE(refused) << photometric;
        EXPECT_EQ(refused.error().code, ErrorCode::inputNotUsable);
        EXPECT_FALSE(refused.error().hint.empty());
    }
}

std::vector<double> numbersOf(const Json& value) {
    return value.is_array() ? value.get<std::vector<double>>() : std::vector<double>{value.get<double>()};
}

// The probe's value as this reader should have it: stored values become grey units, or colours.
void expectProbe(const Opened& opened, const PlanarFrame& frame, const Json& probe, const Json& truth) {
    const auto row = probe[0].get<std::size_t>();
    const auto column = probe[1].get<std::size_t>();
    const std::size_t pixel = row * std::size_t(frame.columns) + column;
    const std::vector<double> stored = numbersOf(probe[2]);
    if (!frame.isColour()) {
        const Frame& of = opened.stack.frames.front();
        const double value = of.slope.value_or(1.0) * stored[0] + of.intercept.value_or(0.0);
        const double tolerance = truth["lossless_stream"].get<bool>() ? 1e-3 + 1e-6 * std::abs(value) : 2.0;
        EXPECT_NEAR(frame.values.at(pixel), value, tolerance);
        return;
    }
    std::vector<std::uint8_t> expected;
    if (stored.size() == 1) {
        ASSERT_TRUE(opened.header.palette);
        const auto& colour = (*opened.header.palette)(int(stored[0]));
        expected.assign(colour.begin(), colour.end());
    } else {
        const std::vector<std::uint16_t> samples(stored.begin(), stored.end());
        const auto model = colourModelOf(truth["photometric"].get<std::string>());
        ASSERT_TRUE(model);
        expected = toRgb(*model, truth["bits"][0].get<int>(), samples);
    }
    // Decoders of lossy streams differ in how they enlarge colour differences, and round them.
    const int tolerance = truth["lossless_stream"].get<bool>() ? 0 : 4;
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(frame.rgb.at(3 * pixel + c), expected[c], tolerance) << row << " " << column << " " << c;
}

TEST(PlanarFrames, OfRealImagesAreWhatOtherDecodersRead) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path data = sharedData() / "planar";
    if (!fs::is_directory(data)) GTEST_SKIP() << "the planar data are not on this machine";
    std::size_t images = 0;
    for (const char* kind : {"1_planar_and_cine", "5_codecs"}) {
        std::ifstream stream(data / "truth" / (std::string(kind) + ".json"));
        const Json all = Json::parse(stream);
        for (const auto& [name, truth] : all.items()) {
            if (!truth.is_object() || !truth.contains("probes") || !fs::exists(data / name)) continue;
            SCOPED_TRACE(name);
            if (examine(data / name).kind != Examination::Kind::image) continue;  // a segmentation
            const Opened opened(data / name);
            const std::string& transferSyntax = opened.stack.frames.at(0).instance->transferSyntaxUid;
            ++images;
            EXPECT_EQ(opened.stack.frames.size(), truth["frames"].get<std::size_t>());
            for (const auto& [number, probes] : truth["probes"].items()) {
                auto loaded =
                    loadPlanarFrame(opened.stack, std::size_t(std::stoul(number) - 1), opened.header);
                const bool isDecoded = transferSyntaxInfo(transferSyntax).codec != Codec::unsupported;
                EXPECT_EQ(loaded.ok(), isDecoded) << "JPEG XL and video are named";
                if (!isDecoded) continue;
                ASSERT_TRUE(loaded) << loaded.error().message;
                for (const Json& probe : probes) expectProbe(opened, *loaded, probe, truth);
            }
        }
    }
    EXPECT_GE(images, 40u);
}

}  // namespace
}  // namespace macula::dicom::test
