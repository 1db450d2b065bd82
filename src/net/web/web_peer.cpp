#include "net/web/web_peer.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/parsing.h"
#include "net/web/web_address.h"

namespace macula::net {

namespace {

Error badSetting(Text message, Text hint) {
    return {ErrorCode::usage, std::move(message), {}, std::move(hint)};
}

bool holdsControls(const std::string& text) {
    return std::ranges::any_of(text,
                               [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; });
}

Result<void> checkFiles(const Tls& tls) {
    std::error_code failed;
    if (!tls.authorities.empty() && !std::filesystem::exists(tls.authorities, failed))
        return badSetting(Text("The file or folder of trusted authorities does not exist."),
                          Text("Name a PEM file, or leave the field empty for those of the system."));
    for (const auto& file : {tls.certificate, tls.key}) {
        if (!file.empty() && !std::filesystem::is_regular_file(file, failed))
            return badSetting(Text("The certificate of this machine, or its key, does not exist."),
                              Text("Name the PEM files that the archive's administrator issued."));
    }
    if (tls.certificate.empty() && !tls.key.empty())
        return badSetting(Text("There is a key, but no certificate that it belongs to."),
                          Text("Name the PEM file of the certificate too."));
    return {};
}

Result<void> checkSecretsOf(const WebPeer& peer, const Secrets& secrets) {
    for (const std::string& text :
         {peer.user, peer.clientId, peer.scope, secrets.password, secrets.token, secrets.refreshToken}) {
        if (holdsControls(text))
            return badSetting(Text("A name, password or token of the sign-in holds a control character."),
                              Text("Enter it again, without a line end."));
    }
    if (peer.signIn == SignIn::basic && peer.user.find(':') != std::string::npos)
        return badSetting(Text("The user name of the sign-in holds a colon, which no user name may."),
                          Text("Enter the user name alone."));
    if (peer.signIn == SignIn::basic && peer.user.empty())
        return badSetting(Text("The sign-in has no user name."), Text("Enter user name and password."));
    const auto mayStand = [](char c) { return c > ' ' && c <= '~'; };
    if (peer.signIn == SignIn::bearer &&
        (secrets.token.empty() || !std::ranges::all_of(secrets.token, mayStand)))
        return badSetting(Text("The sign-in has no token that could be sent."),
                          Text("Enter the token that the archive's administrator issued."));
    return {};
}

Result<void> checkTokenService(const WebPeer& peer) {
    std::vector<std::string> urls{peer.tokenUrl};
    if (peer.signIn == SignIn::device) urls.push_back(peer.deviceUrl);
    for (const std::string& url : urls) {
        const auto address = webAddressOf(url);
        if (!address || !mayHearSecrets(*address))
            return badSetting(
                Text("The address of the service that gives tokens does not begin with https://."),
                Text("Enter the address that the administrator of the sign-in names."));
    }
    if (peer.clientId.empty())
        return badSetting(Text("The sign-in has no name of the client."),
                          Text("Enter the client and its secret, as they are registered."));
    return {};
}

}  // namespace

Result<void> checkWebPeer(const WebPeer& peer, const Secrets& secrets) {
    MACULA_TRY(const WebAddress address, webAddressOf(peer.url));
    if (peer.signIn != SignIn::none && !mayHearSecrets(address))
        return badSetting(
            Text("A password or token would go over the network without encryption."),
            Text("Enter an address that begins with https://, or one of this machine, or no sign-in."));
    MACULA_TRY_VOID(checkSecretsOf(peer, secrets));
    if (peer.signIn == SignIn::clientCredentials || peer.signIn == SignIn::device)
        MACULA_TRY_VOID(checkTokenService(peer));
    constexpr std::array kProxies{"http://", "https://", "socks5://", "socks5h://"};
    const std::string proxy = lowerCase(peer.proxy);
    const bool isProxy = proxy.empty() || std::ranges::any_of(kProxies, [&](const char* scheme) {
                             return proxy.starts_with(scheme);
                         });
    if (!isProxy || holdsControls(proxy))
        return badSetting(Text("The address of the proxy is malformed."),
                          Text("Enter it as in http://proxy.example.org:3128, or leave it empty."));
    if (proxy.find('@') != std::string::npos)
        return badSetting(
            Text("The address of the proxy holds a user name or password, which others could read there."),
            Text("Leave it out, and ask whoever runs the proxy to allow this machine without one."));
    return checkFiles(peer.tls);
}

HttpSettings httpSettingsOf(const Source& source, const WebPeer& peer, const Secrets& secrets) {
    HttpSettings settings;
    settings.tls = peer.tls;
    settings.keyPassphrase = secrets.keyPassphrase;
    settings.proxy = peer.proxy;
    settings.connectTimeout = source.connectTimeout;
    settings.answerTimeout = source.answerTimeout;
    return settings;
}

}  // namespace macula::net
