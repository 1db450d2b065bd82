// What a link from a RIS, an EHR or a web page asks Macula to open.
//
// A link chooses studies, and at most one of the archives that are set up, by its name. It can name no file,
// no address, no option and no password.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace macula::study {

// Names patients: for the screen only, never for a log, a file, an error or the title of a window.
struct StudyLink {
    // One of these three is given; accession numbers beside UIDs must fit.
    std::vector<std::string> studyInstanceUids;
    std::vector<std::string> accessionNumbers;
    std::string patientId;

    std::string issuer;            // who gave the patient ID; empty: not said
    std::string patientBirthDate;  // YYYYMMDD; that of the study must not differ
    std::string dateFrom;          // of the study, YYYYMMDD, both ends included
    std::string dateTo;
    std::vector<std::string> modalities;    // one of them; empty: any
    std::optional<std::size_t> mostRecent;  // so many, the newest
    std::string archive;                    // its name; empty: all that are set up

    // What the link asks for and Macula does not do: sentences without any value of the link.
    std::vector<Text> notDone;
};

// macula://open?study=UID|accession=NUMBER|patient=ID[&issuer=…][&archive=NAME], or an Invoke Image Display
// (IHE RAD-106), as macula://IHEInvokeImageDisplay?… or at any web address that ends so. Fails with usage.
Result<StudyLink> studyLinkOf(std::string_view link);

}  // namespace macula::study
