// Files that say in which axes they are stored.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "base/paths.h"
#include "pipeline/splat/files/gzip.h"
#include "pipeline/splat/files/model_file.h"
#include "pipeline/splat/files/spz.h"
#include "splat/model_support.h"

namespace macula::splat {
namespace {

// By their number in the record: where x, y and z run to.
constexpr std::array<std::string_view, 17> kAxes{"RUB", "LDB", "RDB", "LUB", "RUB", "LDF",
                                                 "RDF", "LUF", "RUF", "LFD", "RFD", "LFU",
                                                 "RFU", "LBD", "RBD", "LBU", "RBU"};

// In the axes of a model: right, down, forward.
glm::dvec3 directionOf(char letter) {
    switch (letter) {
        case 'R':
            return {1, 0, 0};
        case 'L':
            return {-1, 0, 0};
        case 'D':
            return {0, 1, 0};
        case 'U':
            return {0, -1, 0};
        case 'F':
            return {0, 0, 1};
        default:
            return {0, 0, -1};
    }
}

std::vector<std::byte> recordOf(std::uint32_t axes) {
    std::vector<std::byte> record(12);
    const std::array<std::uint32_t, 3> words{0xadbe0003, 4, axes};
    std::memcpy(record.data(), words.data(), record.size());
    return record;
}

constexpr std::size_t kHeaderBytes = 16;
constexpr std::size_t kFlags = 14;
constexpr std::size_t kTable = 16;

std::vector<std::byte> withAxes(std::vector<std::byte> file, SpzVersion version, std::uint32_t axes) {
    const std::vector<std::byte> record = recordOf(axes);
    if (version == SpzVersion::zstd) {
        std::uint32_t table = 0;
        std::memcpy(&table, file.data() + kTable, sizeof table);
        file.insert(file.begin() + table, record.begin(), record.end());
        table += static_cast<std::uint32_t>(record.size());
        std::memcpy(file.data() + kTable, &table, sizeof table);
        file[kFlags] |= std::byte{2};
        return file;
    }
    Gunzip stream(file);
    std::vector<std::byte> data(kHeaderBytes);
    EXPECT_TRUE(stream.read(data));
    const auto body = stream.rest(1 << 20);
    EXPECT_TRUE(body.has_value());
    data.insert(data.end(), body->begin(), body->end());
    data.insert(data.end(), record.begin(), record.end());
    data[kFlags] |= std::byte{2};
    const auto packed = gzip(data, "");
    EXPECT_TRUE(packed.ok());
    return *packed;
}

Splats decoded(const std::vector<std::byte>& file) {
    const auto read = decodeSpz(file);
    EXPECT_TRUE(read.ok()) << read.error().message;
    return read->splats;
}

// The same numbers under each name: what is read is turned, or mirrored, as the letters say, with shapes and
// colours.
TEST(SpzAxes, EachIsHeeded) {
    for (int degree = 0; degree <= kMaxShDegree; ++degree) {
        Splats model = testing::randomModel(12, degree, 5);
        model.colourSpace = ColourSpace::display;
        model.originMm = glm::dvec3(0.0);
        const SpzVersion version = degree % 2 == 0 ? SpzVersion::gzip : SpzVersion::zstd;
        const auto file = encodeSpz(model, version);
        ASSERT_TRUE(file.ok());
        const Splats plain = decoded(withAxes(file->bytes, version, 0));
        for (std::uint32_t axes = 0; axes < kAxes.size(); ++axes) {
            SCOPED_TRACE(kAxes[axes]);
            const Splats turned = decoded(withAxes(file->bytes, version, axes));
            ASSERT_EQ(turned.size(), plain.size());
            glm::dmat3 turnedFromFile(0.0);
            for (int a = 0; a < 3; ++a)
                turnedFromFile[a] = directionOf(kAxes[axes][static_cast<std::size_t>(a)]);
            const glm::dmat3 fileFromPlain(glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1));
            const glm::dmat3 turn = turnedFromFile * fileFromPlain;
            for (std::size_t i = 0; i < plain.size(); ++i) {
                EXPECT_EQ(turned.position[i], glm::vec3(turn * glm::dvec3(plain.position[i])));
                for (const glm::dvec3& d :
                     {glm::dvec3(1, 0, 0), glm::dvec3(0, 0.6, -0.8), glm::dvec3(0.48, 0.64, 0.6)}) {
                    const double before = glm::dot(d, testing::covariance(plain, i) * d);
                    const glm::dvec3 there = turn * d;
                    EXPECT_NEAR(glm::dot(there, testing::covariance(turned, i) * there), before,
                                1e-4 * before + 1e-3);
                    const glm::dvec3 difference =
                        testing::colourAlong(turned, i, there) - testing::colourAlong(plain, i, d);
                    EXPECT_LT(glm::length(difference), 1e-5);
                }
            }
        }
    }
}

TEST(SpzAxes, OthersAreRefusedInWords) {
    const auto file = encodeSpz(testing::randomModel(3, 0, 5), SpzVersion::zstd);
    ASSERT_TRUE(file.ok());
    for (const std::uint32_t axes : {17u, 0xffffffffu}) {
        const auto read = decodeSpz(withAxes(file->bytes, SpzVersion::zstd, axes));
        ASSERT_FALSE(read.ok());
        EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
        EXPECT_NE(read.error().message.english().find("axes"), std::string::npos) << read.error().message;
    }
}

// Files of another program, and the PLY that they were made of.
TEST(SpzAxes, FilesOfAnotherProgramAreWhatTheyWereMadeOf) {
    const std::filesystem::path folder = macula::test::sharedFolder() / "data/failures/other/spz";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "shared data is not here";
    const auto truth = readModel(folder / "p-ref.ply");
    ASSERT_TRUE(truth.ok()) << truth.error().message;
    const Splats& expected = truth->splats;
    for (const char* name : {"s-v4.spz", "s-v4-ext-rdf.spz", "s-v4-ext-ruf.spz", "s-v3-ext-rdf.spz"}) {
        SCOPED_TRACE(name);
        const auto read = readModel(folder / name);
        ASSERT_TRUE(read.ok()) << read.error().message;
        const Splats& s = read->splats;
        ASSERT_EQ(s.size(), expected.size());
        for (std::size_t i = 0; i < s.size(); ++i) {
            EXPECT_LT(glm::length(s.position[i] - expected.position[i]), 3e-4f) << i;
            const glm::dmat3 a = testing::covariance(s, i);
            const glm::dmat3 b = testing::covariance(expected, i);
            for (int c = 0; c < 3; ++c)
                EXPECT_LT(glm::length(a[c] - b[c]),
                          0.1 * std::sqrt(glm::dot(b[0], b[0]) + glm::dot(b[1], b[1]) + glm::dot(b[2], b[2])))
                    << i;
        }
    }
}

}  // namespace
}  // namespace macula::splat
