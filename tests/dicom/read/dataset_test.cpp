// What the getters of a header give: of items, of frames, and of every value representation.
#include <cerrno>
#include <chrono>
#include <fstream>

#include "bytes.h"
#include "support.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

constexpr Tag kFrameContent{0x0020, 0x9111};
constexpr Tag kPlanePosition{0x0020, 0x9113};
constexpr Tag kPixelMeasures{0x0028, 0x9110};
constexpr Tag kInStackPosition{0x0020, 0x9057};

Dataset headerOf(const TemporaryFolder& folder, const std::string& bytes) {
    std::ofstream(folder / "f", std::ios::binary) << bytes;
    HeaderFile read = readHeader(folder / "f");
    EXPECT_EQ(read.state, FileState::complete);
    MACULA_CHECK(read.header.has_value());
    return *read.header;
}

Dataset headerOf(const fs::path& file) {
    HeaderFile read = readHeader(file);
    EXPECT_EQ(read.state, FileState::complete);
    MACULA_CHECK(read.header.has_value());
    return *read.header;
}

using Numbers = std::vector<double>;

TEST(Dataset, FramesOfEnhancedCt) {
    SKIP_WITHOUT_SHARED_DATA();
    const Dataset header = headerOf(sharedData() / "odd/enhanced_ct_2frame.dcm");
    EXPECT_FALSE(header.has(tag::kImagePositionPatient));
    ASSERT_EQ(header.frameCount(), 2);
    const Dataset first = header.frame(0), second = header.frame(1), none = header.frame(2);
    EXPECT_EQ(first.allNumbers(tag::kImagePositionPatient), (Numbers{99.5, -301.5, -159}));
    EXPECT_EQ(second.allNumbers(tag::kImagePositionPatient), (Numbers{99.5, -301.5, -149}));
    EXPECT_FALSE(none.has(tag::kImagePositionPatient));
    EXPECT_FALSE(header.frame(-1).has(tag::kImagePositionPatient));
    EXPECT_EQ(first.integer(kInStackPosition), 2);
    EXPECT_EQ(second.integer(kInStackPosition), 1);
    EXPECT_EQ(first.allNumbers({0x0020, 0x9157}), (Numbers{1, 2}));
    for (const Dataset& frame : {first, second, none}) {
        EXPECT_EQ(frame.allNumbers(tag::kPixelSpacing), (Numbers{0.388672, 0.388672}));
        EXPECT_EQ(frame.number(tag::kRescaleIntercept), -1024.0);
        EXPECT_EQ(frame.text(tag::kRescaleType), "US");
        EXPECT_EQ(frame.integer(tag::kRows), 512);
        EXPECT_EQ(frame.text(tag::kModality), "CT");
    }
    const auto mapping = first.items({0x0040, 0x9096});
    ASSERT_EQ(mapping.size(), 1u);
    EXPECT_EQ(mapping[0].number({0x0040, 0x9224}), -1024.0);
    EXPECT_EQ(mapping[0].integer({0x0040, 0x9211}), 4095);
    EXPECT_EQ(mapping[0].items({0x0040, 0x08EA}).at(0).text({0x0008, 0x0100}), "ml/100ml/s");
    EXPECT_FALSE(mapping[0].has(tag::kModality)) << "an item sees no more than itself";
    EXPECT_FALSE(first.has({0x0008, 0x0100})) << "a code is no attribute of the frame";
}

TEST(Dataset, FramesOfLegacyConvertedCt) {
    SKIP_WITHOUT_SHARED_DATA();
    const Dataset header = headerOf(sharedData() / "odd/legacy_enhanced_pair/mf.dcm");
    ASSERT_EQ(header.frameCount(), 3);
    for (int i = 0; i < 3; ++i) {
        const Dataset frame = header.frame(i);
        EXPECT_EQ(frame.allNumbers(tag::kImagePositionPatient),
                  (Numbers{46.4649, 5.01881, -177.75 + 2.5 * i}));
        EXPECT_EQ(frame.allNumbers(tag::kImageOrientationPatient), (Numbers{1, 0, 0, 0, 1, 0}));
        EXPECT_EQ(frame.integer(kInStackPosition), 3 - i);
        EXPECT_EQ(frame.integer(tag::kInstanceNumber), i + 1) << "of the file it was made from";
        EXPECT_EQ(frame.text(tag::kSopInstanceUid), header.text(tag::kSopInstanceUid));
    }
    EXPECT_EQ(header.items(tag::kPerFrameFunctionalGroups).size(), 3u);
    EXPECT_EQ(header.items(tag::kPerFrameFunctionalGroups)[1].items(kPlanePosition).size(), 1u);
    EXPECT_TRUE(header.items(tag::kModality).empty());
    EXPECT_TRUE(header.items({0x0040, 0x0555}).empty()) << "empty sequence";
}

TEST(Dataset, FramesWithoutFunctionalGroups) {
    SKIP_WITHOUT_SHARED_DATA();
    const Dataset header = headerOf(sharedData() / "odd/enhanced_mr_10frame.dcm");
    ASSERT_EQ(header.frameCount(), 10);
    EXPECT_EQ(header.frame(9).text(tag::kModality), "MR");
    EXPECT_EQ(header.frame(9).number({0x0018, 0x9053}), 4.68);
    EXPECT_EQ(header.frame(9).allNumbers({0x0018, 0x9090}), (Numbers{0, 0, 0}));
}

// A macro of the frame, an attribute of the frame's item itself, of a shared macro, of the top level.
TEST(Dataset, TheNearestValueIsTaken) {
    const TemporaryFolder folder;
    const auto thickness = [](const char* value) { return shortElement({0x0018, 0x0050}, "DS", value); };
    const auto number = [](const char* value) { return shortElement(tag::kInstanceNumber, "IS", value); };
    const auto comments = [](const char* value) { return shortElement({0x0020, 0x4000}, "LT", value); };
    const std::string shared =
        sequence(tag::kSharedFunctionalGroups,
                 {comments("shared") + sequence(kPixelMeasures, {thickness("2") + number("20")})});
    const std::string perFrame =
        sequence(tag::kPerFrameFunctionalGroups,
                 {number("31") + sequence(kFrameContent, {number("41") + comments("frame"), number("7")}) +
                      sequence(kPixelMeasures, {thickness("4")}),
                  number("32") + sequence(kPixelMeasures, {thickness("  ")}), ""});
    const Dataset header =
        headerOf(folder, preamble(kExplicit) + sopClass() + thickness("1") + number("10") +
                             shortElement(tag::kNumberOfFrames, "IS", "5") + shared + perFrame);
    ASSERT_EQ(header.frameCount(), 5);
    EXPECT_EQ(header.frame(0).number({0x0018, 0x0050}), 4);
    EXPECT_EQ(header.frame(0).integer(tag::kInstanceNumber), 41);
    EXPECT_EQ(header.frame(0).text({0x0020, 0x4000}), "frame");
    EXPECT_EQ(header.frame(1).number({0x0018, 0x0050}), 2) << "an empty value is none";
    EXPECT_EQ(header.frame(1).integer(tag::kInstanceNumber), 32);
    EXPECT_EQ(header.frame(1).text({0x0020, 0x4000}), "shared");
    for (const int i : {2, 3, 4}) {
        EXPECT_EQ(header.frame(i).integer(tag::kInstanceNumber), 20) << i;
        EXPECT_EQ(header.frame(i).text(tag::kModality), "CT") << i;
    }
    EXPECT_EQ(header.integer(tag::kInstanceNumber), 10);
    // A view of an item still knows its file.
    EXPECT_EQ(header.items(tag::kPerFrameFunctionalGroups)[0].frame(1).integer(tag::kInstanceNumber), 32);
}

TEST(Dataset, TenThousandFrames) {
    const TemporaryFolder folder;
    constexpr int kFrames = 10000;
    std::vector<std::string> frames;
    for (int i = 0; i < kFrames; ++i) {
        const std::string at = fmt::format("{}\\0\\{}", i, 0.5 * i);
        frames.push_back(sequence(kFrameContent, {shortElement(kInStackPosition, "UL", bytesOf(i + 1, 4))}) +
                         sequence(kPlanePosition, {shortElement(tag::kImagePositionPatient, "DS", at)}) +
                         sequence({0x0028, 0x9145}, {shortElement(tag::kRescaleSlope, "DS", "1.5")}));
    }
    const std::string bytes =
        preamble(kExplicit) + sopClass() + shortElement(tag::kNumberOfFrames, "IS", std::to_string(kFrames)) +
        sequence(tag::kSharedFunctionalGroups,
                 {sequence(kPixelMeasures, {shortElement(tag::kPixelSpacing, "DS", "0.5\\0.5")})}) +
        sequence(tag::kPerFrameFunctionalGroups, frames);
    const auto before = std::chrono::steady_clock::now();
    const Dataset header = headerOf(folder, bytes);
    ASSERT_EQ(header.frameCount(), kFrames);
    double sum = 0.0;
    for (int i = 0; i < kFrames; ++i) {
        const Dataset frame = header.frame(i);
        const auto position = frame.numbers(tag::kImagePositionPatient, 3);
        ASSERT_TRUE(position);
        sum += (*position)[2] - 0.5 * i + frame.integer(kInStackPosition).value_or(0) - (i + 1) +
               frame.number(tag::kRescaleSlope).value_or(0) - 1.5;
        for (const Tag tag : {tag::kPixelSpacing, tag::kModality, tag::kSopInstanceUid})
            sum += !frame.has(tag);
        for (std::uint16_t k = 0; k < 20; ++k) sum += frame.has({0x0018, k});
    }
    EXPECT_EQ(sum, 0.0);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - before;
    EXPECT_LT(seconds.count(), 2.0);  // a debug build, beside others; a linear search would take minutes
    RecordProperty("seconds", std::to_string(seconds.count()));
}

TEST(Dataset, BinaryNumbers) {
    const TemporaryFolder folder;
    const std::string negative = bytesOf(0xFFFE, 2);
    const Dataset header =
        headerOf(folder, preamble(kExplicit) + sopClass() + shortElement({0x0018, 0x0001}, "US", negative) +
                             shortElement({0x0018, 0x0002}, "SS", negative) +
                             shortElement({0x0018, 0x0003}, "UL", bytesOf(0xFFFFFFFE, 4)) +
                             shortElement({0x0018, 0x0004}, "SL", bytesOf(0xFFFFFFFE, 4)) +
                             shortElement({0x0018, 0x0005}, "FL", bytesOf(0x3DCCCCCD, 4)) +
                             shortElement({0x0018, 0x0006}, "FD", bytesOf(0x3FB999999999999A, 8)) +
                             shortElement({0x0018, 0x0007}, "FD", bytesOf(0x7FF0000000000000, 8)) +
                             shortElement({0x0018, 0x0008}, "AT", bytesOf(0x00100018, 4)) +
                             shortElement({0x0018, 0x0009}, "US", bytesOf(0x00030002, 4)) +
                             shortElement({0x0018, 0x000A}, "UL", bytesOf(1, 6)) +
                             longElement({0x0018, 0x000B}, "OW", 6) + bytesOf(0x000300020001, 6) +
                             longElement({0x0018, 0x000C}, "OB", 4) + bytesOf(0x04030201, 4) +
                             longElement({0x0018, 0x000D}, "SV", 8) + bytesOf(0xFFFFFFFFFFFFFFFF, 8));
    const auto element = [](std::uint16_t number) { return Tag{0x0018, number}; };
    EXPECT_EQ(header.number(element(1)), 65534);
    EXPECT_EQ(header.word(element(1)), 0xFFFE);
    EXPECT_EQ(header.number(element(2)), -2);
    EXPECT_EQ(header.word(element(2)), 0xFFFE);
    EXPECT_EQ(header.number(element(3)), 4294967294.0);
    EXPECT_FALSE(header.integer(element(3)));
    EXPECT_EQ(header.integer(element(4)), -2);
    EXPECT_EQ(header.number(element(5)), 0.1f);
    EXPECT_EQ(header.text(element(5)), "0.1");
    EXPECT_EQ(header.number(element(6)), 0.1);
    EXPECT_FALSE(header.number(element(7))) << "infinite";
    EXPECT_EQ(header.text(element(8)), "(0018,0010)");
    EXPECT_EQ(header.allNumbers(element(9)), (Numbers{2, 3}));
    EXPECT_FALSE(header.number(element(9))) << "two";
    EXPECT_EQ(header.texts(element(9)), (std::vector<std::string>{"2", "3"}));
    EXPECT_FALSE(header.has({0x0018, 0x00FF}));
    EXPECT_TRUE(header.allNumbers(element(10)).empty()) << "six bytes are no numbers of four";
    EXPECT_EQ(header.words(element(11)), (std::vector<std::uint16_t>{1, 2, 3}));
    EXPECT_EQ(header.words(element(12)), (std::vector<std::uint16_t>{0x0201, 0x0403}));
    EXPECT_EQ(header.number(element(13)), -1);
    EXPECT_TRUE(header.words(tag::kModality).empty());
}

TEST(Dataset, NumbersInText) {
    const TemporaryFolder folder;
    const Dataset header =
        headerOf(folder, preamble(kExplicit) + sopClass() + shortElement({0x0018, 0x0050}, "DS", "1\\x\\3") +
                             shortElement({0x0018, 0x0088}, "DS", "1\\\\3") +
                             shortElement({0x0018, 0x1114}, "DS", " +1.5e1 \\-2") +
                             shortElement({0x0018, 0x1115}, "DS", "nan") +
                             shortElement({0x0018, 0x1150}, "IS", "1.0"));
    EXPECT_TRUE(header.allNumbers({0x0018, 0x0050}).empty());
    EXPECT_TRUE(header.allNumbers({0x0018, 0x0088}).empty());
    EXPECT_EQ(header.allNumbers({0x0018, 0x1114}), (Numbers{15, -2}));
    EXPECT_FALSE(header.numbers({0x0018, 0x1114}, 3));
    EXPECT_TRUE(header.has({0x0018, 0x1115}));
    EXPECT_FALSE(header.number({0x0018, 0x1115}));
    EXPECT_EQ(header.integer({0x0018, 0x1150}), 1) << "not allowed, and harmless";
}

// Implicit VR: the dictionary knows, also private elements by their creator.
TEST(Dataset, ImplicitElements) {
    const TemporaryFolder folder;
    const auto element = [](Tag tag, const std::string& value) {
        return bytesOf(tag.group, 2) + bytesOf(tag.element, 2) + bytesOf(value.size(), 4) + value;
    };
    const std::string item = element(tag::kRescaleSlope, "2 ");
    const auto file = [&](int sign) {
        return preamble(kImplicit) + element(tag::kSopClassUid, "1.2 ") +
               element({0x0019, 0x0010}, "SIEMENS MR HEADER ") + element({0x0019, 0x100C}, "800 ") +
               element({0x0021, 0x0010}, "UNHEARD OF") + element({0x0021, 0x1001}, "legible ") +
               element({0x0021, 0x1002}, std::string("\x01\x02\x03\x04", 4)) +
               element(tag::kRows, bytesOf(300, 2)) + element(tag::kPixelRepresentation, bytesOf(sign, 2)) +
               element(tag::kPixelPaddingValue, bytesOf(0xF830, 2)) +
               element({0x0028, 0x9145}, bytesOf(0xE000FFFE, 4) + bytesOf(item.size(), 4) + item);
    };
    const Dataset header = headerOf(folder, file(1));
    EXPECT_EQ(header.integer(tag::kRows), 300);
    EXPECT_EQ(header.integer({0x0019, 0x100C}), 800) << "b-value";
    EXPECT_EQ(header.text({0x0021, 0x1001}), "legible");
    EXPECT_FALSE(header.text({0x0021, 0x1002}));
    EXPECT_EQ(header.integer(tag::kPixelPaddingValue), -2000);
    EXPECT_EQ(header.word(tag::kPixelPaddingValue), 0xF830);
    EXPECT_EQ(header.items({0x0028, 0x9145}).at(0).number(tag::kRescaleSlope), 2);
    EXPECT_EQ(headerOf(folder, file(0)).integer(tag::kPixelPaddingValue), 0xF830);
}

// What archives make that know no functional groups.
TEST(Dataset, SequencesOfUnknownVr) {
    const TemporaryFolder folder;
    const auto file = [&](const std::string& position) {
        const std::string inner = kItem + bytesOf(position.size(), 4) + position;
        return preamble(kExplicit) + sopClass() +
               longElement(kPlanePosition, "UN", static_cast<std::uint32_t>(inner.size())) + inner;
    };
    const std::string implicit = bytesOf(0x00320020, 4) + bytesOf(6, 4) + "1\\2\\3 ";
    const std::string explicitOne = shortElement(tag::kImagePositionPatient, "DS", "1\\2\\3");
    for (const std::string& position : {implicit, explicitOne}) {
        const Dataset header = headerOf(folder, file(position));
        ASSERT_EQ(header.items(kPlanePosition).size(), 1u);
        EXPECT_EQ(header.items(kPlanePosition)[0].allNumbers(tag::kImagePositionPatient), (Numbers{1, 2, 3}));
    }
}

TEST(Dataset, TransferSyntaxThatIsNotTheOneUsed) {
    const TemporaryFolder folder;
    const Dataset header = headerOf(folder, preamble(kImplicit) + sopClass());
    EXPECT_EQ(header.text(tag::kModality), "CT");
    const std::string implicit =
        bytesOf(0x00160008, 4) + bytesOf(4, 4) + "1.2 " + bytesOf(0x00600008, 4) + bytesOf(2, 4) + "MR";
    EXPECT_EQ(headerOf(folder, preamble(kExplicit) + implicit).text(tag::kModality), "MR");
}

TEST(Dataset, CopiesShareTheFileAndOutliveIt) {
    const TemporaryFolder folder;
    std::vector<Dataset> items;
    {
        const Dataset header = headerOf(
            folder, preamble(kExplicit) + sopClass() +
                        sequence(kPlanePosition, {shortElement(tag::kInstanceNumber, "IS", "5"), ""}));
        items = header.items(kPlanePosition);
    }
    fs::remove(folder / "f");
    const Dataset copy = items.at(0);
    items.clear();
    EXPECT_EQ(copy.integer(tag::kInstanceNumber), 5);
    EXPECT_EQ(copy.transferSyntaxUid(), kExplicit);
}

TEST(Dataset, LargeValuesAreNotKept) {
    const TemporaryFolder folder;
    const std::uint32_t size = 300 << 10;
    const Dataset header =
        headerOf(folder, preamble(kExplicit) + sopClass() + longElement({0x0009, 0x1001}, "UT", size) +
                             std::string(size, 'x') + shortElement(tag::kInstanceNumber, "IS", "5"));
    EXPECT_TRUE(header.has({0x0009, 0x1001}));
    EXPECT_FALSE(header.text({0x0009, 0x1001}));
    EXPECT_EQ(header.integer(tag::kInstanceNumber), 5);
}

TEST(Dataset, FilesThatAreElsewhere) {
    for (const int error : {ENODATA, EREMOTEIO, ENXIO, ESTALE, ETIMEDOUT, EHOSTDOWN})
        EXPECT_EQ(stateOfFailure(error), FileState::offline) << error;
    EXPECT_EQ(stateOfFailure(EIO), FileState::mediumError);
    EXPECT_EQ(stateOfFailure(ENAMETOOLONG), FileState::pathTooLong);
    for (const int error : {EACCES, ENOENT, EPERM, EISDIR, EINVAL, EMFILE, ELOOP, 0})
        EXPECT_EQ(stateOfFailure(error), FileState::unreadable) << error;
    const TemporaryFolder folder;
    EXPECT_EQ(readHeader(folder / "missing").state, FileState::unreadable);
    EXPECT_EQ(readHeader(folder.path()).state, FileState::unreadable);
}

TEST(Dataset, TagsByKeyword) {
    EXPECT_EQ(tagOfKeyword("SliceThickness"), (Tag{0x0018, 0x0050}));
    EXPECT_EQ(tagOfKeyword("EffectiveEchoTime"), (Tag{0x0018, 0x9082}));
    EXPECT_EQ(tagOfKeyword("DiffusionBValue"), (Tag{0x0018, 0x9087}));
    EXPECT_FALSE(tagOfKeyword("NoSuchThing"));
    EXPECT_FALSE(tagOfKeyword(""));
}

TEST(Dataset, WhereThePixelsAre) {
    const TemporaryFolder folder;
    const std::string head = preamble(kExplicit) + sopClass() + longElement(tag::kPixelData, "OW", 100);
    const auto extent = [&](std::size_t bytes) {
        std::ofstream(folder / "f", std::ios::binary) << head << std::string(bytes, '\1');
        const HeaderFile read = readHeader(folder / "f");
        EXPECT_EQ(read.state, bytes < 100 ? FileState::truncated : FileState::complete);
        EXPECT_TRUE(read.header && read.header->has(tag::kPixelData));
        return read.pixels.value_or(PixelDataExtent{});
    };
    EXPECT_EQ(extent(100).bytesPresent, 100u);
    EXPECT_EQ(extent(60).bytesPresent, 60u);
    EXPECT_EQ(extent(0).bytesPresent, 0u);
    EXPECT_EQ(extent(60).bytesClaimed, 100u);
    EXPECT_EQ(extent(60).offset, head.size());
    EXPECT_EQ(extent(60).tag, tag::kPixelData);
    EXPECT_FALSE(extent(60).encapsulated);
}

}  // namespace
}  // namespace macula::dicom::test
