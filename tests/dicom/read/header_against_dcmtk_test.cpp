// Headers are read by our own walk. Here every element of every real file is read by DCMTK as well.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cmath>

#include "dicom/read/folder.h"
#include "dicom/read/values.h"
#include "support.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

struct Comparison {
    std::size_t values = 0;
    std::size_t numbers = 0;
    std::size_t items = 0;
};

Tag tagOf(DcmElement& element) {
    return {element.getGTag(), element.getETag()};
}

void compareItem(DcmItem& theirs, const Dataset& ours, Comparison& done);

void compareElement(DcmElement& theirs, const Dataset& ours, Comparison& done) {
    const Tag tag = tagOf(theirs);
    SCOPED_TRACE(theirs.getTag().toString().c_str());
    if (theirs.ident() == EVR_SQ) {
        auto& sequence = dynamic_cast<DcmSequenceOfItems&>(theirs);
        const auto items = ours.items(tag);
        ASSERT_EQ(items.size(), sequence.card());
        for (unsigned long i = 0; i < sequence.card(); ++i) compareItem(*sequence.getItem(i), items[i], done);
        return;
    }
    OFString text;
    const std::string vr = DcmVR(theirs.getVR()).getVRName();
    // To DCMTK, ^^^^ is an empty name.
    EXPECT_TRUE(vr == "PN" || ours.has(tag) == !theirs.isEmpty());
    const bool ofBytes = vr[0] == 'O' || vr[0] == '?' || vr == "UN" || vr == "ox" || vr == "px" || vr == "lt";
    if (ofBytes || theirs.isEmpty() || theirs.getOFStringArray(text).bad()) return;
    const std::string_view expected = trimmed({text.c_str(), text.size()});
    constexpr std::string_view kNumbers = "DS IS US SS UL SL FL FD ";
    if (kNumbers.find(vr + ' ') != std::string_view::npos) {
        std::vector<double> numbers;
        for (const std::string_view part : splitAtBackslash(expected)) {
            if (const auto number = finiteNumber(part)) numbers.push_back(*number);
        }
        if (numbers.size() != splitAtBackslash(expected).size()) numbers.clear();  // some are empty
        ++done.numbers;
        const auto read = ours.allNumbers(tag);
        ASSERT_EQ(read.size(), numbers.size()) << expected;
        for (std::size_t i = 0; i < read.size(); ++i)  // DCMTK writes 9 digits of a float
            EXPECT_NEAR(read[i], numbers[i], 1e-8 * std::abs(numbers[i]));
        return;
    }
    for (const char c : expected) {
        if (static_cast<unsigned char>(c) >= 0x80 || c == '\x1B')
            return;  // character_set_test.cpp's business
    }
    ++done.values;
    std::string joined;
    for (const std::string& part : ours.texts(tag)) joined += (joined.empty() ? "" : "\\") + part;
    std::string expectedJoined;
    for (const std::string_view part : splitAtBackslash(expected))
        expectedJoined += (expectedJoined.empty() ? "" : "\\") + std::string(part);
    const auto upper = [](std::string s) {
        for (char& c : s) c = c >= 'a' && c <= 'f' ? static_cast<char>(c - 'a' + 'A') : c;
        return s;
    };
    EXPECT_EQ(vr == "AT" ? upper(joined) : joined, vr == "AT" ? upper(expectedJoined) : expectedJoined);
}

void compareItem(DcmItem& theirs, const Dataset& ours, Comparison& done) {
    ++done.items;
    for (unsigned long i = 0; i < theirs.card(); ++i) compareElement(*theirs.getElement(i), ours, done);
}

TEST(HeaderAgainstDcmtk, EveryElementOfEveryRealFile) {
    SKIP_WITHOUT_SHARED_DATA();
    silenceToolkit();
    Progress progress;
    const auto listing = listFiles(sharedData(), progress);
    ASSERT_TRUE(listing);
    Comparison done;
    std::size_t files = 0;
    for (const fs::path& file : listing->files) {
        SCOPED_TRACE(file.lexically_relative(sharedData()));
        const HeaderFile read = readHeader(file);
        DcmFileFormat format;
        const bool theirs = format
                                .loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, 4096,
                                                  ERM_autoDetect, DcmTagKey(0x7FE0, 0x0008))
                                .good();
        if (!read.header) continue;
        ASSERT_TRUE(theirs);
        ++files;
        const std::string uid = DcmXfer(format.getDataset()->getOriginalXfer()).getXferID();
        // DCMTK takes a syntax that it does not know for the one that the data set looks like, and one that
        // the pixels contradict for the right one.
        if (DcmXfer(read.header->transferSyntaxUid().c_str()).getXfer() == EXS_Unknown) continue;
        if (!read.contradictedSyntaxUid.empty()) continue;
        EXPECT_EQ(read.header->transferSyntaxUid(), uid);
        compareItem(*format.getDataset(), *read.header, done);
        if (HasFailure()) break;
    }
    EXPECT_GT(files, 500u);
    EXPECT_GT(done.values, 15000u);
    EXPECT_GT(done.numbers, 15000u);
    EXPECT_GT(done.items, 1000u);
    std::printf("%zu files, %zu items, %zu texts, %zu numbers\n", files, done.items, done.values,
                done.numbers);
}

}  // namespace
}  // namespace macula::dicom::test
