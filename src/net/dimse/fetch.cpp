#include "net/dimse/fetch.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "net/archive/first_images.h"
#include "net/dimse/contexts.h"
#include "net/dimse/messages.h"
#include "net/dimse/move_receiver.h"

namespace macula::net {

namespace {

constexpr int kTries = 3;
constexpr std::chrono::milliseconds kPauseBetweenTries{100};
constexpr std::size_t kInstancesOfRequest = 200;
// That many responses one after the other, without anything that comes, are no sign of life any more.
constexpr std::size_t kMostIdleResponses = 20000;
constexpr std::size_t kMostBytesOfFailures = std::size_t{1} << 20;
// How long what an archive says it has sent may still be under way.
constexpr std::chrono::seconds kPatienceForStragglers{3};

std::string joinedUids(const std::vector<std::string>& uids, std::size_t from, std::size_t count) {
    std::string joined;
    for (std::size_t i = from; i < std::min(from + count, uids.size()); ++i)
        joined += (joined.empty() ? "" : "\\") + uids[i];
    return joined;
}

Error nothingThere() {
    return archiveError(Text("The archive has no images of what was asked for."),
                        Text("Search again: they may have been moved or deleted."));
}

Error noWayToFetch(bool offersMove) {
    if (offersMove)
        return archiveError(
            Text("The archive can only send to a receiver, and this program has none set up."),
            Text("Enter a receiver's port in the settings of the archive, and ask the administrator of the "
                 "archive to add the receiver's AE title with the host name and this port of this machine."));
    return serviceNotOffered(Service::get);
}

}  // namespace

Fetch::Fetch(const Connector& connector, const Wanted& wanted, std::string patientId, Receiver& receiver,
             Progress& progress)
    : connector_(connector),
      wanted_(wanted),
      study_{wanted.studyInstanceUid, std::move(patientId)},
      progress_(progress),
      incoming_(wanted, receiver, progress),
      heartbeat_(std::make_shared<Heartbeat>()) {}

Result<Fetched> Fetch::run() {
    progress_.beginStage(Text("Asking the archive which images there are"), 1);
    MACULA_TRY_VOID(findPromised());
    incoming_.expect(promised_);
    const std::size_t missing = countMissing();
    progress_.beginStage(Text("Fetching from the archive"), std::max<std::size_t>(missing, 1));
    if (isPromised_ && missing == 0) return fetched();
    std::optional<Error> last;
    for (int failures = 0; failures <= kTries;) {
        const std::size_t before = incoming_.steps();
        const Result<void> attempted = attempt();
        if (const auto failure = incoming_.failure()) return *failure;
        if (progress_.cancelled()) return cancelledError();
        if (attempted && getFailed_ && connector_.peer().receiverPort != 0 &&
            connector_.peer().retrieve == Retrieve::automatic && failures++ == 0)
            continue;  // by C-MOVE
        if (attempted) {
            askInOtherEncodings();
            if (const auto failure = incoming_.failure()) return *failure;
            if (progress_.cancelled()) return cancelledError();
            // What the archive says it cannot send does not come by asking again.
            const Fetched result = fetched();
            const bool isNothing = result.kept + result.hadAlready + result.refused == 0;
            if (refusal_ && isNothing) return *refusal_;
            if (isNothing && result.promised == 0) return nothingThere();
            return result;
        }
        if (attempted.error().code != ErrorCode::archiveNotUsable) return attempted.error();
        if (isPromised_ && countMissing() == 0) return fetched();
        last = attempted.error();
        failures = incoming_.steps() > before ? 1 : failures + 1;
        std::this_thread::sleep_for(kPauseBetweenTries);
    }
    return *last;
}

Result<void> Fetch::findPromised() {
    bool hasConnected = false;
    for (int failures = 0;;) {
        promised_.clear();
        isListWhole_ = true;
        Result<Finder> finder = Finder::open(connector_, progress_.token());
        Result<void> asked;
        if (finder) {
            hasConnected = true;
            asked = askForPromised(*finder);
        } else {
            asked = finder.error();
        }
        isPromised_ = asked && !promised_.empty();
        if (!isPromised_) isListWhole_ = false;
        if (asked || asked.error().code != ErrorCode::archiveNotUsable) return asked;
        // Where nobody may search, or not at this level, the instances can be asked for all the same.
        const bool isRefusal =
            finder ? finder->isOpen() : asked.error().message == serviceNotOffered(Service::find).message;
        if (isRefusal) {
            promised_.clear();
            return {};
        }
        if (!hasConnected || failures++ == kTries) return asked;
        std::this_thread::sleep_for(kPauseBetweenTries);
    }
}

Result<void> Fetch::askForPromised(Finder& finder) {
    MACULA_TRY(const SeriesAnswers answers, finder.series(study_));
    isListWhole_ = !answers.isCutShort && answers.unusable == 0;
    std::vector<FoundSeries> wanted;
    for (const FoundSeries& each : answers.series) {
        const auto& chosen = wanted_.seriesInstanceUids;
        if (!chosen.empty() && std::ranges::find(chosen, each.seriesInstanceUid) == chosen.end()) continue;
        // Before any instances: where these cannot be asked for, modalities tell what may come.
        if (!each.modality.empty()) modalities_.insert(each.modality);
        wanted.push_back(each);
    }
    // After answers that were cut short, the association has ended.
    return answers.isCutShort ? Result<void>() : askForInstances(finder, wanted);
}

Result<void> Fetch::askForInstances(Finder& finder, const std::vector<FoundSeries>& series) {
    for (const FoundSeries& each : series) {
        MACULA_TRY(const InstanceAnswers answers, finder.instances(study_, each.seriesInstanceUid,
                                                                   kMostInstancesOfStudy - promised_.size()));
        for (const FoundInstance& one : answers.instances) promised_.emplace(one.sopInstanceUid, one);
        if (answers.isCutShort || answers.unusable > 0) isListWhole_ = false;
        if (answers.isCutShort) break;
    }
    return {};
}

bool Fetch::isMissing(const std::string& sopInstanceUid) const {
    return !wanted_.sopInstancesHad.contains(sopInstanceUid) && !incoming_.isSettled(sopInstanceUid);
}

std::size_t Fetch::countMissing() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(promised_, [&](const auto& each) { return isMissing(each.first); }));
}

Keys Fetch::keysAt(const char* level, const std::string& series, const std::string& instances) const {
    Keys keys = keysOf(study_, connector_.peer().patientRoot);
    keys[Key::level] = level;
    if (!series.empty()) keys[Key::seriesInstanceUid] = series;
    if (!instances.empty()) keys[Key::sopInstanceUid] = instances;
    return keys;
}

std::vector<Keys> Fetch::requests() const {
    const bool isAll = !sendsImages_ || countMissing() == promised_.size();
    if (isAll && wanted_.seriesInstanceUids.empty()) return {keysAt("STUDY", {}, {})};
    if (isPromised_) return keysOfMissing();
    std::vector<Keys> requests;
    for (const std::string& each : wanted_.seriesInstanceUids) requests.push_back(keysAt("SERIES", each, {}));
    return requests;
}

std::vector<Keys> Fetch::keysOfMissing() const {
    std::map<std::string, std::pair<std::size_t, std::vector<std::string>>> bySeries;  // all, and missing
    for (const auto& [uid, instance] : promised_) {
        auto& series = bySeries[instance.seriesInstanceUid];
        ++series.first;
        if (isMissing(uid)) series.second.push_back(uid);
    }
    std::vector<Keys> requests;
    for (const auto& [series, instances] : bySeries) {
        const std::vector<std::string>& uids = instances.second;
        if (uids.empty()) continue;
        if (!sendsImages_ || uids.size() == instances.first) {
            requests.push_back(keysAt("SERIES", series, {}));
            continue;
        }
        for (std::size_t i = 0; i < uids.size(); i += kInstancesOfRequest)
            requests.push_back(keysAt("IMAGE", series, joinedUids(uids, i, kInstancesOfRequest)));
    }
    return requests;
}

std::vector<ProposedContext> Fetch::contexts() const {
    const DimsePeer& peer = connector_.peer();
    std::vector<ProposedContext> contexts;
    if (peer.retrieve != Retrieve::get)
        contexts.push_back(plainContext(modelOf(Service::move, peer.patientRoot)));
    if (peer.retrieve == Retrieve::move || getFailed_) return contexts;
    contexts.push_back(plainContext(modelOf(Service::get, peer.patientRoot)));
    std::set<std::string> classes;
    for (const auto& [uid, instance] : promised_)
        if (isMissing(uid) && !instance.sopClassUid.empty()) classes.insert(instance.sopClassUid);
    if (classes.empty()) classes = usualClasses(modalities_);
    const auto storage = contextsToReceive(classes, kMostContexts - contexts.size(), encodings_);
    contexts.insert(contexts.end(), storage.begin(), storage.end());
    return contexts;
}

Result<Fetch::Way> Fetch::wayOver(const Association& association) const {
    const DimsePeer& peer = connector_.peer();
    if (association.contextFor(std::string(modelOf(Service::get, peer.patientRoot))) != nullptr)
        return Way::get;
    const bool offersMove =
        association.contextFor(std::string(modelOf(Service::move, peer.patientRoot))) != nullptr;
    if (peer.retrieve == Retrieve::move && !offersMove) return serviceNotOffered(Service::move);
    if (offersMove && peer.receiverPort != 0) return Way::move;
    return noWayToFetch(offersMove);
}

Result<void> Fetch::attempt() {
    MACULA_TRY(const std::unique_ptr<Association> association,
               connector_.open(contexts(), progress_.token()));
    const Result<Way> way = wayOver(*association);
    if (!way) {
        association->release();
        // Asking again would bring the same answer.
        refusal_ = way.error();
        return {};
    }
    const bool patientRoot = connector_.peer().patientRoot;
    const AcceptedContext& context = *association->contextFor(
        std::string(modelOf(*way == Way::get ? Service::get : Service::move, patientRoot)));
    const std::size_t before = incoming_.arrived();
    way_ = *way;
    failed_ = 0;
    refusal_.reset();
    told_ = 0;
    std::unique_ptr<MoveReceiver> receiver;
    if (*way == Way::move) {
        MACULA_TRY(receiver,
                   MoveReceiver::start(connector_, incoming_, heartbeat_, encodings_, progress_.token()));
        association->wire().setHeartbeat(heartbeat_);
        sentByMove_ = failedByMove_ = 0;
    }
    // By C-MOVE, images that are still under way would be asked for again.
    if (*way == Way::get) MACULA_TRY_VOID(requestFirst(*association, context));
    for (const Keys& keys : requests()) MACULA_TRY_VOID(request(*association, context, keys, *way));
    if (receiver && !refusal_) awaitStragglers(*receiver, before + sentByMove_);
    association->release();
    getFailed_ = *way == Way::get && incoming_.arrived() == before;
    return {};
}

void Fetch::askInOtherEncodings() {
    for (const Encodings encodings : {Encodings::plain, Encodings::compressed}) {
        const bool isOver = progress_.cancelled() || incoming_.failure();
        if (isOver || !isPromised_ || failed_ == 0 || countMissing() == 0) return;
        encodings_ = encodings;
        if (way_ == Way::get) getFailed_ = false;
        const std::optional<Error> refusal = refusal_;
        const std::size_t failed = failed_;
        // Where this fails, what it was for is as missing as before.
        if (attempt() && !refusal_) continue;
        refusal_ = refusal;
        failed_ = failed;
    }
}

void Fetch::awaitStragglers(const MoveReceiver& receiver, std::size_t sent) {
    const auto begin = Heartbeat::Clock::now();
    while (!progress_.cancelled() && !incoming_.failure()) {
        // Some archives answer before they send, and then say that they sent nothing.
        if (isPromised_ ? countMissing() <= failedByMove_ : incoming_.arrived() >= sent) return;
        const auto patience = receiver.openAssociations() > 0
                                  ? connector_.answerTimeout()
                                  : std::chrono::milliseconds(kPatienceForStragglers);
        if (Heartbeat::Clock::now() > std::max(begin, heartbeat_->last()) + patience) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
}

Result<void> Fetch::requestFirst(Association& association, const AcceptedContext& context) {
    // From an incomplete list, only the study as a whole brings what is not in it.
    if (!sendsImages_ || !isPromised_ || !isListWhole_ || countMissing() < promised_.size()) return {};
    std::vector<FoundInstance> wanted;
    for (const auto& [uid, instance] : promised_) wanted.push_back(instance);
    std::vector<std::string> uids;
    for (const FoundInstance& each : firstImagesOf(wanted)) uids.push_back(each.sopInstanceUid);
    if (uids.empty()) return {};
    const std::string series = promised_.at(uids.front()).seriesInstanceUid;
    sendsImages_ = false;  // should the archive end the association
    MACULA_TRY_VOID(
        request(association, context, keysAt("IMAGE", series, joinedUids(uids, 0, uids.size())), Way::get));
    sendsImages_ = std::ranges::none_of(uids, [this](const std::string& uid) { return isMissing(uid); });
    // The requests that follow ask again for what did not come.
    refusal_.reset();
    failed_ = 0;
    return {};
}

Result<void> Fetch::request(Association& association, const AcceptedContext& context, const Keys& keys,
                            Way way) {
    // Only a patient's ID has letters other than those of every character set.
    const bool hasText = keys.contains(Key::patientId);
    MACULA_TRY(const auto identifier,
               identifierBytes(keys, context.transferSyntax,
                               hasText ? connector_.peer().characterSet : std::string()));
    const std::uint16_t messageId = association.newMessageId();
    MACULA_TRY_VOID(
        sendCommand(association, context.id,
                    {.field = way == Way::get ? CommandField::getRequest : CommandField::moveRequest,
                     .messageId = messageId,
                     .sopClassUid = context.abstractSyntax,
                     .moveDestination = way == Way::move ? receiverTitle(connector_.peer()) : std::string(),
                     .priority = std::uint16_t{0},
                     .hasDataset = true}));
    MACULA_TRY_VOID(sendDataset(association, context.id, identifier));
    Result<void> received = receiveResponses(association, context, messageId, way);
    const bool isOver = progress_.cancelled() || incoming_.failure();
    if (!received && isOver) endRequest(association, context.id, messageId);
    return received;
}

Result<void> Fetch::receiveResponses(Association& association, const AcceptedContext& context,
                                     std::uint16_t messageId, Way way) {
    const CommandField field = way == Way::get ? CommandField::getResponse : CommandField::moveResponse;
    std::size_t arrived = incoming_.arrived();
    for (std::size_t idle = 0; idle < kMostIdleResponses; ++idle) {
        if (arrived != incoming_.arrived()) idle = 0;
        arrived = incoming_.arrived();
        if (const auto failure = incoming_.failure()) return *failure;
        MACULA_TRY(const ReceivedCommand received, receiveCommand(association));
        if (way == Way::get && received.command.field == CommandField::storeRequest) {
            MACULA_TRY_VOID(incoming_.store(association, received));
            continue;
        }
        if (received.command.field != field || received.command.respondsTo != messageId ||
            received.context != context.id || !received.command.status)
            return notWhatDicomSays();
        MACULA_TRY(const bool isLast, takeResponse(association, context, received.command, way));
        if (isLast) return {};
    }
    return notWhatDicomSays();
}

Result<bool> Fetch::takeResponse(Association& association, const AcceptedContext& context,
                                 const Command& response, Way way) {
    if (response.hasDataset) {  // the list of failed instances: what did not come shows them
        MACULA_TRY(const auto ignored, receiveSmallDataset(association, context.id, kMostBytesOfFailures));
    }
    const std::size_t done = std::size_t{response.completed.value_or(0)} + response.withWarning.value_or(0);
    const std::uint16_t status = *response.status;
    if (isPending(status)) return false;
    told_ += done + response.failed.value_or(0) + response.remaining.value_or(0);
    failed_ += response.failed.value_or(0);
    if (way == Way::move) {
        sentByMove_ += done;
        failedByMove_ += response.failed.value_or(0);
    }
    if (status != 0 && !isWarning(status))
        refusal_ = errorOfStatus(way == Way::get ? Service::get : Service::move, status);
    else if (response.failed.value_or(0) > 0 && done == 0)
        refusal_ = errorOfStatus(way == Way::get ? Service::get : Service::move, 0xa702);
    return true;
}

Fetched Fetch::fetched() const {
    Fetched result = incoming_.counts();
    if (!isPromised_) {
        result.isListWhole = false;
        result.promised = std::max(told_, incoming_.distinct());
        return result;
    }
    for (const auto& [uid, instance] : promised_) {
        if (wanted_.sopInstancesHad.contains(uid) && !incoming_.cameAgain(uid)) ++result.hadAlready;
        if (isMissing(uid)) result.never.push_back(instance);
    }
    // A refusal that kept nothing back leaves the list as good as it was.
    result.isListWhole = isListWhole_ && !(refusal_ && !result.never.empty());
    result.promised = promised_.size();
    if (!result.isListWhole) result.promised = std::max({result.promised, told_, incoming_.distinct()});
    return result;
}

}  // namespace macula::net
