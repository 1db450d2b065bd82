// macula receive with senders that really run, and what it says when it cannot listen or keep what comes;
// macula send --commit.
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "base/exit_codes.h"
#include "cli/run_command.h"
#include "net/servers.h"
#include "synthetic.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// The port that it prints when it listens; 0 before.
std::uint16_t portIn(const std::string& text) {
    std::smatch found;
    if (!std::regex_search(text, found, std::regex("at port (\\d+) of"))) return 0;
    return static_cast<std::uint16_t>(std::stoi(found[1]));
}

class Receive : public CommandTest {
  protected:
    void SetUp() override {
        CommandTest::SetUp();
        sent_ = dicom::test::writeFiles(folder_ / "study", series_);
    }
    std::vector<std::string> receiveAt(const std::vector<std::string>& more) const {
        std::vector<std::string> all{"receive",      "--port",       "0",  "--into",
                                     at("received"), "--done-after", "0.3"};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    // Sends the study once it listens, and stops it when that is over.
    Ran receiving(const std::vector<std::string>& more,
                  const std::function<void(std::uint16_t)>& send) const {
        bool isSent = false;
        return runMaculaInterrupted(receiveAt(more), [&](const std::string& err) {
            const std::uint16_t port = portIn(err);
            if (port != 0 && !isSent) {
                send(port);
                isSent = true;
            }
            return isSent;
        });
    }
    // dcmsend's own exit code.
    int sendAs(const std::string& title, std::uint16_t port) const {
        const dicom::test::TemporaryFolder own;
        return net::test::ran(
                   {net::test::programNamed("dcmsend"), "--aetitle", title, "--call", "MACULA",
                    "--scan-directories", "127.0.0.1", std::to_string(port), (folder_ / "study").string()},
                   own.path())
            .exitCode;
    }
    std::vector<json> linesOf(const std::string& out) const {
        std::vector<json> lines;
        std::istringstream stream(out);
        for (std::string line; std::getline(stream, line);)
            lines.push_back(json::parse(line, nullptr, false));
        return lines;
    }
    std::vector<std::string> datasets(const fs::path& folder) const {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder))
            found.push_back(net::test::datasetBytes(entry.path()));
        std::ranges::sort(found);
        return found;
    }
    void expectFailure(const Ran& ran, int exitCode, std::string_view words) {
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
        EXPECT_EQ(ran.err.find("SYN1"), std::string::npos) << "names the patient: " << ran.err;
    }

    dicom::test::SyntheticSeries series_;
    std::vector<fs::path> sent_;
};

TEST_F(Receive, AStudyThatIsSentIsKeptAndPrinted) {
    const Ran ran = receiving({"--json"}, [](std::uint16_t) {});
    EXPECT_EQ(ran.exitCode, kExitDone) << "Ctrl+C is how it ends: " << ran.err;
    EXPECT_TRUE(ran.out.empty());
    const Ran received =
        receiving({"--json"}, [&](std::uint16_t port) { EXPECT_EQ(sendAs("CT1", port), 0); });
    EXPECT_EQ(received.exitCode, kExitDone) << received.err;
    const std::vector<json> lines = linesOf(received.out);
    ASSERT_FALSE(lines.empty()) << received.err;
    std::size_t kept = 0;
    for (const json& line : lines) kept += line["kept"].get<std::size_t>();
    EXPECT_EQ(kept, sent_.size()) << received.out;
    EXPECT_EQ(lines.back()["instances"], sent_.size());
    EXPECT_EQ(lines.back()["senders"], json({"CT1"}));
    const std::string folder = lines.back()["folder"];
    EXPECT_EQ(datasets(folder), datasets(folder_ / "study"));
    EXPECT_NE(received.err.find("12 images of 1 studies came"), std::string::npos) << received.err;
    EXPECT_EQ((received.out + received.err).find("SYN1"), std::string::npos) << "names the patient";
    const Ran info = runMacula({"info", folder});
    EXPECT_NE(info.out.find("12 images"), std::string::npos) << info.out;
}

TEST_F(Receive, OnceEndsByItselfAndFetchedListsWhoSentIt) {
    const std::string data = "XDG_DATA_HOME=" + at("data");
    net::test::Program running(
        {"/usr/bin/env", data, MACULA_BINARY, "receive", "--port", "0", "--once", "--done-after", "1"},
        folder_);
    ASSERT_TRUE(net::test::comes([&] { return portIn(running.output()) != 0; })) << running.output();
    sendAs("CT1", portIn(running.output()));
    EXPECT_EQ(running.exitCode(), kExitDone) << running.output();
    EXPECT_NE(running.output().find("images came from CT1"), std::string::npos) << running.output();
    const Ran listed = runMacula({"pacs", "fetched", "--json"}, {data});
    const json list = json::parse(listed.out, nullptr, false);
    ASSERT_EQ(list.size(), 1u) << listed.out << listed.err;
    EXPECT_EQ(list[0]["senders"], json({"CT1"}));
    EXPECT_EQ(list[0]["source"], "");
    EXPECT_EQ(list[0]["isComplete"], false);
    EXPECT_NE(running.output().find(list[0]["folder"].get<std::string>()), std::string::npos);
    const Ran shown = runMacula({"pacs", "fetched"}, {data});
    EXPECT_NE(shown.out.find("sent by CT1"), std::string::npos) << shown.out;
    EXPECT_NE(shown.out.find("nobody said how many there are"), std::string::npos) << shown.out;
}

TEST_F(Receive, OnlyThoseWhoMaySendDo) {
    const Ran ran =
        receiving({"--from", "CT1@127.0.0.0/8", "--from", "MR1@10.1.2.3"}, [&](std::uint16_t port) {
            EXPECT_NE(sendAs("CT2", port), 0);
            EXPECT_NE(sendAs("MR1", port), 0);
            EXPECT_EQ(sendAs("CT1", port), 0);
        });
    EXPECT_EQ(ran.exitCode, kExitDone) << ran.err;
    EXPECT_NE(ran.err.find("CT2 (127.0.0.1) wanted to send, and is not among those that may."),
              std::string::npos)
        << ran.err;
    EXPECT_NE(ran.err.find("2 connections were turned away"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("12 images of 1 studies came"), std::string::npos) << ran.err;
}

TEST_F(Receive, WhatThereIsNoRoomForIsAnErrorAtTheEnd) {
    // dcmsend goes on with the other images, and reports no error.
    const Ran ran = receiving({"--limit-gb", "0.000001"}, [&](std::uint16_t port) { sendAs("CT1", port); });
    expectFailure(ran, kExitUsage, "Not all that was sent was kept");
    EXPECT_NE(ran.err.find("There was no room for"), std::string::npos) << ran.err;
}

TEST_F(Receive, EachFailureHasItsSentenceAndExitCode) {
    const auto refused = [&](const std::vector<std::string>& more) { return runMacula(receiveAt(more)); };
    expectFailure(refused({"--address", "all"}), kExitUsage, "nobody said which may");
    expectFailure(refused({"--from", "CT1@pacs"}), kExitUsage, "pacs is no address");
    expectFailure(refused({"--from", "@10.1.2.3"}), kExitUsage, "TITLE@ADDRESS");
    expectFailure(refused({"--from", "*"}), kExitUsage, "--anyone");
    expectFailure(refused({"--ae", "SEVENTEEN_LETTERS"}), kExitUsage, "AE title");
    expectFailure(refused({"--tls-key", at("key.pem")}), kExitUsage, "needs a certificate");
    expectFailure(refused({"--tls-certificate", at("none.pem")}), kExitArchive, "cannot be read");
    expectFailure(refused({"--once", "--for", "0.2"}), kExitArchive, "No study came");
    EXPECT_EQ(refused({"--for", "0.2"}).exitCode, kExitDone);
    write("file", "no folder");
    std::vector<std::string> intoFile = receiveAt({"--for", "0.2"});
    intoFile[4] = at("file");
    expectFailure(runMacula(intoFile), kExitUsage, "folder");
    const net::test::StoreServer other;
    std::vector<std::string> taken = receiveAt({});
    taken[2] = std::to_string(other.port());
    expectFailure(runMacula(taken), kExitUsage, "already listens");
}

TEST_F(Receive, AnArchiveConfirmsWhatItKeeps) {
    const std::string data = "XDG_DATA_HOME=" + at("data");
    const std::uint16_t port = net::test::freePort();
    const net::test::Orthanc archive({.known = {{"MACULA", port}}});
    ASSERT_EQ(runMacula({"pacs", "add", "Hospital", "--dimse",
                         archive.title() + "@127.0.0.1:" + std::to_string(archive.dicomPort()),
                         "--receive-at", std::to_string(port)},
                        {data})
                  .exitCode,
              kExitDone);
    const Ran sent = runMacula({"send", "Hospital", at("study"), "--yes", "--commit", "--json"}, {data});
    EXPECT_EQ(sent.exitCode, kExitDone) << sent.err;
    const json told = json::parse(sent.out, nullptr, false);
    EXPECT_EQ(told["stored"], sent_.size());
    ASSERT_EQ(told["commitment"].size(), sent_.size()) << sent.out;
    for (const json& each : told["commitment"]) EXPECT_EQ(each["state"], "committed") << each;

    const net::test::QrArchive other;
    ASSERT_EQ(runMacula({"pacs", "add", "Other", "--dimse",
                         other.title() + "@127.0.0.1:" + std::to_string(other.port())},
                        {data})
                  .exitCode,
              kExitDone);
    const Ran unasked = runMacula({"send", "Other", at("study"), "--yes", "--commit"}, {data});
    EXPECT_EQ(unasked.exitCode, kExitArchive);
    EXPECT_NE(unasked.err.find("does not offer storage commitment"), std::string::npos) << unasked.err;
    EXPECT_NE(unasked.out.find("12 of 12 stored"), std::string::npos) << unasked.out;
}

}  // namespace
}  // namespace macula::cli
