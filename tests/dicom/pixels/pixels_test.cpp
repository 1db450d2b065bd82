#include "dicom/pixels/pixels.h"
#include "dicom/pixels/decoders.h"

#include <fstream>

#include "base/atomic_file.h"
#include "bytes.h"
#include "dicom/read/dataset.h"
#include "encapsulated.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

constexpr int kColumns = 37;  // odd, as is the number of rows: frames of an odd number of cells
constexpr int kRows = 23;
constexpr std::size_t kCells = kColumns * kRows;
constexpr CellFormat kTwelveBits{16, 12, 11, false};
constexpr CellFormat kEightBits{8, 8, 7, false};

PixelLayout layoutOf(const std::string& uid, int frames = 1, CellFormat format = kTwelveBits) {
    return {.transferSyntaxUid = uid, .columns = kColumns, .rows = kRows, .frames = frames, .format = format};
}

// Smooth, and different in every frame; covers all bits.
std::vector<std::uint16_t> cellsOf(int frame, int bits = 12) {
    std::vector<std::uint16_t> cells(kCells);
    const unsigned most = (1u << bits) - 1;
    for (std::size_t i = 0; i < kCells; ++i)
        cells[i] = static_cast<std::uint16_t>((i * most / kCells + 7u * static_cast<unsigned>(frame)) & most);
    cells[5] = static_cast<std::uint16_t>(most);
    cells[kCells - 1] = static_cast<std::uint16_t>(static_cast<unsigned>(frame) & most);
    return cells;
}

fs::path save(const TemporaryFolder& folder, const std::string& bytes) {
    const fs::path file = folder / "image";
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
}

Result<std::vector<std::uint16_t>> readFrame(PixelReader& reader, int frame) {
    std::vector<std::uint16_t> cells(kCells, 0xABCD);
    if (auto read = reader.read(frame, cells); !read) return read.error();
    return cells;
}

// Backwards, so that no frame leans on the one before.
void expectFrames(const fs::path& file, const PixelLayout& layout, int bits = 12) {
    auto reader = PixelReader::open(file, layout);
    ASSERT_TRUE(reader) << reader.error().message;
    for (int frame = layout.frames - 1; frame >= 0; --frame) {
        EXPECT_FALSE(reader->isCutOff(frame));
        const auto cells = readFrame(*reader, frame);
        ASSERT_TRUE(cells) << frame << ": " << cells.error().message;
        EXPECT_EQ(*cells, cellsOf(frame, bits)) << frame;
    }
}

std::string words(const std::vector<std::uint16_t>& cells) {
    std::string bytes;
    for (const std::uint16_t cell : cells) bytes += bytesOf(cell, 2);
    return bytes;
}

std::string native(const std::string& pixels, const char* vr = "OW") {
    return longElement(tag::kPixelData, vr, static_cast<std::uint32_t>(pixels.size() + pixels.size() % 2)) +
           pixels + std::string(pixels.size() % 2, '\0');
}

// The frames, one stream each.
std::vector<std::string> streams(const char* uid, int frames, int bits = 12) {
    std::vector<std::string> result;
    for (int frame = 0; frame < frames; ++frame)
        result.push_back(encode(uid, kColumns, kRows, bits, cellsOf(frame, bits)));
    return result;
}

constexpr std::array kLossless{kRle, kJpegLossless, kJpegLosslessFirstOrder, kJpegLs, kJpeg2000};

TEST(Pixels, NativeFrames) {
    const TemporaryFolder folder;
    const std::string pixels = words(cellsOf(0)) + words(cellsOf(1)) + words(cellsOf(2));
    expectFrames(save(folder, imageHeader(layoutOf(kExplicit, 3)) + native(pixels)), layoutOf(kExplicit, 3));
}

TEST(Pixels, DeflatedFrames) {
    const TemporaryFolder folder;
    const PixelLayout layout = layoutOf(kDeflated, 3);
    const std::string header = imageHeader(layout);
    const std::size_t dataset = preamble(kDeflated).size();
    const std::string pixels = words(cellsOf(0)) + words(cellsOf(1)) + words(cellsOf(2));
    expectFrames(save(folder, header.substr(0, dataset) + deflated(header.substr(dataset) + native(pixels))),
                 layout);
}

// Of 8 bits: one byte after the other, where the VR is OB; pairs are swapped where it is OW.
TEST(Pixels, BigEndian) {
    const char* const uid = "1.2.840.10008.1.2.2";
    const auto swapped = [](std::string bytes) {
        for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) std::swap(bytes[i], bytes[i + 1]);
        return bytes;
    };
    // Tag, VR and lengths of explicit elements of group 8 and 28, turned around.
    const auto element = [](Tag tag, const std::string& vr, const std::string& value) {
        const auto number = [](std::uint64_t v, int count) {
            std::string bytes = bytesOf(v, count);
            std::reverse(bytes.begin(), bytes.end());
            return bytes;
        };
        const bool isLong = vr == "OB" || vr == "OW";
        return number(tag.group, 2) + number(tag.element, 2) + vr +
               (isLong ? std::string(2, '\0') : std::string()) + number(value.size(), isLong ? 4 : 2) + value;
    };
    const auto file = [&](const CellFormat& format, const std::string& vr, const std::string& pixels) {
        const auto word = [&](Tag tag, int value) {
            return element(tag, "US", swapped(bytesOf(static_cast<std::uint64_t>(value), 2)));
        };
        return preamble(uid) + element(tag::kNumberOfFrames, "IS", "3 ") + word(tag::kRows, kRows) +
               word(tag::kColumns, kColumns) + word(tag::kBitsAllocated, format.bitsAllocated) +
               element(tag::kPixelData, vr, pixels);
    };
    const TemporaryFolder folder;
    expectFrames(save(folder, file(kTwelveBits, "OW",
                                   swapped(words(cellsOf(0)) + words(cellsOf(1)) + words(cellsOf(2))))),
                 layoutOf(uid, 3));
    std::string bytes;
    for (int frame = 0; frame < 3; ++frame) {
        for (const std::uint16_t cell : cellsOf(frame, 8)) bytes += static_cast<char>(cell);
    }
    bytes += '\0';
    expectFrames(save(folder, file(kEightBits, "OB", bytes)), layoutOf(uid, 3, kEightBits), 8);
    expectFrames(save(folder, file(kEightBits, "OW", swapped(bytes))), layoutOf(uid, 3, kEightBits), 8);
}

TEST(Pixels, SingleBitsRunOnFromFrameToFrame) {
    const CellFormat oneBit{1, 1, 0, false};
    std::string bits((3 * kCells + 7) / 8, '\0');
    std::size_t at = 0;
    for (int frame = 0; frame < 3; ++frame) {
        for (const std::uint16_t cell : cellsOf(frame, 1)) {
            bits[at / 8] = static_cast<char>(bits[at / 8] | cell << (at % 8));
            ++at;
        }
    }
    const TemporaryFolder folder;
    const PixelLayout layout = layoutOf(kExplicit, 3, oneBit);
    expectFrames(save(folder, imageHeader(layout) + native(bits, "OB")), layout, 1);
}

TEST(Pixels, WideIntegersKeepTheirSign) {
    std::string pixels;
    for (std::size_t i = 0; i < kCells; ++i) pixels += bytesOf(0xFFFFFFFF - i, 4);
    const TemporaryFolder folder;
    for (const auto& [format, first] : {std::pair(CellFormat{32, 32, 31, true}, -1.0),
                                        std::pair(CellFormat{32, 32, 31, false}, 4294967295.0),
                                        std::pair(CellFormat{32, 20, 19, false}, 1048575.0),
                                        std::pair(CellFormat{32, 20, 31, false}, 1048575.0)}) {
        const PixelLayout layout = layoutOf(kExplicit, 1, format);
        auto reader = PixelReader::open(save(folder, imageHeader(layout) + native(pixels)), layout);
        ASSERT_TRUE(reader);
        std::vector<double> numbers(kCells);
        ASSERT_TRUE(reader->readNumbers(0, numbers));
        EXPECT_EQ(numbers[0], first);
        EXPECT_EQ(numbers[1], format.highBit == 31 && format.bitsStored == 20 ? first : first - 1.0);
    }
}

TEST(Pixels, FloatingPoint) {
    const TemporaryFolder folder;
    std::vector<double> numbers(kCells);
    const auto bytesOfDouble = [](auto value) {
        return std::string(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    std::string floats;
    std::string doubles;
    for (int frame = 0; frame < 2; ++frame) {
        for (std::size_t i = 0; i < kCells; ++i) {
            floats += bytesOfDouble(static_cast<float>(i) * 0.1F - static_cast<float>(frame));
            doubles += bytesOfDouble(double(i) * 1e300 - frame);
        }
    }
    const auto check = [&](CellKind kind, Tag tag, const char* vr, const std::string& pixels, double second,
                           double third) {
        const PixelLayout layout = layoutOf(kExplicit, 2, floatFormat(kind));
        const auto bytes = static_cast<std::uint32_t>(pixels.size());
        const fs::path file = save(folder, imageHeader(layout) + longElement(tag, vr, bytes) + pixels);
        auto reader = PixelReader::open(file, layout);
        ASSERT_TRUE(reader) << reader.error().message;
        ASSERT_TRUE(reader->readNumbers(1, numbers));
        EXPECT_EQ(numbers[0], -1.0);
        EXPECT_EQ(numbers[1], second);
        ASSERT_TRUE(reader->readNumbers(0, numbers));
        EXPECT_EQ(numbers[2], third);
        // And where the header says whole numbers, the element does not fit.
        EXPECT_FALSE(PixelReader::open(file, layoutOf(kExplicit, 2, {32, 16, 15, false})));
    };
    check(CellKind::float32, {0x7FE0, 0x0008}, "OF", floats, double{1 * 0.1F - 1.0F}, double{2 * 0.1F});
    check(CellKind::float64, {0x7FE0, 0x0009}, "OD", doubles, 1e300, 2e300);
}

TEST(Pixels, NarrowCellsAsNumbers) {
    const TemporaryFolder folder;
    const CellFormat format{16, 12, 11, true};
    const PixelLayout layout = layoutOf(kExplicit, 1, format);
    std::vector<std::uint16_t> cells(kCells, 0x0FFF);
    auto reader = PixelReader::open(save(folder, imageHeader(layout) + native(words(cells))), layout);
    ASSERT_TRUE(reader);
    std::vector<double> numbers(kCells);
    ASSERT_TRUE(reader->readNumbers(0, numbers));
    EXPECT_EQ(numbers[7], -1.0);
}

TEST(Pixels, OneFragmentPerFrame) {
    const TemporaryFolder folder;
    for (const char* uid : kLossless) {
        SCOPED_TRACE(uid);
        const Fragments parts = cut(streams(uid, 3), 1);
        const PixelLayout layout = layoutOf(uid, 3);
        expectFrames(save(folder, imageHeader(layout) + encapsulated(parts.fragments)), layout);
        expectFrames(save(folder, imageHeader(layout) + encapsulated(parts.fragments, basicOffsets(parts))),
                     layout);
    }
}

// Encapsulated Uncompressed Explicit VR Little Endian: PS3.5 A.4.11. Frames of 8 bits are of an odd length
// here, and padded.
TEST(Pixels, EncapsulatedWithoutCompression) {
    const TemporaryFolder folder;
    for (const int bits : {8, 12}) {
        SCOPED_TRACE(bits);
        std::vector<std::string> frames;
        for (int frame = 0; frame < 3; ++frame) {
            std::string& bytes = frames.emplace_back();
            for (const std::uint16_t cell : cellsOf(frame, bits)) bytes += bytesOf(cell, bits > 8 ? 2 : 1);
        }
        const PixelLayout layout = layoutOf("1.2.840.10008.1.2.1.98", 3, bits > 8 ? kTwelveBits : kEightBits);
        expectFrames(save(folder, imageHeader(layout) + encapsulated(cut(frames, 1).fragments)), layout,
                     bits);
    }
}

TEST(Pixels, SeveralFragmentsPerFrameByTheBasicOffsetTable) {
    const TemporaryFolder folder;
    for (const char* uid : kLossless) {
        SCOPED_TRACE(uid);
        const Fragments parts = cut(streams(uid, 3), 4);
        const PixelLayout layout = layoutOf(uid, 3);
        expectFrames(save(folder, imageHeader(layout) + encapsulated(parts.fragments, basicOffsets(parts))),
                     layout);
    }
}

TEST(Pixels, SeveralFragmentsPerFrameByTheExtendedOffsetTable) {
    const TemporaryFolder folder;
    for (const char* uid : kLossless) {
        SCOPED_TRACE(uid);
        const Fragments parts = cut(streams(uid, 3), 4);
        std::string table;
        for (const std::uint64_t offset : parts.offsets) table += bytesOf(offset, 8);
        const PixelLayout layout = layoutOf(uid, 3);
        expectFrames(
            save(folder, imageHeader(layout) +
                             longElement({0x7FE0, 0x0001}, "OV", static_cast<std::uint32_t>(table.size())) +
                             table + encapsulated(parts.fragments)),
            layout);
    }
}

TEST(Pixels, SeveralFragmentsPerFrameByMarkers) {
    const TemporaryFolder folder;
    for (const char* uid : {kJpegLossless, kJpegLosslessFirstOrder, kJpegLs, kJpeg2000}) {
        SCOPED_TRACE(uid);
        const Fragments parts = cut(streams(uid, 3), 4);
        const PixelLayout layout = layoutOf(uid, 3);
        expectFrames(save(folder, imageHeader(layout) + encapsulated(parts.fragments)), layout);
        // A table that is wrong is no better than none.
        std::string wrong = basicOffsets(parts);
        wrong[4] = static_cast<char>(wrong[4] + 2);
        expectFrames(save(folder, imageHeader(layout) + encapsulated(parts.fragments, wrong)), layout);
    }
}

TEST(Pixels, AllFramesInOneFragment) {
    const TemporaryFolder folder;
    for (const char* uid : {kJpegLosslessFirstOrder, kJpegLs, kJpeg2000}) {
        SCOPED_TRACE(uid);
        std::string all;
        for (const std::string& fragment : cut(streams(uid, 3), 1).fragments) all += fragment;
        const PixelLayout layout = layoutOf(uid, 3);
        expectFrames(save(folder, imageHeader(layout) + encapsulated({all})), layout);
    }
}

TEST(Pixels, OneFrameInManyFragments) {
    const TemporaryFolder folder;
    for (const char* uid : kLossless) {
        SCOPED_TRACE(uid);
        const Fragments parts = cut(streams(uid, 1), 7);
        expectFrames(save(folder, imageHeader(layoutOf(uid)) + encapsulated(parts.fragments)), layoutOf(uid));
    }
}

TEST(Pixels, FramesThatCannotBeToldApart) {
    const TemporaryFolder folder;
    const Fragments parts = cut(streams(kRle, 3), 2);
    const PixelLayout layout = layoutOf(kRle, 3);
    EXPECT_FALSE(
        PixelReader::open(save(folder, imageHeader(layout) + encapsulated(parts.fragments)), layout));
}

TEST(Pixels, EightBitsInEverySyntax) {
    const TemporaryFolder folder;
    for (const char* uid : kLossless) {
        for (const CellFormat& format : {kEightBits, CellFormat{16, 8, 7, false}}) {
            SCOPED_TRACE(uid);
            const Fragments parts = cut(streams(uid, 2, 8), 1);
            const PixelLayout layout = layoutOf(uid, 2, format);
            expectFrames(save(folder, imageHeader(layout) + encapsulated(parts.fragments)), layout, 8);
        }
    }
}

TEST(Pixels, SixteenBitsInEverySyntax) {
    const TemporaryFolder folder;
    for (const char* uid : kLossless) {
        SCOPED_TRACE(uid);
        const PixelLayout layout = layoutOf(uid, 2, {16, 16, 15, true});
        const Fragments parts = cut(streams(uid, 2, 16), 1);
        expectFrames(save(folder, imageHeader(layout) + encapsulated(parts.fragments)), layout, 16);
    }
}

TEST(Pixels, LossyJpegIsCloseToTheImage) {
    const TemporaryFolder folder;
    for (const auto& [uid, bits] : {std::pair(kJpegBaseline, 8), std::pair(kJpegExtended, 12)}) {
        const PixelLayout layout = layoutOf(uid, 1, bits == 8 ? kEightBits : kTwelveBits);
        std::vector<std::uint16_t> smooth(kCells);
        const unsigned most = (1u << bits) - 1;
        for (std::size_t i = 0; i < kCells; ++i) smooth[i] = static_cast<std::uint16_t>(i * most / kCells);
        const std::string stream = encode(uid, kColumns, kRows, bits, smooth);
        auto reader = PixelReader::open(
            save(folder, imageHeader(layout) + encapsulated(cut({stream}, 1).fragments)), layout);
        ASSERT_TRUE(reader);
        const auto cells = readFrame(*reader, 0);
        ASSERT_TRUE(cells) << cells.error().message;
        for (std::size_t i = 0; i < kCells; ++i) ASSERT_NEAR((*cells)[i], smooth[i], most / 30.0) << i;
    }
}

TEST(Pixels, NativeInSpiteOfACompressedName) {
    const TemporaryFolder folder;
    const PixelLayout layout = layoutOf(kJpegLs, 2);
    const std::string pixels = words(cellsOf(0)) + words(cellsOf(1));
    expectFrames(save(folder, imageHeader(layout) + native(pixels)), layout);
    EXPECT_FALSE(PixelReader::open(save(folder, imageHeader(layout) + native(pixels.substr(4))), layout));
}

// Those before are read, and those after said to be cut off; wherever the file ends, nothing else happens.
TEST(Pixels, CutOffAnywhere) {
    const TemporaryFolder folder;
    constexpr int kFrames = 3;
    std::vector<std::pair<PixelLayout, std::string>> files;
    const std::string pixels = words(cellsOf(0)) + words(cellsOf(1)) + words(cellsOf(2));
    files.emplace_back(layoutOf(kExplicit, kFrames),
                       imageHeader(layoutOf(kExplicit, kFrames)) + native(pixels));
    for (const char* uid : {kRle, kJpegLosslessFirstOrder, kJpeg2000}) {
        for (const bool withTable : {true, false}) {
            const Fragments parts = cut(streams(uid, kFrames), withTable ? 2 : 1);
            files.emplace_back(layoutOf(uid, kFrames),
                               imageHeader(layoutOf(uid, kFrames)) +
                                   encapsulated(parts.fragments, withTable ? basicOffsets(parts) : ""));
        }
    }
    for (const auto& [layout, whole] : files) {
        SCOPED_TRACE(layout.transferSyntaxUid);
        int mostFrames = 0;
        const std::size_t headerBytes = imageHeader(layout).size();
        for (std::size_t bytes = headerBytes; bytes < whole.size();
             bytes += 1 + (whole.size() - headerBytes) / 67) {
            auto reader = PixelReader::open(save(folder, whole.substr(0, bytes)), layout);
            if (!reader) continue;
            int good = 0;
            for (int frame = 0; frame < kFrames; ++frame) {
                const bool cutOff = reader->isCutOff(frame);
                const auto cells = readFrame(*reader, frame);
                ASSERT_EQ(cells.ok(), !cutOff) << frame << " of " << bytes << " bytes of " << whole.size();
                if (cutOff) continue;
                ASSERT_EQ(good, frame);  // none before is missing
                ASSERT_EQ(*cells, cellsOf(frame)) << frame;
                ++good;
            }
            mostFrames = std::max(mostFrames, good);
        }
        EXPECT_GE(mostFrames, kFrames - 1);
    }
}

// Whatever bytes of its first frame are damaged: the second one is read as it is, nothing is written beyond
// the cells that were asked for, and what cannot be decoded is said. A sanitizer sees what is read beyond.
TEST(Pixels, DamagedAnywhere) {
    const TemporaryFolder folder;
    std::uint32_t state = 12345;
    const auto random = [&] { return state = state * 1664525u + 1013904223u, state >> 8; };
    for (const char* uid : kLossless) {
        SCOPED_TRACE(uid);
        const Fragments parts = cut(streams(uid, 2), 3);
        const PixelLayout layout = layoutOf(uid, 2);
        const std::string header = imageHeader(layout);
        const std::string whole = header + encapsulated(parts.fragments, basicOffsets(parts));
        int refused = 0;
        for (int round = 0; round < 300; ++round) {
            std::string bytes = whole;
            for (int change = 0; change < 1 + round % 4; ++change) {
                const std::string& fragment = parts.fragments[random() % 3];
                bytes[whole.find(fragment) + random() % fragment.size()] = static_cast<char>(random());
            }
            auto reader = PixelReader::open(save(folder, bytes), layout);
            if (!reader) {  // the damage made it a stream of another kind
                EXPECT_NE(reader.error().message.english().find("has changed"), std::string::npos)
                    << reader.error().message;
                ++refused;
                continue;
            }
            std::vector<std::uint16_t> cells(kCells + 16, 0xABCD);
            const auto read = reader->read(0, std::span(cells).first(kCells));
            refused += read.ok() ? 0 : 1;
            if (!read) {
                EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
                EXPECT_FALSE(read.error().message.empty());
            }
            for (std::size_t i = kCells; i < cells.size(); ++i) ASSERT_EQ(cells[i], 0xABCD) << round;
            const auto second = readFrame(*reader, 1);
            ASSERT_TRUE(second) << round << ": " << second.error().message;
            ASSERT_EQ(*second, cellsOf(1)) << round;
        }
        EXPECT_GT(refused, 20);  // the damage does damage
    }
}

// Of the items and of the table of offsets: what is read all the same is what was written.
TEST(Pixels, DamagedBetweenTheFrames) {
    const TemporaryFolder folder;
    std::uint32_t state = 54321;
    const auto random = [&] { return state = state * 1664525u + 1013904223u, state >> 8; };
    for (const char* uid : kLossless) {
        SCOPED_TRACE(uid);
        const Fragments parts = cut(streams(uid, 2), 3);
        const PixelLayout layout = layoutOf(uid, 2);
        const std::string header = imageHeader(layout);
        const std::string whole = header + encapsulated(parts.fragments, basicOffsets(parts));
        std::vector<std::size_t> between;  // bytes that are of no fragment
        std::size_t at = header.size();
        for (const std::string& fragment : parts.fragments) {
            const std::size_t begin = whole.find(fragment, at);
            for (; at < begin; ++at) between.push_back(at);
            at += fragment.size();
        }
        int refused = 0;
        for (int round = 0; round < 300; ++round) {
            std::string bytes = whole;
            bytes[between[random() % between.size()]] ^= static_cast<char>(1 + random() % 255);
            auto reader = PixelReader::open(save(folder, bytes), layout);
            for (const int frame : {0, 1}) {
                const auto cells =
                    reader ? readFrame(*reader, frame) : Result<std::vector<std::uint16_t>>(reader.error());
                refused += cells ? 0 : 1;
                if (cells) {
                    ASSERT_EQ(*cells, cellsOf(frame)) << round;
                }
            }
        }
        EXPECT_GT(refused, 200);
        EXPECT_LT(refused, 550);
    }
}

TEST(Pixels, FileThatChangedSinceTheScan) {
    const TemporaryFolder folder;
    const PixelLayout layout = layoutOf(kExplicit);
    const std::string pixels = native(words(cellsOf(0)));
    const auto open = [&](const PixelLayout& written) {
        return PixelReader::open(save(folder, imageHeader(written) + pixels), layout);
    };
    EXPECT_TRUE(open(layout));
    PixelLayout other = layout;
    other.rows = kRows - 1;
    EXPECT_FALSE(open(other));
    other = layout;
    other.format.bitsAllocated = 8;
    EXPECT_FALSE(open(other));
    other = layout;
    other.transferSyntaxUid = kImplicit;
    EXPECT_FALSE(open(other));
    const auto gone = PixelReader::open(folder / "nowhere", layout);
    ASSERT_FALSE(gone);
    EXPECT_EQ(gone.error().where, (folder / "nowhere").string());
    EXPECT_FALSE(PixelReader::open(folder.path(), layout));
    EXPECT_FALSE(PixelReader::open(save(folder, imageHeader(layout)), layout));
}

TEST(Pixels, ClaimsOfTheHeaderCostNothing) {
    const TemporaryFolder folder;
    for (const char* uid : {kExplicit, kRle, kJpegLs}) {
        PixelLayout layout = layoutOf(uid, 2'000'000'000, {16, 16, 15, false});
        layout.columns = layout.rows = 65535;
        auto reader =
            PixelReader::open(save(folder, imageHeader(layout) + encapsulated({"ab", "cd"})), layout);
        EXPECT_TRUE(!reader || reader->isCutOff(1'999'999'999));
        reader = PixelReader::open(save(folder, imageHeader(layout) + native("abcd")), layout);
        EXPECT_TRUE(!reader || reader->isCutOff(1'999'999'999));
    }
}

// A decoder that fills a lost tile with zeros shows a hole in the patient.
TEST(Jpeg2000, AMissingTileIsNoImage) {
    constexpr int kSize = 64;
    std::vector<std::uint16_t> cells(kSize * kSize);
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = static_cast<std::uint16_t>(1000 + i % 997);
    const std::string whole = encodeJpeg2000(kSize, kSize, 12, cells, 32);
    std::vector<std::uint16_t> read(cells.size());
    const auto decode = [&](const std::string& stream) {
        return decodeJpeg2000(std::as_bytes(std::span(stream)), kSize, kSize, read).ok();
    };
    ASSERT_TRUE(decode(whole));
    EXPECT_EQ(read, cells);
    // Each tile-part begins with FF90, its length of 10, the tile, and how long it is.
    std::vector<std::size_t> parts;
    for (std::size_t at = whole.find("\xFF\x90");
         at != std::string::npos && whole.substr(at, 2) == "\xFF\x90";) {
        parts.push_back(at);
        std::size_t bytes = 0;
        for (std::size_t i = 6; i < 10; ++i) bytes = bytes << 8 | static_cast<unsigned char>(whole[at + i]);
        at += bytes;
    }
    ASSERT_EQ(parts.size(), 4u);
    for (std::size_t tile = 0; tile < parts.size(); ++tile) {
        const std::size_t end = tile + 1 < parts.size() ? parts[tile + 1] : whole.size() - 2;
        std::string without = whole;
        without.erase(parts[tile], end - parts[tile]);
        EXPECT_FALSE(decode(without)) << tile;
    }
    // A million tiles that are only announced.
    std::string announced = whole;
    announced.replace(24, 8, std::string("\0\0\0\1\0\0\0\1", 8));
    EXPECT_FALSE(decode(announced));
}

}  // namespace
}  // namespace macula::dicom::test
