#include "net/web/device_sign_in.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "net/web/flat_json.h"
#include "net/web/http_trouble.h"
#include "net/web/token_service.h"
#include "net/web/web_address.h"
#include "net/web/web_peer.h"

namespace macula::net {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr std::size_t kLongestText = 2048;
constexpr double kUsualInterval = 5.0;  // RFC 8628 3.2
constexpr double kLongestInterval = 60.0;
constexpr double kSlower = 5.0;  // RFC 8628 3.5
constexpr double kLongestLife = 3600.0;
constexpr int kMostFailuresInTurn = 5;
constexpr std::chrono::milliseconds kSlice{100};
const std::string kGrant = "urn:ietf:params:oauth:grant-type:device_code";

struct Codes {
    DeviceCode shown;
    std::string secret;  // of this sign-in: never shown
    double interval = kUsualInterval;
};

bool isPrintable(const std::string& text) {
    return text.size() <= kLongestText &&
           std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
}

bool mayBeOpened(const std::string& address) {
    const auto parsed = webAddressOf(address.substr(0, address.find_first_of("?#")));
    return isPrintable(address) && parsed && mayHearSecrets(*parsed);
}

Error noCode() {
    return {ErrorCode::archiveNotUsable,
            Text("The service that signs people in gave no code."),
            {},
            Text("Check its address, the client and the scope in the settings of the archive.")};
}

Result<Codes> askForCodes(const HttpSettings& settings, const WebPeer& peer, Progress& progress) {
    std::string form = "client_id=" + percentEncoded(peer.clientId);
    if (!peer.scope.empty()) form += "&scope=" + percentEncoded(peer.scope);
    const FormAnswer sent = sendForm(settings, peer.deviceUrl, form, nullptr, progress);
    if (sent.outcome.ended) return *sent.outcome.ended;
    if (!sent.outcome.ok()) {
        if (sent.outcome.status == 400) return noCode();
        Error error = sent.outcome.error();
        error.message = Text("The service that signs people in failed: {}", std::move(error.message));
        return error;
    }
    const auto json = flatJson(sent.text);
    Codes codes;
    codes.secret = textIn(json, "device_code");
    codes.shown.userCode = textIn(json, "user_code");
    codes.shown.address = textIn(json, "verification_uri");
    // As some services called it before the standard did.
    if (codes.shown.address.empty()) codes.shown.address = textIn(json, "verification_url");
    codes.shown.wholeAddress = textIn(json, "verification_uri_complete");
    if (codes.secret.empty() || codes.shown.userCode.empty() || !isPrintable(codes.shown.userCode) ||
        !mayBeOpened(codes.shown.address))
        return noCode();
    if (!mayBeOpened(codes.shown.wholeAddress)) codes.shown.wholeAddress.clear();
    codes.shown.life = std::chrono::seconds(static_cast<long>(
        std::clamp(numberIn(json, "expires_in").value_or(kLongestLife), 1.0, kLongestLife)));
    codes.interval = std::clamp(numberIn(json, "interval").value_or(kUsualInterval), 0.1, kLongestInterval);
    return codes;
}

// False after a cancellation.
bool waitFor(Seconds time, const Progress& progress) {
    const auto until = Clock::now() + time;
    while (Clock::now() < until) {
        if (progress.cancelled()) return false;
        std::this_thread::sleep_for(std::min<Seconds>(kSlice, until - Clock::now()));
    }
    return !progress.cancelled();
}

Error failureOf(const std::string& fault) {
    if (fault == "access_denied")
        return {ErrorCode::archiveNotUsable,
                Text("The sign-in was declined in the browser."),
                {},
                Text("Begin again, and agree there.")};
    if (fault == "expired_token")
        return {ErrorCode::archiveNotUsable,
                Text("Nobody signed in before the code ran out."),
                {},
                Text("Begin again, and type the new code in the browser.")};
    return noTokenError();
}

}  // namespace

Result<Secrets> signInByDevice(const Source& source, const Secrets& secrets, const ShowDeviceCode& show,
                               Progress& progress) {
    const auto* const peer = std::get_if<WebPeer>(&source.peer);
    if (peer == nullptr || peer->signIn != SignIn::device)
        return Error{ErrorCode::usage,
                     Text("Nobody signs in at this archive by a browser."),
                     {},
                     Text("Set it up so, or enter a password for it.")};
    MACULA_TRY_VOID(checkWebPeer(*peer, secrets));
    const HttpSettings settings = withoutOwnCertificate(httpSettingsOf(source, *peer, secrets));
    MACULA_TRY(Codes codes, askForCodes(settings, *peer, progress));
    show(codes.shown);
    progress.beginStage(Text("Waiting for the sign-in in a browser"), 1);
    const std::string form =
        "grant_type=" + percentEncoded(kGrant) + "&device_code=" + percentEncoded(codes.secret);
    const auto end = Clock::now() + codes.shown.life;
    int failuresInTurn = 0;
    while (Clock::now() < end) {
        if (!waitFor(Seconds(codes.interval), progress)) return cancelledByPerson();
        auto answer =
            askForToken(settings, peer->tokenUrl, form, {peer->clientId, secrets.password}, progress);
        if (!answer) {
            // A line that is lost for a moment ends no sign-in; it is tried less often (RFC 8628 3.5).
            const Error& error = answer.error();
            if (error.code != ErrorCode::archiveNotUsable || ++failuresInTurn == kMostFailuresInTurn)
                return error;
            codes.interval = std::min(2.0 * codes.interval, kLongestInterval);
            continue;
        }
        failuresInTurn = 0;
        if (answer->fault == "authorization_pending") continue;
        if (answer->fault == "slow_down") {
            codes.interval += kSlower;
            continue;
        }
        if (!answer->fault.empty()) return failureOf(answer->fault);
        Secrets signedIn = secrets;
        signedIn.token = std::move(answer->accessToken);
        signedIn.refreshToken = std::move(answer->refreshToken);
        return signedIn;
    }
    return failureOf("expired_token");
}

}  // namespace macula::net
