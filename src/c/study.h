// What a macula_study is.
#pragma once

#include <macula.h>

#include <string>
#include <vector>

#include "study/open/opened_study.h"

struct macula_study {
    macula::study::OpenedStudy opened;  // with a volume
    std::vector<std::string> titles;    // one for each volume
    // Of the volume that is loaded.
    std::vector<std::string> notes;
    std::string unitName;

    std::string found;  // the JSON of macula_study_found
};
