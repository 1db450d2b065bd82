// Two patients are never one volume, and what could not be read is told of.
#include "dicom/read/patient.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "edit.h"
#include "support.h"
#include "synthetic.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

TEST(Patient, NamesThatAreOne) {
    EXPECT_EQ(normalisedName("DOE^JOHN^^^"), "doe^john");
    EXPECT_EQ(normalisedName("Doe ^ John  "), "doe^john");
    EXPECT_EQ(normalisedName("Wang^XiaoDong=王^小東="), "wang^xiaodong");
    EXPECT_EQ(normalisedName("=王^小東"), "王^小東");
    EXPECT_EQ(normalisedName("  ^^"), "");
    EXPECT_NE(normalisedName("DOE^JOHN"), normalisedName("DOE^JANE"));
    EXPECT_NE(normalisedName("DOE^JOHN"), normalisedName("DOEJOHN"));
}

// All slices share every UID; only what the second half says of the patient differs.
TEST(Patient, EachDifferenceSeparates) {
    struct Case {
        Tag tag;
        std::string first, second;
    };
    const std::vector<Case> cases{{tag::kPatientName, "DOE^JOHN", "ROE^JANE"},
                                  {tag::kPatientSex, "M", "F"},
                                  {tag::kPatientBirthDate, "19500101", "19760203"},
                                  {tag::kPatientName, "DOE^JOHN", ""}};
    for (const std::string id : {"", "SAME"}) {
        for (const Case& c : cases) {
            SCOPED_TRACE(fmt::format("id '{}', '{}' and '{}'", id, c.first, c.second));
            const TemporaryFolder folder;
            const auto files = write(smallVolume(), folder.path());
            for (std::size_t k = 0; k < files.size(); ++k) {
                setText(files[k], tag::kPatientId, id);
                setText(files[k], c.tag, k < 3 ? c.first : c.second);
            }
            const auto found = scan(folder.path());
            ASSERT_TRUE(found);
            ASSERT_EQ(found->studies.size(), 2u);
            EXPECT_EQ(found->patients, 2);
            EXPECT_NE(found->studies[0].patient, found->studies[1].patient);
            for (const Study& study : found->studies) {
                ASSERT_EQ(study.series.size(), 1u);
                EXPECT_EQ(study.series[0].instances, 3u);
                EXPECT_TRUE(hasMessage(study.series[0], key::kSeveralPatients));
                EXPECT_FALSE(study.series[0].assumptions.empty());
            }
            const std::string uid = found->studies[0].series[0].seriesInstanceUid;
            EXPECT_EQ(findSeries(*found, uid), nullptr);
            EXPECT_EQ(findAllSeries(*found, uid).size(), 2u);
            const ChosenStack best = bestVolume(*found);
            ASSERT_TRUE(best);
            EXPECT_NE(best.why.english().find("of 2 patients in this folder"), std::string::npos) << best.why;
        }
    }
}

// A program has written the same words for both.
TEST(Patient, TwoStudiesOfNobodyAreOfTwo) {
    const auto studiesOf = [](const char* name, const char* id, bool isOneStudy) {
        const TemporaryFolder folder;
        for (int n = 0; n < 2; ++n) {
            SyntheticSeries series;
            series.patientName = name;
            series.patientId = id;
            series.studyUid = isOneStudy ? "2.25.7000" : fmt::format("2.25.700{}", n);
            series.seriesUid = fmt::format("2.25.800{}", n);
            writeFiles(folder / std::to_string(n), series);
        }
        auto found = scan(folder.path());
        EXPECT_TRUE(found);
        return *std::move(found);
    };
    for (const auto& [name, id] :
         {std::pair("ANONYMOUS", "ANONYMOUS"), {"Patient^Anonymous", "0000"}, {"", ""}}) {
        SCOPED_TRACE(name);
        const Scan two = studiesOf(name, id, false);
        ASSERT_EQ(two.studies.size(), 2u);
        EXPECT_EQ(two.patients, 2);
        EXPECT_NE(two.studies[0].patient, two.studies[1].patient);
        EXPECT_EQ(patientsText(two), "up to 2 patients");
        EXPECT_TRUE(mayBeOnePatient(two, 0, 1));
        EXPECT_NE(bestVolume(two).why.english().find("of up to 2 patients in this folder"),
                  std::string::npos);
        const Scan one = studiesOf(name, id, true);
        ASSERT_EQ(one.studies.size(), 1u) << "a study is of one patient";
        EXPECT_EQ(one.patients, 1);
        EXPECT_EQ(one.studies[0].series.size(), 2u);
    }
    // Either of both names somebody.
    for (const auto& [name, id] : {std::pair("ANONYMOUS", "LIDC-IDRI-0001"), {"DOE^JANE", "0000"}}) {
        const Scan one = studiesOf(name, id, false);
        ASSERT_EQ(one.studies.size(), 2u);
        EXPECT_EQ(one.patients, 1) << name;
        EXPECT_EQ(patientsText(one), "1 patient");
    }
}

TEST(Patient, SpellingDoesNotSeparate) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    for (std::size_t k = 0; k < files.size(); ++k)
        setText(files[k], tag::kPatientName, k % 2 ? "DOE^JOHN^^^" : "Doe^John");
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->patients, 1);
    const Series& series = found->studies.at(0).series.at(0);
    EXPECT_EQ(series.instances, 6u);
    EXPECT_EQ(findSeries(*found, series.seriesInstanceUid), &series);
}

// Deeper than a path may be long: a folder that nobody can list by its path, not even root.
void makeUnreachableFolder(const fs::path& at) {
    int folder = open(at.c_str(), O_RDONLY | O_DIRECTORY);
    const std::string name(200, 'x');
    for (int depth = 0; depth < 30 && folder >= 0; ++depth) {
        mkdirat(folder, name.c_str(), 0700);
        const int next = openat(folder, name.c_str(), O_RDONLY | O_DIRECTORY);
        close(folder);
        folder = next;
    }
    ASSERT_GE(folder, 0);
    close(folder);
}

TEST(Patient, UnreadableFolderStopsNothingAndIsToldOf) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder / "m");
    for (const char* name : {"a", "z"}) {
        fs::create_directories(folder / name);
        makeUnreachableFolder(folder / name);
    }
    fs::create_directories(folder / "zz");
    fs::rename(files[5], folder / "zz/last");
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    const Series& series = found->studies.at(0).series.at(0);
    EXPECT_EQ(series.instances, 6u);
    EXPECT_TRUE(hasMessage(series, key::kUnreadableFolder)) << keysOf(series);
    EXPECT_TRUE(series.canBeVolume()) << keysOf(series);
    EXPECT_EQ(series.assumptions.size(), 1u);
    ASSERT_EQ(found->skipped.size(), 2u);
    for (const SkippedFile& skipped : found->skipped) {
        EXPECT_EQ(skipped.message.key, key::kPathTooLong) << "which no permission changes";
        EXPECT_EQ(skipped.message.severity, Severity::warning);
    }
    EXPECT_LT(found->skipped[0].file, found->skipped[1].file);
}

TEST(Patient, OnlyAnUnreadableFolder) {
    const TemporaryFolder folder;
    makeUnreachableFolder(folder.path());
    Progress progress;
    const auto found = scanFolder(folder.path(), progress);
    ASSERT_FALSE(found);
    EXPECT_NE(found.error().message.english().find("sub-folders cannot be read"), std::string::npos);
    EXPECT_NE(found.error().message.english().find("longer than this system can open"), std::string::npos);
    EXPECT_EQ(found.error().hint.english().find("permissions"), std::string::npos) << found.error().hint;
}

// Many copies of one file: each is read once, and a cancellation is noticed while they are.
TEST(Patient, ComparingCopiesCanBeCancelled) {
    const TemporaryFolder folder;
    const auto files = write(smallVolume(), folder.path());
    for (int copy = 0; copy < 40; ++copy) fs::copy_file(files[2], folder / fmt::format("copy{:02}", copy));
    setPixels(folder / "copy07", std::vector<std::uint16_t>(20, 77));
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->studies.at(0).series.at(0).instances, 7u);

    const CancelToken token;
    bool compared = false;
    Progress progress(
        [&](const ProgressUpdate& update) {
            if (!update.stage.english().starts_with("Comparing")) return;
            compared = true;
            token.cancel();
        },
        token);
    const auto cancelled = scanFolder(folder.path(), progress);
    EXPECT_TRUE(compared);
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace macula::dicom::test
