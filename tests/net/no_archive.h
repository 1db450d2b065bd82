// An archive that has nothing and takes nothing. Tests override what theirs does.
#pragma once

#include "net/archive/archive.h"

namespace macula::net::test {

class NoArchive : public Archive {
  public:
    Result<StudyAnswers> findStudies(const StudyQuery& /*query*/, Progress& /*progress*/) override {
        return StudyAnswers();
    }
    Result<std::vector<FoundSeries>> findSeries(const std::string& /*study*/,
                                                Progress& /*progress*/) override {
        return std::vector<FoundSeries>();
    }
    Result<std::vector<FoundInstance>> findInstances(const std::string& /*study*/,
                                                     const std::string& /*series*/,
                                                     Progress& /*progress*/) override {
        return std::vector<FoundInstance>();
    }
    Result<Fetched> fetch(const Wanted& /*wanted*/, Receiver& /*receiver*/, Progress& /*progress*/) override {
        return Fetched();
    }
    Result<Sent> send(std::span<const std::filesystem::path> /*files*/, Progress& /*progress*/) override {
        return Sent();
    }
    std::vector<TestStep> test(Progress& /*progress*/) override { return {}; }
};

}  // namespace macula::net::test
