#include "studio/catalog/favourites.h"

#include <QSettings>

namespace idap {

namespace {

const QString kLiked = QStringLiteral("catalog/favourites");
const QString kRecentKey = QStringLiteral("catalog/recent");

}  // namespace

Favourites::Favourites(QObject* parent)
    : QObject(parent),
      liked_(QSettings().value(kLiked).toStringList()),
      recent_(QSettings().value(kRecentKey).toStringList()) {}

void Favourites::setLiked(const QString& id, bool liked) {
  if (liked == isLiked(id)) return;
  liked_.removeAll(id);
  if (liked) liked_.prepend(id);
  QSettings().setValue(kLiked, liked_);
  emit changed();
}

void Favourites::addRecent(const QString& id) {
  if (!recent_.isEmpty() && recent_.front() == id) return;
  recent_.removeAll(id);
  recent_.prepend(id);
  while (recent_.size() > kRecent) recent_.removeLast();
  QSettings().setValue(kRecentKey, recent_);
  emit changed();
}

}  // namespace idap
