// The servers of the tests themselves: they answer, keep what they get, and leave nothing.
#include "net/servers.h"

#include <gtest/gtest.h>

#include "dicom/synthetic.h"

namespace macula::net::test {

namespace {

void expectEcho(std::uint16_t port, const std::string& title) {
    const dicom::test::TemporaryFolder folder;
    const Ran echoed =
        ran({programNamed("echoscu"), "-aec", title, "127.0.0.1", std::to_string(port)}, folder.path());
    EXPECT_EQ(echoed.exitCode, 0) << echoed.output;
}

TEST(Servers, OrthancAnswers) {
    SKIP_WITHOUT_PROGRAM("Orthanc");
    SKIP_WITHOUT_PROGRAM("echoscu");
    std::filesystem::path folder;
    std::uint16_t port = 0;
    {
        Orthanc orthanc;
        folder = orthanc.folder();
        port = orthanc.dicomPort();
        expectEcho(port, orthanc.title());
        orthanc.stop();
        EXPECT_FALSE(answersAt(port));
        orthanc.start();
        expectEcho(port, orthanc.title());
    }
    EXPECT_FALSE(answersAt(port));
    EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(Servers, DcmtksArchiveAnswers) {
    SKIP_WITHOUT_PROGRAM("dcmqrscp");
    SKIP_WITHOUT_PROGRAM("echoscu");
    const QrArchive archive;
    expectEcho(archive.port(), archive.title());
}

TEST(Servers, AStoreKeepsDatasetsByteByByte) {
    SKIP_WITHOUT_PROGRAM("storescp");
    SKIP_WITHOUT_PROGRAM("dcmsend");
    const dicom::test::TemporaryFolder folder;
    dicom::test::SyntheticSeries series;
    series.size = {8, 8, 1};
    const auto files = dicom::test::writeFiles(folder.path(), series);
    const StoreServer server;
    sendFolder(folder.path(), server.port(), server.title());
    ASSERT_EQ(server.files().size(), 1u) << server.output();
    EXPECT_EQ(datasetBytes(server.files().front()), datasetBytes(files.front()));
}

}  // namespace

}  // namespace macula::net::test
