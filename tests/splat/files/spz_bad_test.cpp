// SPZ files that are none, damaged, or made to harm.
#include <gtest/gtest.h>

#include <cstring>
#include <ctime>

#include "pipeline/splat/files/gzip.h"
#include "pipeline/splat/files/spz.h"
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

std::string model(std::size_t count, int degree, SpzVersion version) {
    const auto file = encodeSpz(testing::randomModel(count, degree, 31), version);
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
        {"NGSP", "damaged"},
        {header(3, 1) + body(1), "damaged"},  // not packed
        {header(4, 1) + body(1), "damaged"},
        {header(5, 1) + body(1), "version 5"},
        {header(4, 1, 4) + body(1), "degree 4"},
        {header(4, 9999999u) + body(1), "too small"},
        {"no gzip at all", "damaged"},
        {packed(""), "damaged"},
        {packed("NGSP"), "damaged"},
        {packed("a letter to somebody, long enough to be a header"), "no SPZ"},
        {packed(header(0, 1) + body(1)), "version 0"},
        {packed(header(4, 1) + body(1)), "damaged"},  // no gzip in version 4
        {packed(header(5, 1) + body(1)), "version 5"},
        {packed(header(0xffffffff, 1) + body(1)), "version 4294967295"},
        {packed(header(3, 0)), "no splats"},
        {packed(header(3, 1, 4) + body(10)), "degree 4"},
        {packed(header(3, 1, 255) + body(10)), "degree 255"},
        {packed(header(3, 1, 0, 32) + body(1)), "damaged"},
        {packed(header(3, 2) + body(1)), "damaged"},
        {packed(header(3, 1) + body(2)), "damaged"},
        {packed(header(3, 4000000000u) + body(1)), "4000000000 splats"},
        {packed(header(3, 9999999u) + body(1)), "too small"},
        {packed(header(3, 1) + body(1), "macula model 9"), "version"},
        {packed(header(3, 1) + body(1), "macula model 1\nmacula axes sideways"), "axes"},
        {packed(header(1, 1, 0) + std::string("\0\x7e\0\0\0\0", 6) + std::string(10, 'a')),
         "1 of the 1"},  // NaN
    };
    for (const Case& c : cases) {
        const auto read = parse(c.bytes);
        ASSERT_FALSE(read.ok()) << c.says;
        EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
        EXPECT_NE(read.error().message.english().find(c.says), std::string::npos)
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

// Two million splats that are all the same, in 40 kB: the file is whole, but who would unpack it would spend
// memory and time a thousand times as much as it took to send it.
TEST(SpzBad, SmallFilesOfMillionsAreRefused) {
    const std::string bytes = packed(header(3, 2'000'000) + body(2'000'000));
    ASSERT_LT(bytes.size(), 60'000u);
    const auto read = parse(bytes);
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.error().message.english().find("2000000 splats"), std::string::npos)
        << read.error().message;
    // As many as nobody's memory lacks may be alike.
    EXPECT_TRUE(parse(packed(header(3, 100'000) + body(100'000))).ok());
    // And none such is written.
    Splats alike;
    alike.resize(2'000'000);
    for (const SpzVersion version : {SpzVersion::gzip, SpzVersion::zstd})
        EXPECT_FALSE(encodeSpz(alike, version).ok());
    alike.resize(100'000);
    for (const SpzVersion version : {SpzVersion::gzip, SpzVersion::zstd})
        EXPECT_TRUE(parse(asText(encodeSpz(alike, version)->bytes)).ok());
}

// The table of version 4 says other sizes than the header.
TEST(SpzBad, TablesThatDisagree) {
    const std::string bytes = model(3, 1, SpzVersion::zstd);
    std::uint32_t table = 0;
    std::memcpy(&table, bytes.data() + 16, sizeof table);
    const auto with = [&](std::size_t at, std::uint64_t value, std::size_t size) {
        std::string changed = bytes;
        std::memcpy(changed.data() + at, &value, size);
        return changed;
    };
    ASSERT_TRUE(parse(with(16, table, 4)).ok());
    const std::vector<std::string> cases{with(8, 2, 4),                      // splats
                                         with(8, 4, 4),                      //
                                         with(12, 0, 1),                     // degree
                                         with(15, 5, 1),                     // streams
                                         with(15, 255, 1),                   //
                                         with(16, 31, 4),                    // where the table lies
                                         with(16, table + 1, 4),             //
                                         with(16, bytes.size(), 4),          //
                                         with(16, 0xffffffff, 4),            //
                                         with(table, ~std::uint64_t{0}, 8),  // packed size
                                         with(table + 8, ~std::uint64_t{0}, 8),
                                         with(table + 8, 28, 8),  // unpacked size
                                         with(table + 8, 26, 8)};
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto read = parse(cases[i]);
        ASSERT_FALSE(read.ok()) << i;
        EXPECT_NE(read.error().message.english().find("damaged"), std::string::npos) << i;
    }
    // A record that is longer than its zone: nothing of it is read, and the model is not less for it.
    const auto read = parse(with(36, 0xffffffff, 4));
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read->splats.axes, Axes::unknown);
}

TEST(SpzBad, CutOffAnywhere) {
    for (const SpzVersion version : {SpzVersion::gzip, SpzVersion::zstd}) {
        const std::string bytes = model(3, 1, version);
        ASSERT_TRUE(parse(bytes).ok());
        for (std::size_t length = 0; length < bytes.size(); ++length)
            ASSERT_FALSE(parse(bytes.substr(0, length)).ok()) << length;
    }
}

// The checksums of gzip and zstd find damage to what is packed.
TEST(SpzBad, RandomDamage) {
    std::mt19937 random(41);
    for (const SpzVersion version : {SpzVersion::gzip, SpzVersion::zstd}) {
        const std::string bytes = model(5, 1, version);
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
