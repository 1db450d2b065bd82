// What macula send could not store waits in the queue: macula pacs queue, retry and drop, with archives that
// really run.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/exit_codes.h"
#include "cli/run_command.h"
#include "net/servers.h"
#include "synthetic.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class SendQueue : public CommandTest {
  protected:
    void SetUp() override {
        CommandTest::SetUp();
        series_.size = {8, 7, 4};
        files_ = dicom::test::writeFiles(folder_ / "study", series_);
    }
    Ran macula(std::vector<std::string> arguments) {
        return runMacula(arguments, {"XDG_DATA_HOME=" + at("data")});
    }
    void addBoth(const net::test::Orthanc& archive) {
        const std::string dimse = archive.title() + "@127.0.0.1:" + std::to_string(archive.dicomPort());
        ASSERT_EQ(macula({"pacs", "add", "Hospital", "--dimse", dimse}).exitCode, kExitDone);
        ASSERT_EQ(macula({"pacs", "add", "Cloud", "--web", archive.webUrl()}).exitCode, kExitDone);
    }
    json jsonOf(std::vector<std::string> arguments, int exitCode = kExitDone) {
        arguments.push_back("--json");
        const Ran ran = macula(std::move(arguments));
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        return json::parse(ran.out, nullptr, false);
    }
    // Of one error, which says that the queue has it, and names nobody.
    void expectQueued(const Ran& ran) {
        EXPECT_EQ(ran.exitCode, kExitArchive) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find("macula pacs retry"), std::string::npos) << ran.err;
        const std::string error = ran.err.substr(ran.err.find("macula: "));
        EXPECT_EQ(error.find("SYN"), std::string::npos) << "names the patient: " << error;
    }

    dicom::test::SyntheticSeries series_;
    std::vector<fs::path> files_;
};

TEST_F(SendQueue, WhatFailedIsSentOnceTheArchiveIsThere) {
    net::test::Orthanc archive;
    addBoth(archive);
    archive.stop();
    expectQueued(macula({"send", "Hospital", files_[0].string(), files_[1].string(), "--yes"}));
    expectQueued(macula({"send", "Cloud", files_[2].string(), files_[3].string(), "--yes"}));
    fs::remove_all(folder_ / "study");

    const json queue = jsonOf({"pacs", "queue"});
    ASSERT_EQ(queue.size(), 2u) << queue;
    for (std::size_t i = 0; i < queue.size(); ++i) {
        EXPECT_EQ(queue[i]["state"], "waiting");
        EXPECT_EQ(queue[i]["archive"], i == 0 ? "Hospital" : "Cloud") << "the first comes first";
        EXPECT_EQ(queue[i]["files"].size(), 2u);
        EXPECT_EQ(queue[i]["tries"], 1);
        EXPECT_EQ(queue[i]["patients"][0]["patientName"], series_.patientName);
        EXPECT_NE(queue[i]["trouble"]["why"].get<std::string>().find("port"), std::string::npos);
    }
    const Ran listed = macula({"pacs", "queue"});
    EXPECT_NE(listed.out.find("waiting  Hospital  2 objects"), std::string::npos) << listed.out;
    EXPECT_NE(listed.out.find("SYNTHETIC, ONE"), std::string::npos) << listed.out;

    const Ran tooEarly = macula({"pacs", "retry"});
    EXPECT_EQ(tooEarly.exitCode, kExitArchive) << tooEarly.err;
    EXPECT_NE(tooEarly.out.find("0 stored, 4 still wait"), std::string::npos) << tooEarly.out;
    EXPECT_EQ(jsonOf({"pacs", "queue"}).size(), 2u);

    archive.start();
    const Ran one = macula({"pacs", "retry", "hospital"});
    EXPECT_EQ(one.exitCode, kExitDone) << one.err;
    EXPECT_NE(one.err.find("2 objects to Hospital"), std::string::npos) << one.err;
    EXPECT_EQ(jsonOf({"pacs", "queue"}).size(), 1u);
    EXPECT_EQ(jsonOf({"pacs", "retry"})["stored"], 2);
    EXPECT_EQ(jsonOf({"pacs", "queue"}).size(), 0u);
    const json found = jsonOf({"fetch", "Hospital", "--study", series_.studyUid});
    EXPECT_EQ(found[0]["kept"], files_.size());
    EXPECT_EQ(macula({"pacs", "retry"}).exitCode, kExitDone) << "nothing waits";
}

TEST_F(SendQueue, WhatIsRefusedStaysWithItsReasonUntilItIsDropped) {
    net::test::OrthancOptions implicitOnly;
    implicitOnly.more = {{"AcceptedTransferSyntaxes", {"1.2.840.10008.1.2"}}};
    const net::test::Orthanc archive(implicitOnly);
    addBoth(archive);
    const json sent = jsonOf({"send", "Hospital", at("study"), "--yes"}, kExitArchive);
    EXPECT_EQ(sent["stored"], 0);
    EXPECT_EQ(sent["notSent"].size(), files_.size());
    const std::string id = sent["queued"];
    const json queue = jsonOf({"pacs", "queue"});
    ASSERT_EQ(queue.size(), 1u);
    EXPECT_EQ(queue[0]["id"], id);
    EXPECT_EQ(queue[0]["state"], "refused");
    EXPECT_EQ(queue[0]["files"][0]["refused"]["why"], "The archive takes no instances of this kind.");
    const Ran retried = macula({"pacs", "retry"});
    EXPECT_EQ(retried.exitCode, kExitDone) << retried.err;
    EXPECT_NE(retried.out.find("Nothing waits to be sent."), std::string::npos) << retried.out;
    EXPECT_EQ(jsonOf({"pacs", "retry", "--refused-too"}, kExitArchive)["refused"], files_.size());

    EXPECT_EQ(macula({"pacs", "drop", "ffff"}).exitCode, kExitUsage);
    EXPECT_EQ(macula({"pacs", "drop"}).exitCode, kExitUsage);
    EXPECT_EQ(macula({"pacs", "drop", id.substr(0, 6)}).exitCode, kExitDone);
    EXPECT_EQ(jsonOf({"pacs", "queue"}).size(), 0u);
}

TEST_F(SendQueue, NothingIsKeptOfWhatIsNotToBe) {
    net::test::Orthanc archive;
    addBoth(archive);
    archive.stop();
    const Ran sent = macula({"send", "Hospital", at("study"), "--yes", "--no-queue"});
    EXPECT_EQ(sent.exitCode, kExitArchive);
    EXPECT_EQ(sent.err.find("queue"), std::string::npos) << sent.err;
    EXPECT_EQ(jsonOf({"pacs", "queue"}).size(), 0u);
    EXPECT_EQ(macula({"send", "Hospital", at("study")}).exitCode, kExitUsage) << "nobody confirmed it";
    EXPECT_EQ(jsonOf({"pacs", "queue"}).size(), 0u);
    EXPECT_EQ(macula({"pacs", "retry", "Nowhere"}).exitCode, kExitUsage);
}

TEST_F(SendQueue, AnArchiveThatIsNotSetUpAnyMoreLosesNothing) {
    net::test::Orthanc archive;
    addBoth(archive);
    archive.stop();
    expectQueued(macula({"send", "Hospital", at("study"), "--yes"}));
    ASSERT_EQ(macula({"pacs", "remove", "Hospital"}).exitCode, kExitDone);
    const Ran retried = macula({"pacs", "retry"});
    EXPECT_EQ(retried.exitCode, kExitUsage) << retried.err;
    EXPECT_NE(retried.err.find("stays in the queue"), std::string::npos) << retried.err;
    EXPECT_EQ(jsonOf({"pacs", "queue"}).size(), 1u);
}

// A queue that cannot be written changes no reason.
TEST_F(SendQueue, WhereNothingCanBeKeptBothReasonsAreSaid) {
    net::test::Orthanc archive;
    addBoth(archive);
    archive.stop();
    write("data/macula/outbox", "a file where the folder should be");
    const Ran sent = macula({"send", "Hospital", at("study"), "--yes"});
    EXPECT_EQ(sent.exitCode, kExitArchive) << sent.err;
    EXPECT_NE(sent.err.find("could not be put into the queue"), std::string::npos) << sent.err;
    EXPECT_NE(sent.err.find("port"), std::string::npos) << sent.err;
    EXPECT_EQ(sent.err.find("pacs retry"), std::string::npos) << sent.err;
}

}  // namespace
}  // namespace macula::cli
