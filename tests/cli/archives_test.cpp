// macula pacs, find, fetch and send against an archive that really runs, and what each says when that fails.
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/exit_codes.h"
#include "cli/run_command.h"
#include "net/servers.h"
#include "synthetic.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Archives : public CommandTest {
  protected:
    void SetUp() override {
        CommandTest::SetUp();
        sent_ = dicom::test::writeFiles(folder_ / "study", series_);
    }
    Ran macula(std::vector<std::string> arguments) {
        return runMacula(arguments, {"XDG_DATA_HOME=" + at("data")});
    }
    void add(const char* name, const std::string& how, const std::string& where) {
        const Ran added = macula({"pacs", "add", name, how, where});
        ASSERT_EQ(added.exitCode, kExitDone) << added.err;
    }
    void addBoth() {
        add("Hospital", "--dimse", archive_.title() + "@127.0.0.1:" + std::to_string(archive_.dicomPort()));
        add("Cloud", "--web", archive_.webUrl());
    }
    json jsonOf(std::vector<std::string> arguments) {
        arguments.push_back("--json");
        const Ran ran = macula(std::move(arguments));
        EXPECT_EQ(ran.exitCode, kExitDone) << ran.err;
        return json::parse(ran.out, nullptr, false);
    }
    std::vector<std::string> datasets(const fs::path& folder) {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder))
            found.push_back(net::test::datasetBytes(entry.path()));
        std::ranges::sort(found);
        return found;
    }
    void expectFailure(const Ran& ran, int exitCode, std::string_view words) {
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
        EXPECT_EQ(ran.err.find("SYN1"), std::string::npos) << "names the patient: " << ran.err;
    }

    net::test::Orthanc archive_;
    dicom::test::SyntheticSeries series_;
    std::vector<fs::path> sent_;
};

TEST_F(Archives, WhatIsSentIsFoundFetchedAndTheSameByBothProtocols) {
    addBoth();
    EXPECT_EQ(jsonOf({"send", "Hospital", at("study"), "--yes"})["stored"], sent_.size());
    for (const char* name : {"Hospital", "Cloud"}) {
        const json found = jsonOf({"find", name, "--name", "SYNTH*", "--modality", "CT", "--series"});
        ASSERT_EQ(found["studies"].size(), 1u) << name << found;
        EXPECT_EQ(found["studies"][0]["studyInstanceUid"], series_.studyUid);
        EXPECT_EQ(found["studies"][0]["patientName"], series_.patientName);
        EXPECT_EQ(found["studies"][0]["series"].size(), 1u);
        EXPECT_EQ(jsonOf({"find", name, "--name", "NOBODY"})["studies"].size(), 0u);

        const json fetched = jsonOf(
            {"fetch", name, "--patient-id", series_.patientId, "--into", at(std::string("to") + name)});
        ASSERT_EQ(fetched.size(), 1u);
        EXPECT_EQ(fetched[0]["isComplete"], true) << fetched;
        EXPECT_EQ(fetched[0]["kept"], sent_.size());
        EXPECT_EQ(datasets(fetched[0]["folder"].get<std::string>()), datasets(folder_ / "study")) << name;
        const Ran info = macula({"info", fetched[0]["folder"].get<std::string>()});
        EXPECT_NE(info.out.find("12 images, 0 other DICOM objects, 0 left out, 0 not DICOM"),
                  std::string::npos)
            << info.out;
    }
}

TEST_F(Archives, AFetchGoesOnFromWhatIsThere) {
    addBoth();
    jsonOf({"send", "Hospital", at("study"), "--yes"});
    const std::string folder = jsonOf({"fetch", "Cloud", "--study", series_.studyUid})[0]["folder"];
    std::size_t removed = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (removed++ < 5) fs::remove(entry.path());
    }
    for (const char* name : {"Hospital", "Cloud"}) {
        const json again = jsonOf({"fetch", name, "--study", series_.studyUid});
        EXPECT_EQ(again[0]["folder"], folder);
        EXPECT_EQ(again[0]["isComplete"], true);
        EXPECT_EQ(again[0]["kept"], std::string(name) == "Hospital" ? 5 : 0) << again;
    }
    const json list = jsonOf({"pacs", "fetched"});
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0]["source"], "Cloud");
    EXPECT_EQ(macula({"pacs", "purge", "--keep", "0"}).exitCode, kExitDone);
    EXPECT_FALSE(fs::exists(folder));
}

TEST_F(Archives, SendingAsksFirstAndNamesThePatient) {
    addBoth();
    const Ran unasked = macula({"send", "Hospital", at("study")});  // no terminal
    EXPECT_EQ(unasked.exitCode, kExitUsage);
    EXPECT_NE(unasked.err.find("SYNTHETIC, ONE"), std::string::npos) << unasked.err;
    EXPECT_NE(unasked.err.find("12 files to Hospital"), std::string::npos) << unasked.err;
    EXPECT_EQ(jsonOf({"find", "Hospital"})["studies"].size(), 0u);
}

TEST_F(Archives, EachFailureHasItsSentenceAndExitCode) {
    addBoth();
    expectFailure(macula({"find", "Nowhere"}), kExitUsage, "Hospital");
    expectFailure(macula({"fetch", "Hospital"}), kExitUsage, "which study");
    expectFailure(macula({"fetch", "Hospital", "--patient-id", "SYN1"}), kExitArchive,
                  "no study that matches");
    expectFailure(macula({"find", "Hospital", "--date", "yesterday"}), kExitUsage, "YYYYMMDD");
    expectFailure(macula({"send", "Hospital", write("a.txt", "text"), "--yes"}), kExitInput, "no DICOM file");
    archive_.stop();
    expectFailure(macula({"find", "Hospital"}), kExitArchive, "port");
    expectFailure(macula({"find", "Cloud"}), kExitArchive, "port");
    const Ran tried = macula({"pacs", "test", "Hospital"});
    EXPECT_EQ(tried.exitCode, kExitArchive);
    EXPECT_NE(tried.out.find("ok      Host name"), std::string::npos) << tried.out;
    EXPECT_NE(tried.out.find("FAILED  Port"), std::string::npos) << tried.out;
}

TEST_F(Archives, AreListedAndRemoved) {
    addBoth();
    const json list = jsonOf({"pacs", "list"});
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0]["name"], "Hospital");
    EXPECT_EQ(list[1]["dicomweb"]["url"], archive_.webUrl());
    EXPECT_EQ(macula({"pacs", "remove", "Cloud"}).exitCode, kExitDone);
    EXPECT_EQ(jsonOf({"pacs", "list"}).size(), 1u);
    expectFailure(macula({"pacs", "add", "Odd", "--dimse", "no address"}), kExitUsage, "AE@HOST:PORT");
    expectFailure(macula({"pacs", "add", "Odd", "--web", "ftp://a"}), kExitUsage, "https://");
}

}  // namespace
}  // namespace macula::cli
