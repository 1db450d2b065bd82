// Links: what good ones mean, and why bad ones are refused.
#include "study/link/study_link.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "study/link/link_text.h"

namespace macula::study {
namespace {

using Strings = std::vector<std::string>;

const std::string kInvoke = "macula://IHEInvokeImageDisplay?requestType=";

StudyLink good(const std::string& text) {
    EXPECT_TRUE(isLink(text)) << text;
    const auto link = studyLinkOf(text);
    EXPECT_TRUE(link) << text << ": " << link.error().message;
    return link ? *link : StudyLink();
}

// The sentence; the test fails where the link is taken, or the sentence repeats a secret.
std::string refused(const std::string& text) {
    const auto link = studyLinkOf(text);
    if (link) {
        ADD_FAILURE() << text;
        return {};
    }
    EXPECT_EQ(link.error().code, ErrorCode::usage);
    EXPECT_FALSE(link.error().hint.empty());
    const std::string said =
        link.error().message.english() + link.error().hint.english() + link.error().where;
    EXPECT_EQ(said.find("SECRET"), std::string::npos) << said;
    return link.error().message.english();
}

TEST(StudyLink, NamesAStudyAnOrderOrAPatient) {
    EXPECT_EQ(good("macula://open?study=1.2.840.1").studyInstanceUids, Strings{"1.2.840.1"});
    EXPECT_EQ(good("macula://open?accession=A-4711").accessionNumbers, Strings{"A-4711"});
    EXPECT_EQ(good("macula://open?patient=P%2F1").patientId, "P/1");
    const StudyLink all = good("macula://open?patient=4711&issuer=Clinic%20S%C3%BCd&archive=Hospital%20B");
    EXPECT_EQ(all.issuer, "Clinic Süd");
    EXPECT_EQ(all.archive, "Hospital B");
    EXPECT_EQ(all.notDone.size(), 1u) << "the issuer is not compared";
    EXPECT_TRUE(good("macula://open?study=1.2").notDone.empty());
}

TEST(StudyLink, IsTakenAsBrowsersAndDesktopsWriteIt) {
    for (const char* text :
         {"macula://open/?study=1.2", "MACULA://OPEN?study=1.2", "macula://open?study=1.2&",
          "macula://open?&study=1.2&issuer=", "macula://open?study=1%2E2", "macula://open?stud%79=1.2"})
        EXPECT_EQ(good(text).studyInstanceUids, Strings{"1.2"}) << text;
    EXPECT_EQ(good("macula://open?accession=a+b").accessionNumbers, Strings{"a+b"}) << "no form";
}

TEST(StudyLink, ReadsAnInvokeImageDisplayForStudies) {
    const StudyLink studies = good(
        kInvoke + "STUDY&studyUID=1.2,1.3&viewerType=IHE_BIR&diagnosticQuality=true&keyImagesOnly=false");
    EXPECT_EQ(studies.studyInstanceUids, (Strings{"1.2", "1.3"}));
    EXPECT_EQ(studies.notDone.size(), 2u) << "the viewer and its quality";
    const StudyLink orders = good(kInvoke + "STUDY&accessionNumber=1%5E%5E%5EHOSPITAL,2&keyImagesOnly=TRUE");
    EXPECT_EQ(orders.accessionNumbers, (Strings{"1", "2"}));
    EXPECT_EQ(orders.notDone.size(), 2u) << "the issuer and key images";
    EXPECT_EQ(good("https://viewer.example.org/a/IHEInvokeImageDisplay?requestType=STUDY&studyUID=1.2")
                  .studyInstanceUids,
              Strings{"1.2"});
    EXPECT_EQ(good("macula://iheinvokeimagedisplay/?requestType=STUDY&studyUID=1.2&additionalParameters=a")
                  .notDone.size(),
              1u);
}

TEST(StudyLink, ReadsAnInvokeImageDisplayForAPatient) {
    const StudyLink link = good(
        kInvoke +
        "PATIENT&patientID=99998410^^^AcmeHospital%261.2.3%26ISO&patientName=DOE%5EJOHN&patientBirthDate="
        "1970-02-28&lowerDateTime=2013-01-01T00:00:00%2B01:00&upperDateTime=20131231&mostRecentResults=2&"
        "modalitiesInStudy=CT,MR");
    EXPECT_EQ(link.patientId, "99998410");
    EXPECT_EQ(link.issuer, "AcmeHospital");
    EXPECT_EQ(link.patientBirthDate, "19700228");
    EXPECT_EQ(link.dateFrom, "20130101");
    EXPECT_EQ(link.dateTo, "20131231");
    EXPECT_EQ(link.mostRecent, 2u);
    EXPECT_EQ(link.modalities, (Strings{"CT", "MR"}));
    EXPECT_EQ(link.notDone.size(), 3u) << "the issuer, the name, the time of the day";
    EXPECT_EQ(good(kInvoke + "PATIENT&patientID=1^^^%261.2.3%26ISO").issuer, "1.2.3");
    EXPECT_TRUE(good(kInvoke + "PATIENT&patientID=1&modalitiesInStudy=").modalities.empty());
}

TEST(StudyLink, SaysWhatIsWrong) {
    const std::pair<const char*, const char*> bad[] = {
        {"macula:open?study=1.2", "no //"},
        {"macula://close?study=1.2", "does not do"},
        {"macula://open/etc/passwd?study=1.2", "does not do"},
        {"macula://user:SECRET@open?study=1.2", "does not do"},
        {"macula://open", "which study"},
        {"macula://open?", "which study"},
        {"macula://open?archive=SECRET", "which study"},
        {"macula://open?study=", "which study"},
        {"macula://open?study", "key=value"},
        {"macula://open?=SECRET", "key=value"},
        {"macula://open?study=1.2&study=1.3", "twice"},
        {"macula://open?study=1.2&accession=SECRET", "more than one"},
        {"macula://open?accession=1&patient=SECRET", "more than one"},
        {"macula://open?study=1.2&issuer=SECRET", "names no patient"},
        {"macula://open?study=SECRET", "no UID"},
        {"macula://open?study=../../SECRET", "no UID"},
        {"macula://open?study=1.2%00", "control"},
        {"macula://open?study=1.2%0ASECRET", "control"},
        {"macula://open?accession=%C2%85", "control"},
        {"macula://open?accession=%E2%80%AESECRET", "control"},
        {"macula://open?accession=%ff%fe", "UTF-8"},
        {"macula://open?accession=%C0%AF", "UTF-8"},
        {"macula://open?accession=%4", "percent"},
        {"macula://open?accession=%zz", "percent"},
        {"macula://open?accession=SECRET*", "wildcard"},
        {"macula://open?accession=%3F", "wildcard"},
        {"macula://open?patient=SECRET%5C2", "wildcard"},
        {"macula://open?study=1.2#SECRET", "#"},
        {"macula://open?study=1.2 --preset", "blank"},
        {"macula://open?study=1.2&file=/SECRET", "Part 2"},
        {"macula://open?url=https://SECRET&study=1.2", "Part 1"},
        {"macula://open?study=1.2&password=SECRET", "Part 2"},
        {"macula://open?study=1.2&SECRET=1", "Part 2"},
        {"macula://open?study=1.2&amp;archive=SECRET", "Part 2"},
        {"https://user:SECRET@host/IHEInvokeImageDisplay?requestType=STUDY&studyUID=1.2", "user name"},
        {"https://example.org/IHEInvokeImageDisplay", "which study"},
        {"/home/SECRET/study", "no link"},
        {"", "no link"},
    };
    for (const auto& [text, words] : bad) {
        const std::string said = refused(text);
        EXPECT_NE(said.find(words), std::string::npos) << text << ": " << said;
    }
}

TEST(StudyLink, SaysWhatIsWrongWithAnInvokeImageDisplay) {
    const std::pair<const char*, const char*> bad[] = {
        {"", "requestType"},
        {"SERIES&studyUID=1.2", "requestType"},
        {"STUDY", "which study"},
        {"STUDY&studyUID=1.2,SECRET", "no UID"},
        {"STUDY&patientID=SECRET", "Part 2"},
        {"STUDY&studyUID=1.2&diagnosticQuality=yes", "true nor false"},
        {"PATIENT", "which patient"},
        {"PATIENT&patientID=%5E%5E%5ESECRET", "which patient"},
        {"PATIENT&patientID=SECRET*", "wildcard"},
        {"PATIENT&patientID=1&mostRecentResults=0", "number"},
        {"PATIENT&patientID=1&mostRecentResults=-1", "number"},
        {"PATIENT&patientID=1&mostRecentResults=99999999999999999999", "number"},
        {"PATIENT&patientID=1&lowerDateTime=2013-02-30", "day"},
        {"PATIENT&patientID=1&upperDateTime=yesterday", "day"},
        {"PATIENT&patientID=1&lowerDateTime=20140101&upperDateTime=20130101", "after"},
        {"PATIENT&patientID=1&modalitiesInStudy=*", "modality"},
        {"PATIENT&patientID=1&patientBirthDate=1970", "day"},
    };
    for (const auto& [text, words] : bad) {
        const std::string said = refused(kInvoke + text);
        EXPECT_NE(said.find(words), std::string::npos) << text << ": " << said;
    }
}

TEST(StudyLink, HasBounds) {
    refused("macula://open?accession=" + std::string(65, '1'));
    EXPECT_EQ(good("macula://open?accession=" + std::string(64, '1')).accessionNumbers[0].size(), 64u);
    refused("macula://open?study=1.2&archive=" + std::string(kMostBytesOfLink, 'a'));
    std::string many = "macula://open?study=1.2";
    for (int i = 0; i < 40; ++i) many += "&k" + std::to_string(i) + "=1";
    refused(many);
    std::string uids = kInvoke + "STUDY&studyUID=1.2";
    for (int i = 0; i < 40; ++i) uids += ",1.3." + std::to_string(i);
    refused(uids);
}

TEST(StudyLink, APathIsNone) {
    for (const char* path : {"/home/macula", "macula", "macula/open", "./macula:open",
                             "https://example.org/a", "file:///a", "--macula://open", "C:\\macula", ""})
        EXPECT_FALSE(isLink(path)) << path;
}

}  // namespace
}  // namespace macula::study
