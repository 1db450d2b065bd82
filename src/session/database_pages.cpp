#include "session/database_pages.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

namespace macula::session {

namespace {

constexpr std::size_t kFileHeader = 100;
constexpr std::size_t kDefaultPage = 4096;
constexpr std::uint64_t kMostPayload = 16'000'000;
constexpr std::uint8_t kTableLeaf = 13;
// How often the same bytes may be read as part of a row: each byte belongs to one row, and to a few older
// versions of it. Without a limit, cells that all lead to the same place would be copied for hours.
constexpr std::uint64_t kMostCopies = 32;

using Bytes = std::span<const std::byte>;

std::uint64_t bigEndian(Bytes bytes) {
    std::uint64_t value = 0;
    for (const std::byte byte : bytes) value = value << 8 | std::to_integer<std::uint64_t>(byte);
    return value;
}

// Reads from the front. After an attempt to read beyond the end it has failed, and returns zeros.
class Reader {
  public:
    explicit Reader(Bytes bytes) : left_(bytes) {}
    bool hasFailed() const { return hasFailed_; }
    Bytes left() const { return left_; }

    Bytes take(std::size_t count) {
        hasFailed_ = hasFailed_ || count > left_.size();
        if (hasFailed_) return {};
        const Bytes taken = left_.first(count);
        left_ = left_.subspan(count);
        return taken;
    }
    // SQLite's varint: seven bits in each of at most eight bytes, eight in the ninth.
    std::uint64_t varint() {
        std::uint64_t value = 0;
        for (int i = 0; i < 9; ++i) {
            const std::uint64_t byte = bigEndian(take(1));
            if (i == 8) return value << 8 | byte;
            value = value << 7 | (byte & 0x7f);
            if ((byte & 0x80) == 0) break;
        }
        return value;
    }

  private:
    Bytes left_;
    bool hasFailed_ = false;
};

class Pages {
  public:
    explicit Pages(Bytes file) : file_(file), size_(pageSize(file)) {}
    std::size_t count() const { return (file_.size() + size_ - 1) / size_; }
    std::size_t size() const { return size_; }
    std::size_t bytes() const { return file_.size(); }
    // Numbers start at 1, as SQLite counts; empty for a page that does not exist. The last page may be cut
    // off.
    Bytes page(std::uint64_t number) const {
        if (number == 0 || number > count()) return {};
        const std::size_t first = (number - 1) * size_;
        return file_.subspan(first, std::min(size_, file_.size() - first));
    }

  private:
    // Our databases have the default size; any other valid size in the header is accepted.
    static std::size_t pageSize(Bytes file) {
        if (file.size() < kFileHeader) return kDefaultPage;
        const std::uint64_t told = bigEndian(file.subspan(16, 2));
        const std::size_t size = told == 1 ? 65536 : told;
        return size >= 512 && (size & (size - 1)) == 0 ? size : kDefaultPage;
    }

    Bytes file_;
    std::size_t size_;
};

// The bytes that may still be copied: from cells of the current page, and from overflow pages altogether.
struct MayCopy {
    std::uint64_t ofPage = 0;
    std::uint64_t overflowed = 0;
};

// The payload of a cell: the part in its page, and the part in overflow pages. Our pages have no reserved
// bytes.
std::optional<std::vector<std::byte>> payloadOf(const Pages& pages, Reader& cell, std::uint64_t bytes,
                                                MayCopy& mayCopy) {
    const std::uint64_t usable = pages.size();
    const std::uint64_t mostLocal = usable - 35;
    std::uint64_t local = bytes;
    if (bytes > mostLocal) {
        const std::uint64_t leastLocal = (usable - 12) * 32 / 255 - 23;
        local = leastLocal + (bytes - leastLocal) % (usable - 4);
        if (local > mostLocal) local = leastLocal;
    }
    const Bytes first = cell.take(local);
    if (cell.hasFailed() || local > mayCopy.ofPage) return {};
    mayCopy.ofPage -= local;
    std::vector<std::byte> payload(first.begin(), first.end());
    std::uint64_t next = bytes > local ? bigEndian(cell.take(4)) : 0;
    // A circular chain ends once the payload, which is no larger than the file, is complete.
    while (payload.size() < bytes && !cell.hasFailed()) {
        const Bytes page = pages.page(next);
        if (page.size() < 4) return {};
        next = bigEndian(page.first(4));
        const Bytes more = page.subspan(4, std::min<std::size_t>(page.size() - 4, bytes - payload.size()));
        if (more.empty() || more.size() > mayCopy.overflowed) return {};
        mayCopy.overflowed -= more.size();
        payload.insert(payload.end(), more.begin(), more.end());
    }
    if (payload.size() != bytes) return {};
    return payload;
}

std::optional<Value> valueOf(std::uint64_t type, Reader& body) {
    constexpr std::size_t kBytes[]{0, 1, 2, 3, 4, 6, 8};
    if (type == 0) return Value();
    if (type == 8 || type == 9) return Value(static_cast<std::int64_t>(type - 8));
    if (type < std::size(kBytes)) {
        const Bytes bytes = body.take(kBytes[type]);
        if (bytes.empty()) return {};
        const int unused = 64 - 8 * static_cast<int>(bytes.size());
        return Value(static_cast<std::int64_t>(bigEndian(bytes) << unused) >> unused);
    }
    if (type < 13 || type % 2 == 0) return {};  // our tables have no floating-point numbers and no blobs
    const Bytes text = body.take((type - 13) / 2);
    if (body.hasFailed()) return {};
    return Value(std::string(reinterpret_cast<const char*>(text.data()), text.size()));
}

// The columns of a record, row_check last.
std::optional<std::vector<Value>> recordOf(Bytes payload) {
    Reader all(payload);
    const std::uint64_t headerBytes = all.varint();
    const std::size_t sizeBytes = payload.size() - all.left().size();
    if (headerBytes < sizeBytes) return {};
    Reader header(all.take(headerBytes - sizeBytes));
    std::vector<Value> values;
    while (!all.hasFailed() && !header.left().empty()) {
        auto value = valueOf(header.varint(), all);
        if (!value || header.hasFailed()) return {};
        values.push_back(std::move(*value));
    }
    if (all.hasFailed() || values.empty()) return {};
    return values;
}

// Tables with the same number of columns are distinguished by the checksum, which includes the table's name.
void addRow(std::vector<Value> values, std::int64_t id, std::vector<FoundRow>& found) {
    const auto* check = std::get_if<std::int64_t>(&values.back());
    if (check == nullptr) return;
    const std::int64_t expected = *check;
    values.pop_back();
    for (const Table* table : allTables()) {
        if (values.size() != table->columns.size()) continue;
        Row row{values};
        // SQLite does not store the column that is the row's id (INTEGER PRIMARY KEY).
        if (table->columns.front().isInteger) row.values.front() = id;
        if (isSound(*table, row, expected)) found.push_back({table, std::move(row)});
    }
}

void addCell(const Pages& pages, Bytes bytes, MayCopy& mayCopy, std::vector<FoundRow>& found) {
    Reader cell(bytes);
    const std::uint64_t payloadBytes = cell.varint();
    const auto id = static_cast<std::int64_t>(cell.varint());
    if (cell.hasFailed() || payloadBytes > std::min<std::uint64_t>(kMostPayload, pages.bytes())) return;
    const auto payload = payloadOf(pages, cell, payloadBytes, mayCopy);
    if (!payload) return;
    if (auto values = recordOf(*payload)) addRow(std::move(*values), id, found);
}

}  // namespace

std::vector<FoundRow> rowsInPages(Bytes file) {
    const Pages pages(file);
    std::vector<FoundRow> found;
    MayCopy mayCopy{.overflowed = kMostCopies * file.size()};
    for (std::size_t number = 1; number <= pages.count(); ++number) {
        const Bytes page = pages.page(number);
        const std::size_t start = number == 1 ? kFileHeader : 0;
        if (page.size() < start + 8 || std::to_integer<std::uint8_t>(page[start]) != kTableLeaf) continue;
        const std::uint64_t cells = bigEndian(page.subspan(start + 3, 2));
        Reader pointers(page.subspan(start + 8));
        mayCopy.ofPage = kMostCopies * page.size();
        for (std::uint64_t i = 0; i < cells; ++i) {
            const std::uint64_t place = bigEndian(pointers.take(2));
            if (pointers.hasFailed()) break;
            if (place < page.size()) addCell(pages, page.subspan(place), mayCopy, found);
        }
    }
    return found;
}

}  // namespace macula::session
