// A checksum of each row: SQLite has none of its pages, so a changed bit of a disk would pass for a value.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace macula::session {

// NULL, INTEGER or TEXT: all that columns hold.
using Value = std::variant<std::monostate, std::int64_t, std::string>;

// CRC-64/XZ (ECMA-182, reflected): finds every burst of up to 64 bits, all else but one in 2^64. `before` is
// the checksum of what came before.
std::uint64_t crc64(std::string_view bytes, std::uint64_t before = 0);

// RowSum takes the checksum of a row column by column, where SQLite holds it: a row that is only looked at
// is not copied.
class RowSum {
  public:
    explicit RowSum(std::string_view table) : crc_(crc64(table)) {}
    void add(std::int64_t number);
    void add(std::string_view text);
    void addNull() { crc_ = crc64("n", crc_); }
    std::int64_t value() const { return static_cast<std::int64_t>(crc_); }

  private:
    std::uint64_t crc_;
};

// Of the name of the table and all columns but row_check, with their kinds and lengths. The id is one of
// them, so a row that is found under another id fails as well.
std::int64_t rowCheck(std::string_view table, std::span<const Value> values);

}  // namespace macula::session
