#include "net/servers.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>

namespace macula::net::test {

namespace fs = std::filesystem;

namespace {

constexpr int kTries = 5;

// Starts a server at ports that were free a moment ago, and again at others if it ends, since somebody else
// may have taken one in between.
std::unique_ptr<Program> started(const std::function<std::unique_ptr<Program>()>& start,
                                 const std::function<bool()>& answers) {
    std::string output;
    for (int i = 0; i < kTries; ++i) {
        std::unique_ptr<Program> program = start();
        const bool hasChanged = comes([&] { return !program->isRunning() || answers(); }, 60.0);
        if (hasChanged && program->isRunning()) return program;
        output = program->output();
    }
    ADD_FAILURE() << "a server does not start:\n" << output;
    return nullptr;
}

void writeText(const fs::path& file, const std::string& text) {
    std::ofstream(file) << text;
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
}

}  // namespace

Orthanc::Orthanc(OrthancOptions options) : options_(std::move(options)) {
    fs::create_directory(folder_ / "storage");
    program_ = started(
        [&] {
            dicomPort_ = freePort();
            httpPort_ = freePort();
            writeSettings();
            return std::make_unique<Program>(
                std::vector<std::string>{programNamed("Orthanc"), (folder_ / "settings.json").string()},
                folder_.path());
        },
        [&] { return answersAt(dicomPort_) && answersAt(httpPort_); });
}

void Orthanc::start() {
    program_.reset();
    program_ = started(
        [&] {
            return std::make_unique<Program>(
                std::vector<std::string>{programNamed("Orthanc"), (folder_ / "settings.json").string()},
                folder_.path());
        },
        [&] { return answersAt(dicomPort_) && answersAt(httpPort_); });
}

void Orthanc::writeSettings() {
    nlohmann::json known = nlohmann::json::object();
    for (const KnownEntity& entity : options_.known)
        known[entity.title] = {entity.title, "127.0.0.1", entity.port};
    nlohmann::json settings = {
        {"Name", "Test"},
        {"StorageDirectory", (folder_ / "storage").string()},
        {"IndexDirectory", (folder_ / "storage").string()},
        {"Plugins", {"/usr/share/orthanc/plugins/libOrthancDicomWeb.so"}},
        {"DicomWeb", {{"Enable", true}, {"Root", "/dicom-web/"}, {"Host", "127.0.0.1"}}},
        {"HttpPort", httpPort_},
        {"DicomPort", dicomPort_},
        {"DicomAet", options_.title},
        {"DicomCheckCalledAet", true},
        {"DicomModalities", known},
        {"DicomAlwaysAllowEcho", true},
        {"DicomAlwaysAllowStore", true},
        {"DicomAlwaysAllowFind", true},
        {"DicomAlwaysAllowGet", true},
        {"DicomAlwaysAllowMove", true},
        {"TranscodeDicomProtocol", false},
        {"OverwriteInstances", true},
        {"SyncStorageArea", false},
        {"RemoteAccessAllowed", false},
        {"AuthenticationEnabled", !options_.user.empty()},
    };
    if (!options_.user.empty()) settings["RegisteredUsers"] = {{options_.user, options_.password}};
    if (options_.dicomTls) {
        settings["DicomTlsEnabled"] = true;
        settings["DicomTlsCertificate"] = options_.dicomTls->certificate.string();
        settings["DicomTlsPrivateKey"] = options_.dicomTls->key.string();
        settings["DicomTlsRemoteCertificateRequired"] = !options_.trusted.empty();
        // It wants such a file even where it asks for no certificate.
        settings["DicomTlsTrustedCertificates"] =
            (options_.trusted.empty() ? options_.dicomTls->certificate : options_.trusted).string();
    }
    if (options_.httpTls) {
        std::ofstream both(folder_ / "http.pem");
        both << std::ifstream(options_.httpTls->certificate).rdbuf()
             << std::ifstream(options_.httpTls->key).rdbuf();
        settings["SslEnabled"] = true;
        settings["SslCertificate"] = (folder_ / "http.pem").string();
    }
    settings.update(options_.more);
    writeText(folder_ / "settings.json", settings.dump(2));
}

std::string Orthanc::url() const {
    return fmt::format("{}://127.0.0.1:{}", options_.httpTls ? "https" : "http", httpPort_);
}

std::string Orthanc::webUrl() const {
    return url() + "/dicom-web";
}

QrArchive::QrArchive(QrArchiveOptions options) : options_(std::move(options)) {
    fs::create_directory(folder_ / "storage");
    program_ = started(
        [&] {
            port_ = freePort();
            std::string known;
            for (const KnownEntity& entity : options_.known)
                known += fmt::format("{0} = ({0}, 127.0.0.1, {1})\n", entity.title, entity.port);
            writeText(folder_ / "settings.cfg",
                      fmt::format("NetworkTCPPort = {}\nMaxPDUSize = 16384\nMaxAssociations = 16\n"
                                  "HostTable BEGIN\n{}HostTable END\nVendorTable BEGIN\nVendorTable END\n"
                                  "AETable BEGIN\n{} {} RW (500, 4096mb) ANY\nAETable END\n",
                                  port_, known, options_.title, (folder_ / "storage").string()));
            std::vector<std::string> command{programNamed("dcmqrscp"), "-c",
                                             (folder_ / "settings.cfg").string(), "-dhl"};
            command.insert(command.end(), options_.arguments.begin(), options_.arguments.end());
            return std::make_unique<Program>(command, folder_.path());
        },
        [&] { return answersAt(port_); });
}

StoreServer::StoreServer(std::vector<std::string> arguments, std::string title) : title_(std::move(title)) {
    fs::create_directory(folder_ / "received");
    program_ = started(
        [&] {
            port_ = freePort();
            std::vector<std::string> command{programNamed("storescp"),
                                             "--bit-preserving",
                                             "--accept-all",
                                             "--aetitle",
                                             title_,
                                             "--output-directory",
                                             (folder_ / "received").string()};
            command.insert(command.end(), arguments.begin(), arguments.end());
            command.push_back(std::to_string(port_));
            return std::make_unique<Program>(command, folder_.path());
        },
        [&] { return answersAt(port_); });
}

std::vector<fs::path> StoreServer::files() const {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder_ / "received")) files.push_back(entry.path());
    return files;
}

void sendFolder(const fs::path& folder, std::uint16_t port, const std::string& title) {
    const dicom::test::TemporaryFolder own;
    const Ran sent = ran(
        {programNamed("dcmsend"), "--aetitle", "SENDER", "--call", title, "--scan-directories", "--recurse",
         "--no-uid-checks", "--decompress-never", "127.0.0.1", std::to_string(port), folder.string()},
        own.path());
    EXPECT_EQ(sent.exitCode, 0) << sent.output;
}

std::string datasetBytes(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string all{std::istreambuf_iterator<char>(stream), {}};
    constexpr std::size_t kLengthAt = 128 + 4 + 8;  // of the value of FileMetaInformationGroupLength
    EXPECT_GT(all.size(), kLengthAt + 4) << file;
    if (all.size() <= kLengthAt + 4) return {};
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i)
        length |= static_cast<std::size_t>(static_cast<unsigned char>(all[kLengthAt + i])) << (8 * i);
    EXPECT_LE(kLengthAt + 4 + length, all.size()) << file;
    return all.substr(std::min(all.size(), kLengthAt + 4 + length));
}

}  // namespace macula::net::test
