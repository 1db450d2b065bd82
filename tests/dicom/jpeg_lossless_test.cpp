#include "dicom/jpeg_lossless.h"

#include <gtest/gtest.h>

#include "encapsulated.h"

namespace macula::dicom::test {
namespace {

constexpr int kColumns = 61;
constexpr int kRows = 47;
constexpr std::size_t kCells = std::size_t{kColumns} * kRows;

std::uint32_t random(std::uint32_t& state) {
    state = state * 1664525u + 1013904223u;
    return state >> 8;
}

JpegLosslessResult decode(const std::string& stream, std::vector<std::uint16_t>& cells) {
    cells.assign(kCells, 0xABCD);
    return decodeJpegLossless(std::as_bytes(std::span(stream)), kColumns, kRows, cells);
}

// Smooth images have short codes, noise has the longest there are, and half the range apart is a category of
// its own.
TEST(JpegLossless, givesBackWhatWasEncoded) {
    for (const int bits : {8, 12, 16}) {
        const std::uint32_t most = (1u << bits) - 1;
        std::uint32_t state = 1;
        for (const int kind : {0, 1, 2, 3, 4}) {
            SCOPED_TRACE(fmt::format("{} bits, image {}", bits, kind));
            std::vector<std::uint16_t> cells(kCells);
            for (std::size_t i = 0; i < kCells; ++i) {
                const std::uint32_t noise = random(state);
                const std::uint32_t value[] = {7, static_cast<std::uint32_t>(i * most / kCells), noise,
                                               i % 2 == 0 ? 0 : (most + 1) / 2,
                                               // Mostly flat: rare differences get long codes.
                                               noise % 97 == 0 ? noise / 97 : 5};
                cells[i] = static_cast<std::uint16_t>(value[kind] & most);
            }
            std::vector<std::uint16_t> decoded;
            ASSERT_EQ(decode(encode(kJpegLosslessFirstOrder, kColumns, kRows, bits, cells), decoded),
                      JpegLosslessResult::decoded);
            EXPECT_EQ(decoded, cells);
        }
    }
}

TEST(JpegLossless, leavesTheRestToTheGeneralDecoder) {
    const std::vector<std::uint16_t> cells(kCells, 9);
    std::vector<std::uint16_t> decoded;
    EXPECT_EQ(decode(encode(kJpegBaseline, kColumns, kRows, 8, cells), decoded),
              JpegLosslessResult::otherKind);
    std::string otherPredictor = encode(kJpegLossless, kColumns, kRows, 12, cells);
    otherPredictor[otherPredictor.find("\xFF\xDA") + 7] = 2;
    EXPECT_EQ(decode(otherPredictor, decoded), JpegLosslessResult::otherKind);
    EXPECT_EQ(decode(encode(kJpegLs, kColumns, kRows, 12, cells), decoded), JpegLosslessResult::otherKind);
}

TEST(JpegLossless, cutOffAnywhereIsDamage) {
    std::vector<std::uint16_t> cells(kCells);
    std::uint32_t state = 3;
    for (auto& cell : cells) cell = static_cast<std::uint16_t>(random(state) & 0xFFF);
    const std::string stream = encode(kJpegLosslessFirstOrder, kColumns, kRows, 12, cells);
    std::vector<std::uint16_t> decoded;
    for (std::size_t bytes = 0; bytes + 4 < stream.size(); bytes += 1 + bytes / 50)
        EXPECT_EQ(decode(stream.substr(0, bytes), decoded), JpegLosslessResult::damaged) << bytes;
}

// A sanitizer sees what this test does not.
TEST(JpegLossless, damagedAnywhereEndsWell) {
    std::vector<std::uint16_t> cells(kCells);
    std::uint32_t state = 4;
    for (auto& cell : cells) cell = static_cast<std::uint16_t>(random(state) % 977);
    const std::string stream = encode(kJpegLosslessFirstOrder, kColumns, kRows, 12, cells);
    std::vector<std::uint16_t> decoded;
    for (int round = 0; round < 5000; ++round) {
        std::string bytes = stream;
        // The headers most of all.
        const std::size_t reach = round % 2 == 0 ? 80 : bytes.size();
        for (int change = 0; change < 1 + round % 3; ++change)
            bytes[random(state) % reach] = static_cast<char>(random(state));
        (void)decode(bytes, decoded);
    }
}

}  // namespace
}  // namespace macula::dicom::test
