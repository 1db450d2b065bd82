// Seeds of fuzz_database: a page of 512 bytes with one row, and a row that goes on in other pages. The format
// is that of sqlite.org/fileformat2.html.
#include "fuzz/seeds.h"
#include "session/rows.h"

namespace macula::fuzz {
namespace {

using session::Value;

constexpr std::size_t kPage = 512;

std::string bigEndian(std::uint64_t value, int bytes) {
    std::string text;
    for (int i = bytes - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i));
    return text;
}

// Of less than 16384: at most two bytes.
std::string varint(std::size_t value) {
    if (value < 128) return {static_cast<char>(value)};
    return {static_cast<char>(128 | value >> 7), static_cast<char>(value & 127)};
}

// A row of volumes, with its checksum.
std::string record(const std::string& digest) {
    const std::vector<Value> values{digest, std::int64_t{1'600'000'000}, std::int64_t{1'700'000'000}};
    const std::int64_t check = session::rowCheck(session::kVolumes.name, values);
    std::string types = varint(13 + 2 * digest.size()) + "\6\6\6";
    types = varint(types.size() + 1) + types;
    return types + digest + bigEndian(1'600'000'000, 8) + bigEndian(1'700'000'000, 8) +
           bigEndian(static_cast<std::uint64_t>(check), 8);
}

// The first page: the header of the file, then a leaf with one cell at the end of it.
std::string firstPage(const std::string& cell) {
    std::string page = std::string("SQLite format 3\0", 16) + bigEndian(kPage, 2);
    page.resize(100);
    const std::size_t place = kPage - cell.size();
    page += "\x0D" + bigEndian(0, 2) + bigEndian(1, 2) + bigEndian(place, 2) + std::string(1, '\0') +
            bigEndian(place, 2);
    page.resize(place);
    return page + cell;
}

}  // namespace

void writeDatabaseSeeds(const std::filesystem::path& corpus) {
    const std::filesystem::path folder = corpus / "database";
    const std::string small = record("abcdef");
    save(folder / "one_row", firstPage(varint(small.size()) + varint(1) + small));
    // What does not fit lies in a chain of pages, each of which begins with the number of the next.
    const std::string large = record(std::string(1000, 'a'));
    const std::size_t least = (kPage - 12) * 32 / 255 - 23;
    const std::size_t fitting = least + (large.size() - least) % (kPage - 4);
    const std::size_t local = fitting > kPage - 35 ? least : fitting;
    std::string file = firstPage(varint(large.size()) + varint(2) + large.substr(0, local) + bigEndian(2, 4));
    for (std::size_t at = local, page = 3; at < large.size(); at += kPage - 4, ++page) {
        const std::string part = large.substr(at, kPage - 4);
        file += bigEndian(at + part.size() < large.size() ? page : 0, 4) + part;
        file.resize((file.size() + kPage - 1) / kPage * kPage);
    }
    save(folder / "overflow", file);
}

}  // namespace macula::fuzz
