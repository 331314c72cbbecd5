#include "studio/properties/panel_link.h"

#include <QThreadPool>

#include "base/error.h"
#include "catalog/material.h"
#include "catalog/model_file.h"
#include "model/diff.h"
#include "model/edits/piece_edits.h"
#include "model/edits/wall_shape_edits.h"

namespace idap {

namespace {

Home withFollowers(const Home& before, Home after, bool roomsFollow) {
  if (roomsFollow) {
    const HomeDiff changes = diff(before, after);
    std::set<LevelId> levels;
    for (const WallId id : changes.walls.changed)
      if (const Wall* wall = after.walls.find(id)) levels.insert(wall->level);
    for (const LevelId level : levels) after = followWalls(before, after, level, true);
  }
  return dimensionsFollow(before, after);
}

std::string modelKey(const Piece& piece) {
  return piece.model.asset.empty() ? "piece " + piece.model.catalogId : "file " + piece.model.asset;
}

// Which parts a model has depends on what was chosen of it.
std::string keyOf(const Piece& piece) {
  std::string key = modelKey(piece);
  for (const auto& [name, value] : piece.model.parameters) {
    key.append("\n").append(name);
    key.append(" ").append(std::to_string(value));
  }
  return key;
}

// Models name the catalog's materials in English.
PieceFacts::Slot partOf(const SurfaceModel::Slot& slot) {
  for (const std::string& id : materialIds())
    if (!slot.material.name.empty() && materialName(id, "en") == slot.material.name) {
      const bool tinted = !(findMaterial(id)->color == slot.material.color);
      return {slot.name, id, tinted ? std::optional(slot.material.color) : std::nullopt};
    }
  return {slot.name, {}, slot.material.color};
}

PieceFacts fetch(const ModelRef& ref, Vec3 size, const Catalog& catalog, const Assets& assets) {
  PieceFacts facts;
  try {
    SurfaceModelPtr model;
    if (!ref.catalogId.empty()) facts.piece = catalog.find(ref.catalogId);
    if (!ref.asset.empty()) {
      const auto file = assets.find(ref.asset);
      if (file == assets.end() || !file->second) return facts;
      const std::string folder = ref.asset.substr(0, ref.asset.rfind('/') + 1);
      const SiblingFiles siblings = [&](const std::string& path) -> SharedBytes {
        const auto found = assets.find(folder + path);
        return found == assets.end() ? nullptr : found->second;
      };
      model = std::make_shared<const SurfaceModel>(readModelFile(*file->second, ref.asset, siblings));
    } else if (!ref.catalogId.empty()) {
      model = catalog.model(ref.catalogId, size, ref.parameters);
    }
    if (model)
      for (const SurfaceModel::Slot& slot : model->slots) facts.parts.push_back(partOf(slot));
  } catch (const Error& e) {
    facts.problem = e.what();
  }
  return facts;
}

}  // namespace

PanelLink::PanelLink(Editor& editor, QObject* parent) : QObject(parent), editor_(editor) {}
PanelLink::~PanelLink() { abandon(); }

bool PanelLink::apply(const char* name, const Change& change, bool moves) {
  abandon();
  const bool rooms = editor_.settings().roomAreas;
  return editor_.apply(name, [&](const Home& home) {
    Home next = change(home);
    return moves ? withFollowers(home, std::move(next), rooms) : next;
  });
}

void PanelLink::preview(const char* name, const Change& change) {
  Document& document = editor_.document();
  if (live_ && !document.inTransaction()) live_ = false;  // somebody else ended it
  if (!live_) {
    if (document.inTransaction()) return;  // a tool is at work
    document.begin(name);
    live_ = true;
  }
  editor_.preview(change);
}

void PanelLink::abandon() {
  if (!live_) return;
  live_ = false;
  editor_.document().cancel();
}

const PieceFacts* PanelLink::facts(const Piece& piece, const Home& home) {
  if (piece.model.asset.empty() && piece.model.catalogId.empty()) {
    static const PieceFacts kNone;
    return &kNone;
  }
  const std::string key = keyOf(piece);
  if (const auto found = facts_.find(key); found != facts_.end()) {
    latest_[modelKey(piece)] = key;
    return &found->second;
  }
  if (asked_.insert(key).second)
    QThreadPool::globalInstance()->start([this, key, ref = piece.model, size = piece.size,
                                          catalog = editor_.sharedCatalog(), assets = home.assets,
                                          alive = std::weak_ptr<int>(alive_)] {
      PieceFacts facts = fetch(ref, size, *catalog, *assets);
      QMetaObject::invokeMethod(
          qApp,
          [this, key, alive, facts = std::move(facts)] {
            if (alive.expired()) return;
            facts_[key] = facts;
            asked_.erase(key);
            emit factsReady();
          },
          Qt::QueuedConnection);
    });
  return nullptr;
}

}  // namespace idap
