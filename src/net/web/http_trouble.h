// What can go wrong between us and a server of the web, in words.
#pragma once

#include "base/result.h"

namespace macula::net {

enum class HttpTrouble {
    none,
    noName,
    noProxy,
    proxyRefuses,
    notReached,
    connectTimedOut,
    answerTimedOut,
    closed,
    certificateExpired,
    certificateNotTrusted,
    certificateOfAnotherHost,
    certificateRevoked,
    certificateWanted,
    ownCertificateUnusable,
    authoritiesUnusable,
    noTls,
    tlsFailed,
    notHttp,
    redirected,
    tooLarge,
    packed,
    badRequest,        // 400
    signInRefused,     // 401
    forbidden,         // 403
    notFound,          // 404, 410
    notOffered,        // 405, 501
    notAcceptable,     // 406
    conflict,          // 409
    requestTooLarge,   // 413
    mediaTypeRefused,  // 415
    busy,              // 429, 503
    serverFailed,      // other 5xx
    strangeStatus,     // any other
    clientFailed,      // memory, or what should not happen
};

// Of a status that is no success.
HttpTrouble troubleOfStatus(int status);

// Whether the same request may succeed when it is simply made again.
bool mayPass(HttpTrouble trouble);

// archiveNotUsable. The status is named where it says more than the words.
Error errorOf(HttpTrouble trouble, int status);

Error cancelledByPerson();

}  // namespace macula::net
