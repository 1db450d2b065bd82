#include "net/web/http_client.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include "net/archive/broken_pipe.h"
#include "net/web/http_handle.h"
#include "net/web/web_address.h"

namespace macula::net {

namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kLongestPoll{100};  // until a cancel is seen
constexpr std::chrono::seconds kLongestRetryAfter{60};
constexpr int kMostRedirects = 5;

void prepareLibcurl() {
    static const CURLcode kPrepared = curl_global_init(CURL_GLOBAL_DEFAULT);
    (void)kPrepared;
}

HttpOutcome outcomeOfEnd(Error error) {
    HttpOutcome outcome;
    outcome.ended = std::move(error);
    return outcome;
}

// A request on its way, with what was tried already.
struct Course {
    const HttpRequest* request = nullptr;
    std::string url;
    Credentials credentials;
    std::unique_ptr<HttpHandle> handle;  // while it runs
    SteadyClock::time_point notBefore{};
    std::chrono::nanoseconds idle{0};
    int redirects = 0;
    bool wasRenewed = false;
    bool hasWaited = false;
    std::optional<HttpOutcome> outcome;
};

// A run of requests.
class HttpRun {
  public:
    HttpRun(const HttpSettings& settings, CredentialSource* signIn, CURLM* multi, std::size_t mostAtOnce,
            Progress& progress)
        : settings_(settings), signIn_(signIn), multi_(multi), mostAtOnce_(mostAtOnce), progress_(progress) {}
    ~HttpRun() {
        for (Course& course : courses_) stop(course);
    }
    HttpRun(const HttpRun&) = delete;
    HttpRun& operator=(const HttpRun&) = delete;

    std::vector<HttpOutcome> outcomes(std::span<const HttpRequest> requests) {
        courses_.resize(requests.size());
        for (std::size_t i = 0; i < requests.size(); ++i) {
            courses_[i].request = &requests[i];
            courses_[i].url = requests[i].url;
        }
        while (!end_ && !isDone()) step();
        std::vector<HttpOutcome> all;
        for (Course& course : courses_) {
            stop(course);
            all.push_back(course.outcome ? *std::move(course.outcome) : outcomeOfEnd(*end_));
        }
        return all;
    }

  private:
    bool isDone() const {
        return std::ranges::all_of(courses_, [](const Course& c) { return c.outcome.has_value(); });
    }

    void step() {
        if (progress_.cancelled()) {
            end_ = cancelledByPerson();
            return;
        }
        startNext();
        int running = 0;
        if (end_ || curl_multi_perform(multi_, &running) != CURLM_OK) {
            if (!end_) end_ = errorOf(HttpTrouble::clientFailed, 0);
            return;
        }
        int left = 0;
        while (const CURLMsg* const message = curl_multi_info_read(multi_, &left)) {
            if (message->msg == CURLMSG_DONE) finish(message->easy_handle, message->data.result);
        }
        if (end_ || isDone()) return;
        const SteadyClock::time_point before = SteadyClock::now();
        curl_multi_poll(multi_, nullptr, 0, static_cast<int>(kLongestPoll.count()), nullptr);
        // Only what passed in here was waiting for the peer: disks may be slow.
        countIdle(SteadyClock::now() - before);
    }

    void startNext() {
        for (Course& course : courses_) {
            if (end_ || running_ >= mostAtOnce_) return;
            if (course.outcome || course.handle || course.notBefore > SteadyClock::now()) continue;
            start(course);
        }
    }

    void start(Course& course) {
        if (signIn_ != nullptr) {
            auto credentials = signIn_->credentials(progress_);
            if (!credentials) {
                end_ = credentials.error();
                return;
            }
            course.credentials = *std::move(credentials);
        }
        course.handle =
            std::make_unique<HttpHandle>(settings_, *course.request, course.url, course.credentials);
        course.idle = {};
        if (course.handle->get() == nullptr ||
            curl_multi_add_handle(multi_, course.handle->get()) != CURLM_OK) {
            course.handle.reset();
            course.outcome = HttpOutcome{.trouble = HttpTrouble::clientFailed};
            return;
        }
        ++running_;
    }

    void stop(Course& course) {
        if (!course.handle) return;
        curl_multi_remove_handle(multi_, course.handle->get());
        course.handle.reset();
        --running_;
    }

    void finish(const CURL* easy, CURLcode code) {
        const auto found = std::ranges::find_if(
            courses_, [&](const Course& c) { return c.handle && c.handle->get() == easy; });
        if (found == courses_.end()) return;
        Course& course = *found;
        if (const std::exception_ptr thrown = course.handle->thrown()) std::rethrow_exception(thrown);
        HttpOutcome outcome = course.handle->outcome(code);
        const bool isAgain = !outcome.ended && !course.handle->hasBegun() && goesOn(course, outcome);
        stop(course);
        if (isAgain) return;
        const HttpSink* const sink = course.request->sink;
        if (outcome.ended && (sink == nullptr || sink->endsAll())) end_ = outcome.ended;
        course.outcome = std::move(outcome);
    }

    // Whether the request is made again: elsewhere, with other credentials, or later.
    bool goesOn(Course& course, HttpOutcome& outcome) {
        if (outcome.status >= 300 && outcome.status < 400) return isRedirected(course, outcome);
        bool isAgain = false;
        if (outcome.trouble == HttpTrouble::signInRefused && signIn_ != nullptr && !course.wasRenewed) {
            course.wasRenewed = true;
            isAgain = signIn_->renew(course.credentials);
        } else if (outcome.trouble == HttpTrouble::busy && !course.hasWaited) {
            const auto wait = course.handle->retryAfter();
            course.hasWaited = true;
            isAgain = wait && *wait <= kLongestRetryAfter;
            if (isAgain) course.notBefore = SteadyClock::now() + *wait;
        }
        return isAgain && isRewound(course, outcome);
    }

    static bool isRedirected(Course& course, HttpOutcome& outcome) {
        const bool keepsMethod =
            course.request->body == nullptr || outcome.status == 307 || outcome.status == 308;
        const std::string url = course.handle->redirectUrl();
        if (url.empty()) return false;
        outcome.trouble = HttpTrouble::redirected;
        if (!keepsMethod || ++course.redirects > kMostRedirects || !mayRedirect(course.url, url))
            return false;
        course.url = url;
        return isRewound(course, outcome);
    }

    static bool isRewound(Course& course, HttpOutcome& outcome) {
        if (course.request->body == nullptr) return true;
        auto rewound = course.request->body->rewind();
        if (!rewound) outcome.ended = rewound.error();
        return rewound.ok();
    }

    void countIdle(std::chrono::nanoseconds waited) {
        for (Course& course : courses_) {
            if (!course.handle) continue;
            // Until there is a connection, libcurl counts.
            course.idle = course.handle->wasActive() || !course.handle->isConnected()
                              ? std::chrono::nanoseconds{0}
                              : course.idle + waited;
            if (course.idle < settings_.answerTimeout) continue;
            HttpOutcome outcome = course.handle->outcome(CURLE_OK);
            outcome.trouble = HttpTrouble::answerTimedOut;
            stop(course);
            course.outcome = std::move(outcome);
        }
    }

    const HttpSettings& settings_;
    CredentialSource* signIn_;
    CURLM* multi_;
    std::size_t mostAtOnce_;
    Progress& progress_;
    std::vector<Course> courses_;
    std::size_t running_ = 0;
    std::optional<Error> end_;
};

}  // namespace

Error HttpOutcome::error() const {
    return ended ? *ended : errorOf(trouble, status);
}

HttpClient::HttpClient(const HttpSettings& settings, CredentialSource* signIn)
    : settings_(settings),
      signIn_(signIn),
      multi_((prepareLibcurl(), curl_multi_init()), curl_multi_cleanup) {}

HttpClient::~HttpClient() {
    const WithoutBrokenPipes quiet;  // TLS says good-bye
    multi_.reset();
}

std::vector<HttpOutcome> HttpClient::run(std::span<const HttpRequest> requests, std::size_t mostAtOnce,
                                         Progress& progress) {
    const WithoutBrokenPipes quiet;
    if (!multi_)
        return std::vector<HttpOutcome>(requests.size(), HttpOutcome{.trouble = HttpTrouble::clientFailed});
    HttpRun run(settings_, signIn_, multi_.get(), std::max<std::size_t>(mostAtOnce, 1), progress);
    return run.outcomes(requests);
}

HttpOutcome HttpClient::run(const HttpRequest& request, Progress& progress) {
    return run(std::span(&request, 1), 1, progress).front();
}

}  // namespace macula::net
