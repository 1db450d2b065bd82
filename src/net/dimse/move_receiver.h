// Where an archive sends the instances that it was asked to by C-MOVE: a provider of the storage service that
// exists only while they are fetched.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "net/dimse/connector.h"
#include "net/dimse/contexts.h"
#include "net/dimse/heartbeat.h"
#include "net/dimse/incoming.h"

namespace macula::net {

class MoveReceiver {
  public:
    // Waits until no other fetch of this process listens at the port. The receiver accepts eight associations
    // at most, only from peers that call it by its AE title, and only the transfer syntaxes of `encodings`.
    static Result<std::unique_ptr<MoveReceiver>> start(const Connector& connector, Incoming& incoming,
                                                       std::shared_ptr<Heartbeat> heartbeat,
                                                       Encodings encodings, const CancelToken& cancel);
    ~MoveReceiver();

    std::size_t openAssociations() const;

  private:
    struct State;
    explicit MoveReceiver(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

// The AE title by which the archive knows it.
const std::string& receiverTitle(const DimsePeer& peer);

}  // namespace macula::net
