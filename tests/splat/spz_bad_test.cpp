// SPZ files that are none, damaged, or made to harm.
#include <gtest/gtest.h>

#include <ctime>

#include "pipeline/splat/gzip.h"
#include "pipeline/splat/spz.h"
#include "splat/model_support.h"

namespace macula::splat {
namespace {

std::vector<std::byte> asBytes(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

std::string asText(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Result<ModelFile> parse(const std::string& bytes) {
    return decodeSpz(asBytes(bytes));
}

std::string packed(const std::string& data, const std::string& comment = {}) {
    return asText(*gzip(std::as_bytes(std::span(data)), comment));
}

std::string header(std::uint32_t version, std::uint32_t count, int degree = 0, int bits = 12, int flags = 0) {
    std::string text = "NGSP";
    for (const std::uint32_t value : {version, count}) {
        for (int k = 0; k < 4; ++k) text.push_back(static_cast<char>(value >> (8 * k)));
    }
    for (const int value : {degree, bits, flags, 0}) text.push_back(static_cast<char>(value));
    return text;
}

// The rows of a model, unpacked: version 3, of `count` splats.
std::string body(std::size_t count) {
    return std::string(20 * count, 'a');
}

std::string model(std::size_t count, int degree) {
    const auto file = encodeSpz(testing::randomModel(count, degree, 31));
    EXPECT_TRUE(file.ok());
    return asText(file->bytes);
}

struct Case {
    std::string bytes;
    std::string says;
};

TEST(SpzBad, EachSaysWhatIsWrong) {
    ASSERT_TRUE(parse(packed(header(3, 2) + body(2))).ok());
    const std::vector<Case> cases{
        {"", "cut off"},
        {"NGSP", "version 4"},
        {header(4, 1) + body(1), "version 4"},
        {"no gzip at all", "damaged"},
        {packed(""), "damaged"},
        {packed("NGSP"), "damaged"},
        {packed("a letter to somebody, long enough to be a header"), "no SPZ"},
        {packed(header(0, 1) + body(1)), "version 0"},
        {packed(header(4, 1) + body(1)), "version 4"},
        {packed(header(0xffffffff, 1) + body(1)), "version 4294967295"},
        {packed(header(3, 0)), "no splats"},
        {packed(header(3, 1, 4) + body(10)), "degree 4"},
        {packed(header(3, 1, 255) + body(10)), "degree 255"},
        {packed(header(3, 1, 0, 32) + body(1)), "damaged"},
        {packed(header(3, 2) + body(1)), "damaged"},
        {packed(header(3, 1) + body(2)), "damaged"},
        {packed(header(3, 4000000000u) + body(1)), "4000000000 splats"},
        {packed(header(3, 9999999u) + body(1)), "damaged"},
        {packed(header(3, 1) + body(1), "macula model 9"), "version"},
        {packed(header(3, 1) + body(1), "macula model 1\nmacula axes sideways"), "axes"},
        {packed(header(1, 1, 0) + std::string("\0\x7e\0\0\0\0", 6) + std::string(10, 'a')),
         "1 of the 1"},  // NaN
    };
    for (const Case& c : cases) {
        const auto read = parse(c.bytes);
        ASSERT_FALSE(read.ok()) << c.says;
        EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
        EXPECT_NE(read.error().message.find(c.says), std::string::npos)
            << read.error().message << "\nfor " << c.says;
        EXPECT_FALSE(read.error().hint.empty());
    }
}

TEST(SpzBad, ExtensionsAreSkipped) {
    EXPECT_TRUE(parse(packed(header(3, 1, 0, 12, 2) + body(1) + "an extension")).ok());
    // Longer than any: 17 MiB of them.
    EXPECT_FALSE(parse(packed(header(3, 1, 0, 12, 2) + body(1) + std::string(17 << 20, 'x'))).ok());
}

TEST(SpzBad, CommentsOfOthersAreLeftAlone) {
    const auto read = parse(packed(header(3, 1) + body(1), std::string(10000, 'c') + "\nmacula model 9"));
    ASSERT_TRUE(read.ok());  // cut off at 4 KiB
    EXPECT_EQ(read->splats.axes, Axes::unknown);
}

// 64 MiB of zeros in 64 KiB behind the header of one splat: it stops after the first 4 KiB.
TEST(SpzBad, BombsAreNotUnpacked) {
    const std::string bomb = packed(header(3, 1) + body(1) + std::string(64 << 20, '\0'));
    ASSERT_LT(bomb.size(), 100000u);
    const std::clock_t begin = std::clock();  // of this process: others may be busy
    for (int i = 0; i < 100; ++i) ASSERT_FALSE(parse(bomb).ok());
    // Unpacking it a hundred times would take more than 10 s, even the most that extensions may have 3 s.
    EXPECT_LT(std::clock() - begin, CLOCKS_PER_SEC);
}

TEST(SpzBad, CutOffAnywhere) {
    const std::string bytes = model(3, 1);
    ASSERT_TRUE(parse(bytes).ok());
    for (std::size_t length = 0; length < bytes.size(); ++length)
        ASSERT_FALSE(parse(bytes.substr(0, length)).ok()) << length;
}

// gzip's checksum finds damage to what is packed.
TEST(SpzBad, RandomDamage) {
    std::mt19937 random(41);
    const std::string bytes = model(5, 1);
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto read = parse(testing::mutated(bytes, random));
        refused += read.ok() ? 0 : 1;
        if (read.ok()) {
            ASSERT_TRUE(read->splats.validate().ok());
        }
    }
    EXPECT_GT(refused, 1500);
}

// So what is behind it is damaged before it is packed.
TEST(SpzBad, RandomDamageInside) {
    std::mt19937 random(43);
    std::string sources[3];
    for (std::uint32_t version = 1; version <= 3; ++version)
        sources[version - 1] = header(version, 4, 1) + std::string(4 * (version == 1   ? 25
                                                                        : version == 2 ? 28
                                                                                       : 29),
                                                                   'k');
    for (const std::string& source : sources) ASSERT_TRUE(parse(packed(source)).ok());
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto read = parse(packed(testing::mutated(sources[i % 3], random)));
        refused += read.ok() ? 0 : 1;
        if (read.ok()) {
            ASSERT_TRUE(read->splats.validate().ok());
        }
    }
    EXPECT_GT(refused, 500);
    EXPECT_LT(refused, 3000);
}

}  // namespace
}  // namespace macula::splat
