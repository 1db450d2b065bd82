// The interface through which the renderer keeps models of scenes between runs.
#pragma once

#include <memory>
#include <string>

#include "base/volume.h"
#include "pipeline/hybrid/model/model_store.h"
#include "scene/drawing/drawing.h"

namespace macula::live {

// The live model calls find() and keep(), with names that were passed to willShow().
class SceneKeeper : public hybrid::ModelStore {
  public:
    // Announces that the scene with this complete drawing is about to be shown, and gives it `name`. Drops
    // the search for the scene before, and what it found. Returns at once.
    virtual void willShow(const std::string& name, std::shared_ptr<const Volume> volume,
                          const scene::Drawing& drawing) = 0;
};

}  // namespace macula::live
