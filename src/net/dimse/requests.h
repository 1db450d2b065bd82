// Requests of a peer, over an association that it asked for.
#pragma once

#include <functional>

#include "net/dimse/messages.h"

namespace macula::net {

// Answers C-ECHO, and hands over all other requests, until `handle` returns false or the association ends.
void answerRequests(Association& association, const std::function<bool(const ReceivedCommand&)>& handle);

}  // namespace macula::net
