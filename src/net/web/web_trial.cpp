#include "net/web/web_trial.h"

#include <utility>

#include "net/web/multipart_parser.h"
#include "net/web/qido_search.h"
#include "net/web/web_address.h"

namespace macula::net {

namespace {

// Looks at how an answer begins, and stops it.
class FirstBytes final : public HttpSink {
  public:
    Result<void> begin(const HttpHead& head) override {
        isOfDicom_ = boundaryOf(head.contentType) || mediaTypeOf(head.contentType) == "application/dicom";
        return {};
    }
    Result<void> write(std::span<const std::byte> /*bytes*/) override {
        return Error{ErrorCode::cancelled, Text("The first bytes are enough."), {}, {}};
    }
    bool endsAll() const override { return false; }
    bool isOfDicom() const { return isOfDicom_; }

  private:
    bool isOfDicom_ = false;
};

Error noImagesSent() {
    return {ErrorCode::archiveNotUsable,
            Text("The archive finds images but does not send them."),
            {},
            Text("Ask its administrator whether WADO-RS is on.")};
}

}  // namespace

WebTrial::WebTrial(const std::string& service, const HttpSettings& settings, CredentialSource& signIn,
                   Progress& progress)
    : service_(service), settings_(settings), signIn_(signIn), progress_(progress) {}

Text WebTrial::nameOf(Step step) {
    switch (step) {
        case Step::address:
            return Text("Address");
        case Step::name:
            return Text("Host name");
        case Step::connection:
            return Text("Connection");
        case Step::encryption:
            return Text("Encryption");
        case Step::signIn:
            return Text("Sign-in");
        case Step::search:
            return Text("Search");
        case Step::retrieval:
            return Text("Retrieval");
    }
    return {};
}

WebTrial::Step WebTrial::stepOf(const HttpOutcome& outcome) {
    switch (outcome.trouble) {
        case HttpTrouble::noName:
        case HttpTrouble::noProxy:
            return Step::name;
        case HttpTrouble::proxyRefuses:
        case HttpTrouble::notReached:
        case HttpTrouble::connectTimedOut:
            return Step::connection;
        case HttpTrouble::certificateExpired:
        case HttpTrouble::certificateNotTrusted:
        case HttpTrouble::certificateOfAnotherHost:
        case HttpTrouble::certificateRevoked:
        case HttpTrouble::certificateWanted:
        case HttpTrouble::ownCertificateUnusable:
        case HttpTrouble::authoritiesUnusable:
        case HttpTrouble::noTls:
        case HttpTrouble::tlsFailed:
            return Step::encryption;
        case HttpTrouble::signInRefused:
        case HttpTrouble::forbidden:
            return Step::signIn;
        case HttpTrouble::none:
        case HttpTrouble::answerTimedOut:
        case HttpTrouble::closed:
        case HttpTrouble::notHttp:
        case HttpTrouble::redirected:
        case HttpTrouble::tooLarge:
        case HttpTrouble::packed:
        case HttpTrouble::badRequest:
        case HttpTrouble::notFound:
        case HttpTrouble::notOffered:
        case HttpTrouble::notAcceptable:
        case HttpTrouble::conflict:
        case HttpTrouble::requestTooLarge:
        case HttpTrouble::mediaTypeRefused:
        case HttpTrouble::busy:
        case HttpTrouble::serverFailed:
        case HttpTrouble::strangeStatus:
        case HttpTrouble::clientFailed:
            break;
    }
    return Step::search;
}

void WebTrial::pass(Step step, Text detail) {
    if (step == Step::encryption && !isSecure_) {
        now_ = Step::signIn;
        return;
    }
    steps_.push_back({nameOf(step), true, std::move(detail), {}});
    now_ = static_cast<Step>(static_cast<int>(step) + 1);
}

void WebTrial::failAt(Step step, const Error& error) {
    steps_.push_back({nameOf(step), false, error.message, error.hint});
}

void WebTrial::fail(const Error& error) {
    failAt(now_, error);
}

void WebTrial::failAt(const HttpOutcome& outcome) {
    // A token is got before there is a connection to the archive.
    if (outcome.ended) return failAt(Step::signIn, outcome.error());
    const Step failed = stepOf(outcome);
    while (now_ < failed) pass(now_, {});
    failAt(failed, outcome.error());
}

void WebTrial::passConnection(const HttpOutcome& outcome) {
    pass(Step::name, {});
    pass(Step::connection, outcome.peer.empty() ? Text() : Text("Connected to {}.", outcome.peer));
    pass(Step::encryption, Text("The certificate is valid."));
    pass(Step::signIn, {});
}

void WebTrial::run() {
    progress_.beginStage(Text("Testing the connection with the archive"), 3);
    auto address = webAddressOf(service_);
    if (!address) return failAt(Step::address, address.error());
    isSecure_ = address->isSecure;
    pass(Step::address, {});
    HttpClient client(settings_, &signIn_);
    const QidoText studies =
        qidoText(client, pageUrl(service_ + "/studies?fuzzymatching=false", 1, 0), progress_);
    if (!studies.outcome.ok()) return failAt(studies.outcome);
    passConnection(studies.outcome);
    progress_.advance();
    auto page = studiesInJson(studies.text);
    if (!page) return fail(page.error());
    pass(Step::search, page->found.empty() ? Text("The archive is empty, or shows nothing to this user.")
                                           : Text("The archive answers searches."));
    progress_.advance();
    if (page->found.empty()) {
        pass(Step::retrieval, Text("There was no image to try it with."));
    } else {
        tryRetrieval(client, page->found.front().studyInstanceUid);
    }
    progress_.advance();
}

void WebTrial::tryRetrieval(HttpClient& client, const std::string& studyInstanceUid) {
    const auto seriesAddress = seriesUrl(service_, studyInstanceUid);
    if (!seriesAddress) return fail(seriesAddress.error());
    const QidoText series = qidoText(client, pageUrl(*seriesAddress, 1, 0), progress_);
    if (!series.outcome.ok()) return fail(series.outcome.error());
    const auto oneSeries = seriesInJson(series.text);
    if (!oneSeries) return fail(oneSeries.error());
    if (oneSeries->found.empty()) return pass(Step::retrieval, Text("There was no image to try it with."));
    const std::string seriesUid = oneSeries->found.front().seriesInstanceUid;
    const auto instancesAddress = instancesUrl(service_, studyInstanceUid, seriesUid);
    if (!instancesAddress) return fail(instancesAddress.error());
    const QidoText instances = qidoText(client, pageUrl(*instancesAddress, 1, 0), progress_);
    if (!instances.outcome.ok()) return fail(instances.outcome.error());
    const auto one = instancesInJson(instances.text);
    if (!one) return fail(one.error());
    if (one->found.empty()) return pass(Step::retrieval, Text("There was no image to try it with."));
    FirstBytes first;
    const HttpRequest request{
        .url = retrieveUrl(service_, studyInstanceUid, seriesUid, one->found.front().sopInstanceUid),
        .accept = kInstancesAsStored,
        .contentType = {},
        .body = nullptr,
        .sink = &first};
    const HttpOutcome outcome = client.run(request, progress_);
    if (progress_.cancelled()) return fail(cancelledByPerson());
    if (outcome.trouble != HttpTrouble::none) return fail(outcome.error());
    if (!first.isOfDicom()) return fail(noImagesSent());
    pass(Step::retrieval, Text("The archive sends images."));
}

}  // namespace macula::net
