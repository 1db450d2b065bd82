// What the tests of DIMSE share.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "net/archive/archive.h"
#include "net/connect.h"

namespace macula::net::test {

DimsePeer peerAt(std::uint16_t port, const std::string& title);
// Fails the test if the settings are refused. Waits short times.
std::unique_ptr<Archive> archiveAt(const DimsePeer& peer, const Secrets& secrets = {},
                                   std::chrono::seconds answerTimeout = std::chrono::seconds(20));

// Keeps what comes in a folder, as the parts of Macula do that have a place for it.
class FolderReceiver : public Receiver {
  public:
    explicit FolderReceiver(std::uintmax_t most = std::uintmax_t{1} << 30) : most_(most) {}

    Result<std::filesystem::path> place() override;
    Result<Verdict> take(const std::filesystem::path& file, const InstanceKey& promised) override;
    void drop(const std::filesystem::path& file) noexcept override;
    std::uintmax_t mostBytesOfInstance() const override { return most_; }

    // The files taken, by SOP Instance UID.
    std::map<std::string, std::filesystem::path> files() const;
    std::vector<InstanceKey> promises() const;
    std::size_t filesInFolder() const;  // taken, dropped and forgotten ones together
    std::size_t drops() const;

    std::set<std::string> refuses;       // SOP Instance UIDs
    std::size_t fullAfter = 1000000000;  // instances; then place() fails
    CancelToken cancelsAfterFirst;       // cancelled when the first instance is taken
    bool cancels = false;

  private:
    std::uintmax_t most_;
    dicom::test::TemporaryFolder folder_;
    mutable std::mutex mutex_;
    std::size_t placed_ = 0;
    std::size_t drops_ = 0;
    std::map<std::string, std::filesystem::path> files_;
    std::vector<InstanceKey> promises_;
};

// A study of several series with small images.
struct SmallStudy {
    std::string studyUid = "2.25.77001";
    std::string patientName = "MEIER^ANNA";
    std::string patientId = "P1";
    std::string date = "20240229";
    std::string modality = "CT";
    std::string description = "HEAD";
    int seriesCount = 2;
    int slices = 3;
    std::string transferSyntaxUid = "1.2.840.10008.1.2.1";
    std::vector<dicom::test::Edit> edits;
};
std::string seriesUidOf(const SmallStudy& study, int series);
// The files by SOP Instance UID.
std::map<std::string, std::filesystem::path> writeStudy(const std::filesystem::path& folder,
                                                        const SmallStudy& study);

// Every instance came, and its dataset is that of the file, byte by byte.
void expectSameDatasets(const std::map<std::string, std::filesystem::path>& received,
                        const std::map<std::string, std::filesystem::path>& expected);

std::string told(const Error& error);
std::string told(const std::vector<TestStep>& steps);

}  // namespace macula::net::test
