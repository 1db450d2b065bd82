#include "net/sources/source_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "net/dimse/dimse_archive.h"
#include "net/web/web_address.h"

namespace macula::net {

namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;
constexpr std::size_t kLongestName = 64;

Error unusableSources(Text why) {
    return {ErrorCode::inputNotUsable,
            std::move(why),
            {},
            Text("docs/pacs.md shows how a file of archives is written.")};
}

// Reads the members of one object, and says in the end which it was not asked for.
class Members {
  public:
    explicit Members(const Json& object) : object_(object) {}

    void read(const char* name, std::string& value) {
        if (const Json* found = find(name)) wrong(name, found->is_string()) || (value = *found, true);
    }
    void read(const char* name, std::filesystem::path& value) {
        std::string text;
        read(name, text);
        if (!text.empty()) value = text;
    }
    void read(const char* name, bool& value) {
        if (const Json* found = find(name)) wrong(name, found->is_boolean()) || (value = *found, true);
    }
    void read(const char* name, std::uint16_t& value) {
        const Json* found = find(name);
        if (found == nullptr) return;
        const bool fits = found->is_number_unsigned() && *found <= 65535u;
        if (!wrong(name, fits)) value = found->get<std::uint16_t>();
    }
    void read(const char* name, std::chrono::seconds& value) {
        const Json* found = find(name);
        if (found == nullptr) return;
        const bool fits = found->is_number_unsigned() && *found >= 1u && *found <= 3600u;
        if (!wrong(name, fits)) value = std::chrono::seconds(found->get<int>());
    }
    template <class Choice, std::size_t count>
    void read(const char* name, Choice& value, const std::pair<std::string_view, Choice> (&choices)[count]) {
        std::string text;
        read(name, text);
        if (text.empty()) return;
        const auto* chosen = std::find_if(std::begin(choices), std::end(choices),
                                          [&](const auto& choice) { return choice.first == text; });
        if (!wrong(name, chosen != std::end(choices))) value = chosen->second;
    }
    const Json* object(const char* name) {
        const Json* found = find(name);
        return found == nullptr || wrong(name, found->is_object()) ? nullptr : found;
    }

    // The first error; otherwise that of a member that nobody asked for.
    Result<void> finish() const {
        if (wrong_) return unusableSources(Text("\"{}\" has a value that does not fit it.", *wrong_));
        for (const auto& [name, value] : object_.items()) {
            if (!asked_.contains(name))
                return unusableSources(Text("\"{}\" is not a setting of an archive.", name.substr(0, 40)));
        }
        return {};
    }

  private:
    const Json* find(const char* name) {
        asked_.insert(name);
        const auto found = object_.find(name);
        return found == object_.end() ? nullptr : &*found;
    }
    bool wrong(const char* name, bool fits) {
        if (!fits && !wrong_) wrong_ = name;
        return !fits;
    }

    const Json& object_;
    std::set<std::string, std::less<>> asked_;
    std::optional<std::string> wrong_;
};

constexpr std::pair<std::string_view, Retrieve> kRetrieves[]{
    {"automatic", Retrieve::automatic}, {"get", Retrieve::get}, {"move", Retrieve::move}};
constexpr std::pair<std::string_view, SignIn> kSignIns[]{{"none", SignIn::none},
                                                         {"basic", SignIn::basic},
                                                         {"bearer", SignIn::bearer},
                                                         {"clientCredentials", SignIn::clientCredentials},
                                                         {"device", SignIn::device}};

template <class Choice, std::size_t count>
std::string nameOf(Choice choice, const std::pair<std::string_view, Choice> (&choices)[count]) {
    for (const auto& [name, value] : choices) {
        if (value == choice) return std::string(name);
    }
    return {};
}

Result<void> readTls(Members& owner, Tls& tls) {
    const Json* object = owner.object("tls");
    if (object == nullptr) return {};
    tls.isOn = true;
    Members members(*object);
    members.read("authorities", tls.authorities);
    members.read("certificate", tls.certificate);
    members.read("key", tls.key);
    return members.finish();
}

Json jsonOf(const Tls& tls) {
    Json json = Json::object();
    if (!tls.authorities.empty()) json["authorities"] = tls.authorities.string();
    if (!tls.certificate.empty()) json["certificate"] = tls.certificate.string();
    if (!tls.key.empty()) json["key"] = tls.key.string();
    return json;
}

Result<DimsePeer> readDimse(const Json& object) {
    DimsePeer peer;
    Members members(object);
    members.read("host", peer.host);
    members.read("port", peer.port);
    members.read("calledAe", peer.calledAe);
    members.read("callingAe", peer.callingAe);
    members.read("retrieve", peer.retrieve, kRetrieves);
    members.read("receiverAe", peer.receiverAe);
    members.read("receiverPort", peer.receiverPort);
    members.read("receiverAddress", peer.receiverAddress);
    members.read("patientRoot", peer.patientRoot);
    members.read("characterSet", peer.characterSet);
    MACULA_TRY_VOID(readTls(members, peer.tls));
    MACULA_TRY_VOID(members.finish());
    return peer;
}

Result<WebPeer> readWeb(const Json& object) {
    WebPeer peer;
    Members members(object);
    members.read("url", peer.url);
    members.read("signIn", peer.signIn, kSignIns);
    members.read("user", peer.user);
    members.read("tokenUrl", peer.tokenUrl);
    members.read("deviceUrl", peer.deviceUrl);
    members.read("clientId", peer.clientId);
    members.read("scope", peer.scope);
    members.read("proxy", peer.proxy);
    MACULA_TRY_VOID(readTls(members, peer.tls));
    MACULA_TRY_VOID(members.finish());
    return peer;
}

Result<Source> readSource(const Json& object) {
    if (!object.is_object()) return unusableSources(Text("An archive in the list is not an object."));
    Source source;
    Members members(object);
    members.read("name", source.name);
    members.read("connectTimeout", source.connectTimeout);
    members.read("answerTimeout", source.answerTimeout);
    const Json* dimse = members.object("dimse");
    const Json* web = members.object("dicomweb");
    MACULA_TRY_VOID(members.finish());
    if ((dimse == nullptr) == (web == nullptr))
        return unusableSources(Text("An archive needs either \"dimse\" or \"dicomweb\"."));
    if (dimse != nullptr) {
        MACULA_TRY(source.peer, readDimse(*dimse));
    } else {
        MACULA_TRY(source.peer, readWeb(*web));
    }
    MACULA_TRY_VOID(checkSource(source));
    return source;
}

Json jsonOf(const DimsePeer& peer) {
    const DimsePeer usual;
    Json json{
        {"host", peer.host}, {"port", peer.port}, {"calledAe", peer.calledAe}, {"callingAe", peer.callingAe}};
    if (peer.retrieve != usual.retrieve) json["retrieve"] = nameOf(peer.retrieve, kRetrieves);
    if (!peer.receiverAe.empty()) json["receiverAe"] = peer.receiverAe;
    if (peer.receiverPort != 0) json["receiverPort"] = peer.receiverPort;
    if (!peer.receiverAddress.empty()) json["receiverAddress"] = peer.receiverAddress;
    if (peer.patientRoot) json["patientRoot"] = true;
    if (peer.characterSet != usual.characterSet) json["characterSet"] = peer.characterSet;
    if (peer.tls.isOn) json["tls"] = jsonOf(peer.tls);
    return json;
}

Json jsonOf(const WebPeer& peer) {
    Json json{{"url", peer.url}};
    if (peer.signIn != SignIn::none) json["signIn"] = nameOf(peer.signIn, kSignIns);
    const std::pair<const char*, const std::string*> texts[] = {
        {"user", &peer.user},         {"tokenUrl", &peer.tokenUrl}, {"deviceUrl", &peer.deviceUrl},
        {"clientId", &peer.clientId}, {"scope", &peer.scope},       {"proxy", &peer.proxy}};
    for (const auto& [name, text] : texts) {
        if (!text->empty()) json[name] = *text;
    }
    if (Json tls = jsonOf(peer.tls); !tls.empty()) json["tls"] = std::move(tls);
    return json;
}

}  // namespace

Result<void> checkSource(const Source& source) {
    const bool plain = std::none_of(source.name.begin(), source.name.end(), [](unsigned char letter) {
        return letter < ' ' || letter == '/' || letter == 127;
    });
    if (source.name.empty() || source.name.size() > kLongestName || !plain)
        return Error{ErrorCode::usage,
                     Text("The name of an archive has 1 to 64 characters, and no slash."),
                     {},
                     Text("Choose another name.")};
    if (const auto* dimse = std::get_if<DimsePeer>(&source.peer)) return checkDimsePeer(*dimse);
    MACULA_TRY([[maybe_unused]] const WebAddress address, webAddressOf(std::get<WebPeer>(source.peer).url));
    return {};
}

Result<std::vector<Source>> sourcesFromJson(std::string_view text) {
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_discarded() || !json.is_object())
        return unusableSources(Text("The file of archives is not JSON."));
    const auto version = json.find("version");
    const auto list = json.find("sources");
    if (version == json.end() || *version != kVersion || list == json.end() || !list->is_array())
        return unusableSources(Text("The file of archives lacks its version (1) or its list of sources."));
    std::vector<Source> sources;
    for (const Json& each : *list) {
        MACULA_TRY(Source source, readSource(each));
        const bool isThere = std::any_of(sources.begin(), sources.end(),
                                         [&](const Source& other) { return other.name == source.name; });
        if (isThere) return unusableSources(Text("Two archives in the list have the same name."));
        sources.push_back(std::move(source));
    }
    return sources;
}

Json toJson(const Source& source) {
    const Source usual;
    Json json{{"name", source.name}};
    if (source.connectTimeout != usual.connectTimeout) json["connectTimeout"] = source.connectTimeout.count();
    if (source.answerTimeout != usual.answerTimeout) json["answerTimeout"] = source.answerTimeout.count();
    const auto* dimse = std::get_if<DimsePeer>(&source.peer);
    if (dimse != nullptr) json["dimse"] = jsonOf(*dimse);
    if (dimse == nullptr) json["dicomweb"] = jsonOf(std::get<WebPeer>(source.peer));
    return json;
}

Json toJson(const std::vector<Source>& sources) {
    Json list = Json::array();
    for (const Source& source : sources) list.push_back(toJson(source));
    return {{"version", kVersion}, {"sources", std::move(list)}};
}

}  // namespace macula::net
