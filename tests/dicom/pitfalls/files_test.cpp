// D16 objects that are no images, D17 how files lie about, D18 damage, D19 transfer syntaxes.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "../bytes.h"
#include "../edit.h"
#include "opened.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

using D16OtherObjects = Pitfall;
using D17FileLayout = Pitfall;
using D18Damage = Pitfall;
using D19TransferSyntaxes = Pitfall;

const std::vector<Shell> kShells{
    {UID_BasicTextSRStorage, "SR", "2.25.31", "2.25.41", {}},
    {UID_XRayRadiationDoseSRStorage, "SR", "2.25.32", "2.25.42", {}},
    {UID_GrayscaleSoftcopyPresentationStateStorage, "PR", "2.25.33", "2.25.43", {}},
    {UID_KeyObjectSelectionDocumentStorage, "KO", "2.25.34", "2.25.44", {}},
    {UID_RTStructureSetStorage, "RTSTRUCT", "2.25.35", "2.25.45", {}},
    {UID_EncapsulatedPDFStorage, "DOC", "2.25.36", "2.25.46", {}},
    {UID_RawDataStorage, "MR", "2.25.37", "2.25.47", {}},
};

TEST_F(D16OtherObjects, AreListedBesideImages) {
    writeFiles(folder.path(), series);
    for (const Shell& shell : kShells) writeShell(folder / shell.sopInstanceUid, shell);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_TRUE(opened.scan().skipped.empty());
    std::vector<std::string> classes;
    for (const OtherObject& other : opened.others()) {
        classes.push_back(other.sopClassUid);
        EXPECT_FALSE(other.file.empty());
    }
    EXPECT_EQ(classes.size(), kShells.size());
    for (const Shell& shell : kShells)
        EXPECT_EQ(std::count(classes.begin(), classes.end(), shell.sopClassUid), 1) << shell.modality;
}

// A report in the series of the images it is about is still no image of it.
TEST_F(D16OtherObjects, InTheSameSeries) {
    writeFiles(folder.path(), series);
    Shell shell = kShells[0];
    shell.seriesUid = series.seriesUid;
    writeShell(folder / "report", shell);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_EQ(opened.others().size(), 1u);
}

TEST_F(D16OtherObjects, AloneAreNoError) {
    writeShell(folder / "report", kShells[0]);
    const Opened opened = open();
    EXPECT_EQ(opened.others().size(), 1u);
    EXPECT_TRUE(opened.stacks().empty());
    EXPECT_EQ(bestVolume(opened.scan()).stack, nullptr);
}

TEST_F(D17FileLayout, NothingInTheNameAndNothingInFront) {
    const auto files = writeFiles(folder.path(), series);
    for (std::size_t n = 0; n < files.size(); ++n) {
        if (n % 2) saveBare(files[n]);
        const char* endings[] = {"", ".txt", ".jpg", ".7", ".DCM"};
        fs::rename(files[n], files[n].string() + endings[n % 5]);
    }
    // What finder, camera and music player leave.
    std::ofstream(folder / "._IM1", std::ios::binary)
        << std::string("\0\5\x16\7\0\2\0\0", 8) << std::string(300, '\0');
    std::ofstream(folder / ".DS_Store") << "Bud1";
    std::ofstream(folder / "Thumbs.db") << "thumbs";
    std::ofstream(folder / "empty");
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_TRUE(opened.scan().skipped.empty());
}

// `._` files are refused whatever they hold: those of a copied disc hold half of a DICOM file.
TEST_F(D17FileLayout, AppleDoubleIsNotRead) {
    const auto files = writeFiles(folder.path(), series);
    fs::copy_file(files[0], folder / "._copy");
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_FALSE(opened.says(key::kDuplicateFiles)) << opened.keys();
}

TEST_F(D17FileLayout, NamesInAnyAlphabet) {
    const auto files = writeFiles(folder.path(), series);
    const fs::path deep = folder / "Ärztekammer" / "画像 データ" / "снимки\tи\nфото" / "a'b\"c;$(d)";
    fs::create_directories(deep);
    for (const fs::path& file : files) fs::rename(file, deep / ("ñ" + file.filename().string() + "😀"));
    expectOnlyVolume(open(), series);
}

TEST_F(D17FileLayout, NamesThatAreNoUtf8) {
    const auto files = writeFiles(folder.path(), series);
    const fs::path latin = folder / "M\xFCller";
    fs::create_directories(latin);
    for (const fs::path& file : files) fs::rename(file, latin / (file.filename().string() + "\xE4"));
    expectOnlyVolume(open(), series);
}

TEST_F(D17FileLayout, LinksThatLoopOrLeadOut) {
    const TemporaryFolder outside;
    SyntheticSeries secret = series;
    secret.seriesUid = "2.25.666";
    const auto files = writeFiles(outside.path(), secret);
    writeFiles(folder / "images", series);
    fs::create_directory_symlink(folder.path(), folder / "images/loop");
    fs::create_directory_symlink("loop2", folder / "loop2");
    fs::create_directory_symlink(outside.path(), folder / "out");
    fs::create_symlink(files[0], folder / "images/link to a file outside");
    fs::create_symlink("nowhere", folder / "broken");
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_EQ(opened.frames(), 12u);
    EXPECT_TRUE(opened.says(key::kLinksOutside)) << opened.keys();
}

// Zips are not opened; where one may hold the rest of a study, that is told. Programs on discs are zips too.
TEST_F(D17FileLayout, ArchivesAreToldOf) {
    writeFiles(folder.path(), series);
    const std::string zip = "PK\x03\x04" + std::string(200, 'x');
    std::ofstream(folder / "viewer.jar", std::ios::binary) << zip;
    std::ofstream(folder / "letter.zip", std::ios::binary) << "no archive";
    std::ofstream(folder / "empty.zip");
    EXPECT_FALSE(open().says(key::kArchives));
    std::ofstream(folder / "Rest.ZIP", std::ios::binary) << zip;
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_TRUE(opened.says(key::kArchives)) << opened.keys();
    EXPECT_EQ(opened.scan().archives, 1u);
    EXPECT_EQ(opened.scan().notDicom, 4u);
}

TEST_F(D17FileLayout, DirectoryInTheWrongCase) {
    const auto files = writeFiles(folder / "images", series);
    std::vector<std::string> ids;
    for (const fs::path& file : files) {
        std::string name = file.filename();
        std::transform(name.begin(), name.end(), name.begin(),
                       [](unsigned char c) { return std::toupper(c); });
        ids.push_back("IMAGES\\" + name);
    }
    writeDirectory(folder / "dicomdir", ids);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_FALSE(opened.says(key::kDicomdirMissingFiles)) << opened.keys();
    EXPECT_TRUE(opened.scan().skipped.empty());
}

TEST_F(D17FileLayout, DirectoryThatListsMoreAndLessThanIsThere) {
    const auto files = writeFiles(folder / "IMAGES", series);
    std::vector<std::string> ids{"IMAGES\\GONE1", "ELSEWHERE\\GONE2"};
    for (std::size_t n = 0; n < 6; ++n) ids.push_back("IMAGES\\" + files[n].filename().string());
    writeDirectory(folder / "DICOMDIR", ids);
    const Opened opened = open();
    expectOnlyVolume(opened, series);  // all twelve: the files are trusted
    const Message* told = opened.find(key::kDicomdirMissingFiles);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_EQ(numberArgument(*told, "count"), 2.0);
}

TEST_F(D17FileLayout, DirectoryThatLeadsOut) {
    const fs::path root = folder / "chosen";
    writeFiles(root / "IMAGES", series);
    SyntheticSeries secret = series;
    secret.seriesUid = "2.25.666";
    const auto outside = writeFiles(folder / "secret", secret);
    fs::create_directory_symlink(folder / "secret", root / "WAYOUT");
    std::vector<std::string> ids;
    for (const fs::path& file : outside) {
        ids.push_back("..\\secret\\" + file.filename().string());
        ids.push_back("IMAGES\\..\\..\\secret\\" + file.filename().string());
        ids.push_back("WAYOUT\\" + file.filename().string());
        ids.push_back(file.string());
    }
    writeDirectory(root / "DICOMDIR", ids);
    const Opened opened(root);
    expectOnlyVolume(opened, series);
    EXPECT_EQ(opened.series().size(), 1u);
    EXPECT_TRUE(opened.says(key::kDicomdirOutside)) << opened.keys();
    // Chosen itself, it leads nowhere else.
    const Opened byFile(root / "DICOMDIR");
    for (const Series* s : byFile.series()) EXPECT_NE(s->seriesInstanceUid, "2.25.666");
}

TEST_F(D17FileLayout, BrokenDirectory) {
    writeFiles(folder / "IMAGES", series);
    writeDirectory(folder / "DICOMDIR", {"IMAGES\\A", "IMAGES\\B"});
    fs::resize_file(folder / "DICOMDIR", fs::file_size(folder / "DICOMDIR") - 100);
    expectOnlyVolume(open(), series);
}

TEST_F(D18Damage, TruncatedSliceIsAGapAndSaid) {
    const auto files = writeFiles(folder.path(), series);
    truncate(files[4], 30);
    const Opened opened = open();
    EXPECT_TRUE(opened.says(key::kTruncatedFile)) << opened.keys();
    EXPECT_TRUE(opened.says(key::kMissingSlices)) << opened.keys();
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectVolumeOf(*volume, series);
    EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{4, 4}}));
}

// The magic of DICOM in front makes no patient of what follows.
TEST_F(D18Damage, GarbageWithTheMagicIsDamageAndNoPatient) {
    writeFiles(folder.path(), series);
    const std::string begin = std::string(128, '\0') + "DICM";
    std::ofstream(folder / "a.dcm", std::ios::binary) << begin;
    std::string text = begin;
    for (int i = 0; i < 50; ++i) text += "no DICOM at all, just some text ";
    std::ofstream(folder / "b.dcm", std::ios::binary) << text;
    std::string noise = begin;
    std::uint32_t state = 1;
    for (int i = 0; i < 3000; ++i)
        noise += static_cast<char>((state = state * 1664525u + 1013904223u) >> 24u);
    std::ofstream(folder / "c.dcm", std::ios::binary) << noise;
    Progress progress;
    const auto scan = scanFolder(folder.path(), progress);
    ASSERT_TRUE(scan.ok());
    EXPECT_EQ(scan->patients, 1);
    EXPECT_EQ(scan->studies.size(), 1u);
    EXPECT_EQ(scan->skipped.size(), 3u);
    EXPECT_EQ(scan->objectCount(), 0u);
}

// Cut at any place: no crash, the rest of the series is a volume, and a slice that is not whole is not in it.
TEST_F(D18Damage, CutAnywhere) {
    series.size = {4, 4, 5};
    const auto files = writeFiles(folder.path(), series);
    const auto whole = fs::file_size(files[2]);
    const TemporaryFolder aside;
    fs::copy_file(files[2], aside / "whole");
    for (std::uintmax_t size = 0; size < whole; size += 23) {
        SCOPED_TRACE(size);
        fs::copy_file(aside / "whole", files[2], fs::copy_options::overwrite_existing);
        fs::resize_file(files[2], size);
        const Opened opened = open();
        const auto volume = opened.onlyVolume();
        ASSERT_NE(volume, nullptr);
        expectVolumeOf(*volume, series);
        EXPECT_EQ(volume->provenance().interpolatedSlices, (std::vector<SliceRange>{{2, 2}}));
        EXPECT_EQ(opened.scan().skipped.size() + opened.scan().notDicom, 1u);
    }
}

// Elements in the way of a strict reader (PS3.5 7.1.1 wants even lengths; 6.2.2, UN of undefined length).
TEST_F(D18Damage, OddAndUndefinedLengths) {
    const std::string odd = bytesOf(0x00110010, 4) + "LO" + bytesOf(7, 2) + "MACULA!" +
                            bytesOf(0x10010011, 4) + "SH" + bytesOf(3, 2) + "odd";
    const std::string unknown = longElement({0x0013, 0x1001}, "UN", kUndefined) + kItem +
                                bytesOf(kUndefined, 4) + bytesOf(0x10020013, 4) + bytesOf(4, 4) + "even" +
                                kItemEnd + kSequenceEnd;
    const std::string sequence = longElement({0x0015, 0x1001}, "SQ", kUndefined) + kItem + bytesOf(0, 4) +
                                 kItem + bytesOf(kUndefined, 4) + kItemEnd + kSequenceEnd;
    const auto files = writeFiles(folder.path(), series);
    int n = 0;
    for (const fs::path& file : files) {
        std::ifstream in(file, std::ios::binary);
        std::string bytes((std::istreambuf_iterator<char>(in)), {});
        // Before group 0018, which every file has.
        const std::size_t at = bytes.find(std::string("\x18\0\x50\0", 4) + "DS");
        ASSERT_NE(at, std::string::npos);
        // Groups 11 to 15 stand between 10 and 18.
        const std::string added = n % 3 == 0 ? odd : n % 3 == 1 ? unknown : sequence;
        bytes.insert(at, added);
        std::ofstream(file, std::ios::binary) << bytes;
        ++n;
    }
    const Opened opened = open();
    EXPECT_TRUE(opened.scan().skipped.empty()) << opened.keys();
    expectOnlyVolume(opened, series);
}

// The file meta information says explicit, the data set is implicit, as after a careless export.
TEST_F(D18Damage, WrongTransferSyntax) {
    const auto replaceSyntax = [](const fs::path& file, const std::string& from, const std::string& to) {
        std::ifstream in(file, std::ios::binary);
        std::string bytes((std::istreambuf_iterator<char>(in)), {});
        const std::size_t at = bytes.find(from + '\0');
        ASSERT_NE(at, std::string::npos);
        ASSERT_EQ((from.size() + 1) / 2, (to.size() + 1) / 2) << "the element's length stays";
        bytes.replace(at, from.size() + 1, to + std::string(from.size() + 1 - to.size(), '\0'));
        std::ofstream(file, std::ios::binary) << bytes;
    };
    // 1.2.840.10008.1.2.1 and 1.2.840.10008.1.2.2 have one length.
    const auto files = writeFiles(folder.path(), series);
    replaceSyntax(files[3], "1.2.840.10008.1.2.1", "1.2.840.10008.1.2.2");
    const Opened opened = open();
    // Either it was seen through, or the slice is a gap; never false values.
    const auto volume = opened.onlyVolume();
    ASSERT_NE(volume, nullptr);
    expectVolumeOf(*volume, series);
}

TEST_F(D19TransferSyntaxes, UnknownOnesAreNamed) {
    const auto files = writeFiles(folder.path(), series);
    for (const fs::path& file : files) {
        std::ifstream in(file, std::ios::binary);
        std::string bytes((std::istreambuf_iterator<char>(in)), {});
        const std::size_t at = bytes.find("1.2.840.10008.1.2.1");
        ASSERT_NE(at, std::string::npos);
        bytes.replace(at, 19, "1.2.3.4.5.6.7.8.9.0");
        std::ofstream(file, std::ios::binary) << bytes;
    }
    const Opened opened = open();
    const Message* told = opened.find(key::kUnsupportedTransferSyntax);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_NE(told->sentence.english().find("1.2.3.4.5.6.7.8.9.0"), std::string::npos) << told->sentence;
    EXPECT_TRUE(opened.volumes().empty());
}

TEST_F(D19TransferSyntaxes, AnotherOneInEverySlice) {
    auto slices = slicesOf(series);
    const char* syntaxes[] = {"1.2.840.10008.1.2", "1.2.840.10008.1.2.1", "1.2.840.10008.1.2.2",
                              "1.2.840.10008.1.2.1.99", "1.2.840.10008.1.2.5"};
    for (std::size_t n = 0; n < slices.size(); ++n) {
        series.transferSyntaxUid = syntaxes[n % 5];
        writeFiles(folder.path(), series, {slices[n]});
    }
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    ASSERT_EQ(opened.series().size(), 1u);
    EXPECT_EQ(opened.series()[0]->transferSyntaxUids.size(), 5u);
}

}  // namespace
}  // namespace macula::dicom::test
