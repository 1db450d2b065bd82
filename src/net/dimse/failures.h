// All that can go wrong between this program and an archive, in plain words, with what to do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/result.h"

namespace macula::net {

Error archiveError(Text message, Text hint);
Error cancelledError();
Error cancelledSending(std::size_t stored, std::size_t all);

// Of the network.
Error unknownHost();
Error connectionRefused();
Error hostUnreachable();
Error noAnswerToConnection();
Error noAnswer();          // connected, then silent
Error closedMidway();      // by the peer or the network
Error closedAtOnce();      // when an association was asked for
Error notWhatDicomSays();  // bytes that no archive should send
// `code`: errno of a connection that could not be made.
Error errorOfConnecting(int code);

// Of A-ASSOCIATE-RJ (PS3.8 9.3.4): its result, source and reason.
struct Rejection {
    unsigned result = 1;  // 1: permanent, 2: transient
    unsigned source = 1;
    unsigned reason = 1;
};
Error errorOfRejection(const Rejection& rejection, const std::string& callingAe, const std::string& calledAe);

// What the archive was asked to do; the same status means different things.
enum class Service { echo, find, get, move, store, commit };
bool isPending(std::uint16_t status);
bool isWarning(std::uint16_t status);
// Of a status that is neither success, pending nor a warning (PS3.7 annex C, PS3.4 annexes B and C).
Error errorOfStatus(Service service, std::uint16_t status);
// Why an archive does not commit to keeping an instance: the reason of PS3.4 J.3.3.1.1 (0008,1197).
Error errorOfCommitment(std::uint16_t reason);
// The archive accepts the association, but not this service.
Error serviceNotOffered(Service service);

}  // namespace macula::net
