// Sends files over the web (STOW-RS).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "net/archive/archive.h"
#include "net/web/http_client.h"
#include "net/web/upload_body.h"

namespace macula::net {

class WebSend {
  public:
    // All of them must outlive it.
    WebSend(const std::string& service, HttpClient& client, Progress& progress);

    Result<Sent> run(std::span<const std::filesystem::path> files);

  private:
    struct ToSend {
        UploadBody::Upload upload;
        std::string sopInstanceUid;
    };

    void lookAt(const std::filesystem::path& file);
    Result<void> sendGroup(std::span<const ToSend> group);
    void judge(std::span<const ToSend> group, int status, const std::string& answer);
    void note(std::span<const ToSend> group, const Error& error, bool isRefused);

    const std::string& service_;
    HttpClient& client_;
    Progress& progress_;
    std::vector<ToSend> toSend_;
    std::size_t judged_ = 0;  // of them, from the first on
    Sent sent_;
};

}  // namespace macula::net
