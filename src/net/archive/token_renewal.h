// Renewing the tokens of a sign-in by OAuth 2.
#pragma once

#include <functional>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/source.h"

namespace macula::net {

// Asks the token service with the refresh token of these secrets, and returns them with new tokens.
using AskForTokens = std::function<Result<Secrets>(const Secrets&)>;
// Renews the tokens of a sign-in that others may be using too, such as another window: one after another,
// since a service may take a refresh token that comes twice for a stolen one. Asks, and keeps what came; or
// returns what another has kept meanwhile. Called by any thread that makes requests.
using RenewTokens =
    std::function<Result<Secrets>(const Secrets& ours, const AskForTokens& ask, const CancelToken& cancel)>;

}  // namespace macula::net
