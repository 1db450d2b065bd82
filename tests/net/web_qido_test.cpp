// Answers to searches in JSON: good ones, odd ones, hostile ones; and the addresses that ask for them.
#include <gtest/gtest.h>

#include <string>

#include "net/archive/query_match.h"
#include "net/web/dicom_json.h"
#include "net/web/qido_answers.h"
#include "net/web/qido_query.h"
#include "net/web/qido_wildcards.h"
#include "net/web/stow_answer.h"

namespace macula::net {
namespace {

TEST(Qido, AStudyOfTheStandard) {
    const auto page = studiesInJson(R"([{
        "00080020": {"vr": "DA", "Value": ["20200102"]},
        "00080030": {"vr": "TM", "Value": ["101112.5"]},
        "00080050": {"vr": "SH", "Value": ["ACC1 "]},
        "00080061": {"vr": "CS", "Value": ["CT", "SR"]},
        "00080090": {"vr": "PN", "Value": [{"Alphabetic": "Ref^A"}]},
        "00081030": {"vr": "LO", "Value": ["Chest"]},
        "00100010": {"vr": "PN", "Value": [{"Phonetic": "p", "Alphabetic": "Yamada^Tarou", "Ideographic": "山田^太郎"}]},
        "00100020": {"vr": "LO", "Value": ["ID7"]},
        "00100030": {"vr": "DA", "Value": ["19700101"]},
        "00100040": {"vr": "CS", "Value": ["F"]},
        "0020000D": {"vr": "UI", "Value": ["1.2.3"]},
        "00200010": {"vr": "SH", "Value": ["S1"]},
        "00201206": {"vr": "IS", "Value": [2]},
        "00201208": {"vr": "IS", "Value": [57]}}])");
    ASSERT_TRUE(page.ok());
    ASSERT_EQ(page->found.size(), 1u);
    const FoundStudy& study = page->found.front();
    EXPECT_EQ(study.studyInstanceUid, "1.2.3");
    EXPECT_EQ(study.date, "20200102");
    EXPECT_EQ(study.time, "101112.5");
    EXPECT_EQ(study.accessionNumber, "ACC1");
    EXPECT_EQ(study.modalities, (std::vector<std::string>{"CT", "SR"}));
    EXPECT_EQ(study.referringPhysician, "Ref^A");
    EXPECT_EQ(study.description, "Chest");
    EXPECT_EQ(study.patientName, "Yamada^Tarou=山田^太郎=p");
    EXPECT_EQ(study.patientId, "ID7");
    EXPECT_EQ(study.patientBirthDate, "19700101");
    EXPECT_EQ(study.patientSex, "F");
    EXPECT_EQ(study.studyId, "S1");
    EXPECT_EQ(study.seriesCount, 2u);
    EXPECT_EQ(study.instanceCount, 57u);
}

TEST(Qido, OddTypesAreLetThrough) {
    const auto page = studiesInJson(R"([{
        "0020000d": {"Value": "1.2.3", "vr": "UI"},
        "00080061": {"vr": "CS", "Value": ["CT\\MR"]},
        "00100010": {"vr": "PN", "Value": ["Doe^J"]},
        "00100020": {"vr": "LO", "Value": [4711]},
        "00080020": null, "00080030": {"vr": "TM"}, "00080050": {"vr": "SH", "Value": [null]},
        "00081030": {"vr": "LO", "Value": {"odd": [{"00081030": 1}]}},
        "00201206": {"vr": "IS", "Value": ["3"]},
        "00201208": {"vr": "IS", "Value": [12.0]},
        "00081140": {"vr": "SQ", "Value": [{"0020000D": {"vr": "UI", "Value": ["9.9"]}}]},
        "junk": [[{"0020000D": {"vr": "UI", "Value": ["8.8"]}}]]},
        {"0020000D": "4.5"}, {"0020000D": {"vr": "UI", "Value": ["1.2.3"]}},
        {"0020000D": {"vr": "UI", "Value": ["../x"]}}, {}, 7, [], null])");
    ASSERT_TRUE(page.ok());
    ASSERT_EQ(page->found.size(), 2u);
    EXPECT_EQ(page->unusable, 2u);
    EXPECT_EQ(page->found[1].studyInstanceUid, "4.5");
    const FoundStudy& study = page->found.front();
    EXPECT_EQ(study.studyInstanceUid, "1.2.3");
    EXPECT_EQ(study.modalities, (std::vector<std::string>{"CT", "MR"}));
    EXPECT_EQ(study.patientName, "Doe^J");
    EXPECT_EQ(study.patientId, "4711");
    EXPECT_EQ(study.date, "");
    EXPECT_EQ(study.accessionNumber, "");
    EXPECT_EQ(study.seriesCount, 3u);
    EXPECT_EQ(study.instanceCount, 12u);
}

TEST(Qido, SeriesAndInstances) {
    const auto series = seriesInJson(R"([{"00080060": {"vr": "CS", "Value": ["MR"]},
        "0008103E": {"vr": "LO", "Value": ["T2"]}, "00180015": {"vr": "CS", "Value": ["HEAD"]},
        "0020000E": {"vr": "UI", "Value": ["1.5"]}, "00200011": {"vr": "IS", "Value": ["-3"]},
        "00201209": {"vr": "IS", "Value": [-1]}}])");
    ASSERT_TRUE(series.ok());
    ASSERT_EQ(series->found.size(), 1u);
    EXPECT_EQ(series->found[0].modality, "MR");
    EXPECT_EQ(series->found[0].description, "T2");
    EXPECT_EQ(series->found[0].bodyPart, "HEAD");
    EXPECT_EQ(series->found[0].number, -3);
    EXPECT_FALSE(series->found[0].instanceCount);
    const auto instances = instancesInJson(R"([{"00080016": {"vr": "UI", "Value": ["1.7"]},
        "00080018": {"vr": "UI", "Value": ["1.8"]}, "00200013": {"vr": "IS", "Value": ["9"]}}])");
    ASSERT_TRUE(instances.ok());
    ASSERT_EQ(instances->found.size(), 1u);
    EXPECT_EQ(instances->found[0].sopClassUid, "1.7");
    EXPECT_EQ(instances->found[0].sopInstanceUid, "1.8");
    EXPECT_EQ(instances->found[0].seriesInstanceUid, "");
    EXPECT_EQ(instances->found[0].number, 9);
    EXPECT_TRUE(instancesInJson("")->found.empty());
}

TEST(Qido, HostileAnswersAreErrorsWithAdvice) {
    const std::string deep(100'000, '[');
    std::string deepItems;
    for (int i = 0; i < 50'000; ++i) deepItems += R"({"0020000D":{"Value":[)";
    for (const std::string& text :
         {deep, deep + std::string(100'000, ']'), "[" + deepItems, std::string("<html>"), std::string("[{"),
          std::string("[{}] x"), std::string("\"text\""), std::string("{\"a\":1")}) {
        const auto page = studiesInJson(text);
        ASSERT_FALSE(page.ok()) << text.substr(0, 20);
        EXPECT_EQ(page.error().code, ErrorCode::archiveNotUsable);
        EXPECT_FALSE(page.error().hint.empty());
    }
    std::string many = "[";
    for (int i = 0; i < 250'000; ++i) many += "{},";
    EXPECT_FALSE(studiesInJson(many + "{}]").ok());
    // Bytes of another character set lose letters only.
    const auto page = studiesInJson("[{\"0020000D\": \"1.2\", \"00100010\": \"M\xfcller\"}]");
    ASSERT_TRUE(page.ok());
    EXPECT_EQ(page->found.at(0).patientName, "M?ller");
}

TEST(Qido, ValuesCannotBreakOutOfTheAddress) {
    const auto url = studiesUrl("https://p/d", {.patientName = "D\xc3\xb6^A&limit=0#*",
                                                .patientBirthDate = "19700101",
                                                .dateFrom = "20200101",
                                                .modality = "CT"});
    ASSERT_TRUE(url.ok());
    EXPECT_EQ(*url,
              "https://p/d/studies?PatientName=D%C3%B6%5EA%26limit%3D0%23*&PatientBirthDate=19700101&"
              "StudyDate=20200101-&ModalitiesInStudy=CT&includefield=StudyDescription&fuzzymatching=false");
    EXPECT_FALSE(studiesUrl("https://p", {.dateTo = "2020"}).ok());
    EXPECT_FALSE(studiesUrl("https://p", {.studyInstanceUid = "1.2/../3"}).ok());
    EXPECT_FALSE(seriesUrl("https://p", "1.2?x").ok());
    EXPECT_FALSE(instancesUrl("https://p", "1.2", "../..").ok());
    EXPECT_EQ(retrieveUrl("https://p", "1", "2"), "https://p/studies/1/series/2");
    EXPECT_EQ(retrieveUrl("https://p", "1", "2", "3"), "https://p/studies/1/series/2/instances/3");
}

TEST(Qido, WildcardsMatchAsInTheStandard) {
    EXPECT_TRUE(matchesWildcards("DOE*", "doe^John"));
    EXPECT_TRUE(matchesWildcards("*^j?hn*", "Doe^John^A"));
    EXPECT_TRUE(matchesWildcards("", ""));
    EXPECT_TRUE(matchesWildcards("**", ""));
    EXPECT_FALSE(matchesWildcards("DOE", "DOE^J"));
    EXPECT_FALSE(matchesWildcards("?", ""));
    EXPECT_FALSE(matchesWildcards("a*b", "abc"));
    EXPECT_FALSE(matchesWildcards(std::string(60, '*') + "b", std::string(64, 'a')));
    EXPECT_FALSE(withWildcards({.patientName = "DOE*", .patientId = "A-1.2"}));
    const auto wide = withWildcards({.patientName = "M\xc3\xbcl^A", .patientId = "7 8"});
    ASSERT_TRUE(wide);
    EXPECT_EQ(wide->patientName, "M*l?A");
    EXPECT_EQ(wide->patientId, "7?8");
    FoundStudy study;
    study.patientName = "Yamada^T=\xe5\xb1\xb1^\xe5\xa4\xaa";
    study.patientId = "7 8";
    EXPECT_TRUE(matchesTexts({.patientName = "\xe5\xb1\xb1*", .patientId = "7 8"}, study));
    EXPECT_TRUE(matchesTexts({.patientName = "yamada^t"}, study));
    EXPECT_FALSE(matchesTexts({.patientId = "7+8"}, study));
}

TEST(Stow, AnswersAreRead) {
    const auto answer = stowAnswerIn(R"({"00081190": {"vr": "UR", "Value": ["http://x"]},
        "00081199": {"vr": "SQ", "Value": [{"00081150": {"vr": "UI", "Value": ["1.7"]}, "00081155": {"vr": "UI", "Value": ["1.1"]}}]},
        "00081198": {"vr": "SQ", "Value": [
            {"00081155": {"vr": "UI", "Value": ["1.2"]}, "00081197": {"vr": "US", "Value": [290]}},
            {"00081155": {"vr": "UI", "Value": ["1.3"]}}, {"00081197": {"vr": "US", "Value": [1]}}]}})");
    ASSERT_TRUE(answer.ok());
    EXPECT_TRUE(answer->stored.contains("1.1"));
    EXPECT_EQ(answer->stored.size(), 1u);
    EXPECT_EQ(answer->refused.size(), 2u);
    EXPECT_EQ(answer->refused.at("1.2"), 0x0122);
    EXPECT_EQ(answer->refused.at("1.3"), 0);
    for (const int reason :
         {0, 0x0110, 0x0111, 0x0122, 0x0124, 0xA700, 0xA7FF, 0xA900, 0xC000, 0xC122, 0xC409, 0x0133}) {
        EXPECT_FALSE(stowReason(reason).why.empty()) << reason;
        EXPECT_FALSE(stowReason(reason).advice.empty()) << reason;
    }
    EXPECT_NE(stowReason(0xA700).why, stowReason(0xC122).why);
}

}  // namespace
}  // namespace macula::net
