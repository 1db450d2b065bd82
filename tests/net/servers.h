// Archives of others that run on loopback while a test does.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "dicom/support.h"
#include "net/certificates.h"
#include "net/programs.h"

namespace macula::net::test {

// An application entity to which an archive may send (C-MOVE).
struct KnownEntity {
    std::string title;
    std::uint16_t port = 0;
};

struct OrthancOptions {
    std::string title = "ORTHANC";
    std::vector<KnownEntity> known;
    // Protects DIMSE. With `trusted`, the peer must show a certificate that this file trusts.
    std::optional<Certificate> dicomTls;
    std::filesystem::path trusted;
    // Protects HTTP: its certificate and key.
    std::optional<Certificate> httpTls;
    std::string user;  // of HTTP; empty: nobody signs in
    std::string password;
    nlohmann::json more = nlohmann::json::object();  // settings that replace those of the fixture
};

// Orthanc with DICOMweb, in a folder of its own; every DIMSE service is on, for everybody. Fails the test if
// it does not start.
class Orthanc {
  public:
    explicit Orthanc(OrthancOptions options = {});

    std::uint16_t dicomPort() const { return dicomPort_; }
    std::uint16_t httpPort() const { return httpPort_; }
    const std::string& title() const { return options_.title; }
    std::string url() const;     // of its own interface, as in http://127.0.0.1:8042
    std::string webUrl() const;  // of DICOMweb
    const std::filesystem::path& folder() const { return folder_.path(); }
    std::string output() const { return program_ ? program_->output() : std::string(); }
    bool isRunning() { return program_ && program_->isRunning(); }

    // Ends it, as when a machine goes down; start() brings it back at the same ports, with what it has.
    void stop() { program_.reset(); }
    void start();

  private:
    void writeSettings();

    OrthancOptions options_;
    dicom::test::TemporaryFolder folder_;
    std::uint16_t dicomPort_ = 0;
    std::uint16_t httpPort_ = 0;
    std::unique_ptr<Program> program_;
};

struct QrArchiveOptions {
    std::string title = "ARCHIVE";
    std::vector<KnownEntity> known;
    std::vector<std::string> arguments;  // more of dcmqrscp, as --disable-get
};

// DCMTK's archive.
class QrArchive {
  public:
    explicit QrArchive(QrArchiveOptions options = {});

    std::uint16_t port() const { return port_; }
    const std::string& title() const { return options_.title; }
    std::string output() const { return program_ ? program_->output() : std::string(); }
    void stop() { program_.reset(); }

  private:
    QrArchiveOptions options_;
    dicom::test::TemporaryFolder folder_;
    std::uint16_t port_ = 0;
    std::unique_ptr<Program> program_;
};

// DCMTK's storescp, which keeps each dataset as it comes.
class StoreServer {
  public:
    explicit StoreServer(std::vector<std::string> arguments = {}, std::string title = "STORE");

    std::uint16_t port() const { return port_; }
    const std::string& title() const { return title_; }
    std::vector<std::filesystem::path> files() const;  // that it received
    std::string output() const { return program_ ? program_->output() : std::string(); }

  private:
    std::string title_;
    dicom::test::TemporaryFolder folder_;
    std::uint16_t port_ = 0;
    std::unique_ptr<Program> program_;
};

// Sends the files of a folder with DCMTK's dcmsend, each in its own transfer syntax.
void sendFolder(const std::filesystem::path& folder, std::uint16_t port, const std::string& title);

// What stands behind the file meta information of PS3.10: the dataset, byte by byte.
std::string datasetBytes(const std::filesystem::path& file);

}  // namespace macula::net::test
