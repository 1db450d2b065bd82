#include "net/dimse/tls.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmtls/tlslayer.h>
#include <openssl/ssl.h>
#include <openssl/x509_vfy.h>

#include <filesystem>
#include <mutex>
#include <utility>

#include "net/dimse/failures.h"
#include "toolkit/quiet_toolkit.h"

namespace macula::net {

namespace fs = std::filesystem;

namespace {

constexpr const char* kAuthoritiesOfTheSystem = "/etc/ssl/certs";

Error unusableFile(Text message, const fs::path& file, Text hint) {
    return {ErrorCode::archiveNotUsable, std::move(message), file.string(), std::move(hint)};
}

// Whether the system's authorities count, or those of a file or a folder.
Result<void> trustAuthorities(DcmTLSTransportLayer& layer, const fs::path& given) {
    const fs::path authorities = given.empty() ? fs::path(kAuthoritiesOfTheSystem) : given;
    std::error_code ignored;
    const bool isFolder = fs::is_directory(authorities, ignored);
    const OFCondition added = isFolder
                                  ? layer.addTrustedCertificateDir(authorities.c_str(), DCF_Filetype_PEM)
                                  : layer.addTrustedCertificateFile(authorities.c_str(), DCF_Filetype_PEM);
    if (added.good()) return {};
    return unusableFile(Text("The certificates of the authorities that are to be trusted cannot be read."),
                        authorities, Text("Enter a PEM file, or a folder of hashed certificates."));
}

Result<void> showCertificate(DcmTLSTransportLayer& layer, const Tls& tls, const std::string& passphrase) {
    if (tls.certificate.empty()) return {};
    // An empty one too: without it, DCMTK asks at the terminal.
    layer.setPrivateKeyPasswd(passphrase.c_str());
    // The key first: a key that does not belong to the certificate counts as unreadable after it.
    const fs::path& key = tls.key.empty() ? tls.certificate : tls.key;
    if (layer.setPrivateKeyFile(key.c_str(), DCF_Filetype_PEM).bad())
        return unusableFile(Text("The key of this program's certificate cannot be read."), key,
                            Text("Enter a PEM file, and its passphrase if it has one."));
    if (layer.setCertificateFile(tls.certificate.c_str(), DCF_Filetype_PEM).bad())
        return unusableFile(Text("The certificate of this program cannot be read."), tls.certificate,
                            Text("Enter a PEM file."));
    if (!layer.checkPrivateKeyMatchesCertificate())
        return unusableFile(Text("The key does not belong to this program's certificate."), key,
                            Text("Enter the key that was made together with the certificate."));
    return {};
}

}  // namespace

struct TlsSettings::Layer {
    explicit Layer(Role role)
        : toolkit(role == Role::connects ? NET_REQUESTOR : NET_ACCEPTOR, nullptr, OFFalse) {}
    DcmTLSTransportLayer toolkit;
};

TlsSettings::TlsSettings(std::unique_ptr<Layer> layer, Role role) : layer_(std::move(layer)), role_(role) {}

TlsSettings::~TlsSettings() = default;

ssl_ctx_st* TlsSettings::native() const {
    return layer_->toolkit.getNativeHandle();
}

Result<std::shared_ptr<const TlsSettings>> TlsSettings::of(const Tls& tls, const std::string& keyPassphrase,
                                                           Role role) {
    const QuietToolkit quiet;
    static std::once_flag once;
    std::call_once(once, [] { DcmTLSTransportLayer::initializeOpenSSL(); });
    auto layer = std::make_unique<Layer>(role);
    DcmTLSTransportLayer& toolkit = layer->toolkit;
    const Error noTls = archiveError(Text("This machine's library for TLS cannot be used."),
                                     Text("Ask whoever looks after this machine to update OpenSSL."));
    if (!toolkit || toolkit.setTLSProfile(TSP_Profile_BCP195_ND).bad()) return noTls;
    // The profile of DCMTK 3.6.7 leaves out certificates with elliptic curves, which BCP 195 allows.
    for (const char* suite :
         {"TLS_ECDHE_ECDSA_WITH_AES_128_GCM_SHA256", "TLS_ECDHE_ECDSA_WITH_AES_256_GCM_SHA384"})
        static_cast<void>(toolkit.addCipherSuite(suite));
    if (toolkit.activateCipherSuites().bad()) return noTls;
    const bool asks = role != Role::acceptsAnyone;
    if (asks) MACULA_TRY_VOID(trustAuthorities(toolkit, tls.authorities));
    MACULA_TRY_VOID(showCertificate(toolkit, tls, keyPassphrase));
    toolkit.setCertificateVerification(asks ? DCV_requireCertificate : DCV_ignoreCertificate);
    // DCMTK's callback logs each certificate, and lets none pass that OpenSSL refuses: it is not needed.
    SSL_CTX_set_verify(toolkit.getNativeHandle(),
                       asks ? SSL_VERIFY_PEER | SSL_VERIFY_FAIL_IF_NO_PEER_CERT : SSL_VERIFY_NONE, nullptr);
    return std::shared_ptr<const TlsSettings>(new TlsSettings(std::move(layer), role));
}

Error errorOfCertificate(long problem) {
    switch (problem) {
        case X509_V_ERR_CERT_HAS_EXPIRED:
            return archiveError(
                Text("The certificate of the archive has expired."),
                Text("Ask the administrator of the archive to renew it, and check this machine's date."));
        case X509_V_ERR_CERT_NOT_YET_VALID:
            return archiveError(Text("The certificate of the archive is not valid yet."),
                                Text("Check this machine's date and time."));
        case X509_V_ERR_HOSTNAME_MISMATCH:
        case X509_V_ERR_IP_ADDRESS_MISMATCH:
            return archiveError(
                Text("The certificate of the archive is for another host name."),
                Text("Enter the host name that the certificate names; another one may be an impostor's."));
        case X509_V_ERR_CERT_REVOKED:
            return archiveError(Text("The certificate of the archive has been revoked."),
                                Text("Ask the administrator of the archive."));
        default:
            return archiveError(
                Text("The certificate of the archive is signed by nobody whom this machine trusts."),
                Text("Enter the certificate of the authority that signed it, which the administrator of the "
                     "archive has."));
    }
}

}  // namespace macula::net
