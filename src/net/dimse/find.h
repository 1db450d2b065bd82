// C-FIND: searches of an archive.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "net/archive/query.h"
#include "net/archive/query_check.h"
#include "net/dimse/connector.h"
#include "net/dimse/identifier.h"

namespace macula::net {

// Where a study stands: the patient root model wants the patient's ID too, where it is known.
struct StudyPlace {
    std::string studyInstanceUid;
    std::string patientId;
};

struct SeriesAnswers {
    std::vector<FoundSeries> series;
    bool isCutShort = false;
    std::size_t unusable = 0;
};
struct InstanceAnswers {
    std::vector<FoundInstance> instances;
    bool isCutShort = false;
    std::size_t unusable = 0;
};

// Asks over an association of its own, which is released when the object goes.
class Finder {
  public:
    // An error if the archive lets nobody search.
    static Result<Finder> open(const Connector& connector, const CancelToken& cancel);
    Finder(Finder&&) noexcept = default;
    ~Finder();

    Result<StudyAnswers> studies(const StudyQuery& query);
    Result<SeriesAnswers> series(const StudyPlace& study);
    Result<InstanceAnswers> instances(const StudyPlace& study, const std::string& seriesInstanceUid,
                                      std::size_t most = kMostInstancesOfStudy);
    // After an error: the archive answered with it, and can be asked more.
    bool isOpen() const { return association_->isOpen(); }

  private:
    // Null: an answer that is malformed. Returns whether more are wanted.
    using Take = std::function<bool(const Keys* answer)>;

    Finder(std::unique_ptr<Association> association, const Connector& connector, CancelToken cancel);
    Result<void> reopen();
    Result<void> ask(const Keys& keys, const Take& take);
    Result<void> receiveAnswers(const AcceptedContext& context, std::uint16_t messageId, const Take& take);
    struct Patients {
        std::vector<std::string> ids;
        bool isCutShort = false;
    };
    Result<Patients> patientsOf(const StudyQuery& query);

    std::unique_ptr<Association> association_;
    const Connector* connector_;  // outlives this
    CancelToken cancel_;
    DimsePeer peer_;
};

// The keys that a study, series or instance is retrieved by.
Keys keysOf(const StudyPlace& study, bool patientRoot);

}  // namespace macula::net
