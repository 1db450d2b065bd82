#include "net/dimse/connector.h"

#include <utility>

namespace macula::net {

Connector::Connector(DimsePeer peer, Secrets secrets, std::chrono::seconds connectTimeout,
                     std::chrono::seconds answerTimeout)
    : peer_(std::move(peer)),
      secrets_(std::move(secrets)),
      target_{peer_.host, peer_.port, connectTimeout, answerTimeout} {}

Result<std::vector<WireAddress>> Connector::findHost(const CancelToken& cancel) const {
    return addressesOf(target_, cancel);
}

Result<std::unique_ptr<Wire>> Connector::connect(const std::vector<WireAddress>& addresses,
                                                 const CancelToken& cancel) const {
    return Wire::connect(target_, addresses, cancel);
}

Result<void> Connector::protect(Wire& wire) const {
    if (!peer_.tls.isOn) return {};
    MACULA_TRY(const auto settings,
               TlsSettings::of(peer_.tls, secrets_.keyPassphrase, TlsSettings::Role::connects));
    return wire.beginTls(*settings, peer_.host, target_.connectTimeout);
}

Result<std::unique_ptr<Association>> Connector::associate(
    std::unique_ptr<Wire> wire, const std::vector<ProposedContext>& contexts) const {
    return Association::request(std::move(wire), {peer_.callingAe, peer_.calledAe}, contexts);
}

Result<std::unique_ptr<Association>> Connector::open(const std::vector<ProposedContext>& contexts,
                                                     const CancelToken& cancel) const {
    MACULA_TRY(const std::vector<WireAddress> addresses, findHost(cancel));
    MACULA_TRY(std::unique_ptr<Wire> wire, connect(addresses, cancel));
    MACULA_TRY_VOID(protect(*wire));
    return associate(std::move(wire), contexts);
}

Result<std::shared_ptr<const TlsSettings>> Connector::receiverTls() const {
    if (!peer_.tls.isOn) return std::shared_ptr<const TlsSettings>();
    if (peer_.tls.certificate.empty())
        return Error{
            ErrorCode::usage,
            Text("To be sent instances over protected connections, this program needs a certificate."),
            {},
            Text("Enter one with its key in the settings of the archive, or fetch with C-GET.")};
    return TlsSettings::of(peer_.tls, secrets_.keyPassphrase, TlsSettings::Role::accepts);
}

}  // namespace macula::net
