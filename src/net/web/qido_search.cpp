#include "net/web/qido_search.h"

namespace macula::net {

QidoText qidoText(HttpClient& client, const std::string& url, Progress& progress) {
    GatheredBody body;
    const HttpRequest request{.url = url,
                              .accept = "application/dicom+json",
                              .contentType = {},
                              .body = nullptr,
                              .sink = &body,
                              .mostBytes = kMostBytesOfPage};
    QidoText text;
    text.outcome = client.run(request, progress);
    text.text = body.text();
    return text;
}

}  // namespace macula::net
