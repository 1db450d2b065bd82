#include "net/dimse/find.h"

#include <algorithm>
#include <set>
#include <utility>

#include "net/dimse/contexts.h"
#include "net/dimse/messages.h"

namespace macula::net {

namespace {

constexpr std::size_t kMostBytesOfAnswer = std::size_t{256} << 10;
constexpr std::size_t kMostPatients = 1000;
constexpr std::size_t kMostSeries = 10000;
// Answers that are of no use are endured up to that many times what was asked for.
constexpr std::size_t kEnduredTimes = 2;

std::string datesOf(const StudyQuery& query) {
    if (query.dateFrom.empty() && query.dateTo.empty()) return {};
    if (query.dateFrom == query.dateTo) return query.dateFrom;
    return query.dateFrom + "-" + query.dateTo;
}

Keys keysOfQuery(const StudyQuery& query) {
    return {{Key::level, "STUDY"},
            {Key::patientName, query.patientName},
            {Key::patientId, query.patientId},
            {Key::patientBirthDate, query.patientBirthDate},
            {Key::patientSex, ""},
            {Key::accessionNumber, query.accessionNumber},
            {Key::studyId, query.studyId},
            {Key::studyInstanceUid, query.studyInstanceUid},
            {Key::studyDate, datesOf(query)},
            {Key::studyTime, ""},
            {Key::modalitiesInStudy, query.modality},
            {Key::studyDescription, query.description},
            {Key::referringPhysician, query.referringPhysician},
            {Key::seriesOfStudy, ""},
            {Key::instancesOfStudy, ""}};
}

// Dates and times of before 1993 had dots and colons.
std::string digitsOf(const Keys& answer, Key key, std::string_view dropped) {
    std::string text = firstValue(answer, key);
    std::erase_if(text, [&](char c) { return dropped.find(c) != std::string_view::npos; });
    const bool isSound = std::ranges::all_of(text, [](char c) { return c == '.' || (c >= '0' && c <= '9'); });
    return isSound ? text : std::string();
}

std::string dateOf(const Keys& answer, Key key) {
    const std::string date = digitsOf(answer, key, ".");
    return date.size() == 8 ? date : std::string();
}

std::optional<std::size_t> countOf(const Keys& answer, Key key) {
    const std::optional<int> number = numberValue(answer, key);
    if (!number || *number < 0) return {};
    return static_cast<std::size_t>(*number);
}

FoundStudy studyOf(const Keys& answer) {
    FoundStudy study;
    study.studyInstanceUid = uidValue(answer, Key::studyInstanceUid);
    study.date = dateOf(answer, Key::studyDate);
    study.time = digitsOf(answer, Key::studyTime, ":");
    study.description = firstValue(answer, Key::studyDescription);
    study.accessionNumber = firstValue(answer, Key::accessionNumber);
    study.studyId = firstValue(answer, Key::studyId);
    study.patientName = firstValue(answer, Key::patientName);
    study.patientId = firstValue(answer, Key::patientId);
    study.patientBirthDate = dateOf(answer, Key::patientBirthDate);
    study.patientSex = firstValue(answer, Key::patientSex);
    study.referringPhysician = firstValue(answer, Key::referringPhysician);
    study.modalities = allValues(answer, Key::modalitiesInStudy);
    std::erase(study.modalities, "");
    study.seriesCount = countOf(answer, Key::seriesOfStudy);
    study.instanceCount = countOf(answer, Key::instancesOfStudy);
    return study;
}

FoundSeries seriesOf(const Keys& answer) {
    FoundSeries series;
    series.seriesInstanceUid = uidValue(answer, Key::seriesInstanceUid);
    series.number = numberValue(answer, Key::seriesNumber);
    series.modality = firstValue(answer, Key::modality);
    series.description = firstValue(answer, Key::seriesDescription);
    series.bodyPart = firstValue(answer, Key::bodyPart);
    series.instanceCount = countOf(answer, Key::instancesOfSeries);
    return series;
}

// Some archives do not search by ModalitiesInStudy, and answer with all.
bool isOfModality(const FoundStudy& study, const std::string& modality) {
    return modality.empty() || study.modalities.empty() ||
           std::ranges::find(study.modalities, modality) != study.modalities.end();
}

// Takes answers up to a limit, each UID once.
template <class Found>
class Collected {
  public:
    explicit Collected(std::size_t most) : most_(most) {}

    // Whether more are wanted.
    bool take(Found found, const std::string& uid) {
        if (uid.empty() || !seen_.insert(uid).second) return drop(uid.empty());
        if (items.size() == most_) {
            isCutShort = true;
            return false;
        }
        items.push_back(std::move(found));
        return true;
    }
    bool drop(bool isUnusable) {
        if (isUnusable) ++unusable;
        if (++dropped_ <= kEnduredTimes * most_) return true;
        isCutShort = true;
        return false;
    }

    std::vector<Found> items;
    std::size_t unusable = 0;
    bool isCutShort = false;

  private:
    std::size_t most_;
    std::size_t dropped_ = 0;
    std::set<std::string> seen_;
};

}  // namespace

Keys keysOf(const StudyPlace& study, bool patientRoot) {
    Keys keys{{Key::studyInstanceUid, study.studyInstanceUid}};
    if (patientRoot && !study.patientId.empty()) keys[Key::patientId] = study.patientId;
    return keys;
}

Finder::Finder(std::unique_ptr<Association> association, const Connector& connector, CancelToken cancel)
    : association_(std::move(association)),
      connector_(&connector),
      cancel_(std::move(cancel)),
      peer_(connector.peer()) {}

Finder::~Finder() {
    if (association_) association_->release();
}

Result<Finder> Finder::open(const Connector& connector, const CancelToken& cancel) {
    const std::string model(modelOf(Service::find, connector.peer().patientRoot));
    MACULA_TRY(std::unique_ptr<Association> association, connector.open({plainContext(model)}, cancel));
    if (association->contextFor(model) == nullptr) {
        association->release();
        return serviceNotOffered(Service::find);
    }
    return Finder(std::move(association), connector, cancel);
}

Result<void> Finder::reopen() {
    MACULA_TRY(Finder again, open(*connector_, cancel_));
    association_ = std::move(again.association_);
    return {};
}

Result<void> Finder::ask(const Keys& keys, const Take& take) {
    if (!association_->isOpen()) return closedMidway();
    const AcceptedContext* context =
        association_->contextFor(std::string(modelOf(Service::find, peer_.patientRoot)));
    MACULA_CHECK(context != nullptr);
    MACULA_TRY(const auto identifier, identifierBytes(keys, context->transferSyntax, peer_.characterSet));
    const std::uint16_t messageId = association_->newMessageId();
    MACULA_TRY_VOID(sendCommand(*association_, context->id,
                                {.field = CommandField::findRequest,
                                 .messageId = messageId,
                                 .sopClassUid = context->abstractSyntax,
                                 .priority = std::uint16_t{0},
                                 .hasDataset = true}));
    MACULA_TRY_VOID(sendDataset(*association_, context->id, identifier));
    Result<void> received = receiveAnswers(*context, messageId, take);
    if (!received && received.error().code == ErrorCode::cancelled)
        endRequest(*association_, context->id, messageId);
    // In the middle of who knows what, nothing can be ended in order.
    if (!received && received.error().message == notWhatDicomSays().message) association_->abort();
    return received;
}

Result<void> Finder::receiveAnswers(const AcceptedContext& context, std::uint16_t messageId,
                                    const Take& take) {
    while (true) {
        MACULA_TRY(const ReceivedCommand received, receiveCommand(*association_));
        const Command& response = received.command;
        if (received.context != context.id || response.field != CommandField::findResponse ||
            response.respondsTo != messageId || !response.status)
            return notWhatDicomSays();
        const std::uint16_t status = *response.status;
        if (!isPending(status)) {
            if (response.hasDataset)
                MACULA_TRY_VOID(receiveDataset(*association_, context.id,
                                               [](auto /*bytes*/) -> Result<void> { return {}; }));
            if (status == 0 || isWarning(status)) return {};
            return errorOfStatus(Service::find, status);
        }
        if (!response.hasDataset) return notWhatDicomSays();
        MACULA_TRY(const KeptDataset dataset,
                   receiveSmallDataset(*association_, context.id, kMostBytesOfAnswer));
        std::optional<Keys> answer;
        if (dataset.isWhole) answer = identifierOf(dataset.bytes, context.transferSyntax);
        if (take(answer ? &*answer : nullptr)) continue;
        endRequest(*association_, context.id, messageId);
        return {};
    }
}

// In the patient root model, an archive may want to know the patient before it looks for studies.
Result<Finder::Patients> Finder::patientsOf(const StudyQuery& query) {
    const bool isOne = !query.patientId.empty() && query.patientId.find_first_of("*?\\") == std::string::npos;
    const bool isUnknown =
        query.patientId.empty() && query.patientName.empty() && query.patientBirthDate.empty();
    if (!peer_.patientRoot || isOne || isUnknown) return Patients{{query.patientId}, false};
    Collected<std::string> found(kMostPatients);
    MACULA_TRY_VOID(ask({{Key::level, "PATIENT"},
                         {Key::patientName, query.patientName},
                         {Key::patientId, query.patientId},
                         {Key::patientBirthDate, query.patientBirthDate}},
                        [&](const Keys* answer) {
                            if (answer == nullptr) return found.drop(true);
                            const std::string id = firstValue(*answer, Key::patientId);
                            return found.take(id, id);
                        }));
    return Patients{std::move(found.items), found.isCutShort};
}

Result<StudyAnswers> Finder::studies(const StudyQuery& query) {
    MACULA_TRY(const Patients patients, patientsOf(query));
    // To be told no more patients, the association was ended.
    if (patients.isCutShort) MACULA_TRY_VOID(reopen());
    Collected<FoundStudy> found(query.mostAnswers);
    for (const std::string& patient : patients.ids) {
        if (found.isCutShort) break;
        Keys keys = keysOfQuery(query);
        if (peer_.patientRoot) keys[Key::patientId] = patient;
        MACULA_TRY_VOID(ask(keys, [&](const Keys* answer) {
            if (answer == nullptr) return found.drop(true);
            FoundStudy study = studyOf(*answer);
            if (!isOfModality(study, query.modality)) return found.drop(false);
            const std::string uid = study.studyInstanceUid;
            return found.take(std::move(study), uid);
        }));
    }
    return StudyAnswers{std::move(found.items), found.isCutShort || patients.isCutShort, found.unusable};
}

Result<SeriesAnswers> Finder::series(const StudyPlace& study) {
    Keys keys = keysOf(study, peer_.patientRoot);
    keys.merge(Keys{{Key::level, "SERIES"},
                    {Key::seriesInstanceUid, ""},
                    {Key::seriesNumber, ""},
                    {Key::modality, ""},
                    {Key::seriesDescription, ""},
                    {Key::bodyPart, ""},
                    {Key::instancesOfSeries, ""}});
    Collected<FoundSeries> found(kMostSeries);
    MACULA_TRY_VOID(ask(keys, [&](const Keys* answer) {
        if (answer == nullptr) return found.drop(true);
        FoundSeries series = seriesOf(*answer);
        const std::string uid = series.seriesInstanceUid;
        return found.take(std::move(series), uid);
    }));
    return SeriesAnswers{std::move(found.items), found.isCutShort, found.unusable};
}

Result<InstanceAnswers> Finder::instances(const StudyPlace& study, const std::string& seriesInstanceUid,
                                          std::size_t most) {
    Keys keys = keysOf(study, peer_.patientRoot);
    keys.merge(Keys{{Key::level, "IMAGE"},
                    {Key::seriesInstanceUid, seriesInstanceUid},
                    {Key::sopInstanceUid, ""},
                    {Key::sopClassUid, ""},
                    {Key::instanceNumber, ""}});
    Collected<FoundInstance> found(most);
    MACULA_TRY_VOID(ask(keys, [&](const Keys* answer) {
        if (answer == nullptr) return found.drop(true);
        const std::string uid = uidValue(*answer, Key::sopInstanceUid);
        return found.take({uid, uidValue(*answer, Key::sopClassUid), seriesInstanceUid,
                           numberValue(*answer, Key::instanceNumber)},
                          uid);
    }));
    return InstanceAnswers{std::move(found.items), found.isCutShort, found.unusable};
}

}  // namespace macula::net
