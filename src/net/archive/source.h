// An archive (PACS) as a person or an administrator has set it up.
//
// A source holds no secrets: those stand in Secrets, which is read when a connection is made, and never
// written beside it.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>

namespace macula::net {

// PS3.15 B.9 (BCP 195): TLS 1.2 and later. Files are PEM. An empty `authorities` means those of the system.
struct Tls {
    bool isOn = false;
    std::filesystem::path authorities;  // a file, or a folder of hashed certificates, of those who may sign
                                        // the peer's certificate
    std::filesystem::path certificate;  // ours, where the peer asks for one
    std::filesystem::path key;          // of our certificate
};

// Which way instances come: C-GET over the association that asked, or C-MOVE to a receiver of ours, which the
// archive must know by its AE title, host and port. `automatic` takes C-GET if the archive accepts it, else
// C-MOVE if `receiverPort` is set.
enum class Retrieve { automatic, get, move };

// An archive that speaks DIMSE (PS3.7, PS3.8).
struct DimsePeer {
    std::string host;
    std::uint16_t port = 104;
    std::string calledAe;  // the archive's AE title, 1 to 16 characters
    std::string callingAe = "MACULA";
    Retrieve retrieve = Retrieve::automatic;
    // For C-MOVE: the title by which the archive knows our receiver (empty: callingAe), and where that
    // listens. 0: nothing listens.
    std::string receiverAe;
    std::uint16_t receiverPort = 0;
    std::string receiverAddress;  // to listen at; empty: all addresses of this machine, since the archive
                                  // must reach it
    bool patientRoot = false;  // asks by the patient root model; archives without the study root model exist
    // In which non-ASCII keys are sent (PS3.3 C.12.1.1.2). Answers name their own.
    std::string characterSet = "ISO_IR 192";
    Tls tls;
};

enum class SignIn {
    none,
    basic,              // user and Secrets::password
    bearer,             // Secrets::token
    clientCredentials,  // OAuth 2 (RFC 6749 4.4): a token from tokenUrl for clientId and Secrets::password
    device,             // OAuth 2 device flow (RFC 8628): a person signs in by a browser, see
                        // web/device_sign_in.h; then tokens from tokenUrl for Secrets::refreshToken
};

// An archive that speaks DICOMweb (PS3.18).
struct WebPeer {
    std::string
        url;  // of the service: QIDO-RS, WADO-RS and STOW-RS answer below it, as in https://pacs/dicom-web
    SignIn signIn = SignIn::none;
    std::string user;
    std::string tokenUrl;
    std::string deviceUrl;  // of the device flow: where codes come from
    std::string clientId;
    std::string scope;
    std::string proxy;  // empty: that of the environment (https_proxy, no_proxy)
    Tls tls;            // isOn is not read: the URL says it
};

struct Source {
    std::string name;  // by which people call it; unique, without / and control characters
    std::variant<DimsePeer, WebPeer> peer;
    std::chrono::seconds connectTimeout{10};
    std::chrono::seconds answerTimeout{60};  // without a byte from the peer
    bool isManaged = false;                  // from the administrator's file: it cannot be changed here
};

// Never logged, printed or kept in the file of sources.
struct Secrets {
    std::string password;       // of the user, or of the OAuth 2 client
    std::string token;          // bearer
    std::string refreshToken;   // of the device flow
    std::string keyPassphrase;  // of Tls::key
};

}  // namespace macula::net
