// Files made to break a reader: none may crash it, take its memory, or stop the others.
#include <fstream>

#include "base/atomic_file.h"
#include "base/available_memory.h"
#include "bytes.h"
#include "dicom/read/byte_source.h"
#include "dicom/read/outline.h"
#include "edit.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

// Sequences in sequences, Explicit VR Little Endian or Implicit, of undefined length.
std::string nested(int levels, const std::string& vr) {
    std::string open, close;
    for (int i = 0; i < levels; ++i) {
        open += vr.empty() ? bytesOf(0x11400008, 4) + bytesOf(kUndefined, 4)
                           : longElement({0x0008, 0x1140}, vr, kUndefined);
        open += kItem + bytesOf(kUndefined, 4);
        close += kItemEnd + kSequenceEnd;
        if (vr == "UN") return open + nested(levels - 1, "") + close;  // implicit inside
    }
    return open + close;
}

// The same with lengths, which DCMTK follows just as well.
std::string nestedWithLengths(int levels) {
    std::string value;
    for (int i = 0; i < levels; ++i) {
        const std::string item = kItem + bytesOf(value.size(), 4) + value;
        value = longElement({0x0008, 0x1140}, "SQ", static_cast<std::uint32_t>(item.size())) + item;
    }
    return value;
}

TEST(Hostile, DeepNestingIsDamageAndStopsNothing) {
    constexpr int kLevels = 20000;
    const TemporaryFolder folder;
    write(smallVolume(), folder.path());
    const auto put = [&](const char* name, const std::string& bytes) {
        std::ofstream(folder / name, std::ios::binary) << bytes;
    };
    put("explicit", preamble(kExplicit) + sopClass() + nested(kLevels, "SQ"));
    put("unknown", preamble(kExplicit) + sopClass() + nested(kLevels, "UN"));
    put("bytes", preamble(kExplicit) + sopClass() + nested(kLevels, "OB"));
    put("implicit", preamble(kImplicit) + nested(kLevels, ""));
    put("lengths", preamble(kExplicit) + sopClass() + nestedWithLengths(2000));
    put("deflated", preamble(kDeflated) + deflated(sopClass() + nested(kLevels, "SQ")));
    put("bare", sopClass() + nested(kLevels, "SQ"));
    put("no syntax", preamble("1.2.3.4") + sopClass() + nested(kLevels, "SQ"));
    // After the pixels, where DCMTK goes on when tags are out of order.
    put("late", preamble(kExplicit) + sopClass() + longElement(tag::kPixelData, "OW", 4) +
                    std::string(4, '\0') + nested(kLevels, "SQ"));
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->studies.at(0).series.at(0).instances, 6u);
    EXPECT_TRUE(found->studies[0].series[0].canBeVolume());
    EXPECT_EQ(found->skipped.size(), 9u);
    for (const SkippedFile& skipped : found->skipped)
        EXPECT_EQ(skipped.message.key, key::kDamagedFile) << skipped.file;
}

TEST(Hostile, OrdinaryNestingIsFine) {
    const TemporaryFolder folder;
    for (const int levels : {1, 12, 64}) {
        std::ofstream(folder / "f", std::ios::binary)
            << preamble(kExplicit) + sopClass() + nested(levels, "SQ");
        EXPECT_TRUE(outlineOf(folder / "f", true).isPlausible()) << levels;
        EXPECT_EQ(readHeader(folder / "f").state, FileState::complete) << levels;
    }
    std::ofstream(folder / "f", std::ios::binary) << preamble(kExplicit) + sopClass() + nested(65, "SQ");
    EXPECT_TRUE(outlineOf(folder / "f", true).nestedTooDeep);
}

TEST(Hostile, FileThatBecameDeepSinceTheScan) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    std::ofstream(files[2], std::ios::binary) << preamble(kExplicit) + sopClass() + nested(20000, "SQ");
    const auto volume = load(found->studies.at(0).series.at(0));
    ASSERT_NE(volume, nullptr);
    EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{2, 2}}));
    EXPECT_EQ(volume->provenance().messages.at(0).key, key::kDamagedFile);
}

TEST(Hostile, FewerPixelsThanTheHeaderClaims) {
    const TemporaryFolder folder;
    for (const fs::path& file : write(smallVolume(), folder.path())) {
        setWord(file, tag::kRows, 30000);
        setWord(file, tag::kColumns, 30000);
    }
    Progress progress;
    const auto found = scanFolder(folder.path(), progress);
    ASSERT_FALSE(found);
    EXPECT_NE(found.error().message.english().find("None of the 6 DICOM files"), std::string::npos)
        << found.error().message;
}

TEST(Hostile, OneSliceWithTooFewPixelsIsLeftOutAndToldOf) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    setPixels(files[5], std::vector<std::uint16_t>(19, 7));
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    ASSERT_EQ(found->skipped.size(), 1u);
    EXPECT_EQ(found->skipped[0].message.key, key::kTruncatedFile);
    EXPECT_TRUE(hasMessage(found->studies.at(0).series.at(0), key::kTruncatedFile));
}

TEST(Hostile, MoreMemoryThanThereIs) {
    const auto available = availableMemory();
    ASSERT_TRUE(available);
    EXPECT_GT(*available, std::uint64_t{1} << 20);
    const Error error = notEnoughMemory(std::uint64_t{3} << 30, std::uint64_t{1} << 30);
    EXPECT_EQ(error.code, ErrorCode::outOfMemory);
    EXPECT_NE(error.message.english().find("3.0 GiB"), std::string::npos) << error.message;
    EXPECT_NE(error.message.english().find("1.0 GiB"), std::string::npos) << error.message;
    EXPECT_FALSE(error.hint.empty());

    const TemporaryFolder folder;
    write(smallVolume(), folder.path());
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    const Series series = found->studies.at(0).series.at(0);
    Stack stack = series.stacks.at(0);
    stack.columns = stack.rows = 65535;
    Instance large = *stack.frames[0].instance;
    large.columns = large.rows = 65535;
    stack.frames[0].instance = std::make_shared<const Instance>(large);
    const std::size_t slices = *available / (2ull * 65535 * 65535) + 2;
    stack.frames.assign(slices, Frame(stack.frames[0]));
    stack.slices.clear();
    for (std::size_t k = 0; k < slices; ++k) stack.slices.push_back({k, k, 0.0});
    Progress progress;
    const auto volume = loadVolume(series, stack, progress);
    ASSERT_FALSE(volume);
    EXPECT_EQ(volume.error().code, ErrorCode::outOfMemory);
    EXPECT_NE(volume.error().message.english().find("GiB are free"), std::string::npos)
        << volume.error().message;
}

TEST(Hostile, SizesThatAreNone) {
    const TemporaryFolder folder;
    write(smallVolume(), folder.path());
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    for (const int rows : {0, -4, 65536}) {
        const Series series = found->studies.at(0).series.at(0);
        Stack stack = series.stacks.at(0);
        stack.rows = rows;
        Progress progress;
        const auto volume = loadVolume(series, stack, progress);
        ASSERT_FALSE(volume);
        EXPECT_EQ(volume.error().code, ErrorCode::inputNotUsable);
    }
}

TEST(Hostile, StrayBytesAfterThePixelsAreNoDamage) {
    for (const WriteSyntax syntax : {WriteSyntax::explicitLittleEndian, WriteSyntax::rle}) {
        for (std::size_t count = 1; count <= 7; ++count) {
            for (const char stray : {'\0', '\n', '\x7F'}) {
                SCOPED_TRACE(fmt::format("{} bytes {}", count, int{stray}));
                const TemporaryFolder folder;
                const Volume volume = smallVolume();
                const auto files = write(volume, folder.path(), {.syntax = syntax});
                std::ofstream(files[1], std::ios::binary | std::ios::app) << std::string(count, stray);
                const auto found = scan(folder.path());
                ASSERT_TRUE(found);
                EXPECT_TRUE(found->skipped.empty());
                const Series& series = found->studies.at(0).series.at(0);
                EXPECT_TRUE(hasMessage(series, key::kStrayBytes));
                const auto read = load(series);
                ASSERT_NE(read, nullptr);
                expectSameValues(*read, volume);
            }
        }
    }
}

TEST(Hostile, DeflatedFarBeyondItsImage) {
    const TemporaryFolder folder;
    write(smallVolume(), folder.path());
    const std::string image = shortElement(tag::kRows, "US", bytesOf(4, 2)) +
                              shortElement(tag::kColumns, "US", bytesOf(4, 2)) +
                              shortElement(tag::kBitsAllocated, "US", bytesOf(16, 2));
    constexpr std::uint32_t kBomb = 200u << 20;
    std::ofstream(folder / "private", std::ios::binary)
        << preamble(kDeflated) +
               deflated(sopClass() + longElement({0x0009, 0x1001}, "OB", kBomb) + std::string(kBomb, '\0'));
    std::ofstream(folder / "pixels", std::ios::binary)
        << preamble(kDeflated) + deflated(sopClass() + image + longElement(tag::kPixelData, "OW", kBomb) +
                                          std::string(kBomb, '\0'));
    EXPECT_LT(fs::file_size(folder / "pixels"), 1u << 20);
    for (const char* name : {"private", "pixels"}) {
        EXPECT_TRUE(outlineOf(folder / name, true).inflatesTooFar) << name;
        EXPECT_EQ(readHeader(folder / name).state, FileState::damaged) << name;
    }
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->studies.at(0).series.at(0).instances, 6u);
    EXPECT_EQ(found->skipped.size(), 2u);
}

// A megabyte that inflates for seconds must not hold up whoever gave up waiting.
TEST(Hostile, InflatingStopsWhenCancelled) {
    const TemporaryFolder folder;
    const std::string image = shortElement(tag::kRows, "US", bytesOf(60000, 2)) +
                              shortElement(tag::kColumns, "US", bytesOf(60000, 2)) +
                              shortElement(tag::kBitsAllocated, "US", bytesOf(16, 2));
    constexpr std::uint32_t kBytes = 64u << 20;
    std::ofstream(folder / "f", std::ios::binary)
        << preamble(kDeflated) + deflated(sopClass() + image + longElement(tag::kPixelData, "OW", kBytes) +
                                          std::string(kBytes, '\0'));
    EXPECT_EQ(readHeader(folder / "f").state, FileState::complete);
    CancelToken cancel;
    cancel.cancel();
    ByteSource source(folder / "f", cancel);
    ASSERT_TRUE(source.skip(400));
    source.beginInflating();
    std::vector<unsigned char> bytes(1000);
    EXPECT_FALSE(source.read(bytes));
    EXPECT_FALSE(readHeader(folder / "f", cancel).pixels);
}

// More items than any real object has, in a file that says explicit and is implicit: still no reason to
// refuse it.
TEST(Hostile, ManyItemsInAMisdeclaredFile) {
    const TemporaryFolder folder;
    const auto implicitly = [](Tag tag, const std::string& value) {
        return bytesOf(tag.group, 2) + bytesOf(tag.element, 2) + bytesOf(value.size(), 4) + value;
    };
    std::string items;
    for (int i = 0; i < 3000; ++i) items += kItem + bytesOf(0, 4);
    std::ofstream(folder / "f", std::ios::binary)
        << preamble(kExplicit) +
               implicitly({0x0008, 0x0016}, std::string("1.2.840.10008.5.1.4.1.1.2\0", 26)) +
               implicitly({0x0008, 0x1140}, items) + implicitly(tag::kModality, "CT");
    const HeaderFile read = readHeader(folder / "f");
    ASSERT_EQ(read.state, FileState::complete);
    EXPECT_EQ(read.header->items({0x0008, 0x1140}).size(), 3000u);
}

// Whatever is changed in a header, it is read to an end, and so is all that was found in it.
TEST(Hostile, ChangedAnywhere) {
    const TemporaryFolder folder;
    const std::string frames =
        sequence(tag::kPerFrameFunctionalGroups,
                 {sequence({0x0020, 0x9113}, {shortElement(tag::kImagePositionPatient, "DS", "1\\2\\3")}), "",
                  shortElement({0x0008, 0x0005}, "CS", "ISO_IR 192") +
                      shortElement(tag::kPatientName, "PN", "王^小東")});
    const std::string dataset =
        shortElement({0x0008, 0x0005}, "CS", "\\ISO 2022 IR 87") + sopClass() +
        shortElement(tag::kPatientName, "PN", "Yamada^Tarou=\x1B$B;3ED\x1B(B^\x1B$BB@O:\x1B(B") +
        shortElement({0x0009, 0x0010}, "LO", "CREATOR") + longElement({0x0009, 0x1001}, "UN", 8) +
        bytesOf(0xE000FFFE, 4) + bytesOf(0, 4) + nested(3, "SQ") +
        shortElement(tag::kNumberOfFrames, "IS", "3") + shortElement(tag::kRows, "US", bytesOf(2, 2)) +
        sequence(tag::kSharedFunctionalGroups, {sequence({0x0028, 0x9110}, {"", ""})}) + frames +
        longElement(tag::kPixelData, "OW", 16) + std::string(16, 'x');
    std::uint32_t state = 7;
    const auto random = [&](std::size_t below) {
        state = state * 1664525u + 1013904223u;
        return (state >> 8) % below;
    };
    std::size_t readable = 0;
    for (int round = 0; round < 4000; ++round) {
        std::string bytes =
            round % 4 == 3 ? preamble(kDeflated) + deflated(dataset) : preamble(kExplicit) + dataset;
        for (std::size_t k = 1 + random(4); k > 0; --k) {
            const std::size_t at = random(bytes.size());
            switch (random(4)) {
                case 0:
                    bytes[at] = static_cast<char>(random(256));
                    break;
                case 1:
                    bytes[at] = static_cast<char>(random(2) ? 0xFF : 0);
                    break;
                case 2:
                    bytes.erase(at, 1 + random(8));
                    break;
                default:
                    bytes.insert(at, bytes.substr(random(bytes.size()), random(40)));
            }
        }
        // A new file each time: some file systems wait for the disk when one is written again.
        const fs::path file = folder / std::to_string(round);
        std::ofstream(file, std::ios::binary) << bytes;
        const HeaderFile read = readHeader(file);
        fs::remove(file);
        if (!read.header) continue;
        ++readable;
        const auto ask = [](const Dataset& d) {
            for (const Tag tag : {tag::kPatientName, tag::kImagePositionPatient, tag::kRows,
                                  tag::kSopClassUid, tag::kNumberOfFrames, Tag{0x0009, 0x1001}}) {
                d.text(tag);
                d.texts(tag);
                d.allNumbers(tag);
                d.words(tag);
            }
            return d.charsetFallback();
        };
        ask(*read.header);
        for (const int frame : {0, 1, 2, 3, read.header->frameCount() - 1}) ask(read.header->frame(frame));
        for (const Dataset& item : read.header->items(tag::kPerFrameFunctionalGroups)) ask(item);
    }
    EXPECT_GT(readable, 400u);
    EXPECT_LT(readable, 3600u);
}

}  // namespace
}  // namespace macula::dicom::test
