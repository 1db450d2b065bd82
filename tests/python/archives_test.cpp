// Starts the archives that archive_test.py speaks with, and runs it.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "base/paths.h"
#include "net/servers.h"
#include "synthetic.h"

namespace macula::net::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kSeries = 2;
constexpr int kSlices = 8;
constexpr const char* kPassword = "correct-horse";

json dimseAt(std::uint16_t port, const std::string& title) {
    return {{"name", title}, {"dimse", {{"host", "127.0.0.1"}, {"port", port}, {"calledAe", title}}}};
}

// The program with what CMake says of its environment.
std::vector<std::string> pythonWith(const json& archives) {
    std::vector<std::string> command{"/usr/bin/env", "MACULA_TEST_ARCHIVES=" + archives.dump()};
    std::istringstream environment(MACULA_PYTHON_ENVIRONMENT);
    for (std::string setting; std::getline(environment, setting, '|');) command.push_back(setting);
    command.insert(
        command.end(),
        {MACULA_PYTHON, (macula::test::projectFolder() / "tests/python/archive_test.py").string()});
    return command;
}

TEST(PythonArchives, AreFoundFetchedAndSentTo) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    SKIP_WITHOUT_PROGRAM("storescp");
    const dicom::test::TemporaryFolder folder;
    dicom::test::SyntheticSeries series;
    series.studyUid = "2.25.9400";
    series.size = {16, 16, kSlices};
    json uids = json::array();
    for (int i = 1; i <= kSeries; ++i) {
        series.seriesUid = series.studyUid + "." + std::to_string(i);
        series.number = i;
        uids.push_back(series.seriesUid);
        const fs::path own = folder / "study" / std::to_string(i);
        fs::create_directories(own);
        dicom::test::writeFiles(own, series);
    }
    series.sopClassUid = "2.25.9401";  // which no archive knows
    series.seriesUid = "2.25.9402";
    series.size.z = 1;
    fs::create_directory(folder / "odd");
    const fs::path odd = dicom::test::writeFiles(folder / "odd", series).front();

    const QrArchive dcmqrscp;
    const Orthanc orthanc;
    const Orthanc locked({.user = "reader", .password = kPassword});
    const StoreServer store;
    const json ways{{"dcmqrscp", dimseAt(dcmqrscp.port(), dcmqrscp.title())},
                    {"orthanc", dimseAt(orthanc.dicomPort(), orthanc.title())},
                    {"web", {{"name", "Cloud"}, {"dicomweb", {{"url", orthanc.webUrl()}}}}},
                    {"locked",
                     {{"name", "Locked"},
                      {"dicomweb", {{"url", locked.webUrl()}, {"signIn", "basic"}, {"user", "reader"}}}}},
                    {"store", dimseAt(store.port(), store.title())}};
    const Ran ran = test::ran(pythonWith({{"archives", ways},
                                          {"uid", series.studyUid},
                                          {"series", uids},
                                          {"images", kSeries * kSlices},
                                          {"slices", kSlices},
                                          {"study", (folder / "study").string()},
                                          {"odd", odd.string()},
                                          {"password", kPassword},
                                          {"closed", freePort()}}),
                              folder.path());
    EXPECT_EQ(ran.exitCode, 0) << ran.output;
    EXPECT_NE(ran.output.find("\nOK\n"), std::string::npos) << ran.output;
}

}  // namespace
}  // namespace macula::net::test
