// The checksum of rows.
#include "session/row_check.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace macula::session
