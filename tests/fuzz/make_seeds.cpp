// Writes the seeds of the fuzz targets: make_seeds tests/fuzz/corpus. They are in the repository; run this
// again only when there is something new to begin from.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/progress.h"
#include "dicom/bytes.h"
#include "dicom/encapsulated.h"
#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "dicom/write/series_writer.h"
#include "formats/volume_file.h"
#include "fuzz/seeds.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

void keep(const fs::path& from, const fs::path& to) {
    fs::create_directories(to.parent_path());
    fs::copy_file(from, to, fs::copy_options::overwrite_existing);
}

using fuzz::save;

SyntheticSeries smallSeries() {
    SyntheticSeries series;
    series.size = {5, 4, 3};
    return series;
}

void writeSyntaxes(const fs::path& corpus) {
    const std::pair<const char*, WriteSyntax> syntaxes[] = {{"explicit", WriteSyntax::explicitLittleEndian},
                                                            {"implicit", WriteSyntax::implicitLittleEndian},
                                                            {"big_endian", WriteSyntax::explicitBigEndian},
                                                            {"deflated", WriteSyntax::deflated},
                                                            {"rle", WriteSyntax::rle},
                                                            {"jpeg_lossless", WriteSyntax::jpegLossless},
                                                            {"jpeg_ls", WriteSyntax::jpegLs}};
    for (const auto& [name, syntax] : syntaxes) {
        const TemporaryFolder folder;
        keep(write(smallVolume(), folder.path(), {.syntax = syntax}).front(), corpus / "reader" / name);
    }
}

void writeCodecs(const fs::path& corpus) {
    std::vector<std::uint16_t> cells(8 * 6);
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = static_cast<std::uint16_t>(i * 5);
    const std::pair<const char*, const char*> codecs[] = {{"fragments_rle", kRle},
                                                          {"fragments_jpeg_baseline", kJpegBaseline},
                                                          {"fragments_jpeg_extended", kJpegExtended},
                                                          {"fragments_jpeg_lossless", kJpegLossless},
                                                          {"fragments_jpeg_ls", kJpegLs},
                                                          {"fragments_jpeg2000", kJpeg2000}};
    for (const auto& [name, uid] : codecs) {
        const int bits = uid == std::string(kJpegBaseline) ? 8 : 12;
        const PixelLayout layout{.transferSyntaxUid = uid,
                                 .columns = 8,
                                 .rows = 6,
                                 .frames = 2,
                                 .format = {bits > 8 ? 16 : 8, bits, bits - 1, false}};
        const std::string stream = encode(uid, 8, 6, bits, cells);
        const Fragments fragments = cut({stream, stream}, uid == std::string(kRle) ? 1 : 2);
        save(corpus / "reader" / name, preamble(uid) + sopClass() + imageHeader(layout) +
                                           encapsulated(fragments.fragments, basicOffsets(fragments)));
    }
}

void writeKinds(const fs::path& corpus) {
    const TemporaryFolder folder;
    const fs::path file = folder / "file";
    SyntheticSeries series = smallSeries();
    writeMultiFrame(file, series, slicesOf(series));
    keep(file, corpus / "reader" / "enhanced_ct");
    series.modality = "MR";
    series.phases = 2;
    series.size = {3, 2, 2};
    writeMultiFrame(file, series, slicesOf(series), {.sharedMeasures = false, .sharedOrientation = false});
    keep(file, corpus / "reader" / "enhanced_mr");
    series.modality = "PT";
    series.phases = 1;
    keep(writeFiles(folder / "pt", series).front(), corpus / "reader" / "pet");
    writeShell(file, {.sopClassUid = "1.2.840.10008.5.1.4.1.1.88.33", .modality = "SR"});
    keep(file, corpus / "reader" / "report");
    save(corpus / "reader" / "no_preamble", sopClass() + shortElement(tag::kPatientName, "PN", "A^B"));
    save(corpus / "reader" / "charset",
         preamble(kExplicit) + shortElement(tag::kSpecificCharacterSet, "CS", "\\ISO 2022 IR 87") +
             sopClass() + shortElement(tag::kPatientName, "PN", "Yamada^Tarou=\x1B$B;3ED\x1B(B^\x1B$BB@O:"));
    save(corpus / "reader" / "nested",
         preamble(kExplicit) + sopClass() +
             sequence({0x0008, 0x1140}, {sequence({0x0008, 0x1140}, {shortElement({8, 0x60}, "CS", "CT")})}));
}

std::string words(Tag tag, int value) {
    return shortElement(tag, "US", bytesOf(static_cast<std::uint64_t>(value), 2));
}

std::string texts(Tag tag, const char* vr, const std::string& value) {
    return shortElement(tag, vr, value);
}

// A small file with three frames of 4 x 4 pixels, 2 mm apart; `more` are elements after group 28.
struct Frames {
    std::string sopClass, modality;
    int bits = 16;
    std::string first = {};                          // elements before group 28
    std::string more = {};                           // and after (0028,0103)
    std::vector<std::string> macros = {"", "", ""};  // of each frame
    std::string pixels = longElement(tag::kPixelData, "OW", 96) + std::string(96, '\x15');
};

std::string bytesOfFrames(const Frames& f) {
    std::vector<std::string> frames;
    for (int i = 0; i < 3; ++i) {
        const std::string position = "1\\2\\" + std::to_string(3 + 2 * i);
        frames.push_back(sequence({0x0020, 0x9113}, {texts(tag::kImagePositionPatient, "DS", position)}) +
                         f.macros[static_cast<std::size_t>(i)]);
    }
    const std::string shared =
        sequence({0x0020, 0x9116}, {texts(tag::kImageOrientationPatient, "DS", "1\\0\\0\\0\\1\\0")}) +
        sequence({0x0028, 0x9110},
                 {texts({0x0018, 0x0088}, "DS", "2") + texts(tag::kPixelSpacing, "DS", "1\\1")});
    return preamble(kExplicit) + texts(tag::kSopClassUid, "UI", f.sopClass) +
           texts(tag::kModality, "CS", f.modality) + f.first + words(tag::kSamplesPerPixel, 1) +
           texts(tag::kPhotometricInterpretation, "CS", "MONOCHROME2") +
           texts(tag::kNumberOfFrames, "IS", "3") + words(tag::kRows, 4) + words(tag::kColumns, 4) +
           words(tag::kBitsAllocated, f.bits) + words(tag::kBitsStored, f.bits) +
           words(tag::kHighBit, f.bits - 1) + words(tag::kPixelRepresentation, 0) + f.more +
           sequence(tag::kSharedFunctionalGroups, {shared}) +
           sequence(tag::kPerFrameFunctionalGroups, frames) + f.pixels;
}

void writeObjects(const fs::path& corpus) {
    const auto record = [](const char* fileId) {
        return texts({4, 0x1430}, "CS", "IMAGE") + texts({4, 0x1500}, "CS", fileId);
    };
    save(corpus / "reader" / "directory",
         preamble(kExplicit) + texts(tag::kSopClassUid, "UI", "1.2.840.10008.1.3.10") +
             sequence(tag::kDirectoryRecords, {record("IMAGE"), record("..\\..\\ETC\\PASSWD")}));

    std::vector<std::string> segments;
    for (int i = 0; i < 3; ++i)
        segments.push_back(sequence({0x0062, 0x000A}, {words({0x0062, 0x000B}, 1 + i)}));
    save(corpus / "reader" / "segmentation",
         bytesOfFrames(
             {.sopClass = "1.2.840.10008.5.1.4.1.1.66.4",
              .modality = "SEG",
              .bits = 1,
              .first = sequence(tag::kReferencedSeries, {texts(tag::kSeriesInstanceUid, "UI", "2.25.9")}),
              .more = texts({0x0062, 0x0001}, "CS", "BINARY") +
                      sequence({0x0062, 0x0002}, {words({0x0062, 0x0004}, 1), words({0x0062, 0x0004}, 2)}),
              .macros = segments,
              .pixels = longElement(tag::kPixelData, "OB", 6) + "\x81\x42\x24\x18\x24\x42"}));
}

void writeValues(const fs::path& corpus) {
    const std::string mr = "1.2.840.10008.5.1.4.1.1.4.1";
    const auto rescale = [](const char* slope, const char* intercept) {
        return sequence({0x0028, 0x9145},
                        {texts({0x0028, 0x1052}, "DS", intercept) + texts({0x0028, 0x1053}, "DS", slope) +
                         texts({0x0028, 0x1054}, "LO", "US")});
    };
    save(corpus / "reader" / "slope_per_frame",
         bytesOfFrames({.sopClass = mr,
                        .modality = "MR",
                        .macros = {rescale("1.5", "0"), rescale("0.75", "3"), rescale("-0.333", "1")}}));
    save(corpus / "reader" / "modality_lut",
         bytesOfFrames({.sopClass = mr,
                        .modality = "MR",
                        .more = words({0x0028, 0x0120}, 7) +
                                sequence({0x0028, 0x3000},
                                         {shortElement({0x0028, 0x3002}, "US",
                                                       bytesOf(4, 2) + bytesOf(5400, 2) + bytesOf(16, 2)) +
                                          texts({0x0028, 0x3004}, "LO", "HU") +
                                          shortElement({0x0028, 0x3006}, "US", "aabbccdd")})}));
    save(corpus / "reader" / "wide",
         bytesOfFrames({.sopClass = mr,
                        .modality = "MR",
                        .bits = 32,
                        .pixels = longElement(tag::kPixelData, "OW", 192) + std::string(192, '\x15')}));
    std::string floats, doubles;
    for (int i = 0; i < 48; ++i) {
        floats += std::string("\0\0\x80", 3) + char(0x3E + i % 4);
        doubles += std::string("\0\0\0\0\0\0\xF0", 7) + char(0x3E + i % 4);
    }
    const std::string map = "1.2.840.10008.5.1.4.1.1.30";
    save(corpus / "reader" / "float",
         bytesOfFrames({.sopClass = map,
                        .modality = "MR",
                        .bits = 32,
                        .pixels = longElement({0x7FE0, 0x0008}, "OF", 192) + floats}));
    save(corpus / "reader" / "double",
         bytesOfFrames({.sopClass = map,
                        .modality = "MR",
                        .bits = 64,
                        .pixels = longElement({0x7FE0, 0x0009}, "OD", 384) + doubles}));
    const std::string drug = texts({0x0018, 0x1072}, "TM", "100000.5") +
                             texts({0x0018, 0x1074}, "DS", "3e8") + texts({0x0018, 0x1075}, "DS", "6588") +
                             texts({0x0018, 0x1078}, "DT", "20200102100000.5+0100");
    save(corpus / "reader" / "pet_suv",
         bytesOfFrames(
             {.sopClass = "1.2.840.10008.5.1.4.1.1.128",
              .modality = "PT",
              .first = texts({0x0008, 0x0021}, "DA", "20200102") + texts({0x0008, 0x0022}, "DA", "20200102") +
                       texts({0x0008, 0x0031}, "TM", "110000") + texts({0x0008, 0x0032}, "TM", "110001") +
                       texts({0x0010, 0x1030}, "DS", "70"),
              .more = texts({0x0028, 0x0051}, "CS", "ATTN\\DECY") + sequence({0x0054, 0x0016}, {drug}) +
                      texts({0x0054, 0x1001}, "CS", "BQML") + texts({0x0054, 0x1102}, "CS", "START") +
                      texts({0x0054, 0x1300}, "DS", "0")}));
}

void writeVolumeFiles(const fs::path& corpus) {
    const TemporaryFolder folder;
    Progress progress;
    for (const char* name : {"v.nii", "v.nii.gz"}) {
        ASSERT_TRUE(formats::writeVolumeFile(smallVolume(), folder / name, progress));
        keep(folder / name, corpus / "volume_file" / name);
    }
    const std::string values(2 * 3 * 4 * 2, '\7');
    const std::string nrrd =
        "NRRD0004\ntype: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 3 4\n"
        "space directions: (1,0,0) (0,2,0) (0,0,3)\nkinds: domain domain domain\nendian: little\n"
        "encoding: raw\nspace origin: (1,2,3)\n";
    save(corpus / "volume_file" / "nrrd", nrrd + "\n" + values);
    save(corpus / "volume_file" / "nrrd_detached", nrrd + "byte skip: 8\ndata file: volume.raw\n");
    const std::string meta =
        "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
        "CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 1 2 3\n"
        "ElementSpacing = 1 2 3\nDimSize = 2 3 4\nElementType = MET_SHORT\nElementDataFile = ";
    save(corpus / "volume_file" / "meta", meta + "LOCAL\n" + values);
    save(corpus / "volume_file" / "meta_detached", meta + "volume.raw\n");
}

// See fuzz_series.cpp for what the bytes are.
void writeSeriesSeeds(const fs::path& corpus) {
    const std::string head{"\0\0\0\0\2\0", 6};  // CT, straight, 1 mm, steps of 2.5 mm, no tilt
    const auto frame = [](int flags, int number, int place) {
        return std::string{char(flags), char(number), char(place)};
    };
    const auto grid = [&](int from, int to, int number) {
        std::string frames;
        for (int place = from; place < to; ++place) frames += frame(0, number++, place);
        return frames;
    };
    save(corpus / "series" / "volume", head + grid(0, 12, 1));
    save(corpus / "series" / "gap", head + grid(0, 6, 1) + grid(8, 14, 7));
    save(corpus / "series" / "blocks", head + grid(0, 6, 1) + grid(90, 96, 7));
    save(corpus / "series" / "phases", head + grid(0, 6, 1) + grid(0, 6, 7));
    save(corpus / "series" / "repetition", head + grid(0, 12, 1) + grid(5, 6, 20));
    std::string soft = "\1" + head.substr(1);
    for (int echo = 0; echo < 2; ++echo) {
        soft += std::string{char(16), char(14), char(echo + 2)} + frame(0, 1 + 6 * echo, 0).substr(1) +
                grid(1, 6, 2 + 6 * echo);
    }
    save(corpus / "series" / "echoes", soft);
    std::string turning = head;
    for (int i = 0; i < 6; ++i)
        turning += std::string{char(8), 0, char(i * 5), char(i)} + frame(0, i + 1, 0).substr(1);
    save(corpus / "series" / "rotation", turning);
    std::string copies = head + grid(0, 5, 1);
    for (int i = 0; i < 5; ++i) copies += std::string{char(128), char(i), char(i / 2 + 1), char(i)};
    save(corpus / "series" / "copies", copies);
    std::string frames = head + std::string{char(4), 7} + frame(0, 1, 0).substr(1);
    for (int i = 1; i < 6; ++i) frames += std::string{char(32), char(i)};
    save(corpus / "series" / "one_file", frames);
}

}  // namespace
}  // namespace macula::dicom::test

int main(int count, char** arguments) {
    using namespace macula::dicom::test;
    if (count != 2) return 2;
    testing::InitGoogleTest(&count, arguments);  // its assertions are used by what writes the files
    const std::filesystem::path corpus = arguments[1];
    writeSyntaxes(corpus);
    writeCodecs(corpus);
    writeKinds(corpus);
    writeObjects(corpus);
    writeValues(corpus);
    writeVolumeFiles(corpus);
    writeSeriesSeeds(corpus);
    macula::fuzz::writeArchiveSeeds(corpus);
    macula::fuzz::writeDatabaseSeeds(corpus);
    macula::fuzz::writePresetSeeds(corpus);
    macula::fuzz::writeStateSeeds(corpus);
    macula::fuzz::writeModelSeeds(corpus);
    return 0;
}
