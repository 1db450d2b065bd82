// Searches an archive page by page (QIDO-RS).
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "net/web/gathered_body.h"
#include "net/web/http_client.h"
#include "net/web/qido_answers.h"
#include "net/web/qido_query.h"

namespace macula::net {

constexpr std::uintmax_t kMostBytesOfPage = std::uintmax_t{64} << 20;
constexpr std::size_t kUsualPage = 1000;
// Some archives refuse larger limits, and some have a limit of their own, which is never below 100.
constexpr std::size_t kSmallPage = 200;
constexpr std::size_t kSmallestLimit = 100;

template <class Found>
struct QidoFound {
    std::vector<Found> found;
    bool isCutShort = false;
    std::size_t unusable = 0;
};

// One page as text. `trouble` is how the request ended.
struct QidoText {
    HttpOutcome outcome;
    std::string text;
};
QidoText qidoText(HttpClient& client, const std::string& url, Progress& progress);

// Pages follow each other until one brings nothing new, or there are more than `most`. `last`, if it is
// given, gets the outcome of the last request.
template <class Found>
Result<QidoFound<Found>> searchAll(HttpClient& client, const std::string& url, std::size_t most,
                                   Result<QidoPage<Found>> (*parse)(std::string_view),
                                   std::string Found::*uid, Progress& progress, HttpOutcome* last = nullptr) {
    constexpr std::size_t kMostOfAll = 1'000'000;
    most = std::min(most, kMostOfAll);
    QidoFound<Found> all;
    std::unordered_set<std::string> seen;
    std::size_t largest = kUsualPage;
    std::size_t offset = 0;
    while (true) {
        // One more than wanted tells whether there are more.
        const std::size_t limit = std::min(largest, most + 1 - std::min(most, all.found.size()));
        const QidoText answer = qidoText(client, pageUrl(url, limit, offset), progress);
        if (last != nullptr) *last = answer.outcome;
        if (answer.outcome.trouble == HttpTrouble::badRequest && limit > kSmallPage && offset == 0) {
            largest = kSmallPage;
            continue;
        }
        if (!answer.outcome.ok()) return answer.outcome.error();
        MACULA_TRY(QidoPage<Found> page, parse(answer.text));
        const std::size_t before = all.found.size();
        for (Found& found : page.found)
            if (seen.insert(found.*uid).second) all.found.push_back(std::move(found));
        all.unusable += page.unusable;
        offset += page.datasets;
        if (all.found.size() > most) {
            all.found.resize(most);
            all.isCutShort = true;
            return all;
        }
        const bool isLast = page.datasets < std::min(limit, kSmallestLimit) && !answer.outcome.hasWarning;
        if (all.found.size() == before || isLast) {
            all.isCutShort = answer.outcome.hasWarning && all.found.size() == before;
            return all;
        }
    }
}

}  // namespace macula::net
