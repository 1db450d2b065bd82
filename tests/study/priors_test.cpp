// Which other studies are offered, and fetched, to compare a patient's study with.
#include "study/archive/priors.h"

#include <gtest/gtest.h>

namespace macula::study {
namespace {

Identity anna() {
    return {.patientName = "MEIER^ANNA",
            .patientId = "P1",
            .birthDate = "19600229",
            .sex = "F",
            .studyDate = "20260301",
            .studyDescription = {},
            .series = {},
            .isOfNobody = false,
            .studyInstanceUid = "2.25.1"};
}

ListedStudy prior(const std::string& uid, const std::string& date, const std::string& modality = "CT") {
    ListedStudy listed;
    listed.study.studyInstanceUid = uid;
    listed.study.date = date;
    listed.study.patientName = "MEIER^ANNA";
    listed.study.patientId = "P1";
    listed.study.patientBirthDate = "19600229";
    listed.study.patientSex = "F";
    listed.study.modalities = {modality};
    listed.archive = "Hospital";
    return listed;
}

std::vector<std::string> uidsOf(const std::vector<ListedStudy>& studies) {
    std::vector<std::string> uids;
    for (const ListedStudy& each : studies) uids.push_back(each.study.studyInstanceUid);
    return uids;
}

using Uids = std::vector<std::string>;

TEST(Priors, AreSearchedByIdElseByNameAndBirthDateElseNotAtAll) {
    EXPECT_EQ(queryForPriors(anna())->patientId, "P1");
    EXPECT_TRUE(queryForPriors(anna())->patientName.empty()) << "spelt in two ways in two studies";
    Identity patient = anna();
    patient.patientId.clear();
    EXPECT_EQ(queryForPriors(patient)->patientName, "MEIER^ANNA");
    EXPECT_EQ(queryForPriors(patient)->patientBirthDate, "19600229");
    patient.birthDate.clear();
    EXPECT_FALSE(queryForPriors(patient)) << "there are many of this name";
    patient = anna();
    patient.patientId = "ANONYMOUS";
    patient.patientName = "ANONYMOUS";
    EXPECT_FALSE(queryForPriors(patient)) << "all anonymous patients would be one";
}

TEST(Priors, AreOfThePatientLatestFirstAndNotTheStudyItself) {
    ListedStudy other = prior("2.25.4", "20250101");
    other.study.patientBirthDate = "19700101";
    ListedStudy unknownBirth = prior("2.25.5", "20200101");
    unknownBirth.study.patientBirthDate.clear();
    ListedStudy noId = prior("2.25.6", "20190101");
    noId.study.patientId.clear();
    const Listing listing{
        .studies = {prior("2.25.1", "20260301"), prior("2.25.2", "20240101"), other,
                    prior("2.25.3", "20250615"), unknownBirth, noId, prior("2.25.3", "20250615")},
        .silent = {}};
    EXPECT_EQ(uidsOf(priorsOf(anna(), listing)), (Uids{"2.25.3", "2.25.2", "2.25.5"}));
}

TEST(Priors, OfNobodyInParticularAreNone) {
    Identity nameless;
    nameless.studyInstanceUid = "2.25.1";
    ListedStudy listed;
    listed.study.studyInstanceUid = "2.25.2";
    EXPECT_TRUE(priorsOf(nameless, {.studies = {listed}, .silent = {}}).empty());
}

TEST(Priors, ToFetchAreEarlierOfTheSameKindRecentFewAndNotHere) {
    const PriorRule rule{.most = 2, .years = 5};
    const std::vector<std::string> ct{"CT", "SR"};
    const auto fetched = [&](const std::vector<ListedStudy>& priors) {
        return uidsOf(priorsToFetch(rule, anna(), ct, priors));
    };
    EXPECT_EQ(fetched({prior("2.25.9", "20260302"), prior("2.25.8", "20260301"), prior("2.25.7", "20260228"),
                       prior("2.25.6", "20250101", "MR"), prior("2.25.5", "20240101"),
                       prior("2.25.4", "20230101")}),
              (Uids{"2.25.7", "2.25.5"}));
    EXPECT_EQ(fetched({prior("2.25.2", "20210301")}), (Uids{"2.25.2"})) << "five years to the day";
    EXPECT_EQ(fetched({prior("2.25.2", "20210228")}), Uids{});
    EXPECT_EQ(fetched({prior("2.25.2", "")}), Uids{});
    ListedStudy here = prior("2.25.2", "20250101");
    here.folder = "/somewhere";
    here.isWhole = true;
    EXPECT_EQ(fetched({here, prior("2.25.3", "20240101"), prior("2.25.4", "20230101")}), (Uids{"2.25.3"}))
        << "one of the two is here";
    here.isWhole = false;
    EXPECT_EQ(fetched({here}), (Uids{"2.25.2"})) << "only a part of it";
    ListedStudy nowhere = prior("2.25.2", "20250101");
    nowhere.archive.clear();
    EXPECT_EQ(fetched({nowhere}), Uids{});
}

TEST(Priors, OfAStudyWithoutADayAreNotFetched) {
    Identity patient = anna();
    for (const char* day : {"", "2026", "tomorrow", "2026-03-01"}) {
        patient.studyDate = day;
        EXPECT_TRUE(priorsToFetch({}, patient, {"CT"}, {prior("2.25.2", "20250101")}).empty()) << day;
    }
}

}  // namespace
}  // namespace macula::study
