// Macula may be a guest in a process: what the host logs through DCMTK is the host's.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/oflog/appender.h>
#include <dcmtk/oflog/oflog.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "base/phantom.h"
#include "dicom/pixels/decoders.h"
#include "dicom/scan.h"
#include "dicom/write/series_writer.h"
#include "formats/volume_file.h"
#include "support.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::dicom::test {
namespace {

namespace toolkit = dcmtk::log4cplus;

class Counter : public toolkit::Appender {
  public:
    explicit Counter(std::atomic<int>& events) : events_(events) {}
    ~Counter() override { destructorImpl(); }
    void close() override {}

  protected:
    void append(const toolkit::spi::InternalLoggingEvent& /*event*/) override { ++events_; }

  private:
    std::atomic<int>& events_;
};

class QuietToolkitTest : public ::testing::Test {
  protected:
    void SetUp() override {
        OFLog::configure(OFLogger::WARN_LOG_LEVEL);  // the host's
        toolkit::Logger::getRoot().addAppender(appender_);
    }
    void TearDown() override {
        toolkit::Logger::getRoot().removeAppender(appender_);
        OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    }
    void hostWarns() { OFLOG_WARN(logger_, "the host's own"); }

    std::atomic<int> events_{0};
    toolkit::SharedAppenderPtr appender_{new Counter(events_)};
    OFLogger logger_ = OFLog::getLogger("dcmtk.dcmdata");
};

TEST_F(QuietToolkitTest, TheHostsLogOutlivesWhatMaculaDoes) {
    const TemporaryFolder folder;
    Progress progress;
    const Volume volume = phantom::make();
    SeriesWriterOptions options;
    ASSERT_TRUE(writeSeries(volume, folder.path() / "study", options, progress).ok());
    ASSERT_TRUE(scanFolder(folder.path() / "study", progress).ok());
    ASSERT_TRUE(formats::writeVolumeFile(volume, folder.path() / "a.mha", progress).ok());
    // Of a size that the decoder looks at, and then noise.
    const std::vector<std::uint8_t> bytes{0xFF, 0xD8, 0xFF, 0xC3, 0,    11, 16, 0, 2,
                                          0,    2,    1,    1,    0x11, 0,  9,  9, 9};
    std::vector<std::uint16_t> cells(4);
    EXPECT_FALSE(decodeJpeg("1.2.840.10008.1.2.4.70", std::as_bytes(std::span(bytes)), 2, 2, cells).ok());
    EXPECT_EQ(events_, 0) << "Macula's use of the toolkit is heard";

    hostWarns();
    EXPECT_EQ(events_, 1);
}

TEST_F(QuietToolkitTest, QuietIsOneThreadAlone) {
    const QuietToolkit quiet;
    hostWarns();
    EXPECT_EQ(events_, 0);
    std::thread([this] { hostWarns(); }).join();
    EXPECT_EQ(events_, 1);
}

}  // namespace
}  // namespace macula::dicom::test
