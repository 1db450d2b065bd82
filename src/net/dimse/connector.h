// Makes associations with one archive.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/source.h"
#include "net/dimse/association.h"
#include "net/dimse/tls.h"
#include "net/dimse/wire.h"

namespace macula::net {

class Connector {
  public:
    Connector(DimsePeer peer, Secrets secrets, std::chrono::seconds connectTimeout,
              std::chrono::seconds answerTimeout);

    const DimsePeer& peer() const { return peer_; }
    std::chrono::milliseconds answerTimeout() const { return target_.answerTimeout; }

    // All the steps.
    Result<std::unique_ptr<Association>> open(const std::vector<ProposedContext>& contexts,
                                              const CancelToken& cancel) const;
    // One by one.
    Result<std::vector<WireAddress>> findHost(const CancelToken& cancel) const;
    Result<std::unique_ptr<Wire>> connect(const std::vector<WireAddress>& addresses,
                                          const CancelToken& cancel) const;
    Result<void> protect(Wire& wire) const;  // does nothing where TLS is off
    Result<std::unique_ptr<Association>> associate(std::unique_ptr<Wire> wire,
                                                   const std::vector<ProposedContext>& contexts) const;

    // For connections that the archive makes to our receiver; none where TLS is off.
    Result<std::shared_ptr<const TlsSettings>> receiverTls() const;

  private:
    DimsePeer peer_;
    Secrets secrets_;
    WireTarget target_;
};

}  // namespace macula::net
