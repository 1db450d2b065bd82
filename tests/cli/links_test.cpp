// macula fetch of what a link or a manifest names, from archives that really run.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/exit_codes.h"
#include "cli/run_command.h"
#include "net/servers.h"
#include "synthetic_manifest.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;
using dicom::test::SyntheticManifest;
using nlohmann::json;

class Links : public CommandTest {
  protected:
    void SetUp() override {
        CommandTest::SetUp();
        dicom::test::writeFiles(folder_ / "study", series_);
        net::test::sendFolder(folder_ / "study", archive_.dicomPort(), archive_.title());
        add("Cloud", "--web", archive_.webUrl());
    }
    Ran macula(std::vector<std::string> arguments) {
        return runMacula(arguments, {"XDG_DATA_HOME=" + at("data")});
    }
    void add(const char* name, const std::string& how, const std::string& where) {
        const Ran added = macula({"pacs", "add", name, how, where});
        ASSERT_EQ(added.exitCode, kExitDone) << added.err;
    }
    json fetched(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "fetch");
        arguments.push_back("--json");
        const Ran ran = macula(std::move(arguments));
        EXPECT_EQ(ran.exitCode, kExitDone) << ran.err;
        return json::parse(ran.out, nullptr, false);
    }
    void expectFailure(std::vector<std::string> arguments, int exitCode, std::string_view words) {
        arguments.insert(arguments.begin(), "fetch");
        const Ran ran = macula(std::move(arguments));
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
        EXPECT_EQ(ran.err.find(series_.patientId), std::string::npos) << "names the patient: " << ran.err;
    }
    std::string writeManifest(const SyntheticManifest& manifest) {
        dicom::test::writeManifest(folder_ / "manifest.dcm", manifest);
        return at("manifest.dcm");
    }

    net::test::Orthanc archive_;
    dicom::test::SyntheticSeries series_;
};

TEST_F(Links, AStudyIsFoundByItsUidAndItsPatient) {
    for (const std::string& link :
         {"macula://open?study=" + series_.studyUid, std::string("macula://open?patient=SYN1&archive=cloud"),
          "macula://IHEInvokeImageDisplay?requestType=STUDY&studyUID=" + series_.studyUid,
          std::string(
              "https://any.example.org/IHEInvokeImageDisplay?requestType=PATIENT&patientID=SYN1^^^H")}) {
        const json result = fetched({"--link", link});
        ASSERT_EQ(result.size(), 1u) << link;
        EXPECT_EQ(result[0]["isComplete"], true) << link;
    }
}

TEST_F(Links, AnArchiveThatDoesNotAnswerDoesNotHideWhatAnotherHas) {
    add("Away", "--dimse", "NOBODY@127.0.0.1:1");
    const Ran ran = macula({"fetch", "--link", "macula://open?study=" + series_.studyUid});
    EXPECT_EQ(ran.exitCode, kExitDone) << ran.err;
    EXPECT_NE(ran.err.find("Away could not be asked"), std::string::npos) << ran.err;
    expectFailure({"--link", "macula://open?study=1.2.3"}, kExitArchive, "None of 2 archives");
    expectFailure({"--link", "macula://open?study=1.2.3&archive=Cloud"}, kExitArchive, "Cloud has no study");
    expectFailure({"--link", "macula://open?study=1.2.3&archive=Nowhere"}, kExitUsage,
                  "no archive of that name");
}

TEST_F(Links, SeveralStudiesAreNotChosenFromByChance) {
    series_.studyUid = "2.25.2000";
    series_.seriesUid = "2.25.2001";
    series_.edits.push_back([](DcmItem& item) { dicom::test::put(item, DCM_PatientBirthDate, "19700228"); });
    std::vector<dicom::test::Slice> slices = dicom::test::slicesOf(series_);
    for (auto& slice : slices) slice.sopInstanceUid += ".2";
    dicom::test::writeFiles(folder_ / "other", series_, slices);
    net::test::sendFolder(folder_ / "other", archive_.dicomPort(), archive_.title());
    expectFailure({"--link", "macula://open?patient=SYN1"}, kExitUsage, "2 studies match");
    EXPECT_EQ(fetched({"--link", "macula://open?patient=SYN1", "--all"}).size(), 2u);
    const std::string newest =
        "macula://IHEInvokeImageDisplay?requestType=PATIENT&patientID=SYN1&mostRecentResults=1";
    EXPECT_EQ(fetched({"--link", newest}).size(), 1u);
    const std::string all =
        "macula://IHEInvokeImageDisplay?requestType=PATIENT&patientID=SYN1&patientBirthDate=";
    EXPECT_EQ(fetched({"--link", all + "1970-02-28", "--all"}).size(), 2u)
        << "the other has no date of birth";
    EXPECT_EQ(fetched({"--link", all + "1980-02-28"}).size(), 1u);
    expectFailure({"--link", newest + "&modalitiesInStudy=MR"}, kExitArchive, "also answered");
    expectFailure({"--link", newest + "&upperDateTime=1999-12-31"}, kExitArchive, "no study that fits");
}

TEST_F(Links, BadCallsAreToldApart) {
    expectFailure({}, kExitUsage, "from which archive");
    expectFailure({"--link", "macula://open?patient=SYN1*"}, kExitUsage, "wildcard");
    expectFailure({"--link", "macula://open?patient=SYN1", "--accession", "1"}, kExitUsage, "says itself");
    expectFailure({"--manifest", write("a.txt", "text")}, kExitInput, "no imaging manifest");
}

TEST_F(Links, AManifestIsFetchedFromWhereItSays) {
    SyntheticManifest manifest = dicom::test::manifestOf(series_);
    manifest.series[0].url = archive_.webUrl() + "/studies/" + series_.studyUid;
    const json result = fetched({"--manifest", writeManifest(manifest)});
    ASSERT_EQ(result.size(), 1u);
    EXPECT_EQ(result[0]["isComplete"], true);
    EXPECT_EQ(result[0]["kept"], series_.size.z);
}

TEST_F(Links, AManifestOfAStrangerIsNotFollowed) {
    SyntheticManifest manifest = dicom::test::manifestOf(series_);
    manifest.series[0].url = "http://127.0.0.1:1/dicom-web/studies/" + series_.studyUid;
    expectFailure({"--manifest", writeManifest(manifest)}, kExitUsage, "http://127.0.0.1:1/dicom-web");
    EXPECT_EQ(fetched({"Cloud", "--manifest", at("manifest.dcm")})[0]["isComplete"], true)
        << "a person names the archive";
}

TEST_F(Links, WhatAManifestNamesAndNeverCameIsTold) {
    SyntheticManifest manifest = dicom::test::manifestOf(series_);
    manifest.series[0].url = archive_.webUrl();
    manifest.series[0].instanceUids.push_back("2.25.999");
    const Ran ran = macula({"fetch", "--manifest", writeManifest(manifest)});
    EXPECT_EQ(ran.exitCode, kExitArchive) << ran.err;
    EXPECT_NE(ran.err.find("1 of 13 images that the manifest names did not come"), std::string::npos)
        << ran.err;
    const json list = json::parse(macula({"pacs", "fetched", "--json"}).out);
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0]["isComplete"], false);
    EXPECT_EQ(list[0]["instances"], series_.size.z);
}

TEST_F(Links, AManifestOfAnotherPatientFetchesNothing) {
    SyntheticManifest manifest = dicom::test::manifestOf(series_);
    manifest.series[0].url = archive_.webUrl();
    manifest.patientId = "OTHER";
    manifest.patientName = "SOMEBODY^ELSE";
    expectFailure({"--manifest", writeManifest(manifest)}, kExitArchive, "names another patient");
    EXPECT_EQ(json::parse(macula({"pacs", "fetched", "--json"}).out).size(), 0u);
}

}  // namespace
}  // namespace macula::cli
