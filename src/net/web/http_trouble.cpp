#include "net/web/http_trouble.h"

#include <vector>

namespace macula::net {

namespace {

struct HttpWords {
    HttpTrouble trouble;
    Text message;
    Text hint;
};

const Text& askTheAdministrator() {
    static const Text kHint("Ask the administrator of the archive.");
    return kHint;
}

std::vector<HttpWords> wordsOfConnection() {
    return {
        {HttpTrouble::noName, Text("The name of the archive's host is not known in the network."),
         Text(
             "Check how the host is spelled in the address, and that this machine is in the right network.")},
        {HttpTrouble::noProxy, Text("The name of the proxy is not known in the network."),
         Text("Check the proxy in the settings of the archive, or in https_proxy.")},
        {HttpTrouble::proxyRefuses, Text("The proxy does not connect to the archive."),
         Text("Ask whoever runs the proxy, or name the archive's host in no_proxy.")},
        {HttpTrouble::notReached, Text("The archive's host does not accept connections at this port."),
         Text("Check host and port in the address, and ask whether the service runs and the "
              "firewall lets it through.")},
        {HttpTrouble::connectTimedOut, Text("The archive's host did not answer in time when it was called."),
         Text("Check host and port in the address; a firewall may be in between.")},
        {HttpTrouble::answerTimedOut, Text("The archive stopped answering."),
         Text("Try again later, or set a longer time for answers.")},
        {HttpTrouble::closed, Text("The archive closed the connection before its answer was complete."),
         Text("Try again; if it happens again, ask the administrator of the archive.")},
        {HttpTrouble::notHttp, Text("What answers at this address does not speak as a web service does."),
         Text("Check host and port in the address, and whether it begins with https://.")},
        {HttpTrouble::redirected, Text("The archive refers to another host, which gets no requests."),
         Text("Enter the address that the archive's administrator names; a page for signing in "
              "may be in between.")},
    };
}

std::vector<HttpWords> wordsOfTls() {
    return {
        {HttpTrouble::certificateExpired, Text("The archive's certificate is not valid at this time."),
         Text("Check the clock of this machine; if it is right, the archive needs a new certificate.")},
        {HttpTrouble::certificateNotTrusted,
         Text("The archive's certificate is signed by nobody whom this machine trusts."),
         Text("Name the file of the authority that signed it in the settings of the archive.")},
        {HttpTrouble::certificateOfAnotherHost, Text("The archive's certificate is for another host."),
         Text("Enter the host in the address as the certificate names it.")},
        {HttpTrouble::certificateRevoked, Text("The archive's certificate was revoked."),
         Text("Do not use this archive until its administrator has renewed it.")},
        {HttpTrouble::certificateWanted,
         Text("The archive wants a certificate of this machine, and accepts none that it got."),
         Text("Set certificate and key that the archive's administrator issued.")},
        {HttpTrouble::ownCertificateUnusable,
         Text("The certificate of this machine cannot be used with its key."),
         Text("Check both files, which must be PEM, and the passphrase of the key.")},
        {HttpTrouble::authoritiesUnusable, Text("The file or folder of trusted authorities cannot be read."),
         Text("Check that it exists and holds certificates as PEM.")},
        {HttpTrouble::noTls, Text("The archive does not encrypt at this port."),
         Text("Check the port in the address; without encryption it begins with http://.")},
        {HttpTrouble::tlsFailed, Text("This computer and the archive could not agree on encryption."),
         Text("The archive must offer TLS 1.2 or later: ask its administrator.")},
    };
}

std::vector<HttpWords> wordsOfAnswer(int status) {
    return {
        {HttpTrouble::tooLarge, Text("The archive's answer is larger than any should be."),
         askTheAdministrator()},
        {HttpTrouble::packed, Text("The archive compresses its answers, although it was not asked to."),
         Text("Ask the administrator to send DICOMweb answers without compression.")},
        {HttpTrouble::badRequest, Text("The archive does not understand the request (400)."),
         Text("Simplify the search, and check that the address is that of DICOMweb and begins "
              "with https:// where the archive encrypts.")},
        {HttpTrouble::signInRefused, Text("The archive does not accept the sign-in (401)."),
         Text("Check user name and password, or the token, in the settings of the archive.")},
        {HttpTrouble::forbidden, Text("The archive does not allow this to the user that is signed in (403)."),
         Text("Ask the administrator of the archive for the rights to search and retrieve.")},
        {HttpTrouble::notFound, Text("The archive has nothing at this address (404)."),
         Text("Check the path in the address of the service; a study may have been removed.")},
        {HttpTrouble::notOffered, Text("The archive does not offer this service ({}).", status),
         askTheAdministrator()},
        {HttpTrouble::notAcceptable, Text("The archive cannot send images as they are stored (406)."),
         Text("Ask the administrator of the archive whether WADO-RS is on, or use DIMSE with this archive.")},
        {HttpTrouble::conflict, Text("The archive could not store what it was sent (409)."),
         askTheAdministrator()},
        {HttpTrouble::requestTooLarge,
         Text("The archive, or a proxy before it, does not take files of this size (413)."),
         Text("Ask the administrator to raise the limit for uploads.")},
        {HttpTrouble::mediaTypeRefused, Text("The archive does not take files of this kind (415)."),
         askTheAdministrator()},
        {HttpTrouble::busy, Text("The archive has too much to do at the moment ({}).", status),
         Text("Try again in some minutes.")},
        {HttpTrouble::serverFailed, Text("The archive has a fault of its own ({}).", status),
         Text("Try again later; if it stays so, tell the administrator of the archive.")},
        {HttpTrouble::strangeStatus, Text("The archive answered with the unexpected status {}.", status),
         askTheAdministrator()},
    };
}

}  // namespace

HttpTrouble troubleOfStatus(int status) {
    switch (status) {
        case 400:
            return HttpTrouble::badRequest;
        case 401:
            return HttpTrouble::signInRefused;
        case 403:
            return HttpTrouble::forbidden;
        case 404:
        case 410:
            return HttpTrouble::notFound;
        case 405:
        case 501:
            return HttpTrouble::notOffered;
        case 406:
            return HttpTrouble::notAcceptable;
        case 407:
            return HttpTrouble::proxyRefuses;
        case 409:
            return HttpTrouble::conflict;
        case 413:
            return HttpTrouble::requestTooLarge;
        case 415:
            return HttpTrouble::mediaTypeRefused;
        case 429:
        case 503:
            return HttpTrouble::busy;
        default:
            break;
    }
    constexpr int kServersFault = 500;
    constexpr int kBeyond = 600;
    return status >= kServersFault && status < kBeyond ? HttpTrouble::serverFailed
                                                       : HttpTrouble::strangeStatus;
}

bool mayPass(HttpTrouble trouble) {
    return trouble == HttpTrouble::notReached || trouble == HttpTrouble::connectTimedOut ||
           trouble == HttpTrouble::answerTimedOut || trouble == HttpTrouble::closed ||
           trouble == HttpTrouble::busy || trouble == HttpTrouble::serverFailed;
}

Error errorOf(HttpTrouble trouble, int status) {
    for (const auto& table : {wordsOfConnection(), wordsOfTls(), wordsOfAnswer(status)}) {
        for (const HttpWords& words : table) {
            if (words.trouble == trouble) return {ErrorCode::archiveNotUsable, words.message, {}, words.hint};
        }
    }
    return {ErrorCode::archiveNotUsable,
            Text("The connection with the archive failed, for a reason that the program did not foresee."),
            {},
            Text("Try again; if it fails again, report it.")};
}

Error cancelledByPerson() {
    return {ErrorCode::cancelled, Text("The work with the archive was cancelled."), {}, {}};
}

}  // namespace macula::net
