// The checksum of rows.
#include "session/row_check.h"

#include <gtest/gtest.h>

#include <limits>

namespace macula::session {
namespace {

// The check value of CRC-64/XZ in the catalogue of parametrised CRC algorithms.
TEST(RowCheck, IsCrc64Xz) {
    EXPECT_EQ(crc64("123456789"), 0x995dc9bbdf1939fau);
    EXPECT_EQ(crc64("6789", crc64("12345")), crc64("123456789"));
    EXPECT_EQ(crc64(""), 0u);
}

TEST(RowCheck, TellsKindsLengthsAndTablesApart) {
    using Values = std::vector<Value>;
    const Values row{std::string("ab"), std::int64_t{1}, Value()};
    const std::int64_t check = rowCheck("models", row);
    EXPECT_EQ(rowCheck("models", row), check);
    EXPECT_NE(rowCheck("audit", row), check);
    EXPECT_NE(rowCheck("models", Values{std::string("ab"), std::int64_t{1}}), check);
    EXPECT_NE(rowCheck("models", Values{std::string("ab"), std::string("1"), Value()}), check);
    EXPECT_NE(rowCheck("models", Values{std::string("ab"), std::int64_t{1}, std::string()}), check);
    EXPECT_NE(rowCheck("models", Values{std::string("a"), std::string("b")}),
              rowCheck("models", Values{std::string("ab"), std::string()}));
    EXPECT_NE(rowCheck("models", Values{Value(), std::string("ab"), std::int64_t{1}}), check);
}

TEST(RowCheck, IsTheSameWithoutACopy) {
    RowSum sum("documents");
    sum.add(std::int64_t{-2});
    sum.add(std::string_view());
    sum.addNull();
    sum.add("nine byte");
    sum.add(std::numeric_limits<std::int64_t>::min());
    const std::vector<Value> row{std::int64_t{-2}, std::string(), Value(), std::string("nine byte"),
                                 std::numeric_limits<std::int64_t>::min()};
    EXPECT_EQ(sum.value(), rowCheck("documents", row));
    // As stores have it by now: 'i' and eight bytes, least first; 't', the length and the text; 'n'.
    std::string bytes("documents");
    bytes += std::string("i\xfe\xff\xff\xff\xff\xff\xff\xff", 9) + "t" + std::string(8, '\0') + "n";
    bytes += std::string("t\x09\0\0\0\0\0\0\0", 9) + "nine byte";
    bytes += std::string("i\0\0\0\0\0\0\0\x80", 9);
    EXPECT_EQ(sum.value(), static_cast<std::int64_t>(crc64(bytes)));
}

}  // namespace
}  // namespace macula::session
