// One request with libcurl, from its options to its outcome. Bodies stream through it.
#pragma once

#include <curl/curl.h>

#include <exception>
#include <memory>
#include <optional>
#include <string>

#include "net/web/http_exchange.h"

namespace macula::net {

// Stays where it is: libcurl has its address.
class HttpHandle {
  public:
    // `request` and what it points to must outlive the handle. `url` is that of the request, or where a
    // redirection led.
    HttpHandle(const HttpSettings& settings, const HttpRequest& request, const std::string& url,
               const Credentials& credentials);
    HttpHandle(const HttpHandle&) = delete;
    HttpHandle& operator=(const HttpHandle&) = delete;

    CURL* get() const { return easy_.get(); }

    // Once libcurl has said how it ended.
    HttpOutcome outcome(CURLcode code) const;
    // Where an answer of 3xx wants the request to be made again; empty if none.
    std::string redirectUrl() const;
    // How long the answer asks to wait.
    std::optional<std::chrono::seconds> retryAfter() const;
    // Something of the body was shown to the sink, so that the request cannot be made again from here.
    bool hasBegun() const { return hasBegun_; }
    bool isConnected() const { return isConnected_; }
    // Whether a byte has come or gone since the last call.
    bool wasActive();
    // What a sink or a body threw; it could not pass through libcurl.
    std::exception_ptr thrown() const { return thrown_; }

  private:
    struct FreesList {
        void operator()(curl_slist* list) const { curl_slist_free_all(list); }
    };

    template <class T>
    void set(CURLoption option, T value);
    void setTls(const HttpSettings& settings);
    void setProxy(const HttpSettings& settings, const std::string& url);
    void setCallbacks();
    void setRequest(const Credentials& credentials);

    bool isSuccess() const;
    bool takeHeader(std::string_view line);
    bool takeBody(std::span<const std::byte> bytes);
    std::size_t giveBody(std::span<std::byte> bytes);
    bool rewindBody();
    // Runs `work`; keeps what it throws, and then returns `failed`.
    template <class Work, class Value>
    Value guarded(Work work, Value failed);

    HttpTrouble troubleOf(CURLcode code) const;
    HttpTrouble troubleOfTls(CURLcode code) const;

    static std::size_t onHeader(char* bytes, std::size_t size, std::size_t count, void* self);
    static std::size_t onBody(char* bytes, std::size_t size, std::size_t count, void* self);
    static std::size_t onRead(char* bytes, std::size_t size, std::size_t count, void* self);
    static int onSeek(void* self, curl_off_t offset, int origin);
    static int onProgress(void* self, curl_off_t toCome, curl_off_t come, curl_off_t toGo, curl_off_t gone);
    static int onConnected(void* self, char* peer, char* own, int peerPort, int ownPort);

    const HttpRequest& request_;
    std::unique_ptr<CURL, decltype(&curl_easy_cleanup)> easy_;
    std::unique_ptr<curl_slist, FreesList> headers_;
    std::string words_;  // libcurl's, about an error

    std::size_t headerBytes_ = 0;
    std::uintmax_t bodyBytes_ = 0;
    curl_off_t come_ = 0;
    curl_off_t gone_ = 0;
    bool isActive_ = false;
    bool isConnected_ = false;
    bool isPacked_ = false;
    bool isTooLarge_ = false;
    bool hasWarning_ = false;
    bool hasBegun_ = false;
    bool isUsable_ = true;  // every option could be set
    std::optional<Error> ended_;
    std::exception_ptr thrown_;
};

}  // namespace macula::net
