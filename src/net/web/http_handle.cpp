#include "net/web/http_handle.h"

#include <algorithm>
#include <cstring>

#include "base/parsing.h"
#include "net/web/web_address.h"

namespace macula::net {

namespace {

constexpr std::size_t kMostHeaderBytes = std::size_t{256} << 10;
constexpr std::uintmax_t kMostBytesOfFailure = 64 << 10;  // of the page that comes with an error
constexpr long kReceiveBuffer = 256 << 10;

bool holdsWords(const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
}

// By the alerts with which a server ends (RFC 8446 6.2).
bool wantsCertificate(const std::string& words) {
    return holdsWords(words, "certificate required") || holdsWords(words, "alert bad certificate") ||
           holdsWords(words, "alert unknown ca") || holdsWords(words, "alert certificate") ||
           holdsWords(words, "alert unsupported certificate") || holdsWords(words, "alert decrypt error") ||
           holdsWords(words, "alert handshake failure");
}

}  // namespace

template <class T>
void HttpHandle::set(CURLoption option, T value) {
    isUsable_ = isUsable_ && easy_ && curl_easy_setopt(easy_.get(), option, value) == CURLE_OK;
}

HttpHandle::HttpHandle(const HttpSettings& settings, const HttpRequest& request, const std::string& url,
                       const Credentials& credentials)
    : request_(request), easy_(curl_easy_init(), curl_easy_cleanup), words_(CURL_ERROR_SIZE, '\0') {
    set(CURLOPT_URL, url.c_str());
    set(CURLOPT_PROTOCOLS_STR, "http,https");
    set(CURLOPT_FOLLOWLOCATION, 0L);  // the client judges where to
    set(CURLOPT_NOSIGNAL, 1L);
    set(CURLOPT_QUICK_EXIT, 1L);  // who cancels does not wait for a name server
    set(CURLOPT_ERRORBUFFER, words_.data());
    set(CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(settings.connectTimeout.count()));
    set(CURLOPT_HTTP_VERSION, static_cast<long>(CURL_HTTP_VERSION_2TLS));
    set(CURLOPT_HTTP09_ALLOWED, 0L);
    set(CURLOPT_SUPPRESS_CONNECT_HEADERS, 1L);
    set(CURLOPT_TCP_KEEPALIVE, 1L);
    set(CURLOPT_BUFFERSIZE, kReceiveBuffer);
    set(CURLOPT_UPLOAD_BUFFERSIZE, kReceiveBuffer);
    set(CURLOPT_USERAGENT, "Macula");
    setTls(settings);
    setProxy(settings, url);
    setCallbacks();
    setRequest(credentials);
}

void HttpHandle::setTls(const HttpSettings& settings) {
    const Tls& tls = settings.tls;
    set(CURLOPT_SSLVERSION, static_cast<long>(CURL_SSLVERSION_TLSv1_2));
    set(CURLOPT_SSL_VERIFYPEER, 1L);
    set(CURLOPT_SSL_VERIFYHOST, 2L);
    if (!tls.authorities.empty()) {
        // Those of the system are for nothing then.
        std::error_code failed;
        const bool isFolder = std::filesystem::is_directory(tls.authorities, failed);
        set(CURLOPT_CAINFO, isFolder ? static_cast<const char*>(nullptr) : tls.authorities.c_str());
        set(CURLOPT_CAPATH, isFolder ? tls.authorities.c_str() : static_cast<const char*>(nullptr));
    }
    if (tls.certificate.empty()) return;
    set(CURLOPT_SSLCERTTYPE, "PEM");
    set(CURLOPT_SSLCERT, tls.certificate.c_str());
    if (!tls.key.empty()) set(CURLOPT_SSLKEY, tls.key.c_str());
    // Without one, OpenSSL would ask at the terminal.
    set(CURLOPT_KEYPASSWD, settings.keyPassphrase.c_str());
}

void HttpHandle::setProxy(const HttpSettings& settings, const std::string& url) {
    const auto address = webAddressOf(url.substr(0, url.find('?')));
    // What is said to this machine, a password perhaps, goes through no other.
    if (address.ok() && isLoopback(*address)) {
        set(CURLOPT_PROXY, "");
    } else if (!settings.proxy.empty()) {
        set(CURLOPT_PROXY, settings.proxy.c_str());
    }
}

void HttpHandle::setCallbacks() {
    set(CURLOPT_HEADERFUNCTION, &HttpHandle::onHeader);
    set(CURLOPT_HEADERDATA, static_cast<void*>(this));
    set(CURLOPT_WRITEFUNCTION, &HttpHandle::onBody);
    set(CURLOPT_WRITEDATA, static_cast<void*>(this));
    set(CURLOPT_NOPROGRESS, 0L);
    set(CURLOPT_XFERINFOFUNCTION, &HttpHandle::onProgress);
    set(CURLOPT_XFERINFODATA, static_cast<void*>(this));
    set(CURLOPT_PREREQFUNCTION, &HttpHandle::onConnected);
    set(CURLOPT_PREREQDATA, static_cast<void*>(this));
}

void HttpHandle::setRequest(const Credentials& credentials) {
    const auto add = [&](const std::string& header) {
        curl_slist* const list = curl_slist_append(headers_.get(), header.c_str());
        isUsable_ = isUsable_ && list != nullptr;
        if (list == nullptr) return;
        (void)headers_.release();
        headers_.reset(list);
    };
    add("Accept-Encoding: identity");
    if (!request_.accept.empty()) add("Accept: " + request_.accept);
    if (request_.body != nullptr) {
        set(CURLOPT_POST, 1L);
        set(CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(request_.body->size()));
        set(CURLOPT_READFUNCTION, &HttpHandle::onRead);
        set(CURLOPT_READDATA, static_cast<void*>(this));
        set(CURLOPT_SEEKFUNCTION, &HttpHandle::onSeek);
        set(CURLOPT_SEEKDATA, static_cast<void*>(this));
        add("Content-Type: " + request_.contentType);
        add("Expect:");  // many servers do not answer to it, which costs a second
    }
    set(CURLOPT_HTTPHEADER, headers_.get());
    if (!credentials.token.empty()) {
        set(CURLOPT_HTTPAUTH, static_cast<long>(CURLAUTH_BEARER));
        set(CURLOPT_XOAUTH2_BEARER, credentials.token.c_str());
    } else if (!credentials.user.empty() || !credentials.password.empty()) {
        set(CURLOPT_HTTPAUTH, static_cast<long>(CURLAUTH_BASIC));
        set(CURLOPT_USERNAME, credentials.user.c_str());
        set(CURLOPT_PASSWORD, credentials.password.c_str());
    }
}

bool HttpHandle::isSuccess() const {
    long status = 0;
    curl_easy_getinfo(easy_.get(), CURLINFO_RESPONSE_CODE, &status);
    return (status >= 200 && status < 300) || (status != 0 && status == request_.otherSuccess);
}

bool HttpHandle::takeHeader(std::string_view line) {
    isActive_ = true;
    headerBytes_ += line.size();
    if (headerBytes_ > kMostHeaderBytes) {
        isTooLarge_ = true;
        return false;
    }
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) return true;
    const std::string name = lowerCase(std::string(trimmed(line.substr(0, colon))));
    const std::string value = lowerCase(std::string(trimmed(line.substr(colon + 1))));
    if (name == "content-encoding") isPacked_ = !value.empty() && value != "identity";
    if (name == "warning") hasWarning_ = hasWarning_ || value.starts_with("299");
    return true;
}

bool HttpHandle::takeBody(std::span<const std::byte> bytes) {
    bodyBytes_ += bytes.size();
    const bool isShown = isSuccess();
    const std::uintmax_t most = isShown ? request_.mostBytes : kMostBytesOfFailure;
    if (most > 0 && bodyBytes_ > most) {
        isTooLarge_ = true;
        return false;
    }
    if (!isShown || request_.sink == nullptr) return true;
    if (isPacked_) return false;
    if (!hasBegun_) {
        HttpHead head;
        long status = 0;
        const char* type = nullptr;
        curl_easy_getinfo(easy_.get(), CURLINFO_RESPONSE_CODE, &status);
        curl_easy_getinfo(easy_.get(), CURLINFO_CONTENT_TYPE, &type);
        head.status = static_cast<int>(status);
        head.contentType = type == nullptr ? "" : type;
        hasBegun_ = true;
        if (auto begun = request_.sink->begin(head); !begun) ended_ = begun.error();
    }
    if (!ended_) {
        if (auto written = request_.sink->write(bytes); !written) ended_ = written.error();
    }
    return !ended_;
}

std::size_t HttpHandle::giveBody(std::span<std::byte> bytes) {
    auto given = request_.body->read(bytes);
    if (given.ok()) return *given;
    ended_ = given.error();
    return CURL_READFUNC_ABORT;
}

bool HttpHandle::rewindBody() {
    auto rewound = request_.body->rewind();
    if (!rewound) ended_ = rewound.error();
    return rewound.ok();
}

template <class Work, class Value>
Value HttpHandle::guarded(Work work, Value failed) {
    try {
        return work();
    } catch (...) {
        thrown_ = std::current_exception();
        return failed;
    }
}

std::size_t HttpHandle::onHeader(char* bytes, std::size_t size, std::size_t count, void* self) {
    auto& handle = *static_cast<HttpHandle*>(self);
    const std::size_t all = size * count;
    return handle.guarded([&] { return handle.takeHeader({bytes, all}) ? all : 0; }, std::size_t{0});
}

std::size_t HttpHandle::onBody(char* bytes, std::size_t size, std::size_t count, void* self) {
    auto& handle = *static_cast<HttpHandle*>(self);
    const std::span<const char> all(bytes, size * count);
    // Any other count than all of them ends the transfer, also when there are none.
    return handle.guarded([&] { return handle.takeBody(std::as_bytes(all)) ? all.size() : all.size() + 1; },
                          all.size() + 1);
}

std::size_t HttpHandle::onRead(char* bytes, std::size_t size, std::size_t count, void* self) {
    auto& handle = *static_cast<HttpHandle*>(self);
    const std::span<char> all(bytes, size * count);
    return handle.guarded([&] { return handle.giveBody(std::as_writable_bytes(all)); },
                          std::size_t{CURL_READFUNC_ABORT});
}

int HttpHandle::onSeek(void* self, curl_off_t offset, int origin) {
    auto& handle = *static_cast<HttpHandle*>(self);
    if (offset != 0 || origin != SEEK_SET) return CURL_SEEKFUNC_FAIL;
    return handle.guarded([&] { return handle.rewindBody(); }, false) ? CURL_SEEKFUNC_OK : CURL_SEEKFUNC_FAIL;
}

int HttpHandle::onProgress(void* self, curl_off_t /*toCome*/, curl_off_t come, curl_off_t /*toGo*/,
                           curl_off_t gone) {
    auto& handle = *static_cast<HttpHandle*>(self);
    if (come != handle.come_ || gone != handle.gone_) handle.isActive_ = true;
    handle.come_ = come;
    handle.gone_ = gone;
    return 0;
}

int HttpHandle::onConnected(void* self, char* /*peer*/, char* /*own*/, int /*peerPort*/, int /*ownPort*/) {
    auto& handle = *static_cast<HttpHandle*>(self);
    handle.isConnected_ = true;
    handle.isActive_ = true;
    return CURL_PREREQFUNC_OK;
}

bool HttpHandle::wasActive() {
    return std::exchange(isActive_, false);
}

std::string HttpHandle::redirectUrl() const {
    const char* url = nullptr;
    curl_easy_getinfo(easy_.get(), CURLINFO_REDIRECT_URL, &url);
    return url == nullptr ? "" : url;
}

std::optional<std::chrono::seconds> HttpHandle::retryAfter() const {
    curl_off_t seconds = 0;
    curl_easy_getinfo(easy_.get(), CURLINFO_RETRY_AFTER, &seconds);
    if (seconds <= 0) return {};
    return std::chrono::seconds(seconds);
}

HttpTrouble HttpHandle::troubleOfTls(CURLcode code) const {
    constexpr long kNothingSaid = 1;  // as it stands before the chain is verified
    constexpr long kNotYetValid = 9;  // those of OpenSSL: X509_V_ERR_…
    constexpr long kExpired = 10;
    constexpr long kRevoked = 23;
    constexpr long kOtherHost = 62;
    const std::string words = lowerCase(std::string(words_.c_str()));
    long verified = 0;
    curl_easy_getinfo(easy_.get(), CURLINFO_SSL_VERIFYRESULT, &verified);
    // The name of the host is compared by libcurl itself, after the chain was found to be well.
    if (code == CURLE_PEER_FAILED_VERIFICATION && (verified <= kNothingSaid || verified == kOtherHost))
        return HttpTrouble::certificateOfAnotherHost;
    if (verified == kNotYetValid || verified == kExpired) return HttpTrouble::certificateExpired;
    if (verified == kRevoked) return HttpTrouble::certificateRevoked;
    // An authority of the same name with another key: a signature is wrong, not the chain.
    const bool isWronglySigned = holdsWords(words, "rsa routines") ||
                                 holdsWords(words, "asn1 encoding routines") ||
                                 holdsWords(words, "certificate verify failed");
    if (code == CURLE_PEER_FAILED_VERIFICATION || verified > kNothingSaid || isWronglySigned)
        return HttpTrouble::certificateNotTrusted;
    if (wantsCertificate(words)) return HttpTrouble::certificateWanted;
    if (holdsWords(words, "wrong version number") || holdsWords(words, "packet length too long") ||
        holdsWords(words, "http request"))
        return HttpTrouble::noTls;
    return HttpTrouble::tlsFailed;
}

HttpTrouble HttpHandle::troubleOf(CURLcode code) const {
    curl_off_t named = 0;
    curl_easy_getinfo(easy_.get(), CURLINFO_NAMELOOKUP_TIME_T, &named);
    long proxyStatus = 0;  // of the request for a tunnel
    curl_easy_getinfo(easy_.get(), CURLINFO_HTTP_CONNECTCODE, &proxyStatus);
    if (code != CURLE_OK && proxyStatus >= 300) return HttpTrouble::proxyRefuses;
    // An enum of libcurl: newer ones have more values than this one knows.
    switch (static_cast<int>(code)) {
        case CURLE_OK:
            return HttpTrouble::none;
        case CURLE_COULDNT_RESOLVE_HOST:
            return HttpTrouble::noName;
        case CURLE_COULDNT_RESOLVE_PROXY:
            return HttpTrouble::noProxy;
        case CURLE_PROXY:
            return HttpTrouble::proxyRefuses;
        case CURLE_COULDNT_CONNECT:
            return HttpTrouble::notReached;
        case CURLE_OPERATION_TIMEDOUT:
            return named == 0 ? HttpTrouble::noName : HttpTrouble::connectTimedOut;
        case CURLE_SSL_CONNECT_ERROR:
        case CURLE_SSL_CIPHER:
        case CURLE_PEER_FAILED_VERIFICATION:
            return troubleOfTls(code);
        case CURLE_SSL_CERTPROBLEM:
            return HttpTrouble::ownCertificateUnusable;
        case CURLE_SSL_CACERT_BADFILE:
            return HttpTrouble::authoritiesUnusable;
        case CURLE_WEIRD_SERVER_REPLY:
        case CURLE_UNSUPPORTED_PROTOCOL:
        case CURLE_BAD_CONTENT_ENCODING:
            return HttpTrouble::notHttp;
        case CURLE_GOT_NOTHING:
        case CURLE_PARTIAL_FILE:
        case CURLE_SEND_ERROR:
        case CURLE_HTTP2:
        case CURLE_HTTP2_STREAM:
            return HttpTrouble::closed;
        case CURLE_RECV_ERROR:
            // TLS 1.3 says only with its first answer that it wanted a certificate.
            return wantsCertificate(lowerCase(std::string(words_.c_str()))) ? HttpTrouble::certificateWanted
                                                                            : HttpTrouble::closed;
        default:
            return HttpTrouble::clientFailed;
    }
}

HttpOutcome HttpHandle::outcome(CURLcode code) const {
    HttpOutcome outcome;
    long status = 0;
    const char* peer = nullptr;
    if (easy_) {
        curl_easy_getinfo(easy_.get(), CURLINFO_RESPONSE_CODE, &status);
        curl_easy_getinfo(easy_.get(), CURLINFO_PRIMARY_IP, &peer);
    }
    outcome.status = static_cast<int>(status);
    outcome.peer = peer == nullptr ? "" : peer;
    outcome.isConnected = isConnected_;
    outcome.hasWarning = hasWarning_;
    outcome.ended = ended_;
    if (!isUsable_) {
        outcome.trouble = HttpTrouble::clientFailed;
    } else if (isTooLarge_ && (isSuccess() || status < 200)) {
        outcome.trouble = HttpTrouble::tooLarge;
    } else if (status >= 200 && !isSuccess()) {
        outcome.trouble = troubleOfStatus(outcome.status);
    } else if (isPacked_ && code != CURLE_OK) {
        outcome.trouble = HttpTrouble::packed;
    } else if (!ended_) {
        outcome.trouble = troubleOf(code);
    }
    return outcome;
}

}  // namespace macula::net
